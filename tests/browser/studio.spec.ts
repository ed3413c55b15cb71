import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import { unzipSync } from "fflate";
import { FIRST, MAX_BLOCKS, type Block, type Case } from "../../www/app/studio/case";
import { writeCase } from "../../www/app/studio/link/link";
import { drop, writeAll } from "./support/drop";
import { filesOf } from "./support/engine";
import { expect, picture, rows, test } from "./support/test";

/** Making a case takes a while beside a software renderer. */
const SLOW = 45_000;

async function openStudio(page: Page, fragment = ""): Promise<void> {
  await page.goto(`./?page=studio${fragment}`);
  await expect(standing(page)).toContainText("points", { timeout: SLOW });
}

const standing = (page: Page) => page.locator(".studio-view .picture-tools [role=status]");
const press = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: typeof name === "string" }).click();
const cuts = (page: Page) => page.getByRole("list", { name: "Cuts" }).getByRole("listitem");

/** What is said of the case once it is made. */
async function made(page: Page): Promise<{ points: number; primitives: number }> {
  await expect(standing(page)).toHaveText(/^[\d,]+ points, \d+ primitives/, { timeout: SLOW });
  const [points = "", primitives = ""] = ((await standing(page).textContent()) ?? "").match(/\d[\d,]*/g) ?? [];
  return { points: Number(points.replaceAll(",", "")), primitives: Number(primitives) };
}

/** Waits until there are as many points as said. */
async function madeOf(page: Page, points: number): Promise<void> {
  await expect(standing(page)).toContainText(`${points.toLocaleString("en")} points`, { timeout: SLOW });
}

async function fill(page: Page, name: string, value: number | string): Promise<void> {
  const field = page.getByLabel(name, { exact: true });
  await field.fill(String(value));
  await field.press("Enter");
}

async function lasso(page: Page, from: readonly [number, number], to: readonly [number, number]): Promise<void> {
  await page.getByRole("radio", { name: "Lasso" }).check({ force: true });
  const box = await page.locator(".lasso").boundingBox();
  if (!box) throw new Error("no lasso");
  const at = ([x, y]: readonly [number, number]) => [box.x + x * box.width, box.y + y * box.height] as const;
  const corners = [from, [to[0], from[1]], to, [from[0], to[1]]] as const;
  await page.mouse.move(...at(from));
  await page.mouse.down();
  for (const corner of corners) await page.mouse.move(...at(corner), { steps: 5 });
  await page.mouse.up();
}

async function accessible(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);
}

async function linkIn(page: Page): Promise<string> {
  return page.getByLabel("Link", { exact: true }).inputValue();
}

