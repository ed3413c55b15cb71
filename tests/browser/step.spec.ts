import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import AxeBuilder from "@axe-core/playwright";
import { stepPlate } from "../../scripts/lib/samples.mjs";
import { keptFiles } from "./support/kept";
import { expect, open, picture, row, test } from "./support/test";

test("a STEP file becomes a model that is seen, fitted and scored, packed or not", async ({ page }) => {
  await open(page);
  const choose = async (name: string, buffer: Buffer) => {
    await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
    await page.getByLabel("Choose files or zips").setInputFiles({ name, mimeType: "application/octet-stream", buffer });
  };
  await choose("plate.step", Buffer.from(stepPlate()));
  await expect(page.locator(".notice")).toContainText("points on 6 faces of 1 body, 6 primitives.");
  await picture(page, "step-plate");
  await page.getByRole("tab", { name: "Fit" }).click();
  await page.getByRole("tabpanel").getByRole("button", { name: "Fit plate", exact: true }).click();
  await expect(page.locator("table.fits tbody tr")).toContainText(/[01]\.\d{4}/, { timeout: 45_000 });
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(row(page, "plate")).toContainText("1.000");
  await choose("other.stp.gz", gzipSync(stepPlate()));
  await expect(page.locator(".notice")).toContainText("other.stp.gz: ");
  await page.getByRole("tab", { name: "Files" }).click();
  await expect(page.getByRole("tabpanel")).toContainText("other_implicit.txt");
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save Surfaces, STEP" }).click();
  const saved = await waiting;
  expect(saved.suggestedFilename()).toBe("other_truth_surfaces.step");
  const text = await readFile(await saved.path(), "utf8");
  expect(text.match(/ADVANCED_FACE\(/g)).toHaveLength(6);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("a STEP file that is none, or is cut off, is refused in words and the others are taken", async ({ page }) => {
  await open(page);
  await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
  await page.getByLabel("Choose files or zips").setInputFiles([
    { name: "none.step", mimeType: "", buffer: Buffer.from("nothing of the kind") },
    { name: "cut.step", mimeType: "", buffer: Buffer.from(stepPlate().slice(0, 900)) },
    { name: "damaged.stp.gz", mimeType: "", buffer: gzipSync(stepPlate()).subarray(0, 200) },
    { name: "plate.step", mimeType: "", buffer: Buffer.from(stepPlate()) },
  ]);
  await expect(page.locator(".notice")).toContainText("plate.step: ");
  await page.getByRole("tab", { name: "Files" }).click();
  const files = page.getByRole("tabpanel");
  await expect(files).toContainText("No model could be made of it: this is no STEP file");
  await expect(files).toContainText("No model could be made of it: it is packed by gzip and damaged");
  await expect(files).toContainText("nothing can be read from what is broken here");
  await expect(files).toContainText("plate_parametric.txt");
});

test("the faces of a STEP file are told one by one, and it is imported again in another way, or not", async ({ page }) => {
  await open(page);
  await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
  await page.getByLabel("Choose files or zips").setInputFiles({ name: "plates.step", mimeType: "", buffer: Buffer.from(stepPlate(3)) });
  await page.locator(".notice").getByRole("button", { name: "Faces and options" }).click();
  await expect(page.getByRole("tab", { name: "From CAD" })).toHaveAttribute("aria-selected", "true");
  const panel = page.getByRole("tabpanel");
  await expect(panel.getByRole("table").getByRole("row")).toHaveCount(1 + 18);
  await expect(panel.getByRole("row").nth(1)).toContainText("plane");
  await expect(panel).toContainText("18, all in the cloud");
  // A row stands for its primitive everywhere.
  await panel.getByRole("row").nth(3).locator(".row-name").click();
  await expect(panel.getByRole("row").nth(3)).toHaveAttribute("aria-current", "true");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);

  // In another way: fewer points, at random, of one body alone.
  await panel.getByLabel("Points").fill("500");
  await panel.getByLabel("Spread").selectOption("random");
  await panel.getByRole("checkbox", { name: /^2 plate/ }).uncheck();
  await panel.getByRole("checkbox", { name: /^3 plate/ }).uncheck();
  await panel.getByRole("button", { name: "Import again" }).click();
  await expect(page.locator(".notice")).toContainText("500 points on 6 faces of 1 body, 6 primitives.");
  await expect(panel.getByRole("table").getByRole("row")).toHaveCount(1 + 6);
  await expect(panel.getByLabel("Points")).toHaveValue("500");
  await expect(panel.getByRole("checkbox", { name: /^2 plate/ })).not.toBeChecked();

  await panel.getByLabel("Spread").selectOption("scan");
  await panel.getByLabel("Views").fill("3");
  await panel.getByRole("button", { name: "Import again" }).click();
  await expect(panel.getByRole("button", { name: "Cancel" })).toHaveCount(0);
  await expect(panel.getByLabel("Views")).toHaveValue("3");

  // A spacing stands in for the number of points; one that cannot be is refused in words, and nothing changes.
  await panel.getByLabel("Spacing").fill("100000");
  await expect(panel.getByLabel("Points")).toHaveValue("");
  await panel.getByRole("button", { name: "Import again" }).click();
  await expect(panel.getByRole("alert")).toContainText("mm for this part");
  await expect(panel).toContainText(/6, (all in the cloud|\d with points)/);

  // What takes long is stopped, and the model stays as it was.
  await panel.getByLabel("Points").fill("900000");
  await panel.getByLabel("Spread").selectOption("even");
  await panel.getByRole("button", { name: "Import again" }).click();
  await panel.getByRole("button", { name: "Cancel" }).click();
  await expect(panel.getByRole("button", { name: "Import again" })).toBeEnabled();
  await expect(page.locator("#importing")).toHaveCount(0);
  await expect(panel.getByRole("table").getByRole("row")).toHaveCount(1 + 6);

  // What was fitted goes with the points it was fitted to, and the reader is told before.
  await page.getByRole("tab", { name: "Fit" }).click();
  await page.getByRole("tabpanel").getByRole("button", { name: "Fit plates", exact: true }).click();
  await expect(page.locator("table.fits tbody tr")).toContainText(/[01]\.\d{4}/, { timeout: 45_000 });
  await page.getByRole("tab", { name: "From CAD" }).click();
  await expect(panel).toContainText("1 fit of plates will be removed");
  await panel.getByLabel("Points").fill("600");
  await panel.getByRole("button", { name: "Import again" }).click();
  await expect(page.locator(".notice")).toContainText("600 points");
  await expect(panel).not.toContainText("will be removed");

  // Kept with the model: there again at the next visit.
  await expect.poll(async () => (await keptFiles(page)).find(({ path }) => path === "plates.step/plates.txt")?.points).toBe(600);
  await page.reload();
  await page.getByRole("tab", { name: "From CAD" }).click();
  await expect(panel.getByLabel("Points")).toHaveValue("600");
  await panel.getByLabel("Points").fill("");
  await panel.getByRole("button", { name: "All", exact: true }).click();
  await panel.getByRole("button", { name: "Import again" }).click();
  await expect(page.locator(".notice")).toContainText("of 3 bodies, ");
});
