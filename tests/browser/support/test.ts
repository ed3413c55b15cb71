// A page that must not complain: every test fails on console errors and uncaught exceptions.

import { test as base, expect, type Locator, type Page } from "@playwright/test";
import { MEASURES } from "../../../www/shared/formats/measures.mjs";

export { expect };

export const test = base.extend<{ complaints: string[] }>({
  complaints: [
    async ({ page }, use) => {
      const complaints: string[] = [];
      page.on("console", (message) => {
        if (message.type() === "error" || message.type() === "warning") complaints.push(message.text());
      });
      page.on("pageerror", (error) => complaints.push(String(error)));
      await use(complaints);
      expect(complaints, "the console stays quiet").toEqual([]);
    },
    { auto: true },
  ],
});

/** Opens the page and waits until its sample is scored and drawn. */
export async function open(page: Page): Promise<void> {
  await page.goto("./");
  await expect(rows(page)).toHaveCount(1);
  await expect(page.locator(".canvas-state")).toHaveCount(0);
}

export function rows(page: Page): Locator {
  return page.locator("table.scores tbody tr");
}

export function row(page: Page, model: string): Locator {
  return rows(page).filter({ has: page.getByRole("rowheader", { name: model, exact: true }) });
}

/** The measures shown in a row of the summary, to the last digit. */
export async function measuresIn(summaryRow: Locator): Promise<Record<string, number | null>> {
  return summaryRow.evaluate((element, known) => {
    const heads = [...(element.closest("table")?.querySelectorAll("thead th") ?? [])];
    const names = heads.map((head) => head.querySelector(".sort")?.textContent.replace(/[↑↓]/, "") ?? "");
    const wanted = new Set<string>(known);
    const values: Record<string, number | null> = {};
    [...element.children].forEach((cell, at) => {
      const name = names[at] ?? "";
      if (wanted.has(name)) values[name] = cell.hasAttribute("title") ? Number(cell.getAttribute("title")) : null;
    });
    return values;
  }, MEASURES);
}

/** Keeps a picture of the page where a person can leaf through them. */
export async function picture(page: Page, name: string): Promise<void> {
  await page.screenshot({ path: `tests/screenshots/${name}.png` });
}
