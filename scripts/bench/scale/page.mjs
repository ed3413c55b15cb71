// The page, given many small models in a zip, and a single large one: until every figure is there, what the page's own
// thread worked for it, and the memory it took.

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { zipSync } from "fflate";
import { buildPage } from "../../build.mjs";
import { manyModels, partFiles, sideBySide } from "../../lib/samples.mjs";
import { withServedPage } from "../../lib/served.mjs";

/** Of each step, how many models; small ones, so that it is their number that costs. */
const MODELS = [1_000, 5_000, 10_000];
/** How many of the part stand side by side, each of roughly a million points: the generator makes two million at most. */
const CLOUDS = [
  { points: 1_000_000, copies: 1 },
  { points: 3_000_000, copies: 3 },
];
/** As a share of the diagonal. */
const SPACING = 0.001;
const PART = "plate";
/** What takes more than this times what proportion would, grows too fast. */
const MOST_GROWTH = 2;
const PATIENCE_MS = 30 * 60_000;

/** @typedef {import("../../lib/bench.mjs").Bench} Bench */
/** @typedef {{ address: string, browser: import("@playwright/test").Browser }} Served */
/** @typedef {Window & { longestTask: number }} Watched the page's window with the longest task in it, in milliseconds */

/**
 * How a visit went: what was brought, seconds until done, seconds of the page's own thread and of its longest task, and
 * bytes of its heap and of its process at its largest.
 * @typedef {{ size: number, seconds: number, thread: number, longest: number, heap: number, memory: number | undefined }} Run
 */

/**
 * @param {Bench} bench
 * @param {import("../../bench.mjs").Options} options
 */
export async function measurePage(bench, { quick }) {
  await buildPage();
  const folder = mkdtempSync(join(tmpdir(), "fit4cad-scale-"));
  const zip = join(folder, "brought.zip");
  try {
    await withServedPage(async (served) => {
      const small = [];
      for (const count of quick ? MODELS.slice(0, 2) : MODELS) {
        writeFileSync(zip, zipSync(manyModels(bench.engine, count), { level: 1 }));
        small.push(await visit(served, zip, { size: count, isDone: allScored, detail: count.toLocaleString("en") }));
      }
      tell(bench, "models in the page, of 300 points each", "models", small);
      const large = [];
      for (const { points, copies } of quick ? CLOUDS.slice(0, 1) : CLOUDS) {
        writeFileSync(zip, zipSync(sideBySide(partFiles(bench.engine, PART, "PC1", { spacing: SPACING }), copies), { level: 1 }));
        large.push(await visit(served, zip, { size: points, isDone: opened, detail: "" }));
      }
      tell(bench, "points in the page, in one model", "points", large);
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/**
 * Opens the page, gives it a zip, and measures until `isDone` holds in it.
 * @param {Served} served
 * @param {string} zip
 * @param {{ size: number, isDone: (detail: string) => boolean, detail: string }} what
 * @returns {Promise<Run>}
 */
async function visit({ address, browser }, zip, { size, isDone, detail }) {
  const context = await browser.newContext({ serviceWorkers: "block", viewport: { width: 1280, height: 720 } });
  try {
    const page = await context.newPage();
    const session = await context.newCDPSession(page);
    // Processor time, which other work on the machine does not lengthen.
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    await page.goto(address);
    await page.locator("table.scores tbody tr").first().waitFor();
    await page.locator(".canvas-state").waitFor({ state: "detached" });
    await page.evaluate(watchTasks);
    const before = await metricsOf(session);
    await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
    const start = performance.now();
    await page.getByLabel("Choose files or zips").setInputFiles(zip);
    await page.waitForFunction(isDone, detail, { timeout: PATIENCE_MS, polling: 100 });
    const seconds = (performance.now() - start) / 1000;
    const after = await metricsOf(session);
    await session.send("HeapProfiler.collectGarbage");
    const { heap } = await metricsOf(session);
    const longest = await page.evaluate(() => /** @type {Watched} */ (/** @type {unknown} */ (window)).longestTask);
    const thread = after.thread - before.thread;
    return { size, seconds, thread, longest: longest / 1000, heap, memory: await peakMemory(browser) };
  } finally {
    await context.close();
  }
}

/** Runs in the page. */
function watchTasks() {
  const watched = /** @type {Watched} */ (/** @type {unknown} */ (window));
  watched.longestTask = 0;
  /** @param {PerformanceObserverEntryList} list */
  const take = (list) => {
    for (const { duration } of list.getEntries()) watched.longestTask = Math.max(watched.longestTask, duration);
  };
  new PerformanceObserver(take).observe({ type: "longtask" });
}

/**
 * Whether the summary counts so many submissions. Runs in the page.
 * @param {string} wanted
 */
function allScored(wanted) {
  return document.querySelector(".panel-tools p")?.textContent.startsWith(`${wanted} submission`) === true;
}

/** Whether a model of a million points or so is scored and in view. Runs in the page. */
function opened() {
  const large = /\d{3},\d{3} points/.test(document.querySelector(".stage-title p")?.textContent ?? "");
  return large && !document.querySelector(".canvas-state") && document.querySelector("table.scores tbody tr") !== null;
}

/**
 * Seconds that the page's thread has worked, and bytes of its heap in use.
 * @param {import("@playwright/test").CDPSession} session
 */
async function metricsOf(session) {
  const { metrics } = await session.send("Performance.getMetrics");
  /** @param {string} wanted */
  const of = (wanted) => metrics.find(({ name }) => name === wanted)?.value ?? Number.NaN;
  return { thread: of("TaskDuration"), heap: of("JSHeapUsedSize") };
}

/**
 * The most that a process of pages has had in memory, in bytes; undefined where the system does not tell.
 * @param {import("@playwright/test").Browser} browser
 */
async function peakMemory(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  try {
    const peaks = processInfo
      .filter(({ type }) => type === "renderer")
      .map(({ id }) => /VmHWM:\s+(\d+) kB/.exec(readFileSync(`/proc/${id}/status`, "utf8"))?.[1]);
    return Math.max(...peaks.map((kilobytes) => Number(kilobytes) * 1024));
  } catch {
    return undefined;
  }
}

/**
 * @param {Bench} bench
 * @param {string} title
 * @param {string} unit
 * @param {readonly Run[]} runs
 */
function tell(bench, title, unit, runs) {
  const [first] = runs;
  if (!first) return;
  /**
   * @param {number | undefined} value
   * @param {number | undefined} least
   */
  const growth = (value, least) => (value === undefined || least === undefined ? "–" : `× ${(value / least).toFixed(1)}`);
  /** @param {number | undefined} bytes */
  const megabytes = (bytes) => (bytes === undefined ? "–" : (bytes / 1e6).toFixed(0));
  bench.table({
    title,
    note: "Processor time of the page's own thread, the engine's workers apart; memory of the page with its workers.",
    head: [unit, "grow", "s in all", "grow", "s of the thread", "grow", "longest task, s", "heap, MB", "memory, MB", "grow"],
    rows: runs.map(({ size, seconds, thread, longest, heap, memory }) => {
      const most = (MOST_GROWTH * first.thread * size) / first.size;
      return [
        size.toLocaleString("en"),
        growth(size, first.size),
        seconds.toFixed(1),
        growth(seconds, first.seconds),
        { text: thread.toFixed(2), bar: `≤ ${most.toFixed(2)}`, met: thread <= most },
        growth(thread, first.thread),
        longest.toFixed(2),
        megabytes(heap),
        megabytes(memory),
        growth(memory, first.memory),
      ];
    }),
  });
}
