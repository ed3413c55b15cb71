// What is cut away: the clipping box, and the cross-section that goes with the cut.

import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { contentOf, LEFT } from "./support/pixels";
import { expect, open, picture, test } from "./support/test";

/** Coloured share of the left view. */
async function coloured(page: Page): Promise<number> {
  return (await contentOf(page, page.locator(".canvas-box canvas"), LEFT)).coloured;
}

test("the six sides of a clipping box hide what lies outside, until Escape takes it away", async ({ page }) => {
  await open(page);
  const all = await coloured(page);
  const display = page.getByRole("button", { name: "Display" });
  await display.click();
  await page.getByLabel("Clipping box", { exact: true }).check();
  const sides = page.getByRole("group", { name: "Sides of the clipping box" });
  await expect(sides.getByRole("slider")).toHaveCount(6);
  const low = sides.getByRole("slider", { name: "x from" });
  await low.fill("0.6");
  await sides.getByRole("slider", { name: "z to" }).fill("0.5");
  // One side does not pass the other.
  const high = sides.getByRole("slider", { name: "x to" });
  await high.fill("0.2");
  await expect(high).toHaveValue("0.6");
  await high.fill("0.9");
  expect((await new AxeBuilder({ page }).include(".picture").analyze()).violations).toEqual([]);
  await picture(page, "clipping-box");
  await page.keyboard.press("Escape");
  await expect.poll(() => coloured(page)).toBeLessThan(0.6 * all);
  await page.locator("body").press("Escape");
  await expect.poll(() => coloured(page)).toBeGreaterThan(0.98 * all);
});

test("the cross-section draws the points near the cut and the curves of the surfaces through them", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Section" }).click();
  const panel = page.locator(".section-panel");
  await panel.getByRole("button", { name: "Cut across z" }).click();
  const drawing = panel.getByRole("img", { name: /^Section at z = / });
  await expect(drawing).toHaveAttribute("aria-label", /: [1-9][\d,]* points within .+ of it, [1-9]\d* primitives met$/);
  await panel.getByRole("radio", { name: "Truth" }).check({ force: true });
  const curves = drawing.locator(".curve");
  await expect(panel.getByRole("button", { name: /^True \d+: Plane, line$/ }).first()).toBeVisible();
  const place = panel.getByLabel("Place");
  await place.fill("0.02");
  await expect(panel.getByRole("button", { name: /^True \d+: Cylinder, circle of radius [\d.]+$/ }).first()).toBeVisible();
  // Each of the listed is drawn, in the colours of the views.
  expect(await curves.count()).toBe(await panel.locator("li").count());

  // The views are cut open at the same place, and a curve leads to its primitive.
  await panel.getByRole("button", { name: /^True \d+: Cylinder, / }).first().click();
  await expect(page.locator(".selection-tools strong")).toHaveText(/^True \d+: Cylinder$/);
  await page.locator("body").press("Escape");

  // A thicker layer has more points.
  const points = async () => Number(/: ([\d,]+) points/.exec((await drawing.getAttribute("aria-label")) ?? "")?.[1]?.replaceAll(",", ""));
  const thin = await points();
  await panel.getByLabel("Thickness").fill("0.05");
  await expect.poll(points).toBeGreaterThan(thin);
  await panel.getByLabel("Thickness").fill("0.01");
  await panel.getByLabel("Cut across").selectOption({ label: "y" });
  await place.fill("0.5");
  await expect(panel.getByRole("img", { name: /^Section at y = / })).toBeVisible();
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    for (const [width, height] of [[1440, 1100], [360, 740]] as const) {
      await page.setViewportSize({ width, height });
      await panel.evaluate((element) => element.scrollIntoView());
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      await picture(page, `section-${width}-${colorScheme}`);
    }
    expect((await new AxeBuilder({ page }).include(".panels").analyze()).violations).toEqual([]);
  }
  await place.focus();
  await page.keyboard.press("Escape");
  await expect(panel).toContainText("A cut opens the views");
});