test("a case is composed, worn, cut, undone, sent, saved and scored", async ({ page }) => {
  test.setTimeout(240_000);
  await openStudio(page);
  await accessible(page);
  const first = await made(page);

  // Blocks: a ball on top adds a primitive, a wrong size is said and undone.
  await page.getByLabel("Shape of the new block").selectOption("sphere");
  await press(page, "Add block");
  await fill(page, "position z of block 4", 60);
  await expect(standing(page)).toContainText(`${first.primitives + 1} primitives`, { timeout: SLOW });
  const whole = await made(page);
  await fill(page, "radius of block 4", 0);
  await expect(page.getByRole("alert")).toContainText("block 4 (Sphere): its radius must be positive");
  await expect(page.getByRole("button", { name: "Save files" })).toBeDisabled();
  await page.locator("body").press("Control+z");
  await expect(page.getByRole("alert")).toHaveCount(0);
  await madeOf(page, whole.points);

  // Sampling.
  await fill(page, "Outliers", 0.1);
  await madeOf(page, Math.round(whole.points * 1.1));

  // A ball, without a pointer, and a lasso right across the view.
  const strewn = await made(page);
  await page.getByRole("radio", { name: "Ball" }).check({ force: true });
  for (const [name, value] of [["Centre x", 0], ["Centre y", 0], ["Centre z", 60], ["Radius", 25]] as const) {
    await fill(page, name, value);
  }
  await page.getByRole("button", { name: /^Cut [\d,]+ points$/ }).press("Enter");
  await expect(cuts(page)).toHaveCount(1);
  await expect(standing(page)).toContainText("is gone", { timeout: SLOW });
  await expect(cuts(page).first()).toContainText(/Ball 1 of radius 25: [\d,]+ points; primitive \d+ is gone/);
  const holed = await made(page);
  expect(holed.points).toBeLessThan(strewn.points);
  expect(holed.primitives).toBe(whole.primitives - 1);
  await lasso(page, [0.1, 0.1], [0.5, 0.9]);
  await expect(cuts(page)).toHaveCount(2);
  await expect(cuts(page).nth(1)).toContainText(/: [\d,]+ points/, { timeout: SLOW });
  const halved = await made(page);
  expect(halved.points).toBeLessThan(0.8 * holed.points);

  // Everything is undone and done again, and a cut is taken back from the midst.
  await press(page, "Undo");
  await madeOf(page, holed.points);
  await page.locator("body").press("Control+Shift+z");
  await madeOf(page, halved.points);
  await press(page, "Take back Ball 1");
  await expect(cuts(page)).toHaveCount(1);
  await press(page, "Undo");
  await madeOf(page, halved.points);
  await picture(page, "studio-light-1280");
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "studio-dark-1280");
  await page.emulateMedia({ colorScheme: "light" });

  // The link makes the same case again, digit by digit.
  const link = await linkIn(page);
  const saved = await saveFiles(page);
  await page.goto("about:blank");
  await page.goto(link);
  await madeOf(page, halved.points);
  await expect(cuts(page)).toHaveCount(2);
  expect(await saveFiles(page)).toEqual(saved);
  expect(Object.keys(saved).sort()).toEqual(["case.txt", "case_implicit.txt", "case_parametric.txt", "case_primitives.txt", "fit4cad.json"]);

  // On the scoring page it is a model like any other.
  await press(page, "Open it under Score");
  await expect(page.getByRole("heading", { name: "case", exact: true })).toBeVisible({ timeout: SLOW });
  await expect(page.getByRole("tab", { name: "Fit" })).toHaveAttribute("aria-selected", "true");
  await expect(page.locator(".stage-title")).toContainText(`${halved.points.toLocaleString("en")} points`);
  expect(new URL(page.url()).hash, "the case is no longer what the address is about").toBe("");
});

test("a refused number is explained, blocks far apart are warned of, and a rectangle cuts by keyboard", async ({ page }) => {
  await openStudio(page);
  const spacing = page.getByLabel("Spacing");
  await fill(page, "Spacing", 7);
  await expect(page.getByRole("alert")).toHaveText("7 was not taken: Spacing is a number from 0.0005 to 0.1.");
  await expect(spacing).toHaveValue("0.012");
  await picture(page, "studio-refused");
  await spacing.fill("-1");
  await spacing.press("Tab");
  await expect(page.getByRole("alert")).toContainText("-1 was not taken");
  await expect(spacing).toHaveValue("0.012");
  // What is typed and not yet taken over goes with Escape, and so does the message.
  await spacing.fill("0.5");
  await spacing.press("Escape");
  await expect(page.getByRole("alert")).toHaveCount(0);
  await expect(spacing).toHaveValue("0.012");

  const whole = await made(page);
  await page.getByRole("radio", { name: "Lasso" }).check({ force: true });
  await press(page, "place a rectangle");
  const lasso = page.getByRole("application", { name: "Lasso" });
  await expect(lasso).toBeFocused();
  for (const key of ["ArrowRight", "ArrowUp", "Shift+ArrowRight"]) await page.keyboard.press(key);
  await expect(lasso.getByRole("status")).toHaveText(/^Rectangle 32 % wide and 30 % high, its middle 52 % from the left and 48 % from the top: [1-9][\d,]* points inside\.$/);
  await accessible(page);
  await picture(page, "studio-rectangle");
  await page.keyboard.press("Enter");
  await expect(cuts(page).first()).toContainText(/Lasso 1 all the way through: [\d,]+ points/, { timeout: SLOW });
  expect((await made(page)).points).toBeLessThan(whole.points);

  await page.getByRole("radio", { name: "Ball" }).check({ force: true });
  await fill(page, "Point number", 1);
  await fill(page, "Centre x", 3);
  await expect(page.getByLabel("Point number", { exact: true })).toHaveValue("");
  await page.getByRole("button", { name: /Cone/ }).click();
  await fill(page, "position x of block 2", 4000);
  await expect(page.locator(".studio-warning")).toContainText(/primitives have fewer than 10 points/, { timeout: SLOW });
  await picture(page, "studio-thin");
});

