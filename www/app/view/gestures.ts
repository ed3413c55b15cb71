// Mouse, fingers, wheel and keys, as movements of the view.

import { STANDPOINTS, type CameraState, type Hit, type Standpoint, type ViewEvents } from "./types";

/** A press that moves less than this, in pixels, is a click. */
const CLICK_SLOP = 4;
/** Two clicks within this time, in milliseconds, are one double click. */
const DOUBLE_CLICK_MS = 350;
/** What an arrow key turns (radians) and moves (pixels), and what plus and minus enlarge. */
const KEY_TURN = Math.PI / 24;
const KEY_PAN = 40;
const KEY_ZOOM = 1.2;

/** What gestures move: a view on a canvas. Places are in pixels of the page from the canvas's upper left corner. */
export interface Movable {
  readonly canvas: HTMLCanvasElement;
  readonly camera: CameraState;
  turn(yaw: number, pitch: number, roll?: number): void;
  drag(x0: number, y0: number, x1: number, y1: number): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number, x?: number, y?: number): void;
  lookFrom(standpoint: Standpoint): void;
  fit(): void;
  setProjection(projection: CameraState["projection"]): void;
  pick(x: number, y: number): Promise<Hit | undefined>;
  /** The cursor is there, or gone. */
  hover(x?: number, y?: number): void;
  tell<Name extends keyof ViewEvents>(name: Name, ...details: Parameters<ViewEvents[Name]>): void;
}

interface Press {
  x: number;
  y: number;
  readonly startX: number;
  readonly startY: number;
  readonly pans: boolean;
}

/** What gestures move and ask: the view. Places and ways are in pixels of the canvas, angles in radians. */
export interface Movable {
  readonly canvas: HTMLCanvasElement;
  readonly camera: CameraState;
  drag(x0: number, y0: number, x1: number, y1: number): void;
  fit(): void;
  hover(x?: number, y?: number): void;
  lookFrom(standpoint: Standpoint): void;
  pan(dx: number, dy: number): void;
  pick(x: number, y: number): Promise<Hit | undefined>;
  setProjection(projection: CameraState["projection"]): void;
  tell<Name extends keyof ViewEvents>(name: Name, ...details: Parameters<ViewEvents[Name]>): void;
  turn(yaw: number, pitch: number, roll?: number): void;
  zoom(factor: number, x?: number, y?: number): void;
}

export class Gestures {
  private readonly view: Movable;
  private readonly stop = new AbortController();
  private readonly presses = new Map<number, Press>();
  private moved = false;
  private lastClick = { time: -Infinity, x: 0, y: 0 };

  constructor(view: Movable) {
    this.view = view;
    const { canvas } = view;
    canvas.style.touchAction = "none";
    const { signal } = this.stop;
    canvas.addEventListener("pointerdown", (event) => this.press(event), { signal });
    canvas.addEventListener("pointermove", (event) => this.move(event), { signal });
    canvas.addEventListener("pointerup", (event) => this.release(event), { signal });
    canvas.addEventListener("pointercancel", (event) => this.presses.delete(event.pointerId), { signal });
    canvas.addEventListener("pointerleave", () => view.hover(), { signal });
    canvas.addEventListener("wheel", (event) => this.wheel(event), { signal, passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event), { signal });
    // The right button moves the cloud.
    canvas.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  }

  dispose(): void {
    this.stop.abort();
  }

  private press(event: PointerEvent): void {
    const { offsetX: x, offsetY: y } = event;
    const pans = event.button !== 0 || event.shiftKey || event.ctrlKey || event.metaKey;
    this.view.canvas.setPointerCapture(event.pointerId);
    this.moved = this.presses.size > 0;
    this.presses.set(event.pointerId, { x, y, startX: x, startY: y, pans });
  }

  private move(event: PointerEvent): void {
    const { offsetX: x, offsetY: y } = event;
    const press = this.presses.get(event.pointerId);
    if (!press) {
      if (event.pointerType !== "touch") this.view.hover(x, y);
      return;
    }
    const { x: lastX, y: lastY } = press;
    if (Math.hypot(x - press.startX, y - press.startY) > CLICK_SLOP) this.moved = true;
    if (!this.moved) return;
    const other = [...this.presses].find(([id]) => id !== event.pointerId)?.[1];
    press.x = x;
    press.y = y;
    if (other) this.pinch(lastX, lastY, x, y, other);
    else if (press.pans) this.view.pan(x - lastX, y - lastY);
    else this.view.drag(lastX, lastY, x, y);
  }

  /** One of two fingers moves: their middle moves the cloud, their distance enlarges it, their direction rolls it. */
  private pinch(lastX: number, lastY: number, x: number, y: number, other: Press): void {
    this.view.pan((x - lastX) / 2, (y - lastY) / 2);
    const before = Math.hypot(lastX - other.x, lastY - other.y);
    const after = Math.hypot(x - other.x, y - other.y);
    if (before > 1 && after > 1) {
      this.view.zoom(after / before, (x + other.x) / 2, (y + other.y) / 2);
      const turned = Math.atan2(lastY - other.y, lastX - other.x) - Math.atan2(y - other.y, x - other.x);
      this.view.turn(0, 0, Math.atan2(Math.sin(turned), Math.cos(turned)));
    }
  }

  private release(event: PointerEvent): void {
    this.presses.delete(event.pointerId);
    if (!this.moved && event.button === 0 && !event.shiftKey) void this.click(event);
  }

  private async click(event: PointerEvent): Promise<void> {
    const { offsetX: x, offsetY: y, timeStamp: time } = event;
    const last = this.lastClick;
    const twice = time - last.time < DOUBLE_CLICK_MS && Math.hypot(x - last.x, y - last.y) < 2 * CLICK_SLOP;
    this.lastClick = { time: twice ? -Infinity : time, x, y };
    const hit = await this.view.pick(x, y);
    if (twice) this.view.tell("doubleClick", hit);
    else this.view.tell("click", hit, event);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    // Lines and pages in pixels; a trackpad's pinch comes as a wheel with the control key.
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 18 : 300;
    const speed = event.ctrlKey ? 0.01 : 0.0015;
    const steps = Math.max(-300, Math.min(300, event.deltaY * unit));
    this.view.zoom(Math.exp(-steps * speed), event.offsetX, event.offsetY);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.act(event.key, event.shiftKey)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  /** Does what a key asks; false where it asks for nothing. */
  private act(key: string, shift: boolean): boolean {
    const { view } = this;
    const direction = ARROWS[key];
    if (direction) {
      const [x, y] = direction;
      if (shift) view.pan(x * KEY_PAN, y * KEY_PAN);
      else view.turn(x * KEY_TURN, y * KEY_TURN);
      return true;
    }
    const chosen = STANDPOINTS[Number(key) - 1];
    if (chosen) view.lookFrom(chosen.standpoint);
    else if (key === "+" || key === "=") view.zoom(KEY_ZOOM);
    else if (key === "-" || key === "_") view.zoom(1 / KEY_ZOOM);
    else if (key === "," || key === "<") view.turn(0, 0, KEY_TURN);
    else if (key === "." || key === ">") view.turn(0, 0, -KEY_TURN);
    else if (key === "0" || key === "Home") view.fit();
    else if (key.toLowerCase() === "o") {
      view.setProjection(view.camera.projection === "perspective" ? "orthographic" : "perspective");
    } else return false;
    return true;
  }
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
