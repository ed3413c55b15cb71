// The view: owns a canvas, draws when something has changed, and answers what is under the cursor.

import init, { View, type Lasso } from "../../generated/view/view.js";
import { Gestures } from "./gestures";
import { Growth } from "./growth";
import { bytes, rgb, SEQUENTIAL } from "./palette";
import { PickQueue } from "./pick-queue";
import {
  type CameraState,
  type ClipBox,
  type Hit,
  type LabelState,
  type Layout,
  type PictureOptions,
  type PointSize,
  type Region,
  type Side,
  type Standpoint,
  type SurfacePatch,
  type Theme,
  type ViewEvents,
  ViewUnavailable,
} from "./types";

/** How far from the cursor a point may lie and still be meant, in pixels of the page. */
const REACH = 6;

/** The renderer's code is fetched once, whoever asks first. */
let loading: Promise<unknown> | undefined;

export class PointView {
  readonly canvas: HTMLCanvasElement;
  private readonly view: View;
  private readonly gestures: Gestures;
  private readonly sizes: ResizeObserver;
  private readonly stop = new AbortController();
  private readonly listeners: { [Name in keyof ViewEvents]?: Set<ViewEvents[Name]> } = {};
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  /** Device pixels for one of the page's. */
  private ratio = 1;
  private request = 0;
  /** When the frame under way was asked for. */
  private asked = 0;
  private usable = true;
  private layout: Layout = { kind: "split" };
  private told = "";
  private theme: Theme = { background: "#ffffff", ink: "#000000" };
  private readonly picks: PickQueue;
  private hovered = "";
  private stale = true;
  private readonly growth: Growth;
  /** Frames anew what was framed last, until the reader or the page moves the camera otherwise. */
  private frameAgain: (() => void) | undefined;

  /**
   * Loads the renderer and lets it draw on a canvas. The canvas takes its size from the style sheet.
   * @throws {ViewUnavailable} where the browser or the graphics card cannot.
   */
  static async create(canvas: HTMLCanvasElement): Promise<PointView> {
    try {
      await (loading ??= init());
    } catch (cause) {
      loading = undefined;
      throw new ViewUnavailable("load", "The renderer could not be loaded.", { cause });
    }
    const gl = canvas.getContext("webgl2", {
      alpha: false,
      // Points are not smoothed by it, and lines smooth themselves.
      antialias: false,
      depth: true,
      powerPreference: "high-performance",
      preserveDrawingBuffer: false,
    });
    if (!gl) {
      throw new ViewUnavailable("no-webgl2", "This browser or its graphics driver does not offer WebGL 2.");
    }
    try {
      return new PointView(canvas, new View(gl));
    } catch (cause) {
      throw new ViewUnavailable("shader", "The graphics driver does not accept the renderer's programs.", { cause });
    }
  }

