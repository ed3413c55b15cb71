// The models that fitting is measured on.

import { memory } from "../../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../../www/shared/zip/zip.mjs";
import { trainingZip } from "../../lib/samples.mjs";

/** @typedef {import("../../../bin/cli/engine.mjs").Engine} Engine */

/**
 * A model; what `open` gives is to be freed.
 * @typedef {{ name: string, open: () => import("../../../bin/engine/engine.js").Model }} Entry
 */

/** @typedef {{ real: boolean, list: Entry[] }} Known */

/**
 * The training set where it is at hand, else the generated parts, in the order of the models.
 * @param {Engine} engine
 * @returns {Known}
 */
export function models(engine) {
  const zip = trainingZip();
  return zip ? { real: true, list: zipped(engine, zip) } : { real: false, list: generated(engine) };
}

/**
 * Every part of the generator, as it comes.
 * @param {Engine} engine
 * @returns {Entry[]}
 */
export function generated(engine) {
  return engine.declarations().parts.map(({ name }) => ({ name, open: () => engine.Model.generate(name, {}) }));
}

/**
 * At most so many of a list, evenly spread over it and always the same.
 * @template T
 * @param {readonly T[]} list
 * @param {number} most
 */
export function evenly(list, most) {
  if (list.length <= most) {
    return list;
  }
  const chosen = new Set(Array.from({ length: most }, (_, at) => Math.floor(((at + 0.5) * list.length) / most)));
  return list.filter((_, at) => chosen.has(at));
}

/**
 * @param {Engine} engine
 * @param {Uint8Array} zip
 * @returns {Entry[]}
 */
function zipped(engine, zip) {
  const entries = new Map(listZip(memory(zip), STREAMED).entries.map((entry) => [entry.path, entry]));
  return engine.group([...entries.keys()]).models.map(({ name, files }) => ({
    name,
    open: () =>
      engine.Model.read(
        name,
        files.flatMap((file) => {
          const entry = entries.get(file.path);
          return entry ? [{ ...entry, ...file }] : [];
        }),
      ),
  }));
}
