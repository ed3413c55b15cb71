import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { deflateSync, inflateSync } from "fflate";
import { crc32 } from "../../www/shared/crc32.mjs";
import { MEASURES } from "../../www/shared/formats/measures.mjs";
import { pageModule } from "./page.mjs";
import { generator } from "./random.mjs";

const { isShared } = await pageModule("state/fragment.ts");
const { MAX_FRAGMENT, readFragment, writeFragment } = await pageModule("sharing/codec/link.ts");
const { toBase64Url } = await pageModule("sharing/codec/base64url.ts");
const { write } = await pageModule("sharing/codec/version2.ts");

const PAGE = "https://name-of-the-group.github.io/fit4cad-playground/";
const CAMERA = {
  target: [1.5, -2.25, 3],
  rotation: [0.5, 0.5, 0.5, 0.5],
  height: 120.5,
  projection: "perspective",
};

/**
 * Results of `count` models with figures that use all digits of a double.
 * @param {number} count
 * @param {string[]} methods
 * @param {number} seed
 * @returns {any} typed as what the codec takes, of which these tests break the rules
 */
function results(count, methods = ["MINE"], seed = 1) {
  const random = generator(seed);
  const hexadecimal = () => Array.from({ length: 16 }, () => Math.floor(random() * 16).toString(16)).join("");
  const models = Array.from({ length: count }, (_, i) => ({
    name: `PC${i + 1}`,
    points: 5_000 + Math.floor(random() * 50_000),
    truth: 2 + Math.floor(random() * 60),
    origin: { kind: "files" },
    inputs: hexadecimal(),
  }));
  /** @param {string} measure */
  const figure = (measure) => (["MFE", "dHaus", "d1"].includes(measure) ? random() ** 4 : 1 - random() ** 3);
  const claims = models.flatMap((_, model) =>
    methods.map((method) => ({
      model,
      method,
      predicted: Math.floor(random() * 60),
      typeErrors: Math.floor(random() * 4),
      mean: Object.fromEntries(MEASURES.map((measure) => [measure, figure(measure)])),
      submission: hexadecimal(),
    })),
  );
  const view = {
    model: 0,
    method: methods[0],
    primitive: { side: "prediction", index: 3 },
    camera: CAMERA,
    colour: "figure",
    arrangement: "wipe",
  };
  return { engine: "0.1.0", protocol: "published", models, claims, view };
}

