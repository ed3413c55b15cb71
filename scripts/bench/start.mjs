// What a visitor waits for: what crosses the wire, and when the page answers.

import { spawn } from "node:child_process";
import { createServer } from "node:net";
import { brotliCompressSync } from "node:zlib";
import { chromium } from "@playwright/test";
import { buildPage } from "../build.mjs";
import { median } from "../lib/bench.mjs";
import { BROWSER_FLAGS, ensureBrowser, findBrowser } from "../lib/browser.mjs";
import { ROOT, npmCommand } from "../lib/paths.mjs";

export const name = "start";
export const about = "a first visit on this machine, the processor slowed down four times";

const THROTTLING = 4;

/**
 * Tells, in the page, when it can be used (its tabs are there and the thread is free to answer) and
 * when the sample has been scored and drawn.
 */
function watch() {
  window.moments = {};
  const look = () => {
    const { moments } = window;
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

export async function measure(bench, { quick }) {
  await buildPage();
  await ensureBrowser();
  const port = await freePort();
  const server = spawn(
    process.execPath,
    [npmCommand("vite/bin/vite.js"), "preview", "--host", "127.0.0.1", "--port", String(port), "--strictPort"],
    { cwd: ROOT, stdio: "ignore" },
  );
  const browser = await chromium.launch({ executablePath: findBrowser(), args: BROWSER_FLAGS });
  try {
    const visits = [];
    for (let visit = 0; visit < (quick ? 2 : 6); visit += 1) {
      visits.push(await firstVisit(browser, `http://127.0.0.1:${port}/`));
    }
    // The first one warms the browser up.
    const [{ bytes }, ...warm] = visits;
    const of = (moment) => median(warm.map((moments) => moments[moment])) / 1000;
    bench.figure("over the wire until scored, brotli", bytes / 1000, "kB", { most: 500, digits: 1 });
    bench.figure("until the page can be used", of("usable"), "s", { most: 1.5 });
    bench.figure("until the sample is scored and drawn, in software", of("scored"), "s");
  } finally {
    await browser.close();
    server.kill();
  }
}

async function firstVisit(browser, address) {
  // What is fetched for later, to work offline, is not part of the start.
  const context = await browser.newContext({ serviceWorkers: "block", viewport: { width: 1280, height: 720 } });
  try {
    const page = await context.newPage();
    const session = await context.newCDPSession(page);
    await session.send("Emulation.setCPUThrottlingRate", { rate: THROTTLING });
    await page.addInitScript(watch);
    const responses = [];
    page.on("response", (response) => responses.push(response));
    await reach(page, address);
    await page.waitForFunction(() => window.moments.scored);
    const bodies = await Promise.all(responses.map((response) => response.body()));
    const bytes = bodies.reduce((sum, body) => sum + brotliCompressSync(body).length, 0);
    return { ...(await page.evaluate(() => window.moments)), bytes };
  } finally {
    await context.close();
  }
}

async function reach(page, address) {
  for (let attempt = 0; ; attempt += 1) {
    try {
      await page.goto(address);
      return;
    } catch (error) {
      if (attempt === 50) throw error;
      await page.waitForTimeout(200);
    }
  }
}

function freePort() {
  return new Promise((resolve) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });
}
