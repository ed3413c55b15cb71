import { expect, open, rows, test } from "./support/test";

test("after the first visit the page opens, scores and shows every panel without a network", async ({ page, context }) => {
  await open(page);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await expect
    .poll(() => page.evaluate(async () => (await caches.keys()).length), { message: "kept files" })
    .toBeGreaterThan(0);
  await context.setOffline(true);
  await page.reload();
  await expect(rows(page).first()).toBeVisible();
  for (const panel of await page.getByRole("tab").all()) {
    await panel.click();
    await expect(page.getByRole("tabpanel")).not.toBeEmpty();
  }
});

test("the page asks nobody but its own host for anything", async ({ page, baseURL }) => {
  const foreign: string[] = [];
  page.on("request", (request) => {
    const address = request.url();
    if (/^https?:/.test(address) && !address.startsWith(String(baseURL))) foreign.push(address);
  });
  const refused: string[] = [];
  await page.addInitScript(() =>
    document.addEventListener("securitypolicyviolation", (event) => console.error(`refused ${event.blockedURI}`)),
  );
  page.on("console", (message) => {
    if (message.text().startsWith("refused")) refused.push(message.text());
  });
  await open(page);
  for (const panel of await page.getByRole("tab").all()) await panel.click();
  expect(foreign).toEqual([]);
  expect(refused).toEqual([]);
});
