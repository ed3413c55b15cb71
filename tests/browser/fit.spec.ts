import { join } from "node:path";
import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import { expect, measuresIn, open, picture, row, rows, test } from "./support/test";
import { filesOf, scoreOfFit } from "./support/engine";
import { drop, writeAll } from "./support/drop";
import { contentOf, RIGHT } from "./support/pixels";

/** Fitting beside a software renderer takes its time. */
const FITTED = { timeout: 45_000 };

async function openFit(page: Page): Promise<Locator> {
  await page.getByRole("tab", { name: "Fit", exact: true }).click();
  const panel = page.getByRole("tabpanel");
  await expect(panel.getByLabel("Tolerance", { exact: true })).toBeVisible();
  return panel;
}

async function choose(panel: Locator, method: "HT" | "PG"): Promise<void> {
  await panel.getByRole("radio", { name: method }).check({ force: true });
}

function fits(page: Page): Locator {
  return page.locator("table.fits tbody tr");
}

/** Drops models made of one part, each in a folder layout of its own name. */
async function dropModels(page: Page, names: readonly string[], spacing: number): Promise<void> {
  const folder = test.info().outputPath("models");
  await writeAll(folder, names.flatMap((name) => filesOf("bracket", name, { spacing })));
  await drop(page, [folder]);
  await expect(rows(page)).toHaveCount(names.length, FITTED);
}

for (const method of ["HT", "PG"] as const) {
  test(`a fit of the sample with ${method} is scored and shown like any submission`, async ({ page }) => {
    await open(page);
    const model = (await rows(page).getByRole("rowheader").first().textContent()) ?? "";
    const panel = await openFit(page);
    await choose(panel, method);
    await panel.getByRole("button", { name: `Fit ${model}`, exact: true }).click();
    await expect(fits(page)).toContainText(/0\.\d{4}|1\.0000/, FITTED);
    await expect(page.locator(".stage-head").getByRole("radio", { name: method })).toBeChecked();
    await expect(page.locator(".canvas-state")).toHaveCount(0, FITTED);
    const right = await contentOf(page, page.locator(".canvas-box canvas"), RIGHT);
    expect(right.hues).toBeGreaterThan(4);
    await picture(page, `fit-${method.toLowerCase()}`);
    await page.getByRole("tab", { name: "Measures" }).click();
    const scored = row(page, model).filter({ hasText: method });
    expect(await measuresIn(scored)).toEqual(scoreOfFit(model, method).mean);
  });
}

test("how long a fit takes is told before it begins, and better after the first one here", async ({ page }) => {
  await open(page);
  await dropModels(page, ["PC1", "PC2", "PC3"], 0.03);
  const panel = await openFit(page);
  const outlook = panel.getByTestId("fit-outlook");
  await expect(outlook).toHaveText(/^[\d,]+ points take (?:under|up to) \d+ s, on an ordinary computer; the more noise, the longer\. All 3 models: .*\d s\.$/);
  await panel.getByRole("button", { name: "Fit PC1", exact: true }).click();
  await expect(fits(page)).toContainText(/\d\.\d{4}/, FITTED);
  await expect(outlook).toContainText(", by 1 fit with HT done here;");
  await picture(page, "fit-outlook");
  await choose(panel, "PG");
  await expect(outlook).toContainText(", on an ordinary computer;");
});

test("a parameter changed is heeded, shown as changed, and reset alone or with all others", async ({ page }) => {
  await open(page);
  const panel = await openFit(page);
  const smallest = panel.getByLabel("Smallest", { exact: true });
  const initial = await smallest.inputValue();
  const reset = panel.getByRole("button", { name: /^Reset Smallest/ });
  await expect(reset).toBeDisabled();
  await smallest.fill("1000");
  await reset.click();
  await expect(smallest).toHaveValue(initial);
  await smallest.fill("1000");
  await panel.getByLabel("Seed", { exact: true }).fill("7");
  await choose(panel, "PG");
  await expect(panel.getByLabel("Smallest", { exact: true })).toHaveValue(initial);
  await choose(panel, "HT");
  await expect(smallest).toHaveValue("1000");
  await panel.getByRole("button", { name: "Reset all" }).click();
  await expect(smallest).toHaveValue(initial);
  await expect(panel.getByLabel("Seed", { exact: true })).toHaveValue("1");
});

