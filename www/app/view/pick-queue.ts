// Which point is under the cursor: questions wait their turn, and the answer is asked for frame by
// frame, so that nothing ever waits for the graphics card.

import type { View } from "../../generated/view/view.js";
import type { Hit } from "./types";

/** A place in device pixels from the lower left corner. */
interface Place {
  readonly x: number;
  readonly y: number;
}

interface Question extends Place {
  readonly reach: number;
  readonly answer: (hit: Hit | undefined) => void;
}

export class PickQueue {
  readonly #view: View;
  readonly #waiting: Question[] = [];
  /** Where the cursor has gone last: of many places only this one is looked into. */
  #hover: Question | undefined;
  #asked: Question | undefined;

  constructor(view: View) {
    this.#view = view;
  }

  /** Whether an answer is awaited. */
  get busy(): boolean {
    return this.#asked !== undefined || this.#hover !== undefined || this.#waiting.length > 0;
  }

  /** The point nearest a place, at most `reach` device pixels away. */
  ask(place: Place, reach: number): Promise<Hit | undefined> {
    return new Promise((answer) => this.#waiting.push({ ...place, reach, answer }));
  }

  /** The same for a place that matters only until the next one is given. */
  askLightly(place: Place, reach: number, answer: Question["answer"]): void {
    this.#hover = { ...place, reach, answer };
  }

  /** Forgets the place that does not matter any more. */
  forgetLightly(): void {
    this.#hover = undefined;
  }

  /** Hands out an answer that has come, and asks the next question. Call once per frame. */
  proceed(): void {
    if (this.#asked) {
      const found = this.#view.poll_pick();
      if (!found) return;
      this.#settle(found.hit);
    }
    const next = this.#waiting.shift() ?? this.#hover;
    if (!next) return;
    if (next === this.#hover) this.#hover = undefined;
    this.#asked = next;
    if (!this.#view.start_pick(next.x, next.y, next.reach)) this.#settle(undefined);
  }

  /** Answers every question with nothing. */
  abandon(): void {
    this.#settle(undefined);
    for (const { answer } of this.#waiting.splice(0)) answer(undefined);
    this.#hover = undefined;
  }

  #settle(hit: Hit | undefined): void {
    const asked = this.#asked;
    this.#asked = undefined;
    asked?.answer(hit);
  }
}
