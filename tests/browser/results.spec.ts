import { readFileSync } from "node:fs";
import { join } from "node:path";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { compare } from "../../bin/engine/engine.js";
import { benchmarkFiles } from "../../scripts/lib/paths.mjs";
import { rowsOf } from "../../www/shared/formats/measures.mjs";
import type { Scores, SetScores } from "../../www/shared/results/scores.mjs";
import { drop } from "./support/drop";
import { ROOT } from "./support/engine";
import { expect, picture, test } from "./support/test";

/** What a row of the table says it scored. */
function scored(id: string, set = "test-10"): SetScores {
  const scores = JSON.parse(readFileSync(join(ROOT, "results", id, "scores.json"), "utf8")) as Scores;
  const found = scores.sets.find((each) => each.set === set);
  if (!found) throw new Error(`${id} was not scored on ${set}`);
  return found;
}

async function expectNoFindings(page: Page, where: string): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join("\n")}`), where).toEqual([]);
}

async function expectNoOverflow(page: Page, where: string): Promise<void> {
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), where).toBeLessThanOrEqual(0);
}

const standing = (page: Page) => page.getByRole("region", { name: "Standing table" });
const rowNamed = (page: Page, name: string) => standing(page).getByRole("row", { name: new RegExp(`^${name.replaceAll(/[()]/g, "\\$&")}`) });

test("the table is there before anything is dropped: sorted, shaded, compared, and each row opens its method", async ({ page }) => {
  test.setTimeout(240_000);
  await page.goto("./?page=results");
  const names = standing(page).locator("tbody .row-name > span");
  const first = names.first();
  await expect(first).toContainText("(playground)");
  // The opening sample is for pages that show models.
  await expect(page.locator(".status progress")).toHaveCount(0);

  // What stands in the cells is what the row's file says, with its interval.
  const { summary, models } = scored("paper-ht");
  const dsc = summary.definition.DSC;
  const paper = rowNamed(page, "HT (paper)");
  await expect(paper).toContainText(dsc?.mean.toFixed(4) ?? "");
  await expect(paper).toContainText(`${dsc?.interval?.[0].toFixed(4)} – ${dsc?.interval?.[1].toFixed(4)}`);
  await expect(paper).toContainText("mean, as published, native");
  await expect(rowNamed(page, "HT (playground)").locator("strong").first()).toBeVisible();
  const heats = await standing(page).locator("tbody tr").evaluateAll((rows) => rows.map((row) => getComputedStyle(row.querySelectorAll(".shaded")[1] ?? row).getPropertyValue("--heat")));
  expect(heats.map(Number)).toEqual([...heats].map(Number).sort((one, other) => other - one));
  await expect(page.locator('[data-chart="accuracy-against-time"] svg')).toBeVisible();
  await expectNoFindings(page, "table, light");
  await picture(page, "results-light-1280");

  await standing(page).getByRole("button", { name: "MFE", exact: true }).press("Enter");
  await expect(standing(page).locator("th[aria-sort]")).toContainText("MFE");
  await page.getByRole("radio", { name: "Protocols of the field" }).check({ force: true });
  await expect(rowNamed(page, "HT (paper)")).toContainText(summary.figures.spfn?.mean.toFixed(4) ?? "");

  // Two methods: what the engine makes of both, model by model.
  await page.locator(".results-page").getByRole("radio", { name: "Definition" }).check({ force: true });
  const pair = page.getByRole("region", { name: "Two methods compared" });
  const [one, other] = [pair.getByRole("combobox").first(), pair.getByRole("combobox").last()];
  await one.selectOption("fit4cad-ht");
  await other.selectOption("paper-ht");
  const figures = (entries: SetScores["models"]) => rowsOf(entries.map((entry) => (measure) => entry.definition[measure]));
  const expected = compare(figures(scored("fit4cad-ht").models), figures(models)).find(({ measure }) => measure === "DSC");
  const compared = pair.getByRole("row", { name: /^DSC/ });
  await expect(compared).toContainText(`${expected?.better}, ${expected?.even}, ${expected?.worse}`);
  await expect(compared).toContainText(expected?.test?.probability.toFixed(4) ?? "");
  await expect(compared).toContainText(`+${expected?.mean?.by.toFixed(4)} ▲better`);

  await page.getByRole("radio", { name: "Clean and degraded" }).check({ force: true });
  await expect(rowNamed(page, "HT (playground)")).toContainText(scored("fit4cad-ht", "test-10-noise").summary.definition.DSC?.mean.toFixed(4) ?? "");
  await expect(standing(page).getByRole("columnheader", { name: "DSC: uneven density" })).toBeVisible();
  await expect(rowNamed(page, "PG (playground)")).toContainText(scored("fit4cad-pg", "test-10-density").summary.definition.DSC?.mean.toFixed(4) ?? "");
  await page.emulateMedia({ colorScheme: "dark" });
  await expectNoFindings(page, "table, dark");
  await page.setViewportSize({ width: 360, height: 740 });
  await expectNoOverflow(page, "table");
  await picture(page, "results-dark-360");

  // A row opens its method's page, which has an address of its own.
  await rowNamed(page, "HT (paper)").getByRole("button").press("Enter");
  await expect(page.getByRole("heading", { name: "HT (paper)" })).toBeVisible();
  expect(new URL(page.url()).search).toBe("?page=results&method=paper-ht");
  const every = page.getByRole("region", { name: "Every model" });
  await expect(every.locator("tbody tr")).toHaveCount(10);
  const worst = [...models].sort((one, other) => (one.definition.DSC ?? 0) - (other.definition.DSC ?? 0))[0];
  await expect(page.locator(".results-worst li").first()).toContainText(`${worst?.model} DSC ${worst?.definition.DSC?.toFixed(4)}`);
  await page.getByText("BibTeX of the paper", { exact: true }).click();
  await expect(page.getByRole("region", { name: "BibTeX of the paper" })).toContainText("@article{romanengo2022fit4cad,");
  await expectNoOverflow(page, "method");
  await expectNoFindings(page, "method, dark, 360");
  await picture(page, "results-method-dark-360");
  await page.setViewportSize({ width: 1920, height: 1080 });
  await picture(page, "results-method-dark-1920");
  await page.goBack();
  await expect(standing(page)).toBeVisible();
  await picture(page, "results-dark-1920");
});

test("a row is opened as claimed figures, which the same files verify to the last digit", async ({ page }) => {
  const files = benchmarkFiles();
  test.skip(files === undefined, "the benchmark's files are not in ../shared/fit4cad");
  await page.goto("./?page=results&method=paper-ht");
  await page.getByRole("button", { name: "Open the claimed figures to be verified" }).click();
  const banner = page.getByRole("region", { name: "Shared link" });
  await expect(banner).toContainText("As claimed. 10 shared results, 10 not recomputed.");
  expect(new URL(page.url()).search).toBe("");
  await drop(page, [join(files ?? "", "test_sample")]);
  await expect(banner).toContainText("Verified here. 10 shared results: the same files, scored on this computer, gave every digit.", { timeout: 90_000 });
  await picture(page, "results-verified");
});

test("the worst models are drawn once their files are on the page, and nothing else is called by their names", async ({ page }) => {
  const files = benchmarkFiles();
  test.skip(files === undefined, "the benchmark's files are not in ../shared/fit4cad");
  await page.goto("./");
  await drop(page, [join(files ?? "", "test_sample")]);
  await page.getByRole("navigation").getByRole("link", { name: "Results", exact: true }).click();
  await rowNamed(page, "HT (paper)").getByRole("button").click();
  const worst = page.locator(".results-worst li");
  await expect(worst).toHaveCount(5);
  await expect(worst.first().getByRole("img", { name: /Points of PC\d+ coloured by primitive: truth/ })).toBeVisible({ timeout: 60_000 });
  await expect(page.locator(".results-worst").getByRole("img")).toHaveCount(10, { timeout: 60_000 });
  await expect(page.getByText("The table keeps figures alone.")).toHaveCount(0);
  // Two pictures of one cloud in other colours: as many pixels are drawn, and not all alike.
  const [truth, found] = await worst.first().locator("canvas").evaluateAll((all) =>
    all.map((canvas) => {
      const { data } = (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, 440, 330) ?? { data: [] };
      const inks = Array.from({ length: data.length / 4 }, (_, at) => (data[4 * at + 3] === 0 ? "" : `${data[4 * at]} ${data[4 * at + 1]} ${data[4 * at + 2]}`));
      return { drawn: inks.filter((ink) => ink !== "").length, colours: new Set(inks).size, all: inks.join() };
    }),
  );
  expect(truth?.drawn).toBeGreaterThan(2000);
  expect(found?.drawn).toBe(truth?.drawn);
  expect(truth?.colours).toBeGreaterThan(2);
  expect(found?.all).not.toBe(truth?.all);
  await expectNoFindings(page, "worst models, drawn");
  await page.locator(".results-worst").scrollIntoViewIfNeeded();
  await picture(page, "results-worst");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.setViewportSize({ width: 360, height: 740 });
  await expectNoOverflow(page, "worst models, drawn");
  await page.locator(".results-worst").scrollIntoViewIfNeeded();
  await picture(page, "results-worst-dark-360");
  // The same names with other answers are no picture of this row.
  await page.goto("./?page=results&method=fit4cad-ht");
  await expect(page.locator(".results-worst li").first()).toBeVisible();
  await expect(page.locator(".results-worst canvas")).toHaveCount(0);
});

test("the table is embedded without the rest of the page, and says where the whole is", async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 480 });
  await page.goto("./?embed=results");
  await expect(standing(page).locator("tbody tr").first()).toBeVisible();
  await expect(page.getByRole("button", { name: "Add data" })).toHaveCount(0);
  await expect(standing(page).locator(".shaded").first()).toHaveCSS("display", "block");
  await expect(page.getByRole("link", { name: "Open full" })).toHaveAttribute("href", /\?page=results$/);
  await expectNoFindings(page, "embedded");
  await picture(page, "results-embedded");
  await rowNamed(page, "HT (paper)").getByRole("button").click();
  await expect(page.getByRole("heading", { name: "HT (paper)" })).toBeVisible();
  await expect(page.getByRole("link", { name: "Open full" })).toHaveAttribute("href", /\?page=results&method=paper-ht$/);
  const feed = await page.request.get("results/feed.json");
  expect(((await feed.json()) as { items: unknown[] }).items.length).toBeGreaterThanOrEqual(5);
});
