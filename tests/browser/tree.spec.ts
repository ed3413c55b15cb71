// The primitives by type: what is shown, what a click in the picture finds, and what is shown alone.

import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import { contentOf, LEFT } from "./support/pixels";
import { expect, open, picture, test } from "./support/test";

async function openTree(page: Page): Promise<Locator> {
  await open(page);
  await page.getByRole("tab", { name: "Primitives" }).click();
  await page.getByRole("radio", { name: "By type" }).check({ force: true });
  // The first list is that of the ground truth and its matches, the second that of predictions without one.
  const list = page.locator(".primitive-tree section").first();
  await expect(list.getByRole("button", { name: /^Planes \d+$/ })).toBeVisible();
  return list;
}

/** Coloured share of the left view. */
async function coloured(page: Page): Promise<number> {
  return (await contentOf(page, page.locator(".canvas-box canvas"), LEFT)).coloured;
}

test("a type is hidden and shown by its eye, alone by “Only”, and Escape shows all again", async ({ page }) => {
  const tree = await openTree(page);
  const all = await coloured(page);
  const eye = tree.getByRole("button", { name: "Hide all Planes" });
  await eye.click();
  await expect(eye).toHaveAttribute("aria-pressed", "true");
  await expect.poll(() => coloured(page)).toBeLessThan(0.75 * all);
  const without = await coloured(page);
  await page.locator("body").press("Escape");
  await expect(eye).toHaveAttribute("aria-pressed", "false");
  await expect.poll(() => coloured(page)).toBeGreaterThan(0.98 * all);

  // One of them makes the eye of the type half shut.
  const one = tree.getByRole("button", { name: /^Hide True \d+: Plane$/ }).first();
  await one.click();
  await expect(eye).toHaveAttribute("aria-pressed", "mixed");
  await one.click();
  await expect(eye).toHaveAttribute("aria-pressed", "false");

  await tree.getByRole("button", { name: "Show only all Planes" }).click();
  await expect(eye).toHaveAttribute("aria-pressed", "false");
  await expect(tree.getByRole("button", { name: "Hide all Cylinders" })).toHaveAttribute("aria-pressed", "true");
  await expect(tree.getByRole("button", { name: "Hide unsegmented points" })).toHaveAttribute("aria-pressed", "true");
  await expect.poll(() => coloured(page)).toBeLessThan(0.98 * all);
  await picture(page, "tree-only-planes");
  expect((await coloured(page)) + without).toBeGreaterThan(0.8 * all);
  await page.getByRole("button", { name: /^Show \d+ hidden$/ }).click();
  await expect.poll(() => coloured(page)).toBeGreaterThan(0.98 * all);
});

test("what is locked is not found by a click in the picture, until Escape unlocks it", async ({ page }) => {
  const tree = await openTree(page);
  const box = await page.locator(".canvas-box canvas").boundingBox();
  if (!box) throw new Error("no canvas");
  const [x, y] = [box.x + box.width * 0.25, box.y + box.height * 0.55];
  await page.mouse.move(x - 5, y);
  await page.mouse.move(x, y);
  const tooltip = page.locator(".tooltip strong");
  await expect(tooltip).toContainText(/^True \d+: /);
  const name = (await tooltip.textContent()) ?? "";
  const row = tree.getByRole("button", { name: new RegExp(`^${name}, [\\d,]+ points$`) });
  await page.mouse.click(x, y);
  await expect(row).toHaveAttribute("aria-pressed", "true");
  await page.locator("body").press("Escape");
  await expect(row).toHaveAttribute("aria-pressed", "false");

  await tree.getByRole("button", { name: `Lock ${name}` }).click();
  await page.mouse.move(x - 5, y);
  await page.mouse.move(x, y);
  await expect(tooltip.getByText(name, { exact: true })).toHaveCount(0);
  await page.waitForTimeout(400);
  await page.mouse.click(x, y);
  await page.waitForTimeout(400);
  await expect(row).toHaveAttribute("aria-pressed", "false");
  // What lies behind it may be found instead, or nothing; the row still selects what is locked.
  await expect(page.getByRole("button", { name: "Unlock 1" })).toBeVisible();
  await row.click();
  await expect(row).toHaveAttribute("aria-pressed", "true");
  await page.locator("body").press("Escape");
  await page.locator("body").press("Escape");
  await expect(page.getByRole("button", { name: "Unlock 1" })).toHaveCount(0);
  await page.mouse.move(x - 5, y);
  await page.mouse.move(x, y);
  await expect(tooltip).toHaveText(name);
});

test("the tree is walked and used by keyboard, fits a phone, and axe finds nothing", async ({ page }) => {
  const tree = await openTree(page);
  const planes = tree.getByRole("button", { name: /^Planes \d+$/ });
  await planes.focus();
  await page.keyboard.press("ArrowDown");
  await expect(tree.getByRole("button", { name: /^True \d+: Plane, / }).first()).toBeFocused();
  await page.keyboard.press("ArrowRight");
  const eye = tree.getByRole("button", { name: /^Hide True \d+: Plane$/ });
  await expect(eye.first()).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(eye.first()).toHaveAttribute("aria-pressed", "true");
  await page.keyboard.press("ArrowDown");
  await expect(eye.nth(1)).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(eye.first()).toHaveAttribute("aria-pressed", "false");
  await planes.focus();
  await page.keyboard.press("Enter");
  await expect(planes).toHaveAttribute("aria-expanded", "false");
  await expect(eye).toHaveCount(0);
  await page.keyboard.press("Enter");
  await eye.first().click();
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    for (const [width, height] of [[1440, 900], [360, 740]] as const) {
      await page.setViewportSize({ width, height });
      await tree.scrollIntoViewIfNeeded();
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      await picture(page, `tree-${width}-${colorScheme}`);
    }
    expect((await new AxeBuilder({ page }).include(".panels").analyze()).violations).toEqual([]);
  }
});
