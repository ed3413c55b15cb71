// Version 1 of a case in a link: read for ever, written no more but as part of version 2. It is frozen:
// links of this version are out in the world, and a change of layout needs a new version beside it.

import { ByteReader, ByteWriter, Damaged } from "../../sharing/codec/bytes";
import { MAX_BLOCKS, type Base, type Block, type Case, type Cut, type Sampling, type Vector } from "../case";
import type { LinkedCase } from "./linked";

const MAX_SIZES = 16;
const MAX_CUTS = 200;
const MAX_CORNERS = 1000;

const BASES = ["blocks", "sample"] as const;
const OPERATIONS = ["add", "cut"] as const;
const CUTS = ["ball", "lasso"] as const;

export function read(bytes: Uint8Array<ArrayBuffer>): LinkedCase {
  const from = new ByteReader(bytes);
  const of = readCase(from);
  from.end();
  return { of };
}

export function writeCase(out: ByteWriter, { name, base, sampling, cuts }: Case): void {
  out.text(name);
  if (base.kind === "files") throw new RangeError("Only a case that is generated fits into a link.");
  out.u8(BASES.indexOf(base.kind));
  if (base.kind === "blocks") writeBlocks(out, base.blocks);
  else out.text(base.part);
  for (const value of [sampling.spacing, sampling.noise, sampling.outliers, sampling.seed]) out.f64(value);
  if (cuts.length > MAX_CUTS) throw new RangeError(`A link can hold up to ${MAX_CUTS} cuts. Save the files instead.`);
  out.whole(cuts.length);
  for (const cut of cuts) writeCut(out, cut);
}

export function readCase(from: ByteReader): Case {
  const name = from.text();
  const base: Base =
    oneOf(BASES, from.u8()) === "blocks" ? { kind: "blocks", blocks: readBlocks(from) } : { kind: "sample", part: from.text() };
  const sampling: Sampling = { spacing: from.f64(), noise: from.f64(), outliers: from.f64(), seed: seed(from.f64()) };
  const cuts = times(from.count(MAX_CUTS), () => readCut(from));
  return { name, base, sampling, cuts };
}

function writeBlocks(out: ByteWriter, blocks: readonly Block[]): void {
  out.whole(blocks.length);
  for (const { operation, shape, sizes, position, rotation } of blocks) {
    out.u8(OPERATIONS.indexOf(operation));
    out.text(shape);
    out.whole(sizes.length);
    for (const value of [...sizes, ...position, ...rotation]) out.f64(value);
  }
}

function readBlocks(from: ByteReader): Block[] {
  return times(from.count(MAX_BLOCKS), () => {
    const operation = oneOf(OPERATIONS, from.u8());
    const shape = from.text();
    const sizes = times(from.count(MAX_SIZES), () => from.f64());
    return { operation, shape, sizes, position: vector(from), rotation: vector(from) };
  });
}

function writeCut(out: ByteWriter, cut: Cut): void {
  out.u8(CUTS.indexOf(cut.kind));
  if (cut.kind === "ball") {
    for (const value of [...cut.centre, cut.radius]) out.f64(value);
    return;
  }
  for (const value of cut.target) out.f64(value);
  for (const value of cut.rotation) out.f64(value);
  writeReach(out, cut.eye);
  writeReach(out, cut.depth);
  out.whole(cut.corners.length);
  for (const [x, y] of cut.corners) {
    out.f32(x);
    out.f32(y);
  }
}

function readCut(from: ByteReader): Cut {
  if (oneOf(CUTS, from.u8()) === "ball") return { kind: "ball", centre: vector(from), radius: from.f64() };
  return {
    kind: "lasso",
    target: vector(from),
    rotation: [from.f64(), from.f64(), from.f64(), from.f64()],
    eye: readReach(from),
    depth: readReach(from),
    corners: times(from.count(MAX_CORNERS), () => [from.f32(), from.f32()] as const),
  };
}

/** Infinity is no figure that a link may hold by chance. */
function writeReach(out: ByteWriter, value: number): void {
  out.u8(Number.isFinite(value) ? 1 : 0);
  if (Number.isFinite(value)) out.f64(value);
}

function readReach(from: ByteReader): number {
  return oneOf([false, true] as const, from.u8()) ? from.f64() : Infinity;
}

function vector(from: ByteReader): Vector {
  return [from.f64(), from.f64(), from.f64()];
}

function times<T>(count: number, make: () => T): T[] {
  return Array.from({ length: count }, make);
}

function oneOf<T>(all: readonly T[], place: number): T {
  const found = all[place];
  if (found === undefined) throw new Damaged("it names something that does not exist");
  return found;
}

function seed(value: number): number {
  if (!Number.isSafeInteger(value) || value < 0) throw new Damaged("its seed is no whole number");
  return value;
}
