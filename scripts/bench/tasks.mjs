// How long the page's own thread is ever busy: who scrolls or types meanwhile waits as long.

import { join } from "node:path";
import { buildPage } from "../build.mjs";
import { benchmarkFiles } from "../lib/paths.mjs";
import { withServedPage } from "../lib/served.mjs";
import { tasksWhile } from "../lib/tasks.mjs";

export const name = "tasks";
export const about = "the longest task of the page's own thread, walking the panels with the training set";

/** A step is over when nothing has happened for so long. */
const REST_MS = 2000;
const PATIENCE_MS = 10 * 60_000;
/** From this on a hand feels it. */
const MOST_MS = 50;

/** @param {import("../lib/bench.mjs").Bench} bench */
export async function measure(bench) {
  const shared = benchmarkFiles();
  if (shared === undefined) {
    bench.note("skipped: the training set is not at hand");
    return;
  }
  await buildPage();
  await withServedPage(async ({ address, browser }) => {
    const context = await browser.newContext({ serviceWorkers: "block", viewport: { width: 1440, height: 900 } });
    const page = await context.newPage();
    /** @type {string[][]} */
    const rows = [];
    let longest = 0;
    /**
     * @param {string} what
     * @param {() => Promise<unknown>} act
     */
    const step = async (what, act) => {
      const tasks = await tasksWhile(page, async () => {
        await act();
        await page.waitForTimeout(REST_MS);
      });
      const most = (/** @type {(task: import("../lib/tasks.mjs").Task) => number} */ of) => Math.max(0, ...tasks.map(of));
      const own = most((task) => task.own);
      longest = Math.max(longest, own);
      rows.push([what, own.toFixed(0), most(({ wall }) => wall).toFixed(0)]);
    };
    await step("the page opened, until its sample is scored", async () => {
      await page.goto(address);
      await page.locator("table.scores tbody tr").first().waitFor();
    });
    await step("188 models dropped, until all are scored", async () => {
      await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
      await page.getByLabel("Choose files or zips").setInputFiles(join(shared, "training_set.zip"));
      await page.locator(".models .count", { hasText: /^188 models/ }).waitFor({ timeout: PATIENCE_MS });
      await page.locator("#scoring, #taking").first().waitFor({ state: "detached", timeout: PATIENCE_MS });
    });
    for (const tab of await page.getByRole("tab").all()) {
      await step(`panel ${(await tab.textContent())?.trim() ?? ""}`, () => tab.click());
    }
    for (const model of ["PC2", "PC100"]) {
      await step(`model ${model}`, () => page.locator(".models .name", { hasText: new RegExp(`^${model}$`) }).click());
    }
    bench.table({
      title: "Longest task of the page's own thread, ms",
      note: "Of the processor: without waiting for the renderer, which draws in software here, or for a processor that is busy.",
      head: ["step", "of the processor", "on the clock"],
      rows,
    });
    bench.figure("longest task, of the processor", longest, "ms", { most: MOST_MS, digits: 0 });
    await context.close();
  });
}
