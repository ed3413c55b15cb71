// The files of a model for the engine: each is read when its turn comes, and not at all where it is too large.

import type { InputFile } from "../generated/engine/engine.js";
import type { ModelFile } from "./protocol";

const reader = new FileReaderSync();

/**
 * The model of some files. One that cannot be had any more (moved, changed since it was dropped, too large for the
 * memory that is left) fails it: what the engine would say of its content is not so.
 */
export function modelOf<Model extends { free: () => void }>(
  engine: { readonly read: (name: string, files: InputFile[]) => Model },
  name: string,
  files: readonly ModelFile[],
): Model {
  let lost: { readonly reason: unknown } | undefined;
  const input = ({ path, role, method, first, data }: ModelFile): InputFile => ({
    path,
    role,
    ...(method === undefined ? {} : { method }),
    ...(first === undefined ? {} : { first }),
    size: data.size,
    read: () => {
      try {
        return new Uint8Array(reader.readAsArrayBuffer(data));
      } catch (reason) {
        lost ??= { reason };
        throw reason;
      }
    },
  });
  const model = engine.read(name, files.map(input));
  if (!lost) return model;
  model.free();
  throw lost.reason;
}
