import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import { expect, open, picture, rows, test } from "./support/test";
import { filesOf, scoreOf } from "./support/engine";
import { dropFiles } from "./support/sharing";

const PARTS = ["bracket", "flange", "housing"] as const;
const FILES = PARTS.map((part, at) => filesOf(part, `PC${at + 1}`));

async function openCharts(page: Page): Promise<void> {
  await open(page);
  await dropFiles(page, "three", FILES.flat());
  await expect(rows(page)).toHaveCount(3);
  await page.getByRole("tab", { name: "Charts" }).click();
  await expect(chart(page, "classification").locator("svg")).toBeVisible();
}

function chart(page: Page, name: string): Locator {
  return page.locator(`[data-chart="${name}"]`);
}

/** Row heads and cells of the table that a chart is read as. */
async function tableOf(figure: Locator): Promise<string[][]> {
  await figure.getByRole("button", { name: /as a table$/ }).click();
  return figure.locator("tbody tr").evaluateAll((found) => found.map((row) => [...row.children].map((cell) => cell.textContent)));
}

test("every chart is drawn, in light, in dark and on a phone, and axe finds nothing", async ({ page }) => {
  await openCharts(page);
  const names = ["classification", "MFE", "dHaus", "d1", "types", "confusion", "size", "distances"];
  for (const name of names) await expect(chart(page, name).getByRole("img")).toBeVisible();
  await expect(chart(page, "classification").locator(".boxes rect")).toHaveCount(6);
  await expect(chart(page, "classification").locator(".models-dots circle")).toHaveCount(18);
  for (const scheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width: 1440, height: 2000 });
    await picture(page, `charts-${scheme}`);
    expect((await new AxeBuilder({ page }).include(".charts").analyze()).violations).toEqual([]);
  }
  await page.setViewportSize({ width: 360, height: 740 });
  await page.locator(".charts").evaluate((element) => element.scrollIntoView());
  for (const name of ["classification", "confusion", "distances"]) {
    await chart(page, name).scrollIntoViewIfNeeded();
    const fits = await chart(page, name).evaluate((element) => element.getBoundingClientRect().right <= innerWidth);
    expect(fits, `${name} fits the phone`).toBe(true);
    await picture(page, `charts-phone-${name}`);
  }
});

test("the tables hold the engine's figures", async ({ page }) => {
  await openCharts(page);
  const reports = FILES.map((files) => scoreOf(files));
  const dsc = reports.map(({ mean }) => mean.DSC ?? NaN).sort((a, b) => a - b);
  const [row] = await tableOf(chart(page, "classification"));
  const median = dsc[1] ?? NaN;
  const quartiles = [((dsc[0] ?? NaN) + median) / 2, median, (median + (dsc[2] ?? NaN)) / 2];
  const mean = dsc.reduce((sum, value) => sum + value, 0) / 3;
  const figures = [dsc[0] ?? NaN, ...quartiles, dsc[2] ?? NaN, mean].map((value) => value.toFixed(4));
  expect(row).toEqual(["DSC", "Imperfect", "3", ...figures]);

  const truths = reports.flatMap(({ primitives }) => primitives);
  const types = await tableOf(chart(page, "types"));
  expect(types.find(([name]) => name === "Plane")?.[1]).toBe(String(truths.filter(({ type }) => type === "Plane").length));
  const confusion = await tableOf(chart(page, "confusion"));
  const counted = confusion.flatMap(([, ...cells]) => cells.map(Number));
  expect(counted.reduce((sum, count) => sum + count, 0)).toBe(truths.length);
  const sizes = await tableOf(chart(page, "size"));
  expect(sizes.map(([, , size]) => Number(size?.replaceAll(",", "")))).toEqual(truths.map(({ size }) => size));
  const listed = (histogram: string[][]) => histogram.reduce((sum, [, truth]) => sum + Number(truth?.replaceAll(",", "")), 0);
  const sum = reports[0]?.primitives.reduce((sum, { size }) => sum + size, 0);
  const distances = await tableOf(chart(page, "distances"));
  expect(listed(distances)).toBe(sum);
  // On a linear axis they are the same points.
  const farthest = distances.at(-1)?.[0] ?? "";
  await chart(page, "distances").getByRole("button", { name: /logarithmic axis$/ }).click();
  await expect(chart(page, "distances").locator("tbody tr").last()).not.toContainText(farthest);
  const linear = await chart(page, "distances")
    .locator("tbody tr")
    .evaluateAll((found) => found.map((row) => [...row.children].map((cell) => cell.textContent)));
  expect(listed(linear)).toBe(sum);
  await chart(page, "distances").getByRole("button", { name: /as a table$/ }).click();
  await expect(chart(page, "distances").locator(".bins rect").first()).toBeVisible();
  const logged = chart(page, "d1").getByRole("button", { name: /logarithmic axis$/ });
  await expect(logged).toHaveAttribute("aria-pressed", "true");
  const dots = () => chart(page, "d1").locator(".models-dots circle").evaluateAll((all) => all.map((dot) => dot.getAttribute("cy")));
  const before = await dots();
  await logged.click();
  await expect.poll(dots).not.toEqual(before);
});

