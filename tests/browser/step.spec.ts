import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import AxeBuilder from "@axe-core/playwright";
import { stepPlate } from "../../scripts/lib/samples.mjs";
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
