// The files of a model for the engine: each is read when its turn comes, and not at all where it is too large.

import type { InputFile } from "../generated/engine/engine.js";
import { LONG_FILE_BYTES, type ModelFile, type OnRead } from "./protocol";

const reader = new FileReaderSync();

/** Shorter parts of a file are looked at, longer ones are its pieces. */
const LOOKED_AT = 2 ** 18;

/**
 * The model of some files. One that cannot be had any more (moved, changed since it was dropped, too large for the
 * memory that is left) fails it: what the engine would say of its content is not so.
 */
export function modelOf<Model extends { free: () => void }>(
  engine: { readonly read: (name: string, files: InputFile[]) => Model },
  name: string,
  files: readonly ModelFile[],
  onRead?: OnRead,
): Model {
  let lost: { readonly reason: unknown } | undefined;
  const bytesOf = (data: Blob) => {
    try {
      return new Uint8Array(reader.readAsArrayBuffer(data));
    } catch (reason) {
      lost ??= { reason };
      throw reason;
    }
  };
  const input = ({ path, role, method, first, data }: ModelFile): InputFile => ({
    path,
    role,
    ...(method === undefined ? {} : { method }),
    ...(first === undefined ? {} : { first }),
    size: data.size,
    read: () => bytesOf(data),
    // A blob is read piece by piece: a long text is nowhere held whole.
    part: (from, to) => {
      if (data.size > LONG_FILE_BYTES && to - from > LOOKED_AT) onRead?.(path, to / data.size);
      return bytesOf(data.slice(from, to));
    },
  });
  const model = engine.read(name, files.map(input));
  if (!lost) return model;
  model.free();
  throw lost.reason;
}
