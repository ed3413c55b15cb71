// The engine's boundary: functions called with any numbers and texts, and with plain objects of any kind. An error is an
// answer; a stop of the engine, as every panic is, is not. Texts and typed arrays are always such: that, TypeScript says.

import { EXPORTS } from "../../../www/generated/declared/exports.js";
import { NORMALISATIONS } from "../../../www/generated/declared/normalisations.js";
import { STRATA } from "../../../www/generated/declared/strata.js";
import { loadEngineApart } from "../../../bin/cli/engine.mjs";
import { Bytes } from "../bytes.mjs";

const ROLES = ["cloud", "primitives", "parametric", "implicit", "types", "other"];
const PARTS = ["plate", "bracket", "nosuch"];
const SHAPES = ["cuboid", "rounded", "prism", "cylinder", "tube", "cone", "sphere", "torus", "none"];
const FORMS = [...EXPORTS.map(({ name }) => name), "none"];
const SCALES = [...NORMALISATIONS.map(({ name }) => name), "other"];
const CONDITIONS = [...STRATA.map(({ name }) => name), "other"];
const KINDS = ["plane", "cylinder", "cone", "sphere", "torus", "Plane"];

/** @returns {Promise<import("../targets.mjs").Body>} */
export async function load() {
  const { engine } = await loadEngineApart();
  const encoder = new TextEncoder();
  const texts = engine.Model.generate("plate", { spacing: 0.09 }).write();
  return {
    seeds: () => Array.from({ length: 40 }, (_, at) => Uint8Array.from([at, 200, 3, 5, 64, 1, 130, 7, 12, 65, 66, 0, 180, 3, 9, 70, 128, 200])),
    run(input) {
      const bytes = new Bytes(input);
      /** @type {{ free: () => void }[]} */
      const held = [];
      try {
        while (!bytes.isEmpty && held.length < 8) call(bytes, held);
      } catch (error) {
        if (error instanceof WebAssembly.RuntimeError) throw error;
      } finally {
        for (const each of held) each.free();
      }
    },
  };

  /**
   * @param {Bytes} bytes
   * @param {{ free: () => void }[]} held
   */
  function call(bytes, held) {
    const number = () => bytes.number();
    const numbers = () => Float64Array.from(bytes.list(20, number));
    /** Now and then something of another kind. @template T @param {() => T} usual @returns {any} */
    const any = (usual) => (bytes.below(12) === 0 ? bytes.one([undefined, null, "", {}, [], NaN, -1, 1e10, true, 10n, new Uint8Array(3)]) : usual());
    /** @param {any} model */
    const keep = (model) => {
      if (model) held.push(model);
      return model;
    };
    const options = () => ({ spacing: 0.08, ...(bytes.below(3) === 0 && { seed: any(number), noise: any(number) }), ...(bytes.below(6) === 0 && { missing: number(), outliers: number() }) });
    const file = () => {
      const role = bytes.one(ROLES);
      const text = bytes.below(3) === 0 ? bytes.rest() : encoder.encode(texts[/** @type {"cloud"} */ (role)] ?? bytes.text());
      return { path: bytes.text(), role: any(() => role), ...(bytes.below(2) === 0 && { method: any(() => bytes.text()) }), size: any(() => text.length), read: any(() => () => text), ...(bytes.below(2) === 0 && { part: any(() => (/** @type {number} */ from, /** @type {number} */ to) => text.subarray(from, to)) }) };
    };
    const block = () => ({
      operation: any(() => bytes.one(["add", "cut"])),
      shape: any(() => bytes.one(SHAPES)),
      sizes: any(() => bytes.list(5, number)),
      position: any(() => [number(), number(), number()]),
      rotation: any(() => [number(), number(), number()]),
    });
    switch (bytes.below(8)) {
      case 0:
        engine.pathOf(any(() => bytes.one(["beside", "test-set"])), bytes.text(), any(() => bytes.one(ROLES)), bytes.one([undefined, bytes.text()]));
        engine.fileName(bytes.text());
        break;
      case 1:
        engine.group(bytes.list(8, () => bytes.text()), any(() => ({ [bytes.text()]: { role: any(() => bytes.one(ROLES)), model: any(() => bytes.text()) } })));
        break;
      case 2:
        engine.compare(numbers(), numbers());
        engine.summarise(any(() => bytes.list(4, () => ({ method: any(() => bytes.text()), measures: any(() => bytes.list(12, number)), typeErrors: any(number) }))));
        break;
      case 3:
        engine.compareForms(numbers(), numbers());
        engine.surfaceForms(any(() => ({ type: any(() => bytes.one(KINDS)), at: [number(), number(), number()], tilt: number(), heading: number(), size: number(), minor: number() })));
        break;
      case 4:
        asked(keep(engine.Model.compose(bytes.text(), bytes.list(3, () => any(block)), any(options))), bytes);
        break;
      case 5:
        asked(keep(engine.Model.generate(bytes.one(PARTS), any(options))), bytes);
        break;
      default:
        asked(keep(engine.Model.read(bytes.text(), bytes.list(7, () => any(file)))), bytes);
    }

    /** @param {import("../../../bin/engine/engine.js").Model} model @param {Bytes} from */
    function asked(model, from) {
      const method = () => from.one([undefined, from.text(), "Imperfect", "HT"]);
      model.info();
      model.numbers();
      if (from.below(2) === 0) model.imperfect(number());
      for (let step = 0; step < 6; step += 1) {
        switch (from.below(21)) {
          case 0: model.score(method(), any(() => from.one(["definition", "published", "other"]))); break;
          case 1: model.write(method()); break;
          case 2: model.primitives(method()); model.members(method()); break;
          case 3: model.distances(method()); model.positionsAround(numbers()); break;
          case 4: model.patch(number(), method()); break;
          case 5: model.audit(); model.corrected(); break;
          case 6: keep(model.withoutBall(numbers(), number())); break;
          case 7: keep(model.withoutLasso(numbers(), numbers())); model.pointsInBall(numbers(), number()); break;
          case 8: keep(model.degraded(any(options))); break;
          case 9: model.histogram(from.list(3, () => any(() => ({ method: method(), places: any(() => from.list(4, number)) }))), from.byte(), from.below(2) === 1); break;
          case 10: model.paint(from.list(4, () => Uint32Array.from(from.list(9, number))), number()); break;
          case 11: model.thin(number()); model.normals(); break;
          case 12: model.farthest(method()); model.cloud(); break;
          case 13: model.export(from.one(FORMS), method(), Uint8Array.from(from.list(9, () => from.byte()))); break;
          case 14: model.field(method(), any(() => ({ normalisation: any(() => from.one(SCALES)), epsilon: any(number) }))); break;
          case 15: engine.distribution(numbers()); engine.compareFigures(numbers(), numbers(), from.below(2) === 1); break;
          case 16: model.conditions(); engine.declaredCondition(any(() => from.one(CONDITIONS)), number()); break;
          case 17: engine.rates(any(() => model.segments(method(), from.one(SCALES)))); break;
          case 18: model.section(number(), number(), number(), method()); break;
          case 19: model.pointsInBins(from.list(3, () => any(() => ({ method: method(), places: any(() => from.list(4, number)) }))), from.byte(), from.below(2) === 1, number(), number()); break;
          default: engine.datasetStatistics([any(() => model.statistics())]);
        }
      }
    }
  }
}
