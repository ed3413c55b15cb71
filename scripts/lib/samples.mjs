// Inputs of the benchmark: the public files where they are at hand, else generated parts.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { strFromU8, strToU8, zipSync } from "fflate";
import { ROOT, benchmarkFiles } from "./paths.mjs";

/** The folder `test_sample` of the public files as the bytes of a zip, or undefined. */
export function testSampleZip() {
  const folder = publicFile("test_sample");
  if (!folder) {
    return undefined;
  }
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name));
  return zipSync(
    Object.fromEntries(files.map((path) => [relative(folder, path), readFileSync(path)])),
  );
}

/** The bytes of `training_set.zip`, or undefined. */
export function trainingZip() {
  const path = publicFile("training_set.zip");
  return path === undefined ? undefined : readFileSync(path);
}

/**
 * Every part of the generator, with its truth, as the bytes of a zip.
 * @param {import("../../bin/cli/engine.mjs").Engine} engine
 * @param {import("../../bin/engine/engine.js").SampleOptions} options
 */
export function generatedZip(engine, options = {}) {
  /** @type {Record<string, Uint8Array>} */
  const files = {};
  for (const { name: part } of engine.declarations().parts) {
    const model = engine.Model.generate(part, options);
    const { name } = model.info();
    const texts = /** @type {[import("../../bin/engine/engine.js").Role, string][]} */ (Object.entries(model.write()));
    for (const [role, text] of texts) {
      files[engine.pathOf("beside", name, role)] = strToU8(text);
    }
    model.free();
  }
  return zipSync(files);
}

/**
 * The files of a part with its truth and an imperfect submission, by path, in the layout of the public test set.
 * @param {import("../../bin/cli/engine.mjs").Engine} engine
 * @param {string} part
 * @param {string} name
 * @param {import("../../bin/engine/engine.js").SampleOptions} options
 * @returns {Record<string, Uint8Array>}
 */
export function partFiles(engine, part, name, options = {}) {
  const model = engine.Model.generate(part, options);
  const method = model.imperfect(1);
  const [truth, found] = [model.write(), model.write(method)];
  model.free();
  return {
    [`pointCloud/${name}.txt`]: strToU8(truth.cloud ?? ""),
    [`pointCloud_primitives/${name}_primitives.txt`]: strToU8(truth.primitives),
    [`pointCloud_parametric/${name}_parametric.txt`]: strToU8(truth.parametric),
    [`pointCloud_primitives_${method}/${name}_primitives.txt`]: strToU8(found.primitives),
    [`pointCloud_parametric_${method}/${name}_parametric.txt`]: strToU8(found.parametric),
  };
}

/**
 * The files with the cloud several times over, the others beside the first: those points are in no primitive.
 * @param {Readonly<Record<string, Uint8Array>>} files
 * @param {number} copies
 */
