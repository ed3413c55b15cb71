// A page with nothing but the view, for tests that ask it directly.

import { rgb, segmentTable } from "../../../www/app/view/palette";
import { PointView } from "../../../www/app/view/point-view";
import { LabelState } from "../../../www/app/view/types";

/** Number of labels of the block's faces. */
export const FACES = 6;

/** The surface of a block of 2 × 1.4 × 1, `side` × `side` points a face, faces labelled from 1. */
export function block(side: number): { positions: Float32Array; labels: Uint32Array } {
  const half = [1, 0.7, 0.5];
  const positions: number[] = [];
  const labels: number[] = [];
  for (let face = 0; face < FACES; face++) {
    const axis = face >> 1;
    for (let i = 0; i < side; i++) {
      for (let j = 0; j < side; j++) {
        const point = [0, 0, 0];
        point[axis] = (half[axis] ?? 0) * (face % 2 ? 1 : -1);
        point[(axis + 1) % 3] = (half[(axis + 1) % 3] ?? 0) * ((2 * i) / (side - 1) - 1);
        point[(axis + 2) % 3] = (half[(axis + 2) % 3] ?? 0) * ((2 * j) / (side - 1) - 1);
        positions.push(...point);
        labels.push(face + 1);
      }
    }
  }
  return { positions: Float32Array.from(positions), labels: Uint32Array.from(labels) };
}

const canvas = document.querySelector<HTMLCanvasElement>("#view");
if (!canvas) throw new Error("no canvas");

const view = await PointView.create(canvas);
const harness = { view, canvas, block, rgb, segmentTable, LabelState, PointView };
export type Harness = typeof harness;
Object.assign(window, { harness });
