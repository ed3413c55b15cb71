import { join } from "node:path";
import { drop, writeAll } from "./support/drop";
import { expect, measuresIn, open, picture, row, rows, test } from "./support/test";
import { scoreOfSample } from "./support/engine";
import { contentOf, LEFT, RIGHT } from "./support/pixels";

test("opens with a sample that is scored as the engine scores it", async ({ page }) => {
  await open(page);
  const model = (await rows(page).getByRole("rowheader").textContent()) ?? "";
  expect(await measuresIn(row(page, model))).toEqual(scoreOfSample(model).mean);
  await picture(page, "opening-light");
});

test("shows the points of truth and prediction in the colours of their primitives", async ({ page }) => {
  await open(page);
  const canvas = page.locator(".canvas-box canvas");
  await expect
    .poll(async () => (await contentOf(page, canvas, LEFT)).hues, { message: "colours on the left" })
    .toBeGreaterThan(4);
  const right = await contentOf(page, canvas, RIGHT);
  expect(right.hues).toBeGreaterThan(4);
  expect(right.coloured).toBeGreaterThan(0.05);
});

test("the paper's figure paints what is misclassified black, on the prediction's side only", async ({ page }) => {
  await open(page);
  await page.getByLabel("Colour").selectOption({ label: "The paper's figure" });
  // Without shading, black is nothing but misclassified points.
  await page.getByRole("button", { name: "Display" }).click();
  await page.getByLabel("Depth shading").uncheck();
  await page.keyboard.press("Escape");
  const canvas = page.locator(".canvas-box canvas");
  await expect.poll(async () => (await contentOf(page, canvas, RIGHT)).black).toBeGreaterThan(0.005);
  expect((await contentOf(page, canvas, LEFT)).black).toBeLessThan(0.001);
  await picture(page, "figure");
});

test("the protocol switch shows the other protocol's values and keeps the choice", async ({ page }) => {
  await open(page);
  const model = (await rows(page).getByRole("rowheader").textContent()) ?? "";
  await page.getByRole("radio", { name: "Published" }).check({ force: true });
  expect(await measuresIn(row(page, model))).toEqual(scoreOfSample(model, "published").mean);
  await page.reload();
  await expect(page.getByRole("radio", { name: "Published" })).toBeChecked();
});

test("light and dark follow the system until the reader chooses", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await open(page);
  const root = page.locator("html");
  await expect(root).toHaveAttribute("data-theme", "dark");
  await picture(page, "opening-dark");
  await page.getByRole("button", { name: /^Theme/ }).click();
  await expect(root).toHaveAttribute("data-theme", "light");
  await page.reload();
  await expect(root).toHaveAttribute("data-theme", "light");
});