test("a value out of its range keeps the fit from starting", async ({ page }) => {
  await open(page);
  const panel = await openFit(page);
  await panel.getByLabel("Tolerance", { exact: true }).fill("0.5");
  await panel.getByRole("button", { name: /^Fit / }).click();
  await expect(fits(page)).toHaveCount(0);
  const message = await panel.getByLabel("Tolerance", { exact: true }).evaluate((input: HTMLInputElement) => input.validationMessage);
  expect(message).not.toBe("");
});

test("all models are fitted, each with its result; the same settings again replace it, others add to it", async ({ page }) => {
  await open(page);
  await dropModels(page, ["PC1", "PC2", "PC3"], 0.03);
  const panel = await openFit(page);
  await choose(panel, "PG");
  const all = panel.getByRole("button", { name: "Fit all 3 models" });
  await all.click();
  await expect(fits(page)).toHaveText([/PC1.*PG.*\d\.\d{4}/, /PC2.*PG.*\d\.\d{4}/, /PC3.*PG.*\d\.\d{4}/], FITTED);
  await all.click();
  await expect(fits(page)).toHaveText([/PC1PG\d.*\d\.\d{4}/, /PC2PG\d.*\d\.\d{4}/, /PC3PG\d.*\d\.\d{4}/], FITTED);
  await panel.getByLabel("Smallest", { exact: true }).fill("12");
  await panel.getByRole("button", { name: "Fit PC1", exact: true }).click();
  await expect(fits(page)).toHaveText([/PC1.*PG 2.*\d\.\d{4}/], FITTED);
  await panel.getByRole("button", { name: "Remove PG 2 of PC1" }).click();
  await expect(fits(page)).toContainText("removed");
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(rows(page).filter({ hasText: "PG" })).toHaveCount(3);
});

test("a fit is cancelled at any moment and the model is as it was", async ({ page }) => {
  await open(page);
  const folder = test.info().outputPath("large");
  const files = filesOf("housing", "PC1", { spacing: 0.003 });
  await writeAll(folder, files);
  await drop(page, [folder]);
  await expect(row(page, "PC1")).toBeVisible(FITTED);
  const before = await measuresIn(row(page, "PC1"));
  const panel = await openFit(page);
  await panel.getByRole("button", { name: "Fit PC1", exact: true }).click();
  await expect(page.locator(".status").getByRole("status").filter({ hasText: "HT fits PC1" })).toHaveCount(1);
  // Not waiting for the button to stand still: progress moves it, and the fit is soon over.
  await panel.getByRole("button", { name: "Cancel" }).dispatchEvent("click");
  await expect(fits(page)).toContainText("stopped");
  await expect(page.locator(".status progress")).toHaveCount(0);
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(rows(page)).toHaveCount(1);
  expect(await measuresIn(row(page, "PC1"))).toEqual(before);
});

