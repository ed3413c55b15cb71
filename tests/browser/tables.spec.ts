import { expect, open, picture, row, rows, test } from "./support/test";
import { filesOf, scoreOf } from "./support/engine";
import { drop, writeAll } from "./support/drop";
import { contentOf, LEFT, RIGHT } from "./support/pixels";

test("the summary sorts by a measure, both ways and back", async ({ page }) => {
  const folder = test.info().outputPath("three");
  const parts = ["bracket", "flange", "housing"] as const;
  for (const [at, part] of parts.entries()) await writeAll(folder, filesOf(part, `PC${at + 1}`));
  await open(page);
  await drop(page, [folder]);
  await expect(rows(page)).toHaveCount(3);
  const shown = () => rows(page).locator("td:nth-child(6)").allTextContents();
  const asBrought = await shown();
  const head = page.getByRole("columnheader", { name: /DSC/ });
  const sort = head.getByRole("button", { name: "DSC", exact: true });
  await sort.click();
  await expect(head).toHaveAttribute("aria-sort", "descending");
  const descending = await shown();
  expect(descending).toEqual([...asBrought].sort((a, b) => Number(b) - Number(a)));
  await sort.click();
  await expect(head).toHaveAttribute("aria-sort", "ascending");
  expect(await shown()).toEqual([...descending].reverse());
  await sort.click();
  expect(await shown()).toEqual(asBrought);
});

test("the list of models searches and sorts, worst first", async ({ page }) => {
  const folder = test.info().outputPath("list");
  for (const [at, part] of ["bracket", "flange", "housing"].entries()) await writeAll(folder, filesOf(part, `PC${at + 1}`));
  await open(page);
  await drop(page, [folder]);
  await expect(rows(page)).toHaveCount(3);
  const items = page.locator(".models > ul li");
  await page.getByLabel("Search the models").fill("pc2");
  await expect(items).toHaveCount(1);
  await page.getByLabel("Search the models").fill("");
  await page.getByLabel("List by").selectOption("DSC");
  const figures = await items.locator(".figure").allTextContents();
  expect(figures).toEqual([...figures].sort((a, b) => Number(a) - Number(b)));
});

test("selecting a primitive in its table selects it in the view, and Escape takes it back", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Primitives" }).click();
  const first = page.locator("table.primitives tbody tr").first();
  await first.getByRole("rowheader").getByRole("button").click();
  await expect(first).toHaveAttribute("aria-current", "true");
  await page.getByLabel("Colour").selectOption({ label: "TP, FP, FN of the selected" });
  await expect(page.locator(".legend")).toContainText("false negative");
  await picture(page, "outcome");
  await page.locator("body").press("Escape");
  await expect(first).not.toHaveAttribute("aria-current", "true");
});

test("hovering a point tells what it is, and clicking it selects its row", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Primitives" }).click();
  const box = await page.locator(".canvas-box canvas").boundingBox();
  if (!box) throw new Error("no canvas");
  const [x, y] = [box.x + box.width * 0.25, box.y + box.height * 0.55];
  await page.mouse.move(x - 5, y);
  await page.mouse.move(x, y);
  const tooltip = page.locator(".tooltip");
  await expect(tooltip).toContainText(/True \d+: (Plane|Cylinder|Cone|Sphere|Torus)/);
  await picture(page, "hover");
  const number = /True (\d+)/.exec((await tooltip.textContent()) ?? "")?.[1] ?? "";
  await page.mouse.click(x, y);
  const selected = page.locator("table.primitives tbody tr[aria-current]");
  await expect(selected.getByRole("rowheader")).toHaveText(number);
});

test("the rows of a table are walked with the arrow keys", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Primitives" }).click();
  const names = page.locator("table.primitives").first().locator("tbody .row-name");
  await names.first().focus();
  await page.keyboard.press("ArrowDown");
  await expect(names.nth(1)).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.locator("table.primitives tbody tr").nth(1)).toHaveAttribute("aria-current", "true");
  await page.keyboard.press("End");
  await expect(names.last()).toBeFocused();
});

test("every column head explains its measure", async ({ page }) => {
  await open(page);
  for (const measure of ["DSC", "PPV", "TPR", "TNR", "NPV", "ACC", "MFE", "dHaus", "d1"]) {
    await page.getByRole("button", { name: `What ${measure} means` }).click();
    const text = page.getByRole("dialog", { name: `What ${measure} means` });
    await expect(text).toContainText("Range");
    await expect(text).toContainText("Quality indicators");
    if (measure === "MFE") await picture(page, "explanation");
    await page.keyboard.press("Escape");
    await expect(text).toBeHidden();
  }
});

