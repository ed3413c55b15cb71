import { defineConfig } from "@playwright/test";
import { BROWSER_FLAGS, findBrowser } from "./scripts/lib/browser.mjs";

// Playwright reads this file again in each of its workers, which inherit the chosen port.
process.env.FIT4CAD_PORT ??= String(20_000 + (process.pid % 20_000));
const port = Number(process.env.FIT4CAD_PORT);

export default defineConfig({
  testDir: "tests/browser",
  outputDir: "tests/results",
  // An index of the pictures that the tests take.
  globalTeardown: "./tests/browser/support/gallery.ts",
  fullyParallel: true,
  // The tests share the processor with a software renderer.
  workers: 1,
  timeout: 120_000,
  // Waiting costs nothing where things are quick.
  expect: { timeout: 20_000 },
  // A second chance for a starved machine; the summary counts what needed it.
  retries: 1,
  forbidOnly: process.env.CI !== undefined,
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    // A button that is gone fails its test long before the test's own time is over.
    actionTimeout: 60_000,
    screenshot: "only-on-failure",
    launchOptions: {
      executablePath: findBrowser(),
      args: BROWSER_FLAGS,
    },
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --host 127.0.0.1 --port ${port} --strictPort`,
    port,
  },
});