test("results come out of a link as they went in, to the last bit", () => {
  const shared = results(35, ["MINE", "A/B <i>", "日本語"]);
  shared.claims[0].mean = { ...shared.claims[0].mean, DSC: null, d1: 0, MFE: 5e-324 };
  delete shared.claims[1].submission;
  delete shared.models[2].inputs;
  shared.models[3].origin = { kind: "sample", part: "flange", options: { seed: 7, noise: 0.001 } };
  shared.models[4].origin = { kind: "public" };
  shared.models[5].origin = { kind: "public", model: { set: "training", number: 190 } };
  shared.models[6].origin = { kind: "public", model: { set: "test", number: 1 } };
  shared.claims[2].fitted = { method: "pg", seed: 2 ** 32 - 1, parameters: { tolerance: 0.0125, fuzzy_border: 0 } };
  shared.claims[3].fitted = { method: "ht", seed: 0, parameters: {} };
  shared.claims[9].fitted = { method: "pg", seed: 2 ** 32 - 1, parameters: { fuzzy_border: 0, tolerance: 0.0125 } };
  Object.assign(shared.view, { left: "A/B <i>", rightIsTruth: true, primitive: { side: "rival", index: 7 } });
  const fragment = writeFragment(shared);
  assert.ok(isShared(fragment));
  assert.match(fragment, /^#share=2\.[\w-]+$/);
  assert.deepEqual(readFragment(fragment), shared);
});

test("a link needs no view and no results", () => {
  const { view: _, ...shared } = results(2);
  assert.deepEqual(readFragment(writeFragment(shared)), shared);
  const nothing = { engine: "0.1.0", protocol: "definition", models: [], claims: [] };
  assert.deepEqual(readFragment(writeFragment(nothing)), nothing);
});

test("a link with ten models stays below 2,000 characters, one with thirty-five below 5,000", (t) => {
  for (const [count, most] of [[10, 2_000], [35, 5_000]]) {
    for (let seed = 1; seed <= 20; seed += 1) {
      const shared = results(count, ["MINE"], seed);
      // What a fit of public models adds comes within the same bound.
      const fitted = { method: "pg", seed: 7, parameters: { tolerance: 0.0125 } };
      shared.models.forEach((/** @type {any} */ model, /** @type {number} */ i) => (model.origin = { kind: "public", model: { set: "test", number: i + 1 } }));
      for (const claim of shared.claims) claim.fitted = fitted;
      const { length } = PAGE + writeFragment(shared);
      assert.ok(length <= most, `${count} models take ${length} characters`);
      if (seed === 1) t.diagnostic(`${count} models: ${length} characters`);
    }
  }
});

test("more than a link can hold is refused in words", () => {
  const methods = Array.from({ length: 14 }, (_, i) => `method ${i}`);
  assert.throws(() => writeFragment(results(35, methods)), /more results than one link can hold/);
});

test("names are cut to what a link holds, between characters, and lose what cannot be seen", () => {
  const shared = results(2);
  shared.models[0].name = "é".repeat(500);
  shared.models[1].name = "a\u202eb\u0000c\r\nd";
  const [long, hidden] = readFragment(writeFragment(shared)).models;
  assert.equal(long.name, "é".repeat(100));
  assert.equal(hidden.name, "a\ufffdb\ufffdc\ufffd\ufffdd");
});

/** @param {number} version */
function fixture(version) {
  return JSON.parse(readFileSync(new URL(`fixtures/share-version-${version}.json`, import.meta.url), "utf8"));
}

for (const version of [1, 2]) {
  test(`a link of version ${version} stays readable`, () => {
    const { fragment, results: expected } = fixture(version);
    assert.deepEqual(readFragment(fragment), expected);
  });
}

test("a link of a version to come says that the page must be reloaded", () => {
  const later = writeFragment(results(1)).replace("=2.", "=3.");
  assert.throws(() => readFragment(later), /made by a newer version of the playground/);
});

test("every missing, changed or added character is noticed", () => {
  const fragment = writeFragment(results(3));
  const start = fragment.indexOf(".") + 1;
  /** @param {string} text */
  const damaged = (text) => assert.throws(() => readFragment(text), { name: "Damaged", message: /^This link is damaged/ });
  for (let at = start; at < fragment.length; at += 1) {
    const other = fragment[at] === "A" ? "B" : "A";
    damaged(fragment.slice(0, at) + fragment.slice(at + 1));
    // The last character may hold bits that stand for nothing.
    if (at < fragment.length - 1) damaged(fragment.slice(0, at) + other + fragment.slice(at + 1));
    damaged(fragment.slice(0, at));
  }
  for (const end of [".", ")", "%20", "&utm_source=x", "AAAA", " "]) damaged(fragment + end);
});

/**
 * A link whose checksum is right, whatever it holds.
 * @param {Uint8Array} content
 * @param {number} announced
 * @param {number} version
 */
function forged(content, announced = content.length, version = 2) {
  const length = [];
  for (let rest = announced; ; rest = Math.floor(rest / 128)) {
    length.push(rest < 128 ? rest : (rest % 128) | 128);
    if (rest < 128) break;
  }
  const body = Uint8Array.from([...length, ...deflateSync(content, { level: 9 })]);
  const sum = new Uint8Array(Uint32Array.of(crc32(body)).buffer);
  return `#share=${version}.${toBase64Url(Uint8Array.from([...sum, ...body]))}`;
}

/**
 * What a link holds, without checksum and length.
 * @param {string} fragment
 */
function contentOf(fragment) {
  const body = Buffer.from(fragment.slice(fragment.indexOf(".") + 1), "base64url").subarray(4);
  return inflateSync(body.subarray(body.findIndex((byte) => byte < 128) + 1));
}

test("a link that unpacks to more than it says is refused without taking the memory", () => {
  const links = [0, 100, 131_072, 20_000_000].map((announced) => forged(new Uint8Array(20_000_000), announced));
  const before = process.memoryUsage().arrayBuffers;
  for (const link of links) assert.throws(() => readFragment(link), { name: "Damaged" });
  // Half of what one of them unpacks to: small pieces may wait to be collected.
  assert.ok(process.memoryUsage().arrayBuffers - before < 10_000_000);
});

test("a link longer than any is refused unread", () => {
  assert.throws(() => readFragment(`#share=2.${"A".repeat(MAX_FRAGMENT)}`), /longer than any/);
});

test("a hostile link gives results within bounds or an error in words, nothing else", () => {
  const random = generator(42);
  /** @param {number} most */
  const pick = (most) => Math.floor(random() * most);
  const written = [results(1), results(10), results(2, ["a", "b"]), fixture(2).results];
  const seeds = [...written.map((shared) => ({ content: write(shared), version: 2 })), { content: contentOf(fixture(1).fragment), version: 1 }];
  let read = 0;
  for (let round = 0; round < 20_000; round += 1) {
    const { content: seed, version } = seeds[pick(seeds.length)];
    const content = Array.from(seed);
    for (let edits = 1 + pick(4); edits > 0; edits -= 1) {
      const at = pick(content.length);
      const kind = pick(4);
      if (kind === 0) content[at] = pick(256);
      else if (kind === 1) content[at] = 0xff;
      else if (kind === 2) content.splice(at, 1 + pick(8));
      else content.splice(at, 0, ...Array.from({ length: 1 + pick(8) }, () => pick(256)));
    }
    let shared;
    try {
      shared = readFragment(forged(Uint8Array.from(content), content.length, version));
    } catch (error) {
      assert.ok(error instanceof Error);
      assert.equal(error.name, "Damaged", error.stack);
      continue;
    }
    read += 1;
    assertWithinBounds(shared);
  }
  assert.ok(read > 100, "the edits leave some links readable");
});

test("random characters never read as a link", () => {
  const random = generator(7);
  const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_=.%<>";
  for (let round = 0; round < 5_000; round += 1) {
    const length = Math.floor(random() * 300);
    const text = Array.from({ length }, () => letters[Math.floor(random() * letters.length)]).join("");
    assert.throws(() => readFragment(`#share=${1 + (round % 2)}.${text}`), { name: "Damaged" });
  }
});

/** @param {any} shared */
function assertWithinBounds({ engine, protocol, models, claims, view }) {
  assert.ok(models.length <= 500 && claims.length <= 1000);
  assert.ok(["definition", "published"].includes(protocol));
  const names = [engine, ...models.map((/** @type {any} */ { name }) => name), ...claims.map((/** @type {any} */ { method }) => method)];
  // eslint-disable-next-line no-control-regex -- they are what must not be there
  for (const name of names) assert.ok(name.length <= 200 && !/[\u0000-\u001f\u202e]/.test(name));
  for (const { origin } of models) {
    if (origin.model) assert.ok(origin.model.number >= 1 && origin.model.number <= /** @type {Record<string, number>} */ ({ training: 190, test: 35 })[origin.model.set]);
  }
  for (const { fitted } of claims.filter((/** @type {any} */ claim) => claim.fitted)) {
    assert.ok(["ht", "pg"].includes(fitted.method) && fitted.seed < 2 ** 32);
    assert.ok(Object.values(fitted.parameters).every(Number.isFinite));
  }
  for (const { model, mean, predicted } of claims) {
    assert.ok(model < models.length && Number.isSafeInteger(predicted));
    assert.deepEqual(Object.keys(mean), [...MEASURES]);
    for (const value of Object.values(mean)) assert.ok(value === null || Number.isFinite(value));
  }
  if (view) {
    assert.ok(view.model < models.length);
    const { camera } = view;
    if (camera) assert.ok([...camera.target, ...camera.rotation, camera.height].every(Number.isFinite));
  }
}
