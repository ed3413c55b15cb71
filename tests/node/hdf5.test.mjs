// HDF5 as h5py wrote it, crate/hdf5/fixtures, at the command line.

import assert from "node:assert/strict";
import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { zipSync } from "fflate";
import { fit4cad, folder } from "./support.mjs";

const FIXTURES = fileURLToPath(new URL("../../crate/hdf5/fixtures/", import.meta.url));

/** @param {import("node:test").TestContext} t @param {readonly string[]} names */
function copies(t, names) {
  const root = folder(t, {});
  for (const name of names) cpSync(join(FIXTURES, name), join(root, name), { recursive: true });
  return root;
}

test("arrays of many models and predictions for them are scored model by model", (t) => {
  const root = copies(t, ["train_data.h5", "predictions.h5"]);
  const { out, err } = fit4cad("score", "--json", root);
  /** @type {any[]} */
  const reports = JSON.parse(out);
  assert.deepEqual(reports.map(({ method, model }) => [method, model]), [["predictions", "00000"], ["predictions", "00001"]], err);
  // One point of 40 is none of the truth's, and of the types ParseNet's 5 is no cylinder.
  for (const { mean, type_errors } of reports) {
    assert.ok(mean.DSC > 0.99 && mean.DSC < 1, String(mean.DSC));
    assert.equal(type_errors, 1);
  }
});

test("SPFN's predictions find their cloud, and its pickled parameters are left with one word for all files", (t) => {
  const root = copies(t, ["shape.h5", "SPFN"]);
  cpSync(join(root, "shape.h5"), join(root, "other.h5"));
  const { out, err } = fit4cad("score", "--json", root);
  /** @type {any[]} */
  const reports = JSON.parse(out);
  assert.deepEqual(reports.map(({ method, model, type_errors }) => [method, model, type_errors]), [["SPFN", "shape", 0]]);
  assert.equal(err.match(/pickled/g)?.length, 1, err);
  assert.match(err, /So it is with 1 more of the files/);
});

test("HDF5 within a zip is opened too, and what is none is told", (t) => {
  const root = folder(t, { "broken.h5": "no arrays" });
  writeFileSync(join(root, "a.zip"), zipSync({ "00007.h5": readFileSync(join(FIXTURES, "00007.h5")) }));
  const { out, err } = fit4cad("stats", root);
  assert.match(out, /00007/);
  assert.match(err, /broken\.h5: error: it could not be read as HDF5/);
});
