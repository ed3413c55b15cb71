// What people hold goes in, and what was found comes out, at the command line.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { EXPORTS } from "../../www/generated/declared/exports.js";
import { fit4cad, folder } from "./support.mjs";

/** Points of three faces of a cube, 14 × 14 each, and the face of each. */
const ROWS = Array.from({ length: 3 * 196 }, (_, at) => {
  const [u, v, face] = [(at % 14) * 0.1 + 0.05, (Math.floor(at / 14) % 14) * 0.1 + 0.05, Math.floor(at / 196)];
  const point = [[u, v, 0], [u, 0, v], [0, u, v]][face] ?? [];
  return { point, face };
});

/** @param {string} separator @param {boolean} [labels] @param {string} [decimal] */
function rows(separator, labels = false, decimal = ".") {
  const text = (/** @type {number} */ value) => value.toFixed(3).replace(".", decimal);
  return ROWS.map(({ point, face }) => [...point.map(text), ...(labels ? [String(face)] : [])].join(separator) + "\n").join("");
}

function labelledPly() {
  const head = "ply\nformat binary_little_endian 1.0\nelement vertex 588\nproperty float x\nproperty float y\nproperty float z\nproperty int label\nend_header\n";
  const body = Buffer.alloc(588 * 16);
  for (const [at, { point, face }] of ROWS.entries()) {
    for (const [axis, value] of point.entries()) {
      body.writeFloatLE(value, 16 * at + 4 * axis);
    }
    body.writeInt32LE(face, 16 * at + 12);
  }
  return Buffer.concat([Buffer.from(head), body]);
}

const LABELS = ROWS.map(({ face }) => `${face}\n`).join("");

/** @param {string[]} args */
function scored(...args) {
  const { code, out, err } = fit4cad("score", "--json", ...args);
  return { code, err, reports: JSON.parse(out) };
}

test("a cloud is fitted whatever program wrote its rows", (t) => {
  const clouds = {
    "blanks.xyz": rows(" "),
    "commas.csv": `x,y,z\n${rows(",")}`,
    "semicolons.txt": rows(";"),
    "decimal.asc": rows("\t", false, ","),
    "counted.pts": `588\n${rows(" ")}`,
    "wide.txt": Buffer.from(`\uFEFF${rows(" ")}`, "utf16le"),
    "packed.xyz.gz": gzipSync(rows(" ")),
    "binary.ply": labelledPly(),
  };
  const root = folder(t, clouds);
  const { code, out } = fit4cad("fit", "--method", "pg", "--json", root);
  assert.equal(code, 0);
  for (const { model, points, primitives } of JSON.parse(out)) {
    assert.deepEqual([model, points, primitives.length >= 3], [model, 588, true]);
  }
  assert.equal(JSON.parse(out).length, Object.keys(clouds).length);
});

test("labels are truth and submission in every form, and surfaces are fitted to them", (t) => {
  const root = folder(t, {
    "a.xyz": rows(" ", true),
    "Net/a_labels.txt": LABELS,
    "b.txt": rows(","),
    "b_inst.txt": LABELS,
    "Other/b.ply": labelledPly(),
  });
  const { code, reports, err } = scored(root);
  assert.equal(code, 0, err);
  const found = reports.map((/** @type {any} */ { model, method, mean }) => [model, method, mean.DSC, mean.MFE < 1e-6, mean.d1 < 1e-6]);
  assert.deepEqual(found, [["a", "Net", 1, true, true], ["b", "Other", 1, true, true]]);
  const notes = reports[0].diagnostics.filter((/** @type {any} */ { message }) => message.includes("they were fitted here"));
  assert.deepEqual(notes.map((/** @type {any} */ { severity, found: what }) => [severity, what]), [["note", "3 segments"], ["note", "3 segments"]]);
});

