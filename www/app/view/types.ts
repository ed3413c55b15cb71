// What the page and the view say to each other.

/** One of the two things compared: by custom 0 the truth and 1 the prediction. */
export type Side = 0 | 1;

/** What a label's points look like. A faded or hidden point is not found by the cursor. */
export enum LabelState {
  Hidden = 0,
  Faded = 1,
  Shown = 2,
  Highlighted = 3,
}

/** How the views share the canvas. `at` is the place of the wipe's border, 0 left to 1 right. */
export type Layout =
  | { readonly kind: "single"; readonly side: Side }
  | { readonly kind: "split" }
  | { readonly kind: "wipe"; readonly at: number };

/** A multiple of the typical distance of neighbours (surfaces stay closed), or pixels. */
export type PointSize =
  | { readonly unit: "spacing"; readonly value: number }
  | { readonly unit: "pixels"; readonly value: number };

export type Projection = "perspective" | "orthographic";

/** Six sides of a box and the corner between x, −y and z. */
export const STANDPOINTS = ["front", "back", "left", "right", "top", "bottom", "isometric"] as const;
export type Standpoint = (typeof STANDPOINTS)[number];

/** Angle between the lines of sight to the upper and lower border of a perspective view, in radians; the renderer's. */
export const FIELD_OF_VIEW = 0.52;

/** A camera as plain numbers, for links. Positions are relative to the cloud's centre. */
export interface CameraState {
  /** The point in the middle of the view. */
  readonly target: readonly [number, number, number];
  /** Unit quaternion x y z w: from the camera's axes to the cloud's. */
  readonly rotation: readonly [number, number, number, number];
  /** Visible height at the target, in the cloud's units. */
  readonly height: number;
  readonly projection: Projection;
}

/** Background, and the colour of what must stand out from it; `#rrggbb`. */
export interface Theme {
  readonly background: string;
  readonly ink: string;
}

/** What a line of a patch stands for; `Centre` is a dot, the apex of a cone or a centre. */
export enum PatchMark {
  Rim = 0,
  Axis = 1,
  Radius = 2,
  Centre = 3,
}

/** The part of a fitted surface that its points cover, relative to the cloud's centre. */
export interface SurfacePatch {
  readonly side: Side;
  /** `#rrggbb` */
  readonly colour: string;
  /** x y z per vertex. */
  readonly positions: Float32Array;
  /** Unit normal x y z per vertex. */
  readonly normals: Float32Array;
  /** Three vertices per triangle. */
  readonly triangles: Uint32Array;
  /** Start and end, x y z each, per line. */
  readonly lines: Float32Array;
  /** A `PatchMark` per line. */
  readonly marks: Uint8Array;
}

/** The point found under the cursor. */
export interface Hit {
  readonly side: Side;
  /** As in the positions given to `setCloud`. */
  readonly index: number;
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
