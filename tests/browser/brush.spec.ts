// A range of the histogram of distances: its points stand out in the picture, and their number is said.

import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import { contentOf, RIGHT } from "./support/pixels";
import { expect, open, picture, test } from "./support/test";

async function openChart(page: Page): Promise<Locator> {
  await open(page);
  await page.getByRole("tab", { name: "Charts" }).click();
  const chart = page.locator('[data-chart="distances"]');
  await expect(chart.locator(".bins rect").first()).toBeVisible();
  return chart;
}

/** Coloured share of the right view. */
async function coloured(page: Page): Promise<number> {
  return (await contentOf(page, page.locator(".canvas-box canvas"), RIGHT)).coloured;
}

/** Drags over the intervals from one to another, of 24. */
async function dragOver(page: Page, chart: Locator, from: number, to: number): Promise<void> {
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.locator(".chart-box").boundingBox();
  if (!box) throw new Error("no chart");
  const at = (bin: number) => box.x + 48 + ((box.width - 64) * (bin + 0.5)) / 24;
  const y = box.y + box.height / 2;
  await page.mouse.move(at(from), y);
  await page.mouse.down();
  await page.mouse.move(at(to), y, { steps: 6 });
  await page.mouse.up();
}

const numbers = (text: string | null) => [...(text ?? "").matchAll(/([\d,]+) points? of/g)].map(([, digits]) => Number(digits?.replaceAll(",", "")));

test("dragging over a range of the histogram leaves its points alone in colour and says how many, until Escape", async ({ page }) => {
  const chart = await openChart(page);
  const all = await coloured(page);
  await dragOver(page, chart, 20, 23);
  const words = page.locator(".brushed");
  await expect(words).toContainText(/^Distances .+ to .+: [\d,]+ points of Truth, [\d,]+ points of Imperfect/);
  await expect.poll(() => coloured(page)).toBeLessThan(0.7 * all);
  await picture(page, "brush");

  // As many as the bars are high.
  const said = numbers(await words.textContent());
  await chart.getByRole("button", { name: /as a table$/ }).click();
  const rows = await chart.locator("tbody tr").evaluateAll((found) => found.map((row) => [...row.children].slice(1).map((cell) => Number(cell.textContent.replaceAll(",", "")))));
  const sums = [0, 1].map((side) => rows.slice(20).reduce((sum, row) => sum + (row[side] ?? 0), 0));
  expect(said).toEqual(sums);
  expect(sums[1]).toBeGreaterThan(0);
  await chart.getByRole("button", { name: /as a table$/ }).click();

  // A drag is no click on a bar.
  await expect(page.locator(".selection-tools")).toHaveCount(0);
  await page.locator("body").press("Escape");
  await expect(words).toHaveCount(0);
  await expect.poll(() => coloured(page)).toBeGreaterThan(0.98 * all);
});

test("the handles of the range are moved by keyboard, and axe finds nothing", async ({ page }) => {
  const chart = await openChart(page);
  const from = chart.getByRole("slider", { name: "Distances from" });
  const to = chart.getByRole("slider", { name: "Distances to" });
  await from.focus();
  for (let step = 0; step < 3; step++) await page.keyboard.press("PageUp");
  await expect(from).toHaveAttribute("aria-valuenow", "12");
  const words = page.locator(".brushed");
  await expect(words).toContainText(`Distances ${await from.getAttribute("aria-valuetext")} to `);
  const before = numbers(await words.textContent());
  await to.focus();
  await page.keyboard.press("ArrowLeft");
  await expect(to).toHaveAttribute("aria-valuenow", "23");
  await expect.poll(async () => numbers(await words.textContent())).not.toEqual(before);
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    for (const [width, height] of [[1440, 900], [360, 740]] as const) {
      await page.setViewportSize({ width, height });
      await chart.evaluate((element) => element.scrollIntoView({ block: "end" }));
      await picture(page, `brush-${width}-${colorScheme}`);
    }
    expect((await new AxeBuilder({ page }).include(".panels").analyze()).violations).toEqual([]);
  }
  await to.focus();
  await page.keyboard.press("Escape");
  await expect(words).toHaveCount(0);
  await expect(to).toHaveAttribute("aria-valuenow", "24");
});