  private constructor(canvas: HTMLCanvasElement, view: View) {
    this.canvas = canvas;
    this.view = view;
    this.picks = new PickQueue(view);
    this.growth = new Growth(view);
    this.gestures = new Gestures(this);
    this.sizes = new ResizeObserver((entries) => this.measure(entries.at(-1)));
    this.sizes.observe(canvas);
    const { signal } = this.stop;
    canvas.addEventListener("webglcontextlost", (event) => this.lose(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.restore(), { signal });
    for (const side of [0, 1] as const) {
      this.setColourMap(side, SEQUENTIAL);
    }
    this.measure(undefined);
  }

  /** Gives up canvas and memory. */
  dispose(): void {
    this.stop.abort();
    this.sizes.disconnect();
    this.gestures.dispose();
    cancelAnimationFrame(this.request);
    this.picks.abandon();
    this.usable = false;
    this.view.free();
  }

  /** Listens to what happens; the result ends it. */
  on<Name extends keyof ViewEvents>(name: Name, listener: ViewEvents[Name]): () => void {
    const listeners = (this.listeners[name] ??= new Set() as never) as Set<ViewEvents[Name]>;
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /** Tells the listeners. */
  tell<Name extends keyof ViewEvents>(name: Name, ...details: Parameters<ViewEvents[Name]>): void {
    for (const listener of this.listeners[name] ?? []) {
      (listener as (...details: Parameters<ViewEvents[Name]>) => void)(...details);
    }
  }

  // What is seen. Of a cloud of millions a part is seen first: what is given per point is worked up a little in every frame.

  /** Replaces the points: x y z each, relative to the cloud's centre. Forgets all that was said of the points before. */
  setCloud(positions: Float32Array): void {
    this.give((view) => view.set_cloud(positions));
  }

  /** Unit normals, x y z per point. */
  setNormals(normals: Float32Array): void {
    // The points are seen without them meanwhile.
    this.give((view) => view.set_normals(normals), this.growth.pictured);
  }

  /** A label per point. Labels also say what is hidden where colours come from elsewhere. */
  setLabels(side: Side, labels: Uint32Array | Uint16Array): void {
    const wide = labels instanceof Uint32Array ? labels : Uint32Array.from(labels);
    this.give((view) => view.set_labels(side, wide));
  }

  /** Colours of the labels, r g b each (see `palette.ts`). */
  setColours(side: Side, colours: Uint8Array): void {
    this.change((view) => view.set_colours(side, colours));
  }

  /** State of each label; labels beyond the last are shown. Costs nothing, however many points there are. */
  setStates(side: Side, states: ArrayLike<LabelState>): void {
    this.change((view) => view.set_states(side, Uint8Array.from(states)));
  }

  /** A number per point; NaN where there is none. */
  setScalars(side: Side, scalars: Float32Array): void {
    this.give((view) => view.set_scalars(side, scalars));
  }

  /** Colours from the low to the high end of the scalars. */
  setColourMap(side: Side, map: readonly string[]): void {
    this.change((view) => view.set_colour_map(side, bytes(map)));
  }

  colourByLabel(side: Side): void {
    this.change((view) => view.colour_by_label(side));
  }

  /** Numbers beyond the range take the colour of its end; points without a number that of label 0. */
  colourByScalar(side: Side, low: number, high: number): void {
    this.change((view) => view.colour_by_scalar(side, low, high));
  }

  colourByNormal(side: Side): void {
    this.change((view) => view.colour_by_normal(side));
  }

  /** Replaces the patches drawn over the points; none takes them all away. */
  setPatches(patches: readonly SurfacePatch[]): void {
    this.change((view) => {
      view.clear_patches();
      for (const patch of patches) view.add_patch(patch);
    });
  }

  setLayout(layout: Layout): void {
    this.layout = layout;
    this.change((view) => {
      const before = view.aspect(this.canvas.width, this.canvas.height);
      view.set_layout(layout);
      // A side of another shape shows what was framed whole again.
      if (view.aspect(this.canvas.width, this.canvas.height) !== before) this.frameAgain?.();
    });
  }

  getLayout(): Layout {
    return this.layout;
  }

  setPointSize(size: PointSize): void {
    this.change((view) => view.set_point_size(size));
  }

  /** Strength of eye-dome lighting: 0 off, 1 usual. */
  setEyeDome(strength: number): void {
    this.change((view) => view.set_eye_dome(strength));
  }

  /** Shows or hides the directions of x, y and z in the corner. */
  setGizmo(shown: boolean): void {
    this.change((view) => view.set_gizmo(shown));
  }

  /** Hides what lies outside a box. */
  setClipBox({ low, high }: ClipBox): void {
    this.change((view) => view.set_clip_box(Float32Array.of(...low, ...high)));
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.change((view) => view.set_theme(unit(theme.background), unit(theme.ink)));
  }

  // The camera. Movement is animated unless the reader prefers reduced motion.

  get camera(): CameraState {
    return this.view.camera();
  }

  /** False where the numbers make no camera; nothing changes then. */
  setCamera(state: CameraState, animated = false): boolean {
    return this.move((view) => view.set_camera(state, this.animated(animated)));
  }

  /**
   * The camera as it would be in a view at least as wide as high: without the height that a narrower one needs to show
   * as much. It shows the same in a view of another shape.
   */
  get portableCamera(): CameraState {
    const { camera } = this;
    return { ...camera, height: camera.height * this.narrowness };
  }

  setPortableCamera(state: CameraState): boolean {
    return this.setCamera({ ...state, height: state.height / this.narrowness });
  }

  private get narrowness(): number {
    return Math.min(1, this.view.aspect(this.canvas.width, this.canvas.height));
  }

  setProjection(projection: CameraState["projection"]): void {
    this.change((view) => view.set_projection(projection));
  }

  lookFrom(standpoint: Standpoint, animated = true): void {
    this.move((view) => view.look_from(standpoint, this.animated(animated)));
  }

  /** Frames the whole cloud. */
  fit(animated = true): void {
    this.change((view) => view.fit(this.animated(animated)));
    this.frameAgain = () => this.view.fit(false);
  }

  /** Frames the points of some labels. */
  fitLabels(side: Side, labels: ArrayLike<number>, animated = true): void {
    const framed = Uint32Array.from(labels);
    this.change((view) => view.fit_labels(side, framed, this.animated(animated)));
    this.frameAgain = () => this.view.fit_labels(side, framed, false);
  }

  /** Frames the part of space between two corners. */
  fitBox({ low, high }: ClipBox, animated = true): void {
    const corners = Float32Array.of(...low, ...high);
    this.change((view) => view.fit_box(corners, this.animated(animated)));
    this.frameAgain = () => this.view.fit_box(corners, false);
  }

  /** Turns the cloud about the axes of the screen, in radians: to the right, downwards, counter-clockwise. */
  turn(yaw: number, pitch: number, roll = 0): void {
    this.move((view) => view.turn(yaw, pitch, roll));
  }

  /** Turns the cloud as if a ball around it were dragged. Pixels of the page, as in all that follows. */
  drag(x0: number, y0: number, x1: number, y1: number): void {
    const ratio = this.ratio;
    this.move((view) => view.drag(x0 * ratio, this.up(y0), x1 * ratio, this.up(y1)));
  }

  pan(dx: number, dy: number): void {
    this.move((view) => view.pan(dx * this.ratio, -dy * this.ratio));
  }

  /** Enlarges around a position; around the middle where none is given. */
  zoom(factor: number, x = -1, y = -1): void {
    this.move((view) => {
      if (x >= 0 && y >= 0) view.zoom(factor, x * this.ratio, this.up(y));
      else view.zoom_centre(factor);
    });
  }

  // Asking.

  /**
   * The point nearest a position, or nothing. Does not block: the answer comes when the graphics
   * card has it.
   */
  pick(x: number, y: number): Promise<Hit | undefined> {
    if (!this.usable) return Promise.resolve(undefined);
    const hit = this.picks.ask({ x: x * this.ratio, y: this.up(y) }, this.reach);
    this.schedule();
    return hit;
  }

  /** The cursor is at a position, or has left. Listeners to `hover` hear when it comes to another point. */
  hover(x?: number, y?: number): void {
    if (x === undefined || y === undefined) {
      this.picks.forgetLightly();
      this.tellHover(undefined, -1, -1);
    } else if (this.usable && this.listeners.hover?.size) {
      const place = { x: x * this.ratio, y: this.up(y) };
      this.picks.askLightly(place, this.reach, (hit) => this.tellHover(hit, x, y));
      this.schedule();
    }
  }

  sideAt(x: number, y: number): Side | undefined {
    return this.view.side_at(x * this.ratio, this.up(y));
  }

  /** Where a place of the cloud is seen; nothing where it is behind the eye or the side not shown. */
  project(side: Side, place: readonly [number, number, number]): { x: number; y: number } | undefined {
    const seen = this.view.project(side, ...place);
    const [x, y] = seen ?? [];
    return x === undefined || y === undefined ? undefined : { x: x / this.ratio, y: (this.canvas.height - y) / this.ratio };
  }

  /** Ascending indices of the points inside a region: those that can be seen, or all down to the far side. */
  pointsIn(side: Side, region: Region, visibleOnly = true): Uint32Array {
    if (region.kind === "circle") {
      const { x, y, radius } = region;
      return this.view.points_in_circle(side, x * this.ratio, this.up(y), radius * this.ratio, visibleOnly);
    }
    return this.view.points_in_polygon(side, this.onScreen(region.corners), visibleOnly);
  }

  /**
   * The region of space that a closed curve on a side encloses: all the way through, or as deep as the deepest point
   * that can be seen in it. Nothing where no point is inside.
   */
  lasso(side: Side, curve: readonly (readonly [number, number])[], visibleOnly: boolean): Lasso | undefined {
    return this.view.lasso(side, this.onScreen(curve), visibleOnly);
  }

  private onScreen(places: readonly (readonly [number, number])[]): Float32Array {
    return Float32Array.from(places.flatMap(([x, y]) => [x * this.ratio, this.up(y)]));
  }

  /** Typical distance of neighbouring points. */
  get spacing(): number {
    return this.view.spacing();
  }

  /** The view in any size, points and lines enlarged with it. */
  pixels({ width, height, transparent, background, ink }: PictureOptions): ImageData {
    const ratio = Math.min(width / this.canvas.clientWidth, height / this.canvas.clientHeight);
    const { view, theme, canvas, camera } = this;
    try {
      this.keepInSight(this.view.aspect(canvas.width, canvas.height), this.view.aspect(width, height));
      view.set_theme(unit(background ?? theme.background), unit(ink ?? theme.ink));
      const pixels = view.picture(width, height, ratio, transparent ? 0 : 1);
      return new ImageData(new Uint8ClampedArray(pixels), width, height);
    } finally {
      view.set_theme(unit(theme.background), unit(theme.ink));
      this.setCamera(camera);
      this.invalidate();
    }
  }

  /** The same as a PNG file. */
  async picture(options: PictureOptions): Promise<Blob> {
    const { width, height } = options;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("The browser could not make a picture of this size.");
    context.putImageData(this.pixels(options), 0, 0);
    return canvas.convertToBlob({ type: "image/png" });
  }

  // Drawing.

  /** Asks for a frame. */
  invalidate(): void {
    this.stale = true;
    this.schedule();
  }

  /** Moves the camera elsewhere than to what was framed last. */
  private move<Result>(act: (view: View) => Result): Result {
    this.frameAgain = undefined;
    return this.change(act);
  }

  private change<Result>(act: (view: View) => Result): Result {
    const result = act(this.view);
    this.invalidate();
    return result;
  }

  /** Gives the view something per point, of which as many as are told can be seen before it is worked up. */
  private give(act: (view: View) => void, pictured = 0): void {
    act(this.view);
    this.growth.begin(pictured);
    this.schedule();
  }

  private schedule(): void {
    if (this.request === 0 && !this.stop.signal.aborted) {
      this.asked = performance.now();
      this.request = requestAnimationFrame((now) => this.step(now));
    }
  }

  private step(now: number): void {
    this.request = 0;
    if (!this.usable) return;
    // What is under the cursor is looked for among all points.
    if (!this.growth.busy) this.picks.proceed();
    else if (this.growth.proceed()) this.stale = true;
    // Before the first point is there, what was seen last stays.
    if (this.stale && !(this.growth.busy && this.view.ready() === 0)) {
      this.stale = this.view.draw(now, performance.now() - this.asked);
      if (!this.stale) this.tellCamera();
    }
    if (this.stale || this.growth.busy || this.picks.busy) this.schedule();
  }

  private tellCamera(): void {
    const state = this.camera;
    const told = JSON.stringify(state);
    if (told !== this.told) {
      this.told = told;
      this.tell("camera", state);
    }
  }

  private tellHover(hit: Hit | undefined, x: number, y: number): void {
    const hovered = hit ? `${hit.side} ${hit.index}` : "";
    if (hovered !== this.hovered) {
      this.hovered = hovered;
      this.tell("hover", hit, x, y);
    }
  }

  /** How far from the cursor a point may lie and still be meant, in device pixels. */
  private get reach(): number {
    return Math.round(REACH * this.ratio);
  }

  private animated(wanted: boolean): boolean {
    return wanted && !this.calm.matches;
  }

  /** Height above the canvas's lower border in device pixels. */
  private up(y: number): number {
    return this.canvas.height - y * this.ratio;
  }

  /** A camera keeps the height that it shows; where a view gets narrower than high, what is at its sides must not leave. */
  private keepInSight(from: number, to: number): void {
    const factor = Math.min(1, from) / Math.min(1, to);
    if (factor !== 1) this.setCamera({ ...this.camera, height: factor * this.camera.height });
  }

  private measure(entry: ResizeObserverEntry | undefined): void {
    const { canvas } = this;
    // oxlint-disable-next-line typescript/no-unnecessary-condition -- not every browser has it
    const exact = entry?.devicePixelContentBoxSize?.[0];
    this.ratio = window.devicePixelRatio || 1;
    const width = exact?.inlineSize ?? Math.round(canvas.clientWidth * this.ratio);
    const height = exact?.blockSize ?? Math.round(canvas.clientHeight * this.ratio);
    if (width === 0 || height === 0) return;
    const again = this.frameAgain;
    if (!again) this.keepInSight(this.view.aspect(canvas.width, canvas.height), this.view.aspect(width, height));
    canvas.width = width;
    canvas.height = height;
    this.view.resize(width, height, this.ratio);
    again?.();
    // Setting the size empties the canvas: draw before it is shown.
    if (this.usable) this.stale = this.view.draw(performance.now(), 0);
    if (this.stale) this.schedule();
  }

  private lose(event: Event): void {
    // Without this the browser would not give the context back.
    event.preventDefault();
    this.usable = false;
    this.picks.abandon();
    this.view.lose();
    this.tell("context", false);
  }

  private restore(): void {
    this.view.restore();
    this.usable = true;
    this.tell("context", true);
    this.invalidate();
  }
}

function unit(colour: string): Float32Array {
  return Float32Array.from(rgb(colour), (channel) => channel / 255);
}
