// What the page and the view say to each other.

import { Standpoint, type CameraState, type Hit } from "../../generated/view/view.js";

// The renderer's own types, generated from Rust.
export { LabelState, PatchMark, Standpoint } from "../../generated/view/view.js";
export type { CameraState, Hit, Layout, PointSize, Projection, Side, SurfacePatch } from "../../generated/view/view.js";

/** Six sides of a box and the corner between x, −y and z, with what they are called. */
export const STANDPOINTS: readonly { readonly standpoint: Standpoint; readonly name: string }[] = [
  Standpoint.Front,
  Standpoint.Back,
  Standpoint.Left,
  Standpoint.Right,
  Standpoint.Top,
  Standpoint.Bottom,
  Standpoint.Isometric,
].map((standpoint) => ({ standpoint, name: Standpoint[standpoint].toLowerCase() }));

/** A box outside of which nothing is shown: along x, y and z from 0 at the least coordinate to 1 at the greatest. */
export interface ClipBox {
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
}

/** Background, and the colour of what must stand out from it; `#rrggbb`. */
export interface Theme {
  readonly background: string;
  readonly ink: string;
}

/** A region of a view, in pixels of the page from the canvas's upper left corner. */
export type Region =
  | { readonly kind: "circle"; readonly x: number; readonly y: number; readonly radius: number }
  | { readonly kind: "polygon"; readonly corners: readonly (readonly [number, number])[] };

export interface PictureOptions {
  readonly width: number;
  readonly height: number;
  readonly transparent: boolean;
  /** Behind the points where the picture is not transparent; the theme's background where absent. */
  readonly background?: string;
  /** Of what stands out from the background; the theme's where absent. */
  readonly ink?: string;
}

/** Why there is no picture. */
export type UnavailableReason = "no-webgl2" | "shader" | "load";

/** There is no picture; everything but looking still works. */
export class ViewUnavailable extends Error {
  readonly reason: UnavailableReason;

  constructor(reason: UnavailableReason, message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = "ViewUnavailable";
    this.reason = reason;
  }
}

/** What happens in the view, told to whoever listens. */
export interface ViewEvents {
  /** The cursor rests on another point, or on none. Position in pixels of the page. */
  hover: (hit: Hit | undefined, x: number, y: number) => void;
  click: (hit: Hit | undefined, event: PointerEvent) => void;
  doubleClick: (hit: Hit | undefined) => void;
  /** The camera has come to rest somewhere else. */
  camera: (state: CameraState) => void;
  /** The graphics card gave up (false) or is back (true). */
  context: (usable: boolean) => void;
}