test("types beside labels are kept to, whatever the surface that would fit best, and told where they are of nothing", (t) => {
  const types = ROWS.map(({ face }) => `${[1, 1, 4][face]}\n`).join("");
  const root = folder(t, {
    "a.xyz": rows(" "),
    "a_inst.txt": LABELS,
    "Net/a_inst.txt": LABELS,
    "Net/a_type.txt": types,
  });
  const { reports: [report] } = scored(root);
  // The third is a plane to whom nobody says that it is a cylinder.
  assert.deepEqual([report?.method, report?.type_errors], ["Net", 1]);
  const { err } = fit4cad("score", root);
  assert.match(err, /a_type\.txt: note: Types are read by their numbers \(found 1 plane, 3 cone, 4 cylinder/);
  const named = fit4cad("score", "--json", "--as", `role=types,model=a,method=Net:${join(root, "Net/a_type.txt")}`, root);
  assert.equal(JSON.parse(named.out)[0].type_errors, 1);

  const lone = folder(t, { "b_type.txt": types });
  const { err: told } = fit4cad("stats", lone);
  assert.match(told, /b_type\.txt: error: This is not a cloud but a number, or a name, for each point of one/);
});

test("clouds of single primitives, as CloudCompare saves them, are segments of the cloud beside them, or the cloud", (t) => {
  const single = (/** @type {number} */ face, /** @type {number} */ moved = 0) =>
    ROWS.filter((row) => row.face === face).map(({ point }) => `${point.map((value) => Math.fround(value + moved).toFixed(8)).join(" ")}\n`).join("");
  const far = ROWS.map(({ point }) => `${point.map((value) => (value + 412345).toFixed(3)).join(" ")}\n`).join("");
  const root = folder(t, {
    "a.xyz": rows(" ", true),
    "RANSAC/a_PLANE_0001_cloud.txt": single(0),
    "RANSAC/a_PLANE_0002_cloud.txt": single(1),
    "RANSAC/a_PLANE_0003_cloud.txt": `${single(2)}9 9 9\n`,
    "RANSAC/a_Leftovers_cloud.txt": "9 9 9\n",
    "far/b.xyz": far,
    "far/b_labels.txt": LABELS,
    "far/Moved/Plane_0001.txt": single(0),
    "far/Moved/Plane_0002.txt": single(1),
    "far/Moved/Cylinder_0001.txt": single(2),
  });
  const { reports, err } = scored(root);
  const found = reports.map((/** @type {any} */ { model, method, mean, type_errors }) => [model, method, mean.DSC, type_errors]);
  assert.deepEqual(found, [["a", "RANSAC", 1, 0], ["b", "Moved", 1, 1]], err);
  const told = reports.map((/** @type {any} */ { diagnostics }) => diagnostics.filter((/** @type {any} */ { message }) => message.includes("one for each primitive")));
  assert.deepEqual(told.map((/** @type {any[]} */ each) => each.map(({ severity }) => severity)), [["warning"], ["note"]]);
  assert.match(told[0][0].found, /^1 of 589, the first in .*a_PLANE_0003_cloud\.txt$/);
  assert.match(told[1][0].found, /^by -412345(\.0+\d*)?, /);
  const alone = folder(t, { "scan/Plane_0001.txt": single(0), "scan/Plane_0002.txt": single(1), "scan/Leftovers.txt": single(2) });
  const [itself] = scored("--self", alone).reports;
  assert.deepEqual([itself.model, itself.mean.DSC], ["scan", 1]);
  const { out } = fit4cad("fit", "--single", "--json", alone);
  assert.deepEqual(JSON.parse(out)[0].segments.map((/** @type {any} */ { number, points, best }) => [number, points, best.type]), [[1, 196, "Plane"], [2, 196, "Plane"]]);
});

test("indices that count from 0 are told, and read so where that is said", (t) => {
  const surfaces = [[0, 0, 1], [0, 1, 0], [1, 0, 0]].map((normal, face) => `Primitive${face + 1}:=[Plane, [${normal.join(" ")} 0]];\n`).join("");
  // Mixed, so that what follows a point is on another face.
  const mixed = ROWS.map((row, at) => ROWS[(at * 197) % 588] ?? row);
  const cloud = mixed.map((row) => `${row.point.join(" ")}\n`).join("");
  const lists = (/** @type {number} */ first) =>
    [0, 1, 2].map((face) => `Primitive${face + 1}:=[${mixed.flatMap((row, at) => (row.face === face ? [at + first] : [])).join(" ")}];\n`).join("");
  const root = folder(t, {
    "a.xyz": cloud,
    "a_primitives.txt": lists(1),
    "a_implicit.txt": surfaces,
    "Net/a_primitives.txt": lists(0),
    "Net/a_implicit.txt": surfaces,
  });
  const before = scored(root);
  assert.equal(before.code, 1);
  assert.match(JSON.stringify(before.reports[0].diagnostics), /seem to count from 0/);
  const after = scored(root, "--as", `first=0:${join(root, "Net/a_primitives.txt")}`);
  assert.deepEqual([after.code, after.err, after.reports[0].mean.DSC], [0, "", 1]);
});

test("what was found is written in every form, with a truth and without, and read back scores the same", (t) => {
  const root = folder(t, { "a.xyz": rows(" ", true), "bare/b.xyz": rows(" ") });
  const out = join(root, "out");
  const forms = EXPORTS.filter(({ name }) => name !== "ply-text");
  const { code, err } = fit4cad("export", join(root, "a.xyz"), "--to", forms.map(({ name }) => name).join(","), "--out", out);
  // What is said is what the columns are, and that surfaces were fitted.
  assert.deepEqual([code, err.split("\n").filter((line) => line !== "" && !line.includes(": note: "))], [0, []]);
  assert.deepEqual(readdirSync(out).sort(), forms.map(({ ending }) => `a_truth${ending}`).sort());
  const table = readFileSync(join(out, "a_truth_primitives.csv"), "utf8").trim().split("\n");
  assert.equal(table.length, 4);
  assert.match(table[0] ?? "", /^primitive,type,points,axis_x,.*,mfe,dhaus,axis_error_rad,.*,half_angle_error_rad$/);
  assert.equal(JSON.parse(readFileSync(join(out, "a_truth_primitives.json"), "utf8")).surfacesFitted, true);
  for (const ending of [".ply", ".xyzc", ".npz", ".vg"]) {
    const again = folder(t, { "a.xyz": rows(" "), "a_labels.txt": LABELS, [`HT/a${ending}`]: readFileSync(join(out, `a_truth${ending}`)) });
    const { reports } = scored(again);
    assert.deepEqual([ending, reports[0].method, reports[0].mean.DSC], [ending, "HT", 1]);
  }
  const found = join(root, "found");
  fit4cad("fit", "--method", "ht", "--out", found, join(root, "bare"));
  const bare = fit4cad("export", join(root, "bare"), found, "--to", "ply-text,fit4cad", "--out", found);
  assert.deepEqual([bare.code, bare.err], [0, ""]);
  assert.match(readFileSync(join(found, "b_HT.ply"), "utf8"), /^ply\nformat ascii 1\.0\ncomment b, HT\nelement vertex 588\n/);
  const wrong = fit4cad("export", root, "--to", "nothing");
  assert.equal(wrong.code, 2);
  assert.match(wrong.err, /--to nothing: expected csv, json/);
});

test("each cloud, or each segment that is given, is told as one primitive", (t) => {
  const circle = Array.from({ length: 600 }, (_, at) => {
    const [angle, height] = [at * 2.399963, (at % 60) / 60];
    return `${Math.cos(angle).toFixed(6)},${Math.sin(angle).toFixed(6)},${height.toFixed(6)}\n`;
  }).join("");
  const root = folder(t, { "round.xyz": circle, "cube.xyz": rows(" ", true) });
  const out = join(root, "out");
  const { code, out: json } = fit4cad("fit", "--single", "--json", "--out", out, join(root, "round.xyz"), join(root, "cube.xyz"));
  assert.equal(code, 0);
  const [cube, round] = JSON.parse(json);
  assert.deepEqual(cube.segments.map((/** @type {any} */ { number, points, best }) => [number, points, best.type]), [[0, 196, "Plane"], [1, 196, "Plane"], [2, 196, "Plane"]]);
  const [segment] = round.segments;
  assert.deepEqual([segment.best.type, round.segments.length, segment.margin > 1], ["Cylinder", 1, true]);
  assert.ok(Math.abs(segment.best.surface.radius - 1) < 1e-5);
  const answer = readFileSync(join(out, "shrec2022/round.txt"), "utf8").trim().split("\n").map(Number);
  assert.deepEqual([answer.length, answer[0], Math.round(answer[1] ?? 0)], [8, 2, 1]);
  assert.match(fit4cad("fit", "--single", join(root, "round.xyz")).out, /^model +segment +points +type/);
  assert.equal(fit4cad("fit", "--single", "--method", "ht", root).code, 2);
});
