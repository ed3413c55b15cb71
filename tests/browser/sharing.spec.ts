import type { Page } from "@playwright/test";
import { expect, open, picture, row, rows, test } from "./support/test";
import { filesOf, scoreOf } from "./support/engine";
import { drop, writeAll } from "./support/drop";

/** The link of what is on the page. */
async function linkOf(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const link = page.getByLabel("Link", { exact: true });
  await expect(link).toHaveValue(/#share=1\./);
  const value = await link.inputValue();
  await page.keyboard.press("Escape");
  return value;
}

function claims(page: Page) {
  return page.locator("table.claims tbody tr");
}

async function dropFiles(page: Page, name: string, files: { path: string; text: string }[]): Promise<void> {
  const folder = test.info().outputPath(name);
  await writeAll(folder, files);
  await drop(page, [folder]);
}

test("a shared link shows its figures as claimed, and as verified once the same files are dropped", async ({ page }) => {
  const files = [...filesOf("bracket", "PC7"), ...filesOf("flange", "PC8")];
  await open(page);
  await dropFiles(page, "mine", files);
  await expect(rows(page)).toHaveCount(2);
  const link = await linkOf(page);

  // Another person, who has nothing but the link.
  await page.goto("about:blank");
  await page.goto(link);
  await expect(claims(page)).toHaveCount(2);
  await expect(claims(page).getByText("as claimed")).toHaveCount(2);
  await expect(page.locator(".banner")).toContainText("As claimed.");
  const claimed = claims(page).filter({ hasText: "PC7" });
  const dsc = scoreOf(filesOf("bracket", "PC7")).mean.DSC;
  await expect(claimed.locator(`td[title="${dsc}"]`)).not.toHaveCount(0);
  await picture(page, "shared-claimed");

  await dropFiles(page, "theirs", filesOf("bracket", "PC7"));
  await expect(claimed).toContainText("verified here");
  await expect(claims(page).filter({ hasText: "PC8" })).toContainText("as claimed");
  await expect(page.locator(".banner")).toContainText("1 verified here");
  await dropFiles(page, "theirs too", filesOf("flange", "renamed"));
  await expect(page.locator(".banner")).toContainText("Verified here.");
  await picture(page, "shared-verified");
});

test("other files under the same name do not verify a claim", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", filesOf("bracket", "PC7"));
  await expect(row(page, "PC7")).toBeVisible();
  const link = await linkOf(page);
  await page.goto("about:blank");
  await page.goto(link);
  await expect(claims(page)).toHaveCount(1);
  await dropFiles(page, "other", filesOf("bracket", "PC7", { seed: 9 }));
  await expect(claims(page)).toContainText("other ground truth and submission");
});
