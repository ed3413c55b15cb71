import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import { expect, open, picture, row, test } from "./support/test";
import { filesOf } from "./support/engine";
import { dropFiles } from "./support/sharing";
import { squares } from "./support/squares";

test("a model is set beside the published methods only if it is the test model, or the reader says so", async ({ page }) => {
  await open(page);
  await dropFiles(page, "namesake", filesOf("bracket", "PC1"));
  await expect(row(page, "PC1")).toBeVisible();
  await page.getByRole("tab", { name: "Comparison" }).click();
  const panel = page.locator(".comparison");
  await expect(panel).toContainText("None of the models here is one of the 35 test models");
  await expect(panel).toContainText(/named like PC1, but not that model: \d+ points for 7500/);
  await expect(panel.locator("table")).toHaveCount(0);
  await panel.getByLabel("Which test model PC1 is").selectOption("PC1");
  await expect(panel.getByRole("row", { name: /PC1, as you say/ })).toBeVisible();
});

test("differences carry sign, mark and colour, and wins are counted", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", [...squares("PC1", 7500, 8), ...squares("PC2", 20621, 17)]);
  await expect(row(page, "PC2")).toBeVisible();
  await page.getByRole("tab", { name: "Comparison" }).click();
  const panel = page.locator(".comparison");
  const first = panel.getByRole("row", { name: /^PC1 / });
  // A perfect score against the published 0.986624.
  const dsc = first.locator(".difference").first();
  await expect(dsc).toHaveText("+0.0134 ▲better");
  await expect(dsc).toHaveAttribute("data-outcome", "better");
  await expect(panel.getByRole("row", { name: /^Won, lost, even/ }).getByRole("cell").first()).toHaveText("2, 0, 0");
  await expect(panel.getByRole("row", { name: /^Mean of the published HT/ }).getByRole("cell").first()).toHaveText("0.9540");
  await picture(page, "comparison-light");
  await page.getByLabel("with the published").selectOption("PG");
  await expect(dsc).toHaveText("+0.6301 ▲better");
  await expect(first).toContainText("n/a");
  await page.getByRole("radio", { name: "Published" }).check({ force: true });
  await expect(first.locator("td[title^='1.0000 against 0.6925, 0.693 in the paper']")).toHaveCount(1);
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "comparison-dark");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("an own HT is told from the published one, losses come first and shaded, a row opens its model, and all of it is saved", async ({ page }) => {
  const named = (files: ReturnType<typeof squares>) => files.map(({ path, text }) => ({ path: path.replace("MINE", "HT"), text }));
  await open(page);
  await dropFiles(page, "mine", [...named(squares("PC1", 7500, 8)), ...named(squares("PC2", 20621, 17))]);
  await expect(row(page, "PC2")).toBeVisible();
  await page.getByRole("tab", { name: "Comparison" }).click();
  const panel = page.locator(".comparison");
  await expect(panel.locator("caption")).toContainText("Your HT minus the published HT");
  await expect(panel.locator("select").first().locator("option").first()).toHaveText("your HT");
  await expect(panel.getByRole("row", { name: /^Mean of your HT/ }).getByRole("cell").first()).toHaveText("1.0000");
  await expect(panel.getByRole("columnheader", { name: /DSC/ })).toHaveAttribute("aria-sort", "ascending");

  const names = panel.locator("tbody .row-name");
  const [first, last] = [panel.locator("tbody tr").first(), panel.locator("tbody tr").last()];
  await expect(first.locator(".difference").first()).toHaveText("+0.0134 ▲better");
  const heat = (of: typeof first) => of.locator("td[data-heat=better]").first().evaluate((cell) => Number(cell.style.getPropertyValue("--heat")));
  expect(await heat(first)).toBeLessThan(await heat(last));
  expect(await heat(last)).toBe(1);

  await expect(names).toHaveText(["PC1", "PC2"]);
  await names.last().click();
  await expect(panel.locator("tr[aria-current=true]")).toContainText("PC2");
  await expect(page.locator(".stage")).toContainText("PC2");

  for (const [title, extension, words] of [
    ["CSV", "csv", "your HT minus the published HT,PC1,PC1,0.013"],
    ["Markdown", "md", "| PC1 | PC1 | 0.0134 |"],
    ["LaTeX", "tex", "PC1 & PC1 & $0.0134$"],
  ] as const) {
    const saved = page.waitForEvent("download");
    await panel.getByRole("button", { name: `Save the comparison as ${title}` }).click();
    const file = await saved;
    expect(file.suggestedFilename()).toBe(`fit4cad-HT-against-published-HT.${extension}`);
    expect(await readFile(await file.path(), "utf8")).toContain(words);
  }
});
