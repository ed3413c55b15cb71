// Sharing as people do it: one makes a link, another opens it.

import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./test";
import { drop, writeAll } from "./drop";
import type { Fixture } from "./engine";

/** The link that the page makes of its results. */
export async function linkOf(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const link = page.getByLabel("Link", { exact: true });
  await expect(link).toHaveValue(/#share=2\./);
  const value = await link.inputValue();
  await page.keyboard.press("Escape");
  return value;
}

/** Opens a link as somebody who has nothing else. */
export async function openLink(page: Page, link: string): Promise<void> {
  await page.goto("about:blank");
  await page.goto(link);
}

export function claims(page: Page): Locator {
  return page.locator("table.claims tbody tr");
}

/** Drops files from a folder of that name, which need not be there before. */
export async function dropFiles(page: Page, name: string, files: readonly Fixture[]): Promise<string> {
  const folder = test.info().outputPath(name);
  await writeAll(folder, files);
  await drop(page, [folder]);
  return folder;
}
