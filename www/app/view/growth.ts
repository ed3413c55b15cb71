// Millions of points are brought into the order in which they are drawn a little in every frame.

import type { View } from "../../generated/view/view.js";

/** Points brought into order before the clock is looked at again. */
const PIECE = 30_000;
/** So long in a frame, in milliseconds: who scrolls or types meanwhile must not notice. */
const WORK_MS = 10;
/** A picture is drawn anew when there are so many times more points than in the last one. */
const WORTH_DRAWING = 4;

export class Growth {
  /** Whether points, or what is said of them, are still on their way. */
  busy = false;
  /** Of how many points the last picture was. */
  pictured = 0;
  private readonly view: View;

  constructor(view: View) {
    this.view = view;
  }

  /** Something was given per point; as many points as are told can be seen all the same. */
  begin(pictured: number): void {
    this.busy = true;
    this.pictured = pictured;
  }

  /** Does the work of a frame. Returns whether what there is now is worth a picture. */
  proceed(): boolean {
    const start = performance.now();
    do this.busy = this.view.proceed(PIECE);
    while (this.busy && performance.now() - start < WORK_MS);
    const ready = this.view.ready();
    if (this.busy && (ready === 0 || ready < WORTH_DRAWING * this.pictured)) return false;
    this.pictured = ready;
    return true;
  }
}