export function sideBySide(files, copies) {
  const path = Object.keys(files).find((name) => name.startsWith("pointCloud/")) ?? "";
  const [head = "", ...rows] = strFromU8(files[path] ?? new Uint8Array()).split("\n");
  const points = rows.filter((row) => row.startsWith("["));
  const all = Array.from({ length: copies }, (_, at) =>
    points.map((row) => row.replace(/^\[([^,]+)/, (_row, x) => `[${Number(x) + 2 * at}`)).join("\n"),
  );
  return { ...files, [path]: strToU8([head, ...all, " ];", ""].join("\n")) };
}

/** The name of the model in the path of one of its files. */
const FIRST = /PC1(?=[_.])/;

/**
 * The files of so many models of 300 points, all alike, by path. A zip holds those of 13,000 at most.
 * @param {import("../../bin/cli/engine.mjs").Engine} engine
 * @param {number} count
 */
export function manyModels(engine, count) {
  const one = Object.entries(partFiles(engine, "bracket", "PC1", { spacing: 0.06 }));
  const numbers = Array.from({ length: count }, (_, at) => at + 1);
  return Object.fromEntries(
    numbers.flatMap((number) => one.map(([path, bytes]) => [path.replace(FIRST, `PC${number}`), bytes])),
  );
}

/** @param {string} name */
function publicFile(name) {
  const folder = benchmarkFiles();
  const path = folder && join(folder, name);
  return path && existsSync(path) ? path : undefined;
}

/** The real STEP files, by name; none where they are not at hand. */
export function stepParts() {
  const folder = join(process.env.FIT4CAD_SHARED ?? join(ROOT, "../shared"), "step");
  const names = existsSync(folder) ? readdirSync(folder).filter((file) => /\.ste?p$/.test(file)) : [];
  return names.sort().map((path) => ({ path, bytes: readFileSync(join(folder, path)) }));
}

/** Plates of 10 × 20 × 2 mm with a face a side, 30 mm apart, as STEP: each a body of its own. */
export function stepPlate(count = 1) {
  /** @type {string[]} */
  const lines = [];
  const add = (/** @type {string} */ entity) => `#${lines.push(`#${lines.length + 1}=${entity};`)}`;
  const real = (/** @type {number} */ value) => (Number.isInteger(value) ? `${value}.` : String(value));
  const triple = (/** @type {readonly number[]} */ [a = 0, b = 0, c = 0]) => `(${real(a)},${real(b)},${real(c)})`;
  const point = (/** @type {readonly number[]} */ at) => add(`CARTESIAN_POINT('',${triple(at)})`);
  const direction = (/** @type {readonly number[]} */ of) => add(`DIRECTION('',${triple(of)})`);
  const bodies = Array.from({ length: count }, (_, at) => plate(30 * at)).join(",");
  const unit = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  const angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const context = add(`(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((${unit},${angle}))REPRESENTATION_CONTEXT('',''))`);
  add(`ADVANCED_BREP_SHAPE_REPRESENTATION('',(${bodies}),${context})`);
  const header = "HEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('plate','',(''),(''),'','test','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n";
  return `ISO-10303-21;\n${header}DATA;\n${lines.join("\n")}\nENDSEC;\nEND-ISO-10303-21;\n`;

  function plate(/** @type {number} */ left) {
    const [x, y, z] = [10, 20, 2];
    const corners = [0, 1].flatMap((k) => [0, 1].flatMap((j) => [0, 1].map((i) => [left + i * x, j * y, k * z])));
    const vertices = corners.map((at) => add(`VERTEX_POINT('',${point(at)})`));
    /** @type {Map<string, string>} */
    const edges = new Map();
    const edge = (/** @type {number} */ from, /** @type {number} */ to) => {
      const [low, high] = from < to ? [from, to] : [to, from];
      const key = `${low} ${high}`;
      const [start, end] = [corners[low] ?? [], corners[high] ?? []];
      const along = end.map((value, axis) => value - (start[axis] ?? 0));
      const length = Math.hypot(...along);
      if (!edges.has(key)) {
        const line = add(`LINE('',${point(start)},${add(`VECTOR('',${direction(along.map((value) => value / length))},${real(length)})`)})`);
        edges.set(key, add(`EDGE_CURVE('',${vertices[low]},${vertices[high]},${line},.T.)`));
      }
      return add(`ORIENTED_EDGE('',*,*,${edges.get(key)},${from < to ? ".T." : ".F."})`);
    };
    const sides = [
      { at: [0, 2, 3, 1], normal: [0, 0, -1] },
      { at: [4, 5, 7, 6], normal: [0, 0, 1] },
      { at: [0, 1, 5, 4], normal: [0, -1, 0] },
      { at: [2, 6, 7, 3], normal: [0, 1, 0] },
      { at: [0, 4, 6, 2], normal: [-1, 0, 0] },
      { at: [1, 3, 7, 5], normal: [1, 0, 0] },
    ];
    const faces = sides.map(({ at, normal }) => {
      const loop = add(`EDGE_LOOP('',(${at.map((corner, place) => edge(corner, at[(place + 1) % 4] ?? 0)).join(",")}))`);
      const [first = 0, second = 0] = at;
      const across = (corners[second] ?? []).map((value, axis) => Math.sign(value - (corners[first]?.[axis] ?? 0)));
      const frame = add(`AXIS2_PLACEMENT_3D('',${point(corners[first] ?? [])},${direction(normal)},${direction(across)})`);
      return add(`ADVANCED_FACE('',(${add(`FACE_OUTER_BOUND('',${loop},.T.)`)}),${add(`PLANE('',${frame})`)},.T.)`);
    });
    return add(`MANIFOLD_SOLID_BREP('plate',${add(`CLOSED_SHELL('',(${faces.join(",")}))`)})`);
  }
}
