// What runs in Chromium gives the digits that it gives under Node, whatever the number of workers. That Node's are those
// of a native build, tests/node/digits.test.mjs says.

import { readFile } from "node:fs/promises";
import { expect, measuresIn, open, rows, test } from "./support/test";
import { filesOf, reportsOfFits, scoreOfSample } from "./support/engine";
import { drop, writeAll } from "./support/drop";

/** As many as the most workers, so that each has something to do; few points, so that it is soon done. */
const PARTS = ["bracket", "elbow", "flange", "plate", "bracket", "elbow", "flange"];
const METHODS = ["HT", "PG"] as const;
/** Fitting beside a software renderer takes its time. */
const PATIENCE = { timeout: 120_000 };

const models = PARTS.map((part, at) => ({ name: `PC${at + 1}`, files: filesOf(part, `PC${at + 1}`, { spacing: 0.04, seed: at + 1 }) }));
const expected = models.flatMap(({ name, files }) => reportsOfFits(name, files, METHODS));

for (const workers of [1, 3, 7]) {
  test(`with ${workers} workers parts are generated, fitted and scored in Chromium to the digits that Node gives`, async ({ page }) => {
    test.setTimeout(300_000);
    // The page leaves one processor to itself.
    await page.addInitScript((count) => Object.defineProperty(navigator, "hardwareConcurrency", { value: count }), workers + 1);
    await open(page);
    const part = (await rows(page).getByRole("rowheader").first().textContent()) ?? "";
    expect(await measuresIn(rows(page).first())).toEqual(scoreOfSample(part).mean);

    const folder = test.info().outputPath("models");
    await writeAll(folder, models.flatMap(({ files }) => files));
    await drop(page, [folder]);
    await expect(rows(page)).toHaveCount(models.length, PATIENCE);
    await page.getByRole("tab", { name: "Fit", exact: true }).click();
    const panel = page.getByRole("tabpanel");
    for (const method of METHODS) {
      await panel.getByRole("radio", { name: method }).check({ force: true });
      await panel.getByRole("button", { name: `Fit all ${models.length} models` }).click();
      const done = page.locator("table.fits tbody tr").filter({ hasText: method }).filter({ hasText: /\d\.\d{4}/ });
      await expect(done).toHaveCount(models.length, PATIENCE);
    }
    // Another is started where all are busy: on a slow machine the first few may do it all.
    const started = page.workers().filter((worker) => worker.url().includes("engine")).length;
    expect(started).toBeGreaterThanOrEqual(Math.min(workers, 2));
    expect(started).toBeLessThanOrEqual(workers);

    await page.getByRole("button", { name: "Share", exact: true }).click();
    const waiting = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save JSON", exact: true }).click();
    const exported = JSON.parse(await readFile(await (await waiting).path(), "utf8")) as { model: string; method: string }[];
    for (const report of expected) {
      const told = exported.find(({ model, method }) => model === report.model && method === report.method);
      // Its diagnostics name files by the paths they were dropped from.
      const { diagnostics: _, ...computed } = report;
      expect(told, `${report.model} by ${report.method}`).toMatchObject(JSON.parse(JSON.stringify(computed)) as Record<string, unknown>);
    }
  });
}
