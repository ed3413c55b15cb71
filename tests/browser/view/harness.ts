// A page with nothing but the view, for tests that ask it directly.

import { bytes, rgb, segmentTable } from "../../../www/app/view/palette";
import { PointView } from "../../../www/app/view/point-view";
import { LabelState, PatchMark, Standpoint, ViewUnavailable } from "../../../www/app/view/types";

/** Half the edges of the block. */
const HALF = [1, 0.7, 0.5] as const;

/**
 * The surface of a block of 2 × 1.4 × 1 in the middle of the coordinates, `side` × `side` points a
 * face. Labels: −x 1, +x 2, −y 3, +y 4, −z 5, +z 6.
 */
function block(side: number): { positions: Float32Array; normals: Float32Array; labels: Uint32Array } {
  const count = 6 * side * side;
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  const labels = new Uint32Array(count);
  for (let index = 0; index < count; index++) {
    const face = Math.floor(index / (side * side));
    const axis = face >> 1;
    const sign = face % 2 ? 1 : -1;
    const across = [(axis + 1) % 3, (axis + 2) % 3] as const;
    const steps = [Math.floor(index / side) % side, index % side] as const;
    positions[3 * index + axis] = sign * (HALF[axis] ?? 0);
    for (const k of [0, 1] as const) {
      positions[3 * index + across[k]] = (HALF[across[k]] ?? 0) * ((2 * steps[k]) / (side - 1) - 1);
    }
    normals[3 * index + axis] = sign;
    labels[index] = face + 1;
  }
  return { positions, normals, labels };
}

/** The pixels of a picture file. */
async function decode(file: Blob): Promise<ImageData> {
  const bitmap = await createImageBitmap(file, { premultiplyAlpha: "none" });
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no canvas to decode on");
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

/**
 * How many pixels, between two shares of the width, have one of the colours, shaded as they may be:
 * the proportions of red, green and blue count.
 */
function count({ width, data }: ImageData, colour: string, from = 0, to = 1): number {
  const wanted = rgb(colour);
  let found = 0;
  for (let at = 0; at < data.length; at += 4) {
    const x = (at / 4) % width;
    if (x < from * width || x >= to * width) continue;
    const seen = [data[at] ?? 0, data[at + 1] ?? 0, data[at + 2] ?? 0];
    const product = seen.reduce((sum, channel, k) => sum + channel * (wanted[k] ?? 0), 0);
    if (Math.hypot(...seen) > 40 && product > 0.997 * Math.hypot(...seen) * Math.hypot(...wanted)) found++;
  }
  return found;
}

const canvas = document.querySelector<HTMLCanvasElement>("#view");
if (!canvas) throw new Error("no canvas");

/** Resolves when the view has had time to draw what it was told and to come to rest. */
async function rest(): Promise<void> {
  await new Promise((done) => setTimeout(done, 250));
  await new Promise((done) => requestAnimationFrame(done));
}

const view = await PointView.create(canvas);
const harness = { view, canvas, block, bytes, decode, count, rest, segmentTable, LabelState, PatchMark, PointView, Standpoint, ViewUnavailable };
export type Harness = typeof harness;
Object.assign(window, { harness });
