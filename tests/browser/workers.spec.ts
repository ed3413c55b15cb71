import type { Worker } from "@playwright/test";
import { drop, writeAll } from "./support/drop";
import { filesOf } from "./support/engine";
import { expect, open, rows, test } from "./support/test";

/** Has a worker fail to read the next model it is to score, or meet its end before it can answer for it. */
function spoil(worker: Worker, how: "ends" | "exhausts"): Promise<void> {
  return worker.evaluate((what) => {
    const read = FileReaderSync.prototype.readAsArrayBuffer;
    Object.assign(FileReaderSync.prototype, {
      readAsArrayBuffer(this: FileReaderSync, blob: Blob) {
        if (what === "exhausts") throw new RangeError("Array buffer allocation failed");
        Object.assign(self, { postMessage: () => self.close() });
        return read.call(this, blob);
      },
    });
  }, how);
}

const SAYS = {
  ends: "ended without a word",
  exhausts: "Array buffer allocation failed",
} as const;

for (const how of ["ends", "exhausts"] as const) {
  test(`a model in which the engine ${how === "ends" ? "ends without a word" : "uses up the memory"} fails alone, and the next are scored`, async ({ page }) => {
    // One worker, so that it is known who scores.
    await page.addInitScript(() => Object.defineProperty(navigator, "hardwareConcurrency", { value: 1 }));
    const folder = test.info().outputPath("models");
    const count = 4;
    const models = Array.from({ length: count }, (_, at) => filesOf("bracket", `PC${at + 1}`, { spacing: 0.05 }));
    await writeAll(folder, models.flat());
    await open(page);
    const [engine] = page.workers();
    expect(engine?.url()).toContain("engine");
    if (engine) await spoil(engine, how);
    await drop(page, [folder]);
    const failed = page.locator(".models > ul li", { hasText: "failed" });
    await expect(failed).toHaveCount(1);
    await expect(failed).toContainText(SAYS[how]);
    await expect(rows(page)).toHaveCount(count - 1);
    await expect(page.locator(".status progress")).toHaveCount(0);
    await page.getByRole("tab", { name: "Diagnostics" }).click();
    await expect(page.locator(".diagnostics li")).toContainText(SAYS[how]);
  });
}
