// The models that fitting is measured on.

import { listZip } from "../../../bin/cli/zip.mjs";
import { trainingZip } from "../../lib/samples.mjs";

/**
 * `{ real, list }`: the training set where it is at hand, else the generated parts, as
 * `{ name, open() }` in the order of the models; what `open` gives is to be freed.
 */
export function models(engine) {
  const zip = trainingZip();
  return zip ? { real: true, list: zipped(engine, zip) } : { real: false, list: generated(engine) };
}

/** Every part of the generator, as it comes. */
export function generated(engine) {
  return engine.parts().map(({ name }) => ({ name, open: () => engine.Model.generate(name, {}) }));
}

/** At most so many of a list, evenly spread over it and always the same. */
export function evenly(list, most) {
  if (list.length <= most) {
    return list;
  }
  return Array.from({ length: most }, (_, at) => list[Math.floor(((at + 0.5) * list.length) / most)]);
}

function zipped(engine, zip) {
  const entries = new Map(listZip(zip).entries.map((entry) => [entry.path, entry]));
  return engine.group([...entries.keys()]).models.map(({ name, files }) => ({
    name,
    open: () =>
      engine.Model.read(
        name,
        files.map((file) => ({ ...file, bytes: entries.get(file.path).read() })),
      ),
  }));
}
