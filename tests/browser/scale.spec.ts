import { expect, open, rows, test } from "./support/test";
import { zipOf } from "./support/drop";
import { filesOf, type Fixture } from "./support/engine";

const COUNT = 3000;
/** Seconds of the page's own thread. It takes 4; with work that grows by the square of the number it took minutes. */
const MOST_SECONDS = 40;

function manyFiles(): Fixture[] {
  // Implicit forms are left out: it is the number of models that costs here.
  const one = filesOf("bracket", "PC1", { spacing: 0.06 }).filter(({ path }) => !path.includes("implicit"));
  return Array.from({ length: COUNT }, (_, at) =>
    one.map(({ path, text }) => ({ path: path.replace(/PC1(?=[_.])/, `PC${at + 1}`), text })),
  ).flat();
}

test("thousands of models are scored, listed and walked, and only what is seen is drawn", async ({ page }) => {
  test.setTimeout(600_000);
  await open(page);
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const busy = async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return metrics.find(({ name }) => name === "TaskDuration")?.value ?? NaN;
  };
  const before = await busy();
  await page.getByRole("banner").getByRole("button", { name: "Add data" }).click();
  const buffer = zipOf(manyFiles());
  await page.getByLabel("Choose files or zips").setInputFiles({ name: "many.zip", mimeType: "application/zip", buffer });
  await expect(page.locator(".panel-tools p")).toHaveText(/^3,000 submissions/, { timeout: 500_000 });
  expect(await busy()).toBeLessThan(before + MOST_SECONDS);
  await expect(page.locator(".models .count")).toHaveText("3,000 models");

  // What is drawn says which of all it is.
  const items = page.locator(".models > ul li:not(.gap)");
  expect(await items.count()).toBeLessThan(150);
  await expect(items.first()).toHaveAttribute("aria-setsize", "3000");
  await expect(items.first()).toHaveAttribute("aria-posinset", "1");
  const drawn = rows(page).and(page.locator(":not(.gap)"));
  expect(await drawn.count()).toBeLessThan(150);
  await expect(page.locator("table.scores")).toHaveAttribute("aria-rowcount", "3001");
  await expect(drawn.first()).toHaveAttribute("aria-rowindex", "2");

  // Keys reach every one of them.
  const focused = page.locator(":focus");
  await items.first().getByRole("button").focus();
  await page.keyboard.press("ArrowDown");
  await expect(focused.locator(".name")).toHaveText("PC2");
  await page.keyboard.press("End");
  await expect(focused.locator(".name")).toHaveText("PC3000");
  await page.keyboard.press("Enter");
  await expect(page.locator(".stage h2")).toHaveText("PC3000");
  await page.keyboard.press("PageUp");
  await expect(focused.locator(".name")).toHaveText(/^PC29\d\d$/);
  await page.keyboard.press("Home");
  await expect(focused.locator(".name")).toHaveText("PC1");
  const names = page.locator("table.scores .row-name");
  await names.first().focus();
  await page.keyboard.press("End");
  await expect(focused).toHaveText("PC3000");
  await page.keyboard.press("ArrowUp");
  await expect(focused).toHaveText("PC2999");

  // What has the focus keeps it when it is scrolled out of sight.
  await page.locator(".models > ul li button").first().focus();
  await page.locator(".models ul").evaluate((list) => list.scrollTo({ top: list.scrollHeight / 2, behavior: "instant" }));
  await expect(page.locator('.models [aria-posinset="1500"]')).toBeVisible();
  await expect(focused.locator(".name")).toHaveText("PC1");

  // A search leaves few, which are drawn whole.
  await page.getByPlaceholder("Search").fill("299");
  await expect(page.locator(".models .count")).toHaveText("13 of 3000 models");
  await expect(page.locator(".models > ul li")).toHaveCount(13);
});
