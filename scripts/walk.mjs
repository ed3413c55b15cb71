// Walks the page through its main states and leaves a picture of each: `npm run walk [-- STATE…]`.
// To be looked at; what must hold is in tests/browser.

import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { buildPage } from "./build.mjs";
import { ROOT } from "./lib/paths.mjs";
import { Plain, main, say } from "./lib/run.mjs";
import { withServedPage } from "./lib/served.mjs";
import { setup } from "./setup.mjs";

/** @typedef {import("@playwright/test").Page} Page */

/** Phone, tablet, small and usual laptop, large screen; the last as a laptop at 200 % shows it. */
const WINDOWS = [
  { name: "360", width: 360, height: 740 },
  { name: "768", width: 768, height: 1024 },
  { name: "1366", width: 1366, height: 768 },
  { name: "1440", width: 1440, height: 900 },
  { name: "1920", width: 1920, height: 1080 },
  { name: "200-percent", width: 720, height: 450 },
];
const SCHEMES = /** @type {const} */ (["light", "dark"]);

/** @param {Page} page */
const scored = (page) => page.locator("table.scores tbody tr").first().waitFor();
/** @param {string} id */
const panel = (id) => async (/** @type {Page} */ page) => {
  await scored(page);
  await page.locator(`#tab-${id}`).click();
};
/** @param {string} what */
const coloured = (what) => async (/** @type {Page} */ page) => {
  await scored(page);
  await page.getByRole("combobox", { name: "Colour" }).selectOption(what);
};
/** @param {string} id @param {string} button */
const pressed = (id, button) => async (/** @type {Page} */ page) => {
  await panel(id)(page);
  await page.getByRole("tabpanel").getByText(button, { exact: true }).click();
};
/** @param {Page} page */
const fitted = async (page) => {
  await pressed("fit", "Fit bracket")(page);
  await page.locator(".answer").waitFor({ timeout: 60_000 });
};
/** @param {string} key */
const key = (key) => async (/** @type {Page} */ page) => {
  await scored(page);
  await page.keyboard.press(key);
};
/** @param {Page} page */
const live = (page) => page.locator(".lesson-live canvas").first().waitFor({ timeout: 60_000 });

/** What is walked: the address, and what is done there. @type {Record<string, { at: string, act?: (page: Page) => Promise<void> }>} */
const STATES = {
  opening: { at: "", act: scored },
  alone: { at: "", act: key("v") },
  folded: { at: "", act: key("d") },
  add: { at: "", act: key("o") },
  share: { at: "", act: key("s") },
  keys: { at: "", act: key("?") },
  ...Object.fromEntries(
    ["primitives", "overlooked", "charts", "fit", "diagnostics", "audit", "comparison", "field", "section", "files"].map((id) => [id, { at: "", act: panel(id) }]),
  ),
  fitted: { at: "", act: fitted },
  tree: { at: "", act: pressed("primitives", "By type") },
  cut: { at: "", act: pressed("section", "Cut across z") },
  ...Object.fromEntries(["figure", "distance", "type", "normal"].map((what) => [`by-${what}`, { at: "", act: coloured(what) }])),
  results: { at: "?page=results" },
  lessons: { at: "?page=lessons" },
  ...Object.fromEntries(
    ["score", "hough", "growing", "forms", "protocols", "cad"].map((id) => [`lesson-${id}`, { at: `?page=lesson-${id}`, act: live }]),
  ),
  studio: { at: "?page=studio" },
  statistics: { at: "?page=statistics" },
};

await main(async () => {
  const asked = process.argv.slice(2);
  const unknown = asked.find((name) => !(name in STATES));
  if (unknown !== undefined) throw new Plain(`there is no state ${unknown}; there are ${Object.keys(STATES).join(", ")}`);
  await setup();
  await buildPage();
  const folder = join(ROOT, "tests/screenshots/walk");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  let complaints = 0;
  await withServedPage(async ({ address, browser }) => {
    for (const { name: size, width, height } of WINDOWS) {
      for (const colorScheme of SCHEMES) {
        for (const [name, { at, act }] of Object.entries(STATES)) {
          if (asked.length > 0 && !asked.includes(name)) continue;
          const page = await browser.newPage({ viewport: { width, height }, colorScheme });
          page.on("console", (message) => {
            if (message.type() !== "error") return;
            complaints += 1;
            say(`${name} at ${size}: ${message.text()}`);
          });
          await page.goto(address + at);
          await act?.(page);
          await page.waitForTimeout(1500);
          await page.screenshot({ path: join(folder, `${name}-${size}-${colorScheme}.png`) });
          await page.close();
        }
      }
    }
  });
  say(`the pictures are in ${folder}`);
  if (complaints > 0) throw new Plain(`the console was not quiet: ${complaints} errors`);
});
