import { brotliCompressSync } from "node:zlib";
import type { Response } from "@playwright/test";
import { expect, open, rows, test } from "./support/test";

/** The most that a first visit may take before the page is in use, in bytes as served. */
const FIRST_LOAD = 325_000;

test("after the first visit the page opens, scores and shows every panel without a network", async ({ page, context }) => {
  await open(page);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await expect
    .poll(() => page.evaluate(async () => (await caches.keys()).length), { message: "kept files" })
    .toBeGreaterThan(0);
  await context.setOffline(true);
  await page.reload();
  await expect(rows(page).first()).toBeVisible();
  for (const panel of await page.getByRole("tab").all()) {
    await panel.click();
    await expect(page.getByRole("tabpanel")).not.toBeEmpty();
  }
});

test("the page asks nobody but its own host for anything", async ({ page, baseURL }) => {
  const foreign: string[] = [];
  page.on("request", (request) => {
    const address = request.url();
    if (/^https?:/.test(address) && !address.startsWith(String(baseURL))) foreign.push(address);
  });
  const refused: string[] = [];
  await page.addInitScript(() =>
    document.addEventListener("securitypolicyviolation", (event) => console.error(`refused ${event.blockedURI}`)),
  );
  page.on("console", (message) => {
    if (message.text().startsWith("refused")) refused.push(message.text());
  });
  await open(page);
  for (const panel of await page.getByRole("tab").all()) await panel.click();
  expect(foreign).toEqual([]);
  expect(refused).toEqual([]);
});

test("a first visit fetches at most 325 kB, and neither charts nor fitters before they are wanted", async ({ browser }) => {
  // The service worker fetches the rest later, when the page is in use.
  const context = await browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  // By address: each worker asks for the engine, and the browser has it from the first one's answer.
  const responses = new Map<string, Response>();
  page.on("response", (response) => responses.set(new URL(response.url()).pathname, response));
  const modules = () => [...responses.keys()].filter((name) => name.endsWith(".wasm"));
  await open(page);
  const first = await Promise.all([...responses.values()].map((response) => response.body()));
  const sizes = first.map((body) => brotliCompressSync(body).length);
  expect(modules()).toHaveLength(2);
  expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThanOrEqual(FIRST_LOAD);

  const before = responses.size;
  await page.getByRole("tab", { name: "Charts" }).click();
  await expect(page.locator(".charts svg").first()).toBeVisible();
  expect(responses.size).toBeGreaterThan(before);
  expect(modules()).toHaveLength(2);
  await page.getByRole("tab", { name: "Fit", exact: true }).click();
  await expect(page.getByLabel("Tolerance", { exact: true })).toBeVisible();
  expect(modules()).toHaveLength(2);
  await page.getByRole("tabpanel").getByRole("button", { name: /^Fit / }).click();
  await expect.poll(modules).toHaveLength(3);
  await context.close();
});
