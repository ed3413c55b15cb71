// The boundary of what reads and writes STEP: options and files of any kind. An error is an answer; a stop is not.

import { loadCad } from "../../../bin/cli/cad.mjs";
import { loadEngineApart } from "../../../bin/cli/engine.mjs";
import { TYPE_COLOURS } from "../../../www/shared/step.mjs";
import { Bytes } from "../bytes.mjs";
import { stepPlate } from "../../lib/samples.mjs";

/** @returns {Promise<import("../targets.mjs").Body>} */
export async function load() {
  const [cad, { engine }] = await Promise.all([loadCad(), loadEngineApart()]);
  const names = [...cad.importOptions().map(({ name }) => name), "other"];
  const encoder = new TextEncoder();
  const plate = encoder.encode(stepPlate());
  const model = engine.Model.generate("plate", { spacing: 0.09 });
  const texts = { ...model.write(), cloud: model.cloud() };
  model.free();
  return {
    seeds: () => Array.from({ length: 20 }, (_, at) => Uint8Array.from([at, 1, 0, 180, 3, 65, 0, 170, 2, 160, 1, 64])),
    run(input) {
      const bytes = new Bytes(input);
      try {
        if (bytes.below(2) === 0) sampled(bytes);
        else written(bytes);
      } catch (error) {
        if (error instanceof WebAssembly.RuntimeError) throw error;
      }
    },
  };

  /** @param {Bytes} bytes */
  function sampled(bytes) {
    const part = cad.Part.read(bytes.below(3) === 0 ? bytes.rest() : plate);
    try {
      const value = () => bytes.one([bytes.number(), true, "even", "random", "scan", null, undefined, {}, [], NaN, -1, 50]);
      const options = Object.fromEntries(bytes.list(5, () => [bytes.one(names), value()]));
      // Without a word the cloud would be larger than many runs bear.
      const few = bytes.below(4) === 0 ? options : { points: 50, ...options };
      if (Number(few.points) > 5000) return;
      const model = part.sample(bytes.text(), few);
      try {
        model.files();
        model.report();
      } finally {
        model.free();
      }
    } finally {
      part.free();
    }
  }

  /** @param {Bytes} bytes */
  function written(bytes) {
    const files = Object.fromEntries(Object.entries(texts).map(([role, text]) => [role, bytes.below(4) === 0 ? bytes.text() : text]));
    const colours = bytes.below(4) === 0 ? Uint8Array.from(bytes.list(20, () => bytes.byte())) : TYPE_COLOURS;
    cad.writeStep(bytes.text(), /** @type {import("../../../bin/cad/cad.js").PartFiles} */ (/** @type {unknown} */ (files)), colours);
  }
}