test("a second submission of the same model is scored beside the first", async ({ page }) => {
  const folder = test.info().outputPath("two");
  const files = filesOf("bracket", "PC9");
  const second = files
    .filter(({ path }) => path.includes("Imperfect"))
    .map(({ path, text }) => ({ path: path.replace("Imperfect", "Mine"), text }));
  await writeAll(folder, [...files, ...second]);
  await open(page);
  await drop(page, [folder]);
  await expect(row(page, "PC9")).toHaveCount(2);
  await row(page, "PC9").filter({ hasText: "Mine" }).getByRole("rowheader").getByRole("button").click();
  const [left, right] = [page.getByLabel("Left view"), page.getByLabel("Right view")];
  await expect(right.locator("option:checked")).toHaveText("Mine");
  await expect(left.locator("option:checked")).toHaveText("Truth");

  // Both submissions beside each other, matches in the colour of their true primitive.
  await left.selectOption({ label: "Imperfect" });
  await page.getByLabel("Colour").selectOption({ label: "The paper's figure" });
  await expect(left.locator("option:checked")).toHaveText("Imperfect");
  const canvas = page.locator(".canvas-box canvas");
  await page.getByRole("button", { name: "Display" }).click();
  await page.getByLabel("Depth shading").uncheck();
  await page.keyboard.press("Escape");
  for (const part of [LEFT, RIGHT]) await expect.poll(async () => (await contentOf(page, canvas, part)).black).toBeGreaterThan(0.005);
  await picture(page, "two-submissions");
  // A primitive of the one on the left brings its true primitive and the other's match with it.
  await page.getByLabel("Colour").selectOption({ label: "Segments" });
  await page.getByRole("tab", { name: "Primitives" }).click();
  const box = await canvas.boundingBox();
  if (!box) throw new Error("no canvas");
  await page.mouse.click(box.x + box.width * 0.25, box.y + box.height * 0.55);
  await expect(page.getByRole("group", { name: "Selected primitive" }).locator("strong")).toHaveText(/^Imperfect \d+: /);
  await expect(page.locator("table.primitives tbody tr[aria-current]")).not.toHaveCount(0);
  await right.selectOption({ label: "Truth" });
  await expect(page.getByRole("group", { name: "Selected primitive" }).getByRole("button", { name: "Frame" })).toBeVisible();
  await left.selectOption({ label: "Truth" });
  await expect(page.getByRole("group", { name: "Selected primitive" })).toHaveCount(0);
});

test("the paper's layout sets the methods beside each other, with the means at the foot", async ({ page }) => {
  const folder = test.info().outputPath("paper");
  const parts = ["bracket", "flange"] as const;
  const models = parts.map((part, at) => filesOf(part, `PC${at + 1}`));
  for (const files of models) {
    const copy = files
      .filter(({ path }) => path.startsWith("pointCloud_primitives/"))
      .map(({ path, text }) => ({ path: path.replace("primitives/", "primitives_Copy/"), text }));
    await writeAll(folder, [...files, ...copy]);
  }
  await open(page);
  await drop(page, [folder]);
  await expect(rows(page)).toHaveCount(4);
  const foot = page.locator("table.scores tfoot tr");
  await expect(foot).toHaveCount(2);
  const mean = models.reduce((sum, files) => sum + (scoreOf(files).mean.DSC ?? NaN), 0) / models.length;
  await expect(foot.filter({ hasText: "Imperfect" })).toContainText(mean.toFixed(4));
  await expect(foot.filter({ hasText: "Copy" })).toContainText("1.0000");
  await page.getByRole("radio", { name: "As in the paper" }).check({ force: true });
  const paper = page.locator("table.paper");
  await expect(paper.locator("tbody tr")).toHaveCount(2);
  await expect(paper.locator("tfoot")).toContainText(mean.toFixed(4));
  await picture(page, "paper-layout");
});

test("what the measures overlook is told, and leads to the primitives", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Overlooked" }).click();
  const merged = page.locator(".overlooked section").filter({ hasText: "Merged" }).getByRole("button").first();
  await merged.click();
  await expect(merged).toHaveAttribute("aria-pressed", "true");
  await picture(page, "overlooked");
});

test("the selected primitive can be looked at alone, framed and hidden", async ({ page }) => {
  await open(page);
  const canvas = page.locator(".canvas-box canvas");
  const all = await contentOf(page, canvas, LEFT);
  await page.getByRole("tab", { name: "Primitives" }).click();
  await page.locator("table.primitives tbody tr").nth(3).getByRole("rowheader").getByRole("button").click();
  const tools = page.getByRole("group", { name: "Selected primitive" });
  await tools.getByRole("button", { name: "Isolate" }).click();
  await expect.poll(async () => (await contentOf(page, canvas, LEFT)).hues).toBeLessThan(all.hues);
  await tools.getByRole("button", { name: "Frame" }).click();
  await picture(page, "isolated");
  await tools.getByRole("button", { name: "Hide" }).click();
  await page.getByRole("button", { name: "Show 1 hidden" }).click();
  await page.getByRole("button", { name: "Frame all" }).click();
  await expect.poll(async () => (await contentOf(page, canvas, LEFT)).hues).toBe(all.hues);
});

test("a ground truth without a submission lists its primitives", async ({ page }) => {
  const folder = test.info().outputPath("truth");
  await writeAll(folder, filesOf("bracket", "PC1").filter(({ path }) => !path.includes("Imperfect")));
  await open(page);
  await drop(page, [folder]);
  await expect(page.locator(".models > ul li")).toContainText("truth only");
  await page.getByRole("tab", { name: "Primitives" }).click();
  const listed = page.locator("table.primitives");
  await expect(listed.locator("caption")).toContainText("in the ground truth");
  await expect(listed.locator("tbody tr").first()).toContainText(/Plane|Cylinder/);
  await expect(page.locator(".side-name")).toHaveCount(1);
});
