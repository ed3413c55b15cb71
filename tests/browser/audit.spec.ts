import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import { unzipSync } from "fflate";
import { Model, type Role } from "../../bin/engine/engine.js";
import { drop, writeAll } from "./support/drop";
import { filesOf, type Fixture } from "./support/engine";
import { expect, picture, test } from "./support/test";
import { held } from "../../scripts/lib/input.mjs";

/** The whole engine is fetched first. */
const SLOW = 45_000;

/** The files with one plane of the implicit form moved off its points, and the number of its primitive. */
function broken(files: readonly Fixture[]): { files: Fixture[]; primitive: string } {
  let primitive = "";
  const moved = files.map(({ path, text }) => {
    if (path !== "pointCloud_implicit/PC2_implicit.txt") return { path, text };
    const entry = /Primitive(\d+):=\[Plane, \[(\S+) (\S+) (\S+) (\S+)\]\];/;
    primitive = entry.exec(text)?.[1] ?? "";
    return { path, text: text.replace(entry, (_, number, a, b, c, d) => `Primitive${number}:=[Plane, [${a} ${b} ${c} ${Number(d) + 9}]];`) };
  });
  return { files: moved, primitive };
}

/** How many findings the engine has on the truth in these files. */
function findingsIn(files: readonly Fixture[]): number {
  const roles: readonly Role[] = ["cloud", "primitives", "parametric", "implicit"];
  const truth = files.flatMap(({ path, text }) => {
    const role = roles.find((each) => path.startsWith(each === "cloud" ? "pointCloud/" : `pointCloud_${each}/`));
    return role ? [held({ path, role }, new TextEncoder().encode(text))] : [];
  });
  const model = Model.read("PC2", truth);
  const { findings } = model.audit();
  model.free();
  return findings.length;
}

test("an audit finds the wrong form, shows its primitive and saves it corrected", async ({ page }) => {
  test.setTimeout(180_000);
  const { files, primitive } = broken(filesOf("flange", "PC2"));
  expect(findingsIn(files)).toBe(1);
  const folder = test.info().outputPath("set");
  await writeAll(folder, [...filesOf("flange", "PC1"), ...files]);
  await page.goto("./");
  await drop(page, [folder]);
  await expect(page.getByRole("heading", { name: "PC1", exact: true })).toBeVisible({ timeout: SLOW });
  await page.getByRole("tab", { name: "Audit" }).click();

  const status = page.locator(".audit [role=status]");
  await expect(status).toHaveText("2 models audited: 1 error; nothing wrong with 1", { timeout: SLOW });
  const rows = page.locator(".audit-findings tbody tr");
  await expect(rows).toHaveCount(1);
  await expect(rows).toContainText("implicit distance");
  await expect(rows.locator("td").first()).toHaveText(primitive);
  await page.getByRole("tabpanel").evaluate((panel) => panel.scrollTo(0, 0));
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);

  // A click leads to the model and the primitive.
  await rows.getByRole("button", { name: "PC2" }).click();
  await expect(page.getByRole("heading", { name: "PC2", exact: true })).toBeVisible();
  await expect(page.locator(".selection-tools")).toContainText(`True ${primitive}: Plane`, { timeout: SLOW });
  const measured = page.getByRole("table", { name: /points of PC2/ });
  await expect(measured.locator("tr[aria-current] th")).toHaveText(primitive);
  // Worst first.
  await measured.getByTitle("Sort by largest distance to the implicit form").click();
  await expect(measured.locator("tbody tr").first().locator("th")).toHaveText(primitive);
  await picture(page, "audit-light-1280");

  await page.getByLabel("Findings shown").selectOption("warning");
  await expect(page.getByText("No findings of this severity.")).toBeVisible();
  await page.getByLabel("Findings shown").selectOption("all");

  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save corrected files of 1 model" }).click(),
  ]);
  const zip = unzipSync(new Uint8Array(await readFile(await download.path())));
  const text = (name: string) => new TextDecoder().decode(zip[name]);
  expect(Object.keys(zip).sort()).toEqual(["PC2_implicit.txt", "corrections.txt"]);
  expect(text("corrections.txt")).toMatch(/^Corrected by Fit4CAD engine \d+\.\d+\.\d+\.\n/);
  expect(text("corrections.txt")).toContain(`\nPC2, primitive ${primitive}: implicit form converted from the parametric form\n`);
  const corrected = files.map((file) => (file.path === "pointCloud_implicit/PC2_implicit.txt" ? { ...file, text: text("PC2_implicit.txt") } : file));
  expect(findingsIn(corrected)).toBe(0);
});
