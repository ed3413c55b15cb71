// The browser of the tests: a Chromium or Chrome that is there already, else one that is fetched.

import { accessSync, constants, existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { chromium } from "@playwright/test";
import { npmCommand } from "./paths.mjs";
import { Plain, run, runNode, say } from "./run.mjs";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const PLACES = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  join(process.env.PROGRAMFILES ?? "C:\\Program Files", "Google\\Chrome\\Application\\chrome.exe"),
];

/** Software rendering, so that WebGL works without a graphics card, and no calls home. */
export const BROWSER_FLAGS = [
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  // Chromium's sandbox refuses to run as root.
  ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
];

/** Path of a usable browser, or undefined. `FIT4CAD_BROWSER` names one outright. */
export function findBrowser() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const onPath = folders.flatMap((folder) => NAMES.map((name) => join(folder, name)));
  const chosen = process.env.FIT4CAD_BROWSER;
  return [...(chosen ? [chosen] : []), ...onPath, ...PLACES, chromium.executablePath()].find(
    isExecutable,
  );
}

/** Finds a browser or fetches one; throws with what to do when nothing works. */
export async function ensureBrowser() {
  if (findBrowser()) {
    return;
  }
  say("no Chromium or Chrome was found; fetching Playwright's own");
  await attempt(() => runNode(npmCommand("@playwright/test/cli.js"), ["install", "chromium"]));
  if (!findBrowser() && process.getuid?.() === 0 && existsSync("/usr/bin/apt-get")) {
    say("that did not work; installing Debian's chromium");
    await attempt(() => run("apt-get", ["update", "-qq"]));
    await attempt(() => run("apt-get", ["install", "-y", "-qq", "chromium"]));
  }
  if (!findBrowser()) {
    throw new Plain(
      "The browser tests need Chromium or Chrome, and none could be installed. " +
        "Install one, or set FIT4CAD_BROWSER to the path of its executable.",
    );
  }
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/**
 * A way of installing may fail; the next one is tried.
 * @param {() => Promise<unknown>} install
 */
async function attempt(install) {
  try {
    await install();
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
  }
}
