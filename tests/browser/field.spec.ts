import { readFileSync } from "node:fs";
import AxeBuilder from "@axe-core/playwright";
import { FIGURES } from "../../www/generated/declared/figures.js";
import { STRATA } from "../../www/generated/declared/strata.js";
import { expect, open, picture, row, test } from "./support/test";
import { filesOf, METHOD } from "./support/engine";
import { dropFiles } from "./support/sharing";

const PROTOCOLS = FIGURES.filter(({ group }) => group === "segmentation");

/** What is looked at of a saved file. */
interface Saved {
  readonly results: readonly {
    readonly model: string;
    readonly method: string;
    readonly figures: readonly { readonly figure: string; readonly protocol: string; readonly engine: string }[];
    readonly files: readonly { readonly sha256: string }[];
  }[];
}

/** Two models with an imperfect submission, and one more that is the truth. */
function files() {
  return ["bracket", "flange"].flatMap((part, at) => {
    const own = filesOf(part, `PC${at + 1}`);
    const exact = own
      .filter(({ path }) => path.includes("_") && !path.includes(`_${METHOD}`))
      .map(({ path, text }) => ({ path: path.replace("/", "_EXACT/"), text }));
    return [...own, ...exact];
  });
}

test("methods stand against protocols, with places, certainty and what each rewards", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", files());
  await expect(row(page, "PC2").first()).toBeVisible();
  await page.getByRole("button", { name: "All…" }).click();
  const panel = page.locator(".field-panel");
  const exact = panel.getByRole("row", { name: /^EXACT/ }).first();
  await expect(exact).toContainText("2 models");
  for (const { title, rewards } of PROTOCOLS) {
    await expect(panel.getByRole("columnheader", { name: title, exact: false }).first()).toBeVisible();
    await expect(panel.locator(".rewards")).toContainText(rewards);
  }
  await expect(exact).toContainText("place 11.0000");
  const other = panel.getByRole("row", { name: new RegExp(`^${METHOD}`) }).first();
  await expect(other).toContainText("place 2");
  await expect(other).toContainText("95 % intervalmedianquartiles");
  // Two models of two methods: wins, and how likely they are by chance.
  await expect(panel.getByRole("row", { name: /SPFN/ }).last()).toContainText(/2, 0, 0|0, 0, 2|1, 1, 0/);
  await panel.evaluate((element) => element.scrollIntoView());
  await picture(page, "field-light");
  // As at the command line: every figure with protocol, unit and engine, and the hashes of the files.
  const saved = page.waitForEvent("download");
  await panel.getByRole("button", { name: "Save figures as JSON" }).click();
  const file = await (await saved).path();
  const { results } = JSON.parse(readFileSync(file, "utf8")) as Saved;
  expect(results.map(({ model, method }) => `${model} ${method}`)).toEqual(["PC1 EXACT", `PC1 ${METHOD}`, "PC2 EXACT", `PC2 ${METHOD}`]);
  for (const { figures, files: read } of results) {
    expect(figures.map(({ figure }) => figure)).toEqual(FIGURES.map(({ key }) => key));
    expect(figures.every(({ protocol, engine }) => protocol !== "" && engine !== "")).toBe(true);
    expect(read.every(({ sha256 }) => /^[0-9a-f]{64}$/.test(sha256))).toBe(true);
  }
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "field-dark");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("the rules of a protocol are told in full on demand, by keyboard", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", files());
  await expect(row(page, "PC2").first()).toBeVisible();
  await page.getByRole("tab", { name: "Protocols" }).click();
  const parsenet = page.locator(".rewards summary", { hasText: "ParseNet" });
  await parsenet.focus();
  await page.keyboard.press("Enter");
  await expect(page.locator(".rewards details[open]")).toContainText("one perfect face alone scores 1");
});

