// What a link tells of the page is what the page is made of again: collecting and rebuilding are inverses.

import assert from "node:assert/strict";
import { test } from "node:test";
import { MEASURES } from "../../www/shared/formats/measures.mjs";
import { pageModule } from "./page.mjs";
import { generator } from "./random.mjs";

const { collect } = await pageModule("sharing/collect.ts");
const { readFragment, writeFragment } = await pageModule("sharing/codec/link.ts");
const figures = await pageModule("sharing/kinds/figures.ts");
const fit = await pageModule("sharing/kinds/fit.ts");
const publicModel = await pageModule("sharing/kinds/public-model.ts");
const sample = await pageModule("sharing/kinds/sample.ts");
const view = await pageModule("sharing/kinds/view.ts");

/**
 * @typedef {import("../../www/app/sharing/shared").SharedModel} SharedModel
 * @typedef {import("../../www/app/sharing/shared").SharedOrigin} SharedOrigin
 * @typedef {import("../../www/app/sharing/shared").SharedResults} SharedResults
 * @typedef {import("../../www/app/sharing/shared").Claim} Claim
 * @typedef {import("../../www/app/sharing/kinds/view").Look} Look
 * @typedef {import("../../www/app/state/origin").Origin} Origin
 * @typedef {import("../../www/app/engine/contract").SampleOptions} SampleOptions
 * @typedef {import("../../www/worker/protocol").FitRequest} FitRequest
 * @typedef {{ id: string, origin: Origin, methods: string[] }} Entry A model of the page, and its submissions.
 * @typedef {ReturnType<typeof emptyPage>} Page
 * @typedef {ReturnType<typeof randomly>} Draw
 */

const ROUNDS = 200;
const NEVER = new AbortController().signal;

/** A page without an engine: what it makes, downloads and fits is there at once. */
function emptyPage() {
  /** @type {Entry[]} */
  const models = [];
  /** @type {Map<string, FitRequest>} */
  const fits = new Map();
  /** @param {string} id @param {Origin} origin */
  const add = (id, origin) => models.push({ id, origin, methods: [] });
  /** @param {string} id */
  const methodsOf = (id) => models.find((model) => model.id === id)?.methods ?? [];
  return {
    entries: models,
    models: () => models,
    /** @param {string} model @param {string} method */
    fitOf: (model, method) => fits.get(`${model} ${method}`),
    /** @param {string} part @param {SampleOptions} options @param {string} how */
    async makeSample(part, options, how) {
      add(`${part} ${JSON.stringify(options)}`, { kind: "sample", part, options });
      assert.ok(["shown", "quiet"].includes(how));
    },
    /** @param {import("../../www/app/public/download").Wanted} wanted */
    async download({ set, numbers, withResults }) {
      for (const number of numbers) {
        add(`${set} PC${number}`, { kind: "public", model: { set, number } });
        if (withResults) methodsOf(`${set} PC${number}`).push("HT");
      }
      return "complete";
    },
    /** @param {readonly { model: string, request: FitRequest }[]} jobs */
    async fit(jobs) {
      return jobs.map(({ model, request }) => {
        const own = methodsOf(model);
        const name = `${request.method.toUpperCase()} ${own.length + 1}`;
        own.push(name);
        fits.set(`${model} ${name}`, request);
        return undefined;
      });
    },
  };
}

/** @param {() => number} random */
function randomly(random) {
  /** @param {number} most */
  const below = (most) => Math.floor(random() * most);
  /** @param {number} chance */
  const some = (chance) => random() < chance;
  const double = () => (some(0.2) ? 0 : (random() - 0.3) * 10 ** (below(40) - 20));
  const options = () => ({
    ...(some(0.5) && { seed: below(1000) }),
    ...(some(0.5) && { spacing: random() }),
    ...(some(0.3) && { noise: random() / 100 }),
    ...(some(0.3) && { outliers: random() }),
    ...(some(0.3) && { missing: random() }),
  });
  /** @returns {FitRequest} */
  const request = () => ({
    method: some(0.5) ? "pg" : "ht",
    seed: below(2 ** 32),
    parameters: Object.fromEntries(["fuzzy_border", "smallest", "tolerance"].filter(() => some(0.5)).map((name) => [name, double()])),
  });
  /** @param {string} model @param {string} method */
  const report = (model, method) => ({
    ...{ model, method, points: below(1e6), truth: below(100), predicted: below(100), type_errors: below(10) },
    mean: Object.fromEntries(MEASURES.map((measure) => [measure, some(0.2) ? null : double()])),
    primitives: Array.from({ length: 3 }),
    predictions: Array.from({ length: 2 }),
  });
  return { below, some, double, options, request, report };
}

