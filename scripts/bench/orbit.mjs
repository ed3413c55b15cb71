// Turning a million points: what the processor does for a frame. The graphics card's share is left
// out, since most machines that run this have none.

import { buildPage } from "../build.mjs";
import { median } from "../lib/bench.mjs";
import { withServedPage } from "../lib/served.mjs";

export const name = "orbit";
export const about = "a generated part of a million points, turned with the mouse";

const PART = "Countersunk plate";
const SPACING = "0.001";
const STEPS = 120;

/** @typedef {{ frames: number[], idle: boolean, uploaded: number }} Measured frames in milliseconds, uploads in bytes */

/** The page's window with what is measured in it. @typedef {Window & { measured: Measured }} Watched */

/** Takes the time of every frame; once told to, keeps what is drawn from the software renderer. */
function watch() {
  /** @type {number[]} */
  const frames = [];
  /** @type {Measured} */
  const measured = { frames, idle: false, uploaded: 0 };
  Object.assign(window, { measured });
  /** @type {Record<string, (...details: unknown[]) => unknown>} */
  const context = Object(WebGL2RenderingContext.prototype);
  for (const name of ["drawArrays", "drawElements", "drawArraysInstanced"]) {
    const draw = context[name];
    context[name] = function (...details) {
      if (!measured.idle) draw?.apply(this, details);
    };
  }
  for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D"]) {
    const upload = context[name];
    context[name] = function (...details) {
      for (const detail of details) measured.uploaded += ArrayBuffer.isView(detail) ? detail.byteLength : 0;
      return upload?.apply(this, details);
    };
  }
  const request = window.requestAnimationFrame;
  window.requestAnimationFrame = (step) =>
    request.call(window, (now) => {
      const start = performance.now();
      step(now);
      frames.push(performance.now() - start);
    });
}

/** @param {import("../lib/bench.mjs").Bench} bench */
export async function measure(bench) {
  await buildPage();
  await withServedPage(async ({ address, browser }) => {
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
    await page.addInitScript(watch);
    await page.goto(address);
    await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
    await page.getByLabel("Spacing").fill(SPACING);
    const asked = performance.now();
    await page.getByRole("button", { name: new RegExp(`^${PART}`) }).click();
    const points = page.locator(".stage-title p", { hasText: /\d,\d{3},\d{3} points/ });
    await points.waitFor({ timeout: 120_000 });
    await page.locator(".canvas-state").waitFor({ state: "detached", timeout: 120_000 });
    bench.note((await points.textContent()) ?? "");
    bench.figure("made, scored and opened", (performance.now() - asked) / 1000, "s");

    await atRest(page);
    await page.evaluate(() => (/** @type {Watched} */ (/** @type {unknown} */ (window)).measured.idle = true));
    const { x, y } = (await page.locator(".canvas-box canvas").boundingBox()) ?? { x: 0, y: 0 };
    await page.mouse.move(x + 200, y + 100);
    await page.mouse.down();
    await page.mouse.move(x + 201, y + 100);
    await page.evaluate(() => {
      const { measured } = /** @type {Watched} */ (/** @type {unknown} */ (window));
      measured.frames.length = 0;
      measured.uploaded = 0;
    });
    for (let step = 0; step < STEPS; step += 1) await page.mouse.move(x + 200 + step, y + 100 + (step % 20));
    await page.mouse.up();
    const { frames, uploaded } = await page.evaluate(() => /** @type {Watched} */ (/** @type {unknown} */ (window)).measured);
    const sorted = [...frames].sort((a, b) => a - b);
    bench.figure("a frame, median", median(frames), "ms", { most: 4 });
    bench.figure("a frame, the slowest of twenty", sorted[Math.floor(0.95 * sorted.length)] ?? NaN, "ms");
    bench.figure("sent to the graphics card for them all", uploaded / 1000, "kB", { digits: 1 });
  });
}

/**
 * Resolves when nothing more comes for the view: normals are computed after the points are shown.
 * @param {import("@playwright/test").Page} page
 */
async function atRest(page) {
  for (let before = -1, uploaded = 0; uploaded !== before; ) {
    before = uploaded;
    await page.waitForTimeout(5000);
    uploaded = await page.evaluate(() => /** @type {Watched} */ (/** @type {unknown} */ (window)).measured.uploaded);
  }
}