test("lengths are told in the unit that is chosen, and figures follow", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", files());
  await expect(row(page, "PC2").first()).toBeVisible();
  await page.getByRole("tab", { name: "Protocols" }).click();
  await page.locator(".field-panel").getByRole("radio", { name: "Figures of fit" }).check({ force: true });
  const panel = page.locator(".field-panel");
  await expect(panel.getByRole("columnheader", { name: /^Residual \(of the unit sphere's radius\)/ })).toBeVisible();
  const residual = panel.getByRole("row", { name: new RegExp(`^${METHOD}`) }).first().locator("td").nth(2);
  const before = await residual.textContent();
  await panel.getByLabel("Lengths over").selectOption("cloud");
  await expect(panel.getByRole("columnheader", { name: /^Residual \(of the cloud's diagonal\)/ })).toBeVisible();
  await expect(residual).not.toHaveText(before ?? "");
  await panel.getByLabel("ε").selectOption("0.05");
  await expect(panel.getByRole("columnheader", { name: /P-coverage \(ε = 0\.05/ })).toBeVisible();
  await picture(page, "field-fit");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("primitives are told apart by what they are and by the conditions of their models, in a chart and tables", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", files());
  await expect(row(page, "PC2").first()).toBeVisible();
  await page.getByRole("tab", { name: "Protocols" }).click();
  const panel = page.locator(".field-panel");
  await panel.getByRole("radio", { name: "Strata" }).check({ force: true });
  await panel.getByRole("combobox", { name: "By", exact: true }).selectOption("type");
  await expect(panel.getByRole("row", { name: /^Plane/ }).first()).toBeVisible();
  // A bar for each row of the table.
  const rows = await panel.getByRole("table").first().locator("tbody tr").count();
  await expect(panel.locator(".strata-bars rect")).toHaveCount(rows);
  // Whatever is measured is told how; figures stand beside it by model.
  for (const { name, strata, how, isCondition } of STRATA) {
    await panel.getByRole("combobox", { name: "By", exact: true }).selectOption(name);
    await expect(panel.locator(".note").first()).toContainText(how);
    await expect(panel.getByRole("table").first().getByRole("rowheader").first()).toHaveText(new RegExp(`^(${strata.map(escaped).join("|")})$`));
    await expect(panel.getByRole("table")).toHaveCount(isCondition ? 3 : 1);
  }
  await panel.getByRole("combobox", { name: "By", exact: true }).selectOption("noise");
  await expect(panel.getByRole("row", { name: /^noise < 0\.001 % of the diagonal/ }).first()).toBeVisible();
  await picture(page, "field-strata");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("segments are told by type and measured, of all and by stratum", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", files());
  await expect(row(page, "PC2").first()).toBeVisible();
  await page.getByRole("tab", { name: "Protocols" }).click();
  const panel = page.locator(".field-panel");
  await panel.getByRole("radio", { name: "Segments" }).check({ force: true });
  const exact = panel.getByRole("row", { name: /^EXACT/ }).first();
  await expect(exact).toContainText("1.0000");
  for (const head of ["PPV", "NPV", "TPR", "TNR", "ACC", "L2 of parameters (mixed units)"]) {
    await expect(panel.getByRole("columnheader", { name: head }).first()).toBeVisible();
  }
  await panel.getByLabel("Lengths over").selectOption("none");
  await expect(panel.getByRole("columnheader", { name: "MFE (in the file's units)" }).first()).toBeVisible();
  await panel.getByRole("combobox", { name: "By", exact: true }).selectOption("type");
  await expect(panel.getByRole("table").nth(1).getByRole("row", { name: /^Plane/ }).first()).toBeVisible();
  await picture(page, "field-segments");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

function escaped(text: string): string {
  return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

test("the panel fits a narrow window", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 800 });
  await open(page);
  await dropFiles(page, "mine", files());
  // The header has no room for the way there: the sheet on the protocols has it.
  await page.getByRole("button", { name: "What the protocols are" }).click();
  await page.getByRole("button", { name: "The protocols of the field, side by side" }).click();
  await expect(page.locator(".field-panel table").first()).toBeVisible();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  await page.locator(".panel").evaluate((panel) => panel.scrollIntoView());
  await picture(page, "field-360");
});
