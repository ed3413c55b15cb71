// The built page, served, and a browser to look at it with.

import { spawn } from "node:child_process";
import { createServer } from "node:net";
import { setTimeout as pause } from "node:timers/promises";
import { chromium } from "@playwright/test";
import { BROWSER_FLAGS, ensureBrowser, findBrowser } from "./browser.mjs";
import { ROOT, npmCommand } from "./paths.mjs";
import { Plain } from "./run.mjs";

/**
 * Serves www/dist and starts a browser while `body({ address, browser })` runs.
 * @param {(served: { address: string, browser: import("@playwright/test").Browser }) => Promise<void>} body
 */
export async function withServedPage(body) {
  await ensureBrowser();
  const port = await freePort();
  const server = spawn(
    process.execPath,
    [npmCommand("vite/bin/vite.js"), "preview", "--host", "127.0.0.1", "--port", String(port), "--strictPort"],
    { cwd: ROOT, stdio: "ignore" },
  );
  try {
    const address = `http://127.0.0.1:${port}/`;
    await answered(address);
    const browser = await chromium.launch({ executablePath: findBrowser(), args: BROWSER_FLAGS });
    try {
      await body({ address, browser });
    } finally {
      await browser.close();
    }
  } finally {
    server.kill();
  }
}

/** @param {string} address */
async function answered(address) {
  for (let attempt = 0; attempt < 100; attempt += 1) {
    try {
      await fetch(address);
      return;
    } catch {
      await pause(100);
    }
  }
  throw new Plain("The page's server did not answer.");
}

/** @returns {Promise<number>} */
function freePort() {
  return new Promise((resolve) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const address = probe.address();
      probe.close(() => resolve(typeof address === "object" && address ? address.port : 0));
    });
  });
}