/** The files that are saved, by name. */
async function saveFiles(page: Page): Promise<Record<string, string>> {
  const [download] = await Promise.all([page.waitForEvent("download"), press(page, "Save files")]);
  const content = unzipSync(new Uint8Array(await readFile(await download.path())));
  return Object.fromEntries(Object.entries(content).map(([name, bytes]) => [name, new TextDecoder().decode(bytes)]));
}

test("a model of one's own is cut with its truth, and a damaged link says so", async ({ page }) => {
  test.setTimeout(240_000);
  await openStudio(page, "#case=1.AAAA");
  const alert = page.getByRole("alert");
  await expect(alert).toContainText("This link is damaged");
  await accessible(page);
  await alert.getByRole("button", { name: "Close" }).click();
  await expect(alert).toHaveCount(0);

  const folder = test.info().outputPath("mine");
  await writeAll(folder, filesOf("flange", "PC7"));
  await drop(page, [folder]);
  const base = page.getByLabel("Made of");
  await expect(base.locator("option", { hasText: "PC7" })).toHaveCount(1, { timeout: SLOW });
  await base.selectOption({ label: "PC7" });
  const before = await madeAnew(page);
  await expect(page.getByLabel("Spacing")).toBeDisabled();
  await expect(page.getByText("A link can hold what is generated")).toBeVisible();
  await page.getByRole("radio", { name: "Ball" }).check({ force: true });
  await fill(page, "Point number", 1);
  await press(page, /^Cut [\d,]+ points$/);
  await expect(cuts(page)).toHaveCount(1);
  await expect.poll(async () => (await made(page)).points, { timeout: SLOW }).toBeLessThan(before.points);

  // What is saved can be dropped again.
  const saved = await saveFiles(page);
  const again = test.info().outputPath("again");
  await writeAll(again, Object.entries(saved).map(([path, text]) => ({ path, text })));
  await page.goto("./");
  await drop(page, [again]);
  await expect(page.getByRole("heading", { name: "PC7-case" })).toBeVisible({ timeout: SLOW });
  await expect(rows(page).or(page.locator(".stage-title"))).not.toHaveCount(0);
});

async function madeAnew(page: Page): Promise<{ points: number; primitives: number }> {
  await expect(page.getByLabel("Name", { exact: true })).toHaveValue("PC7-case");
  return made(page);
}

test("a link's case that takes long waits to be asked for, and says which engine it was made with", async ({ page }) => {
  test.setTimeout(240_000);
  // Spheres that nearly coincide: where each cuts every other takes minutes to follow.
  const sphere = (at: number): Block => ({ operation: "add", shape: "sphere", sizes: [20 + at / 100], position: [at / 10, 0, 0], rotation: [0, 0, 0] });
  const of: Case = { ...FIRST, base: { kind: "blocks", blocks: Array.from({ length: MAX_BLOCKS }, (_, at) => sphere(at)) }, sampling: { ...FIRST.sampling, spacing: 0.001 } };
  await page.goto(`./?page=studio${writeCase({ of, engine: "0.0.1" })}`);
  const offer = page.locator(".studio-offer");
  await expect(offer).toContainText(/The case of this link takes .* to make: .*64 blocks/, { timeout: SLOW });
  await expect(page.getByText(/The link was made with engine 0\.0\.1, this is engine \d/)).toBeVisible();
  await expect(page.getByRole("button", { name: "Save files" })).toBeDisabled();
  await picture(page, "studio-offer");
  await accessible(page);
  await offer.getByRole("button", { name: "Make it" }).click();
  await expect(offer).toHaveCount(0);
  await press(page, "Stop");
  await expect(page.getByRole("alert")).toContainText("It was stopped.");
});

test("the studio fits a phone", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await openStudio(page);
  await made(page);
  await picture(page, "studio-light-360");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(360);
  const last: Locator = page.getByRole("button", { name: "Copy link" });
  await last.scrollIntoViewIfNeeded();
  await expect(last).toBeInViewport();
});