/** A page of samples and public models, some of them fitted. @param {Draw} random */
async function somePage(random) {
  const { below, some, options, request } = random;
  const page = emptyPage();
  const parts = ["bracket", "flange", "elbow"];
  for (const part of parts.slice(0, 1 + below(3))) await page.makeSample(part, options(), "quiet");
  for (const set of /** @type {const} */ (["training", "test"])) await page.download({ set, numbers: [1 + below(10), 11 + below(10)], withResults: some(0.5) });
  const jobs = page.entries.flatMap(({ id }) => Array.from({ length: below(3) }, () => ({ model: id, request: request() })));
  await page.fit(jobs);
  return page;
}

/**
 * What is told of a page, with what the engine is to say of it.
 * @param {Page} page
 * @param {(model: string, method: string) => object} reportOf
 * @param {Look} look
 * @returns {Promise<SharedResults>}
 */
async function told(page, reportOf, look) {
  const rows = page.entries.flatMap((entry) =>
    entry.methods.map((method) => {
      const report = reportOf(entry.id, method);
      return { key: `${entry.id} ${method}`, entry, reports: { method, definition: report, published: report } };
    }),
  );
  const fingerprintsOf = async () => ({ inputs: undefined, submission: undefined });
  return collect(rows, "definition", look, { page, engine: "1.2.3", fingerprintsOf });
}

/** Has everything again on an empty page. @param {SharedResults} shared */
async function again({ models, claims }) {
  const page = emptyPage();
  for (const { origin } of models) if (origin.kind === "sample") await sample.rebuild(origin, "quiet", page, NEVER);
  const asked = models.flatMap(({ origin }, place) =>
    origin.kind === "public" ? [{ model: origin.model, withResults: claims.some(({ model, fitted }) => model === place && !fitted) }] : [],
  );
  assert.ok(await publicModel.rebuild(asked, page, NEVER));
  /** @param {SharedModel | undefined} shared */
  const nameOf = (shared) =>
    page.models().find(({ origin }) => (shared?.origin.kind === "sample" ? sample : publicModel).isOf(origin, shared?.origin))?.id;
  const jobs = claims.flatMap(({ model, fitted }) => (fitted ? [{ model: nameOf(models[model]), request: fitted }] : []));
  assert.deepEqual(await fit.rebuild(jobs, page, NEVER), jobs.map(() => undefined));
  return page;
}

test("a page that a link tells of is made again from the link, and tells the same", async () => {
  const random = generator(11);
  for (let round = 0; round < ROUNDS; round += 1) {
    const draw = randomly(random);
    const page = await somePage(draw);
    const reports = new Map();
    /** @param {string} model @param {string} method */
    const reportOf = (model, method) => {
      const key = `${model} ${method}`;
      if (!reports.has(key)) reports.set(key, draw.report(model, method));
      return reports.get(key);
    };
    const looked = page.entries[draw.below(page.entries.length)];
    const look = { model: looked.id, ...(looked.methods[0] && { method: looked.methods[0] }), colour: "figure" };
    const shared = await told(page, reportOf, look);
    const read = readFragment(writeFragment(shared));
    assert.deepEqual(read, shared);

    const rebuilt = await again(read);
    /** @param {readonly Entry[]} all */
    const inOrder = (all) => [...all].sort((a, b) => (JSON.stringify(a.origin) < JSON.stringify(b.origin) ? -1 : 1));
    // Models of which no submission was told are not in the link.
    assert.deepEqual(inOrder(rebuilt.entries), inOrder(page.entries.filter(({ methods }) => methods.length > 0)));
    const retold = await told(rebuilt, reportOf, look);
    /** @param {SharedResults} told */
    const rows = ({ models, claims }) =>
      claims.map(({ model, ...claim }) => JSON.stringify([models[model], claim])).sort();
    assert.deepEqual(rows(retold), rows(shared));
  }
});

