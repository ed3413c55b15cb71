// What a visitor waits for: what crosses the wire, and when the page answers.

import { brotliCompressSync } from "node:zlib";
import { buildPage } from "../build.mjs";
import { median } from "../lib/bench.mjs";
import { withServedPage } from "../lib/served.mjs";

export const name = "start";
export const about = "a first visit on this machine, the processor slowed down four times";

const THROTTLING = 4;

/** @typedef {{ usable?: number, scored?: number }} Moments in milliseconds */

/** The page's window with what is taken in it. @typedef {Window & { moments: Moments }} Watched */

/**
 * Tells, in the page, when it can be used (its tabs are there and the thread is free to answer) and
 * when the sample has been scored and drawn.
 */
function watch() {
  /** @type {Moments} */
  const moments = {};
  Object.assign(window, { moments });
  const look = () => {
    if (!moments.usable && document.querySelector("[role=tab]")) {
      moments.usable = -1;
      setTimeout(() => (moments.usable = performance.now()));
    }
    const drawn = document.querySelector(".canvas-box canvas") && !document.querySelector(".canvas-state");
    if (!moments.scored && drawn && document.querySelector("table.scores tbody tr")) moments.scored = performance.now();
    if (!moments.scored) requestAnimationFrame(look);
  };
  look();
}

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {import("../bench.mjs").Options} options
 */
export async function measure(bench, { quick }) {
  await buildPage();
  await withServedPage(async ({ address, browser }) => {
    /** @type {Awaited<ReturnType<typeof firstVisit>>[]} */
    const visits = [];
    for (let visit = 0; visit < (quick ? 2 : 6); visit += 1) visits.push(await firstVisit(browser, address));
    // The first one warms the browser up.
    const [first, ...warm] = visits;
    /** @param {keyof Moments} moment */
    const of = (moment) => median(warm.map((moments) => moments[moment] ?? NaN)) / 1000;
    bench.figure("over the wire until scored, brotli", (first?.bytes ?? NaN) / 1000, "kB", { most: 325, digits: 1 });
    bench.figure("until the page can be used", of("usable"), "s", { most: 1.5 });
    bench.figure("until the sample is scored and drawn, in software", of("scored"), "s");
  });
}

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {string} address
 */
async function firstVisit(browser, address) {
  // What is fetched for later, to work offline, is not part of the start.
  const context = await browser.newContext({ serviceWorkers: "block", viewport: { width: 1280, height: 720 } });
  try {
    const page = await context.newPage();
    const session = await context.newCDPSession(page);
    await session.send("Emulation.setCPUThrottlingRate", { rate: THROTTLING });
    await page.addInitScript(watch);
    // By address: a second worker has the engine from the first one's answer.
    /** @type {Map<string, import("@playwright/test").Response>} */
    const responses = new Map();
    page.on("response", (response) => responses.set(response.url(), response));
    await page.goto(address);
    await page.waitForFunction(() => /** @type {Watched} */ (/** @type {unknown} */ (window)).moments.scored);
    const bodies = await Promise.all([...responses.values()].map((response) => response.body()));
    const bytes = bodies.reduce((sum, body) => sum + brotliCompressSync(body).length, 0);
    return { ...(await page.evaluate(() => /** @type {Watched} */ (/** @type {unknown} */ (window)).moments)), bytes };
  } finally {
    await context.close();
  }
}