test("a click on a dot goes to its model, on a primitive to it, and the histogram follows", async ({ page }) => {
  await openCharts(page);
  const heading = page.locator(".stage h2");
  await expect(heading).toHaveText("PC1");
  await chart(page, "MFE").locator(".models-dots circle", { hasText: /^PC3 by/ }).click({ force: true });
  await expect(heading).toHaveText("PC3");

  await chart(page, "size").locator(".primitives-dots circle", { hasText: /^PC2, / }).first().dispatchEvent("click");
  await expect(heading).toHaveText("PC2");
  await expect(chart(page, "distances")).toContainText("true primitive 1 of PC2");
  await page.getByRole("tab", { name: "Primitives" }).click();
  await expect(page.locator("table.primitives tbody tr[aria-current]").first()).toBeVisible();
  await page.getByRole("tab", { name: "Charts" }).click();

  // The wrong cells lead to the primitives that they count, one after the other.
  const cell = chart(page, "confusion").locator(".cells rect").first();
  await cell.click();
  const first = await chart(page, "distances").locator("h3").textContent();
  await cell.click();
  await expect(chart(page, "distances").locator("h3")).not.toHaveText(first ?? "");

  await page.getByRole("radio", { name: /^Only PC/ }).check({ force: true });
  await expect(chart(page, "size").locator("h3")).toHaveText(/Imperfect, PC\d$/);
});

test("a saved chart is a drawing of its own, with title, description and no style sheet", async ({ page }) => {
  await openCharts(page);
  const save = async (name: string) => {
    const saved = page.waitForEvent("download");
    await chart(page, name).getByRole("button", { name: /^Save / }).click();
    const file = await saved;
    expect(file.suggestedFilename()).toBe(`fit4cad-${name}.svg`);
    return readFile(await file.path(), "utf8");
  };
  for (const name of ["MFE", "dHaus", "d1", "types", "confusion", "size", "distances"]) {
    expect(await save(name)).toMatch(/^<svg .*<title>.+<\/title><desc>.+<\/desc><metadata>\{"engine":".+","protocol":"definition","files":\[\{"path":.+"sha256":"[0-9a-f]{64}"\}\]\}<\/metadata>/s);
  }
  const text = await save("classification");
  // In an empty page: the policy of ours lets no text become a document.
  const empty = await page.context().newPage();
  const drawing = await empty.evaluate((source) => {
    const parsed = new DOMParser().parseFromString(source, "image/svg+xml");
    const count = (selector: string) => parsed.querySelectorAll(selector).length;
    return {
      root: parsed.documentElement.nodeName,
      title: parsed.querySelector("svg > title")?.textContent,
      described: (parsed.querySelector("svg > desc")?.textContent ?? "").length > 0,
      boxes: count(".boxes rect"),
      dots: count(".models-dots circle"),
      styles: count("style, script"),
    };
  }, text);
  expect(drawing).toEqual({
    root: "svg",
    title: "Classification measures over models",
    described: true,
    boxes: 6,
    dots: 18,
    styles: 0,
  });
  expect(text).not.toContain("var(");
});
