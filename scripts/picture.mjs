// Takes the README's picture from the running page: `npm run picture`.

import { join } from "node:path";
import { buildPage } from "./build.mjs";
import { ROOT } from "./lib/paths.mjs";
import { main, say } from "./lib/run.mjs";
import { withServedPage } from "./lib/served.mjs";
import { setup } from "./setup.mjs";

const WINDOW = { width: 1440, height: 900 };

await main(async () => {
  await setup();
  await buildPage();
  await withServedPage(async ({ address, browser }) => {
    const page = await browser.newPage({ viewport: WINDOW, colorScheme: "light" });
    await page.goto(address);
    await page.getByRole("tabpanel").getByRole("row").nth(1).waitFor();
    await page.getByRole("tab", { name: "Primitives" }).click();
    const row = page.getByRole("tabpanel").getByRole("row").nth(5);
    await row.click();
    await page.waitForTimeout(3000);
    const path = join(ROOT, "docs/playground.png");
    await page.screenshot({ path });
    say(`wrote ${path}`);
  });
});
