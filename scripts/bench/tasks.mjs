// How long the page's own thread is ever busy: who scrolls or types meanwhile waits as long.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { zipSync } from "fflate";
import { buildPage } from "../build.mjs";
import { benchmarkFiles } from "../lib/paths.mjs";
import { partFiles, sideBySide } from "../lib/samples.mjs";
import { withServedPage } from "../lib/served.mjs";
import { tasksWhile } from "../lib/tasks.mjs";

export const name = "tasks";
export const about = "the longest task of the page's own thread: the panels with the training set, a picture of 3 million points";

/** A step is over when nothing has happened for so long. */
const REST_MS = 2000;
const PATIENCE_MS = 10 * 60_000;
/** From this on a hand feels it. */
const MOST_MS = 50;

/** A part of a million points, so many times side by side: the generator makes two million at most. */
const LARGE = { part: "plate", spacing: 0.001, copies: 3 };
/** What is done to the picture of many points, as everybody does. @type {readonly [what: string, act: (page: Page) => Promise<unknown>][]} */
const LOOKING = [
  ["coloured by distance", (page) => page.getByRole("combobox", { name: "Colour" }).selectOption("distance")],
  ["coloured by segment", (page) => page.getByRole("combobox", { name: "Colour" }).selectOption("segments")],
  ["a primitive selected and framed", (page) => page.getByRole("tabpanel").locator("tbody tr").first().click().then(() => page.keyboard.press("f"))],
];

/** @typedef {import("@playwright/test").Page} Page */

/** @param {import("../lib/bench.mjs").Bench} bench */
export async function measure(bench) {
  await buildPage();
  await withServedPage(async ({ address, browser }) => {
    const opened = async () => {
      const context = await browser.newContext({ serviceWorkers: "block", viewport: { width: 1440, height: 900 } });
      return context.newPage();
    };
    await walkMany(bench, await opened(), address);
    await lookAtMany(bench, await opened(), address);
  });
}

/**
 * The training set, panel by panel.
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {Page} page
 * @param {string} address
 */
async function walkMany(bench, page, address) {
  const shared = benchmarkFiles();
  if (shared === undefined) {
    bench.note("the walk with the training set is skipped: it is not at hand");
    return;
  }
  const steps = stepsOf(page);
  await steps.step("the page opened, until its sample is scored", () => openPage(page, address));
  await steps.step("188 models dropped, until all are scored", async () => {
    await bring(page, join(shared, "training_set.zip"));
    await page.locator(".models .count", { hasText: /^188 models/ }).waitFor({ timeout: PATIENCE_MS });
    await page.locator("#scoring, #taking").first().waitFor({ state: "detached", timeout: PATIENCE_MS });
  });
  for (const tab of await page.getByRole("tab").all()) {
    await steps.step(`panel ${(await tab.textContent())?.trim() ?? ""}`, () => tab.click());
  }
  for (const model of ["PC2", "PC100"]) {
    await steps.step(`model ${model}`, () => page.locator(".models .name", { hasText: new RegExp(`^${model}$`) }).click());
  }
  steps.tell(bench, "with 188 models");
  await page.context().close();
}

/**
 * One model of three million points: read, scored, shown and looked at.
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {Page} page
 * @param {string} address
 */
async function lookAtMany(bench, page, address) {
  const folder = mkdtempSync(join(tmpdir(), "fit4cad-tasks-"));
  const steps = stepsOf(page);
  try {
    const zip = join(folder, "large.zip");
    const { part, spacing, copies } = LARGE;
    writeFileSync(zip, zipSync(sideBySide(partFiles(bench.engine, part, "PC1", { spacing }), copies), { level: 1 }));
    await openPage(page, address);
    await steps.step("dropped, until it is scored and shown", async () => {
      await bring(page, zip);
      await page.locator(".stage-title p", { hasText: /\d,\d{3},\d{3} points/ }).waitFor({ timeout: PATIENCE_MS });
      await page.locator(".canvas-state").waitFor({ state: "detached", timeout: PATIENCE_MS });
      await page.locator("table.scores tbody tr").first().waitFor({ timeout: PATIENCE_MS });
    });
    await page.locator("#tab-primitives").click();
    for (const [what, act] of LOOKING) await steps.step(what, () => act(page));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  steps.tell(bench, "with 3 million points");
  await page.context().close();
}

/**
 * @param {Page} page
 * @param {string} address
 */
async function openPage(page, address) {
  await page.goto(address);
  await page.locator("table.scores tbody tr").first().waitFor();
}

/**
 * @param {Page} page
 * @param {string} zip
 */
async function bring(page, zip) {
  await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
  await page.getByLabel("Choose files or zips").setInputFiles(zip);
}

/**
 * Steps of a visit, each with its longest task.
 * @param {Page} page
 */
function stepsOf(page) {
  /** @type {string[][]} */
  const rows = [];
  let longest = 0;
  return {
    /**
     * @param {string} what
     * @param {() => Promise<unknown>} act
     */
    async step(what, act) {
      const tasks = await tasksWhile(page, async () => {
        await act();
        await page.waitForTimeout(REST_MS);
      });
      const most = (/** @type {(task: import("../lib/tasks.mjs").Task) => number} */ of) => Math.max(0, ...tasks.map(of));
      const own = most((task) => task.own);
      longest = Math.max(longest, own);
      rows.push([what, own.toFixed(0), most(({ wall }) => wall).toFixed(0)]);
    },
    /**
     * @param {import("../lib/bench.mjs").Bench} bench
     * @param {string} where
     */
    tell(bench, where) {
      bench.table({
        title: `Longest task of the page's own thread ${where}, ms`,
        note: "Of the processor: without waiting for the renderer, which draws in software here, or for a processor that is busy.",
        head: ["step", "of the processor", "on the clock"],
        rows,
      });
      bench.figure(`longest task ${where}, of the processor`, longest, "ms", { most: MOST_MS, digits: 0 });
    },
  };
}