test("a noisy cloud without ground truth is fitted: the panel leads there and ends in an answer, no scores", async ({ page }) => {
  await open(page);
  const folder = test.info().outputPath("alone");
  const noisy = filesOf("bracket", "PC5", { noise: 0.002, outliers: 0.02 });
  await writeAll(folder, noisy.filter(({ path }) => path === "pointCloud/PC5.txt"));
  await drop(page, [join(folder, "pointCloud/PC5.txt")]);
  await expect(page.locator(".models > ul li")).toContainText("points only");
  const ways = page.getByRole("region", { name: "What can be done" });
  await expect(ways).toContainText("1 model has points only.");
  expect((await new AxeBuilder({ page }).include(".panels").analyze()).violations).toEqual([]);
  await ways.getByRole("button", { name: "Find the primitives" }).click();
  const panel = page.getByRole("tabpanel");
  await panel.getByRole("button", { name: "Fit PC5", exact: true }).click();
  await expect(fits(page)).toContainText("no truth", FITTED);
  await expect(page.locator(".canvas-state")).toHaveCount(0, FITTED);
  expect((await contentOf(page, page.locator(".canvas-box canvas"), RIGHT)).hues).toBeGreaterThan(3);

  const answer = panel.getByRole("region", { name: "What HT found in PC5" });
  await expect(answer).toContainText(/\d primitives in PC5/);
  await expect(answer).toContainText(/[\d.]+ in units of the file, 0\.\d % of the diagonal, measured\./);
  await expect(answer).toContainText(/standard error/);
  await expect(answer).toContainText(/\d points \([\d.]+ %\): on no surface that was found/);
  await expect(answer).toContainText("Where the noise of the scanner is known, give it under Noise.");
  expect((await new AxeBuilder({ page }).include(".panels").analyze()).violations).toEqual([]);
  await picture(page, "fit-answer");
  const all = (await contentOf(page, page.locator(".canvas-box canvas"), RIGHT)).hues;
  await answer.getByRole("button", { name: "Show only these" }).click();
  await expect.poll(async () => (await contentOf(page, page.locator(".canvas-box canvas"), RIGHT)).hues).toBeLessThan(2);
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await contentOf(page, page.locator(".canvas-box canvas"), RIGHT)).hues).toBe(all);

  await page.getByRole("tab", { name: "Primitives" }).click();
  const found = page.locator("table.primitives tbody tr");
  await expect(found.first()).toContainText(/Plane|Cylinder/);
  await found.first().getByRole("button").click();
  await expect(found.first()).toHaveAttribute("aria-current", "true");
  await picture(page, "fit-without-truth");
});

test("the panel is worked by keyboard alone", async ({ page }) => {
  await open(page);
  const panel = await openFit(page);
  await panel.getByRole("radio", { name: "HT" }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(panel.getByRole("radio", { name: "PG" })).toBeChecked();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await expect(fits(page)).toHaveCount(1);
  await expect(page.locator(".status .notice")).toContainText(/PG found \d+ primitives/, FITTED);
});

for (const [name, width, height, colorScheme] of [
  ["dark", 1280, 800, "dark"],
  ["narrow", 360, 740, "light"],
  ["wide", 1920, 1080, "light"],
] as const) {
  test(`the panel fits a window: ${name}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width, height });
    await open(page);
    const panel = await openFit(page);
    await panel.getByRole("button", { name: /^Fit / }).click();
    await expect(fits(page)).toContainText(/0\.\d{4}|1\.0000/, FITTED);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
    await picture(page, `fit-${name}`);
  });
}

test("where a fit may take minutes, one of some points is proposed that takes seconds and labels all", async ({ page }) => {
  test.setTimeout(300_000);
  await open(page);
  const side = 875;
  const points = Array.from({ length: side * side }, (_, at) => `${at % side} ${Math.floor(at / side)} 0`).join("\n");
  const folder = test.info().outputPath("large");
  await writeAll(folder, [{ path: "sheet.xyz", text: points }]);
  await drop(page, [folder]);
  await expect(page.locator(".stage-title")).toContainText("765,625 points", { timeout: 120_000 });
  const panel = await openFit(page);
  await expect(panel.getByTestId("fit-outlook")).toContainText(/200,000 of them take \d+ to 20 s; all points are labelled by what is found\./);
  await panel.getByRole("button", { name: "Fit 200,000 of its points" }).click();
  await expect(page.locator(".stage-head").getByRole("radio", { name: "HT on 200000 points" })).toBeChecked({ timeout: 120_000 });
  await page.getByRole("tab", { name: "Primitives" }).click();
  await expect(page.getByRole("tabpanel")).toContainText("765,625", { timeout: 60_000 });
});
