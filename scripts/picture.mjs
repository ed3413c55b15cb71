// Takes the README's picture from the running page: `npm run picture`.

import { spawn } from "node:child_process";
import { join } from "node:path";
import { chromium } from "@playwright/test";
import { buildPage } from "./build.mjs";
import { BROWSER_FLAGS, ensureBrowser, findBrowser } from "./lib/browser.mjs";
import { ROOT, npmCommand } from "./lib/paths.mjs";
import { main, say } from "./lib/run.mjs";
import { setup } from "./setup.mjs";

const PORT = 41_173;
const WINDOW = { width: 1440, height: 900 };

await main(async () => {
  await setup();
  await buildPage();
  await ensureBrowser();
  const server = spawn(
    process.execPath,
    [npmCommand("vite/bin/vite.js"), "preview", "--host", "127.0.0.1", "--port", String(PORT), "--strictPort"],
    { cwd: ROOT, stdio: "ignore" },
  );
  const browser = await chromium.launch({ executablePath: findBrowser(), args: BROWSER_FLAGS });
  try {
    const page = await browser.newPage({ viewport: WINDOW, colorScheme: "light" });
    await reach(page, `http://127.0.0.1:${PORT}/`);
    await page.getByRole("tab", { name: "Primitives" }).click();
    const row = page.getByRole("tabpanel").getByRole("row").nth(5);
    await row.click();
    await page.waitForTimeout(3000);
    const path = join(ROOT, "docs/playground.png");
    await page.screenshot({ path });
    say(`wrote ${path}`);
  } finally {
    await browser.close();
    server.kill();
  }
});

/** Opens the page once the server answers and its sample has been scored. */
async function reach(page, address) {
  for (let attempt = 0; ; attempt += 1) {
    try {
      await page.goto(address);
      break;
    } catch (error) {
      if (attempt === 50) {
        throw error;
      }
      await page.waitForTimeout(200);
    }
  }
  await page.getByRole("tabpanel").getByRole("row").nth(1).waitFor();
}