for (const [width, height] of [[360, 740], [1280, 720], [2560, 1440]] as const) {
  test(`fits a window of ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await open(page);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
    const canvas = await page.locator(".canvas-box canvas").boundingBox();
    expect(canvas?.height).toBeGreaterThan(150);
    await picture(page, `window-${width}`);
  });
}

test("without WebGL 2 the tables still work, and the page says why there is no picture", async ({ page }) => {
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind === "webgl2" ? null : Reflect.apply(original, this, [kind, ...rest]);
    } as typeof original;
  });
  await page.goto("./");
  await expect(rows(page)).toHaveCount(1);
  await expect(page.getByRole("alert")).toContainText("does not offer WebGL 2");
  await page.getByRole("tab", { name: "Primitives" }).click();
  await page.locator("table.primitives tbody tr").first().getByRole("button").click();
  await expect(page.locator("table.primitives tbody tr[aria-current]")).toHaveCount(1);
});

test("a lesson's address makes no sample until the scores are shown", async ({ page }) => {
  await page.goto("./?page=lessons");
  await expect(page.getByRole("heading", { name: "Lessons" })).toBeVisible();
  const started = () => page.workers().length;
  // Nothing tells that nothing will come: the page is asked for more and has had its time when that is there.
  await page.getByRole("link", { name: "Implicit and parametric" }).click();
  await expect(page.locator(".lesson-live canvas").first()).toBeVisible();
  expect(started(), "the lesson's own engine alone").toBeLessThanOrEqual(1);
  await page.getByRole("link", { name: "Score", exact: true }).click();
  await expect(rows(page)).toHaveCount(1);
});

test("a page that does not exist says so and leads back", async ({ page }) => {
  await page.goto("./?page=nowhere");
  await expect(page.getByText("There is no page “nowhere” here.")).toBeVisible();
  await page.getByRole("link", { name: "Back to the scores" }).click();
  await expect(rows(page)).toHaveCount(1);
});

test("the first screen says what this is and leads three ways on; the picture can have the room of the tables; what is removed can be had back", async ({ page }) => {
  await open(page);
  const door = page.getByRole("region", { name: "What this is" });
  await expect(door).toContainText("point clouds of CAD objects");
  await door.getByRole("button", { name: "Fit my scan" }).click();
  await expect(page.getByRole("dialog", { name: "Add data" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("tab", { name: "Fit" })).toHaveAttribute("aria-selected", "true");

  const box = page.locator(".canvas-box");
  const height = async () => (await box.boundingBox())?.height ?? 0;
  const shared = await height();
  await page.getByRole("button", { name: "Tables" }).click();
  await expect(page.getByRole("tabpanel")).toHaveCount(0);
  await expect.poll(height).toBeGreaterThan(1.3 * shared);
  await page.getByRole("tab", { name: "Files" }).click();
  await expect(page.getByRole("tabpanel")).toBeVisible();
  await page.getByRole("button", { name: "Picture alone" }).click();
  await expect(page.getByRole("tablist")).toBeHidden();
  await expect.poll(height).toBeGreaterThan(1.5 * shared);
  await page.keyboard.press("Escape");
  await expect(page.getByRole("tablist")).toBeVisible();

  // Points that are clicked measure, and are taken back one by one.
  await page.keyboard.press("e");
  const tape = page.locator(".tape");
  await expect(tape).toHaveText("Click a point to measure from.");
  const canvas = await box.boundingBox();
  if (!canvas) throw new Error("no canvas");
  for (const [x, y, said] of [[0.25, 0.4, "Click a second point."], [0.3, 0.62, /^Distance \d/], [0.25, 0.55, /angle \d+\.\d\d°, radius/]] as const) {
    await page.mouse.click(canvas.x + x * canvas.width, canvas.y + y * canvas.height);
    await expect(tape).toHaveText(said);
  }
  for (let turn = 0; turn < 4; turn += 1) await page.keyboard.press("Escape");
  await expect(tape).toHaveCount(0);

  await page.getByRole("button", { name: "Remove everything" }).click();
  await expect(page.getByText("Drop a point cloud anywhere on the page.")).toBeVisible();
  await expect(door).toBeVisible();
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(page.locator(".models").getByRole("button", { name: /^bracket/ })).toBeVisible();

  // On a phone the picture stays in sight while the tables scroll beneath it.
  await page.setViewportSize({ width: 390, height: 740 });
  await page.locator(".panel").evaluate((panel) => panel.scrollIntoView());
  await expect.poll(async () => (await box.boundingBox())?.y ?? -1).toBe(0);
});

test("what was brought and fitted is there again after a reload, and gone once it is removed", async ({ page, context }) => {
  await open(page);
  const points = Array.from({ length: 900 }, (_, k) => `${(k % 30) / 10} ${Math.floor(k / 30) / 10} 0`).join("\n");
  const folder = test.info().outputPath("scan");
  await writeAll(folder, [{ path: "plate.xyz", text: points }]);
  await drop(page, [join(folder, "plate.xyz")]);
  await page.getByRole("tab", { name: "Fit" }).click();
  await page.getByRole("button", { name: "Fit plate", exact: true }).click();
  await expect(page.locator(".stage-title")).toContainText("HT");
  await page.getByRole("tab", { name: "Files" }).click();
  await expect(page.getByText(/Kept in this browser until you remove it: [1-9]/)).toBeVisible();

  // Another tab beside it has no part in that, and says so before anything is done there.
  const other = await context.newPage();
  await open(other);
  await expect(other.locator(".notice")).toContainText("Another tab of this page keeps its work");
  await expect(other.locator(".stage h2")).toHaveText("bracket");
  await other.close();

  await page.reload();
  await expect(page.locator(".stage h2")).toHaveText("plate");
  await expect(page.locator(".stage-title")).toContainText("HT");
  await expect(page.locator(".notice")).toContainText("1 model of your last visit.");
  await page.getByRole("button", { name: "Remove everything" }).first().click();
  await expect(page.getByText("Drop a point cloud anywhere on the page.")).toBeVisible();
  await page.getByRole("tab", { name: "Files" }).click();
  await expect(page.getByText("Kept in this browser until you remove it: 0")).toBeVisible();
  await page.reload();
  await expect(page.locator(".stage h2")).toHaveText("bracket");
});
