// A measure is declared in Rust, and the page has it: in tables, charts, explanations and exports.

import { createServer, type AddressInfo } from "node:net";
import { preview, type PreviewServer } from "vite";
import { checkoutWithOneMoreMeasure, ONE_MORE, pageOf } from "../declared/checkout.mjs";
import { expect, rows, test } from "./support/test";

const { key, name } = ONE_MORE;

let server: PreviewServer;
let address: string;

test.beforeAll(async () => {
  test.setTimeout(600_000);
  const checkout = await checkoutWithOneMoreMeasure();
  const outDir = await pageOf(checkout);
  server = await preview({
    configFile: false,
    logLevel: "silent",
    root: checkout,
    build: { outDir },
    preview: { host: "127.0.0.1", port: await freePort(), strictPort: true },
  });
  address = server.resolvedUrls?.local[0] ?? "";
});

test.afterAll(() => server.close());

test("one more measure stands in tables, explanations, charts and exports by its declaration alone", async ({ page }) => {
  await page.goto(address);
  await expect(rows(page)).toHaveCount(1);
  const head = page.locator("table.scores thead th").filter({ hasText: key });
  await expect(head).toHaveCount(1);
  const place = await head.evaluate((cell) => (cell as HTMLTableCellElement).cellIndex);
  const figure = rows(page).first().locator(":scope > *").nth(place);
  await expect(figure).toHaveText(/^0\.\d{4}$/);

  await head.getByRole("button", { name: `What ${key} means` }).click();
  const explanation = page.getByRole("dialog", { name: `What ${key} means` });
  await expect(explanation).toContainText(name);
  await expect(explanation.locator("math mfrac")).toHaveText("TPTP+FP+FN");
  await page.keyboard.press("Escape");

  await expect(page.locator(".readouts")).toContainText(key);
  await expect(page.getByLabel("List by").locator("option", { hasText: `by ${key}, worst first` })).toHaveCount(1);
  await page.getByRole("tab", { name: "Primitives" }).click();
  await expect(page.locator("table.primitives").first().locator("thead")).toContainText(key);

  await page.getByRole("button", { name: "Add data" }).click();
  await page.getByRole("button", { name: /^Stepped shaft/ }).click();
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(rows(page)).toHaveCount(2);
  await page.getByRole("tab", { name: "Charts" }).click();
  await expect(page.locator('[data-chart="classification"] svg')).toContainText(key);
});

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const { port } = probe.address() as AddressInfo;
      probe.close(() => resolve(port));
    });
  });
}