test("many models are told of in time proportional to their number, whichever order their rows come in", async () => {
  const count = 20_000;
  const draw = randomly(generator(14));
  const report = draw.report("PC", "A");
  const names = Array.from({ length: count }, (_, at) => `PC${at + 1}`);
  let asked = 0;
  const rows = ["A", "B"].flatMap((method) =>
    names.map((id) => {
      const entry = { id, origin: { kind: "files" } };
      // Every look at a row's model counts: the clock would tell the machine's load as well.
      return { key: `${id} ${method}`, reports: { method, definition: report, published: report }, get entry() {
        asked += 1;
        return entry;
      } };
    }),
  );
  const sources = { page: emptyPage(), engine: "1.2.3", fingerprintsOf: async () => ({ inputs: undefined, submission: undefined }) };
  /** @type {SharedResults} */
  const { models, claims } = await collect(rows, "definition", undefined, sources);
  assert.deepEqual(models.map(({ name }) => name), names);
  assert.deepEqual(claims.slice(0, 4).map(({ model, method }) => `${model} ${method}`), ["0 A", "0 B", "1 A", "1 B"]);
  assert.equal(claims.length, 2 * count);
  assert.ok(asked <= 4 * rows.length, `${asked} looks at ${rows.length} rows`);
});

test("figures that were collected from a report are those of the report, and no others are", () => {
  const random = generator(12);
  for (let round = 0; round < ROUNDS; round += 1) {
    const draw = randomly(random);
    const report = draw.report("PC1", "MINE");
    const { model, claim } = figures.collect(report);
    assert.deepEqual(figures.compare({ model, claim }, report), []);
    const measure = MEASURES[draw.below(MEASURES.length)];
    const other = draw.report("PC1", "MINE").mean[measure];
    const differences = figures.compare({ model, claim: { ...claim, mean: { ...claim.mean, [measure]: other } } }, report);
    assert.equal(differences.length, Object.is(other, report.mean[measure]) ? 0 : 1);
  }
});

test("a look comes back as it was where everything it names is there, and without what is not", () => {
  const random = generator(13);
  const names = ["PC1", "PC2", "PC3"];
  for (let round = 0; round < ROUNDS; round += 1) {
    const { below, some, double, report } = randomly(random);
    const reports = ["A", "B"].map((method) => ({ method, definition: report("PC", method), published: undefined }));
    const side = ["truth", "prediction", "rival"][below(3)];
    const look = {
      model: names[below(3)],
      method: "A",
      left: "B",
      ...(some(0.5) && { rightIsTruth: true }),
      ...(some(0.5) && { primitive: { side, index: below(2) } }),
      ...(some(0.5) && { camera: { target: [double(), 0, 1], rotation: [0, 0, 0, 1], height: 2, projection: "orthographic" } }),
      ...{ colour: "figure", arrangement: "wipe" },
    };
    const seen = view.collect(look, names);
    assert.equal(names[seen.model], look.model);
    assert.deepEqual(view.rebuild(seen, look.model, reports), look);
    // A primitive that is not there, and submissions that are not.
    const beyond = { ...seen, primitive: { side, index: 3 + below(2 ** 31) } };
    assert.equal(view.rebuild(beyond, look.model, reports).primitive, undefined);
    const { method, left } = view.rebuild({ ...seen, method: "C", left: "D" }, look.model, reports);
    assert.deepEqual([method, left], [undefined, undefined]);
  }
  assert.equal(view.collect({ model: "PC9" }, names), undefined);
});
