import { join } from "node:path";
import { expect, open, row, rows, test } from "./support/test";
import { filesOf, METHOD, type Fixture } from "./support/engine";
import { drop, writeAll } from "./support/drop";

const COARSE = { spacing: 0.05 };

/** The truth of a part, without the method that comes with it. */
const truthOf = (part: string, name: string) => filesOf(part, name, COARSE).filter(({ path }) => !path.includes(METHOD));

/** Writes files and gives their paths, to be dropped loose. */
async function loose(name: string, files: readonly Fixture[]): Promise<string[]> {
  const folder = test.info().outputPath(name);
  const flat = files.map(({ path, text }) => ({ path: path.split("/").at(-1) ?? "", text }));
  await writeAll(folder, flat);
  return flat.map(({ path }) => join(folder, path));
}

test("what comes later renames, replaces and loses nothing, and is asked about once", async ({ page }) => {
  const set = test.info().outputPath("set");
  await writeAll(set, [...filesOf("bracket", "PC1", COARSE), ...filesOf("flange", "PC2", COARSE)]);
  await open(page);
  await drop(page, [set]);
  await expect(rows(page)).toHaveCount(2);

  // Another part under a name that there is: most likely a model of its own.
  await drop(page, await loose("other", truthOf("plate", "PC1")));
  const notice = page.getByRole("status").filter({ hasText: "Taken as" });
  await expect(notice).toContainText("Taken as the new model PC1-2, beside PC1.");
  const models = page.locator(".models > ul li");
  await expect(models).toHaveCount(3);
  await expect(row(page, "PC1")).toContainText(METHOD);
  await expect(row(page, "PC2")).toContainText(METHOD);

  // Or a submission, if that is what it is; and back.
  await notice.getByRole("button", { name: "Make a submission for PC1" }).click();
  await expect(models).toHaveCount(2);
  await expect(row(page, "PC1").filter({ hasText: "submission" })).toBeVisible();
  await page.getByRole("status").getByRole("button", { name: "Make a new model" }).click();
  await expect(models).toHaveCount(3);
  await expect(models.filter({ hasText: "PC1-2" })).toHaveCount(1);

  // It is all there again after a reload, under the same names.
  await page.waitForTimeout(1000);
  await page.reload();
  await expect(models).toHaveCount(3);
  await expect(models.filter({ hasText: "PC1-2" })).toHaveCount(1);
});

test("files that come with the very cloud that is there are a submission for it", async ({ page }) => {
  const files = filesOf("bracket", "PC1", COARSE);
  const set = test.info().outputPath("set");
  await writeAll(set, files);
  await open(page);
  await drop(page, [set]);
  await expect(row(page, "PC1")).toContainText(METHOD);
  await drop(page, await loose("mine", truthOf("bracket", "PC1")));
  await expect(page.getByRole("status").filter({ hasText: "Taken as" })).toContainText("Taken as a submission for PC1 of the same cloud.");
  await expect(rows(page)).toHaveCount(2);
  await expect(row(page, "PC1").filter({ hasText: "submission" })).toContainText("1.000");
});
