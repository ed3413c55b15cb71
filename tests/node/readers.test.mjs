// What is exported, read by programs that know nothing of this one: plyfile, NumPy, trimesh and meshio of
// Python, where they are installed.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { EXPORTS } from "../../www/generated/declared/exports.js";
import { fit4cad, folder } from "./support.mjs";

/** @param {string} script @param {string} [cwd] */
const python = (script, cwd) => spawnSync("python3", ["-c", script], { encoding: "utf8", ...(cwd === undefined ? {} : { cwd }) });

const MISSING = python("import numpy, plyfile, trimesh, meshio").status !== 0 && "Python's numpy, plyfile, trimesh and meshio are not installed";

const SCRIPT = `
import csv, json
import meshio, numpy, plyfile, trimesh
vertices = plyfile.PlyData.read("part_truth.ply")["vertex"]
arrays = numpy.load("part_truth.npz", allow_pickle=False)
points = numpy.c_[vertices["x"], vertices["y"], vertices["z"]]
assert numpy.array_equal(points, arrays["points"])
assert numpy.array_equal(vertices["primitive_index"], arrays["labels"])
rows = numpy.loadtxt("part_truth.xyzc")
assert numpy.array_equal(rows, numpy.c_[points, arrays["labels"]])
areas = []
for ending in ["obj", "stl", "ply", "glb"]:
    mesh = trimesh.load(f"part_truth_surfaces.{ending}", force="mesh")
    areas.append(mesh.area)
    assert numpy.allclose(mesh.bounds, [points.min(0), points.max(0)], atol=0.05 * numpy.ptp(points)), ending
assert max(areas) - min(areas) < 1e-4 * max(areas), areas
for ending in ["obj", "stl", "ply"]:
    assert len(meshio.read(f"part_truth_surfaces.{ending}").points) > 100, ending
table = list(csv.DictReader(open("part_truth_primitives.csv")))
told = json.load(open("part_truth_primitives.json"))["primitives"]
assert [int(row["points"]) for row in table] == [row["points"] for row in told]
assert len(table) == len(arrays["numbers"])
`;

test("other programs read what is exported, and the same from each form", { skip: MISSING }, (t) => {
  const root = folder(t, {});
  fit4cad("generate", "flange", "--spacing", "0.03", "--name", "part", "--out", root);
  const forms = EXPORTS.map(({ name }) => name).filter((name) => name !== "ply-text");
  assert.equal(fit4cad("export", root, "--to", forms.join(","), "--out", root).code, 0);
  const { status, stderr } = python(SCRIPT, root);
  assert.deepEqual([status, stderr], [0, ""]);
});
