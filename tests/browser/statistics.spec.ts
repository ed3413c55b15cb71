import { unlink } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { Model, datasetStatistics, type DatasetStatistics } from "../../bin/engine/engine.js";
import { drop, writeAll } from "./support/drop";
import { filesOf } from "./support/engine";
import { expect, open, picture, rows, test } from "./support/test";

const SLOW = 45_000;

const SETS = { training_set: ["flange", "bracket", "gear"], test_set: ["elbow"] } as const;

/** What the engine counts in parts sampled as they are dropped. */
function counted(parts: readonly string[]): DatasetStatistics {
  return datasetStatistics(
    parts.map((part) => {
      const model = Model.generate(part, { spacing: 0.02 });
      const statistics = model.statistics();
      model.free();
      return statistics;
    }),
  );
}

/** The figures of a chart, row by row, as its table has them. */
async function tableOf(page: Page, title: string): Promise<string[][]> {
  await page.getByRole("button", { name: `${title} as a table` }).click();
  const rows = page.getByRole("table", { name: title }).locator("tbody tr");
  return rows.evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
}

test("the sets that are dropped are counted, drawn and read as tables", async ({ page }) => {
  test.setTimeout(180_000);
  const folder = test.info().outputPath("dataset");
  for (const [set, parts] of Object.entries(SETS)) {
    const files = parts.flatMap((part, at) => filesOf(part, `PC${at + 1}`));
    await writeAll(`${folder}/${set}`, files.filter(({ path }) => !path.includes("Imperfect")));
  }
  await page.goto("./?page=statistics");
  await drop(page, [folder]);

  const all = counted([...SETS.training_set, ...SETS.test_set]);
  const status = page.locator(".statistics [role=status]");
  await expect(status).toContainText(
    `4 models, ${all.points.toLocaleString("en")} points, ${all.primitives} true primitives`,
    { timeout: SLOW },
  );
  // Every point of these is in a primitive, which needs no drawing.
  await expect(status).toContainText("every point in a primitive");
  await expect(page.locator(".chart-drawing svg")).toHaveCount(4);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);
  await picture(page, "statistics-light-1280");

  for (const [set, parts] of Object.entries(SETS)) {
    const { types } = counted(parts);
    const bars = await tableOf(page, `Surface types, ${set}`);
    expect(bars.map(([type, count]) => [type, Number(count)])).toEqual(
      Object.entries(types).filter(([type, count]) => type !== "Other" || count > 0),
    );
  }
  const spread = counted(SETS.training_set).pointsPerModel;
  const [training] = (await tableOf(page, "Points per model")).filter(([set]) => set === "training_set");
  expect(training?.slice(1)).toEqual([spread?.min, spread?.median, spread?.max].map((value) => value?.toLocaleString("en")));
  await picture(page, "statistics-tables-1280");

  // A model leads to where it is scored.
  await page.getByRole("button", { name: "test_set/PC1" }).click();
  await expect(page).not.toHaveURL(/page=statistics/);
  await expect(page.getByRole("heading", { name: "test_set/PC1" })).toBeVisible();
});

test("a model that cannot be counted is named, with the reason", async ({ page }) => {
  const folder = test.info().outputPath("mine");
  await writeAll(folder, [...filesOf("flange", "PC1"), ...filesOf("bracket", "PC2")]);
  await open(page);
  await drop(page, [folder]);
  await expect(rows(page)).toHaveCount(2);
  // A file that is gone once it is read again.
  await unlink(`${folder}/pointCloud/PC1.txt`);
  await page.getByRole("link", { name: "Statistics" }).click();
  await expect(page.locator(".statistics [role=status]")).toContainText(/^1 model, .*; 1 model could not be counted$/, { timeout: SLOW });
  await page.getByText("1 model of 2 could not be counted").click();
  await expect(page.locator(".uncounted li")).toHaveText(/^PC1 \S+/);
  await picture(page, "statistics-uncounted");
});

test("the statistics fit a phone", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await page.goto("./?page=statistics");
  await expect(page.locator(".statistics [role=status]")).toContainText("1 model", { timeout: SLOW });
  await picture(page, "statistics-light-360");
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
});
