import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { mkdir, readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { unzipSync } from "fflate";
import { expect, open, picture, row, rows, test } from "./support/test";
import { filesOf, METHOD, ROOT } from "./support/engine";
import { dropFiles } from "./support/sharing";
import { squares } from "./support/squares";

const VERSION = run("--version").trim().split(" ")[1] ?? "";

function run(...args: string[]): string {
  return execFileSync(process.execPath, [join(ROOT, "bin/fit4cad.mjs"), ...args], { encoding: "utf8" });
}

async function save(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: button, exact: true }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

const sha256 = (text: string | Uint8Array) => createHash("sha256").update(text).digest("hex");

test("every export downloads, and is what the command line gives for the same files", async ({ page }) => {
  const files = [...filesOf("bracket", "PC3"), ...filesOf("flange", "PC12")];
  await open(page);
  const folder = await dropFiles(page, "my results", files);
  await expect(rows(page)).toHaveCount(2);
  await page.getByRole("radio", { name: "Published" }).check({ force: true });
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await expect(page.getByTestId("command")).toHaveText("fit4cad score 'my results' --protocol published");
  await expect(page.getByTestId("link-contents")).toContainText("2 results on 2 models");
  for (const [title, format, extension] of [["CSV", "csv", "csv"], ["JSON", "json", "json"], ["LaTeX", "latex", "tex"], ["Markdown", "markdown", "md"]] as const) {
    const { name, bytes } = await save(page, `Save ${title}`);
    expect(name).toBe(`fit4cad-published.${extension}`);
    const text = bytes.toString();
    for (const needed of [VERSION, "published", ...files.map((file) => sha256(file.text))]) expect(text).toContain(needed);
    // The line that the page gives, run where the folder is.
    const line = ["score", "my results", "--protocol", "published", "--format", format];
    expect(text).toBe(execFileSync(process.execPath, [join(ROOT, "bin/fit4cad.mjs"), ...line], { cwd: dirname(folder), encoding: "utf8" }));
  }
  await picture(page, "sheet-share-light");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "sheet-share-dark");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.setViewportSize({ width: 360, height: 740 });
  await picture(page, "sheet-share-narrow");
});

test("a table for a paper is chosen under one's eyes, saved as seen, and is what the command line writes", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const files = [...filesOf("bracket", "PC3"), ...filesOf("flange", "PC12"), ...squares("PC1", 7500, 8)];
  await open(page);
  const folder = await dropFiles(page, "set", files);
  await expect(rows(page)).toHaveCount(3);
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const preview = page.getByTestId("table-preview");
  await expect(preview).toContainText("\\begin{tabular}{llrrrrrrrrrrrr}");
  await expect(preview).toContainText("Mean of 2 & Imperfect");
  await expect(preview).not.toContainText("published");
  await page.getByLabel("With the published methods").check();
  await expect(preview).toContainText(/PC 1 & MINE .*\n +& HT \(published\) & \$7\{,\}500\$ & \$8\$ & {2}& \$0\.987\$/);
  await page.getByLabel("Best in bold").check();
  await expect(preview).toContainText(/PC 1 & MINE & .* & \$\\mathbf\{1\.000\}\$/);
  await page.getByRole("combobox", { name: "Digits" }).selectOption("2");
  for (const measure of ["TNR", "NPV", "ACC", "MFE", "dHaus", "d1"]) await page.getByLabel(measure, { exact: true }).uncheck();
  await page.getByRole("combobox", { name: "Rows" }).selectOption("means only");
  await expect(preview).toContainText(/method & \\# models & DSC & PPV & TPR \\\\\n/);
  await expect(preview).toContainText(/ MINE & \$1\$ & .*\n/);
  await expect(preview).toContainText(/ HT \(published\) & \$1\$ & \$0\.99\$ & \$0\.98\$ & /);
  await picture(page, "sheet-share-table");
  const shown = (await preview.textContent()) ?? "";
  const line = ["score", "set", "--means", "--published", "--bold", "--digits", "2", "--measures", "DSC,PPV,TPR", "--format", "latex"];
  const theirs = execFileSync(process.execPath, [join(ROOT, "bin/fit4cad.mjs"), ...line], { cwd: dirname(folder), encoding: "utf8" });
  const { bytes } = await save(page, "Save LaTeX");
  expect(bytes.toString()).toBe(theirs);
  // The preview is the same but for the files, which are hashed when a table is saved.
  expect(shown).toBe(theirs.replace(/^% (?:[0-9a-f]{64}) .*\n/gm, ""));
  await page.getByRole("combobox", { name: "Preview of" }).selectOption("CSV");
  await expect(preview).toContainText(/^method,protocol,models,DSC,PPV,TPR,type_errors,engine\r?\n(?:.*\r?\n)*MINE,definition,1,/);
  await page.getByRole("button", { name: "Copy Markdown" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("| HT \\(published\\) | 1 | 0.99 | 0.98 | ");
});

test("a submission comes as a zip of its own files, which score the same", async ({ page }) => {
  const files = filesOf("bracket", "PC3");
  // Without the implicit file, which the engine then writes.
  const brought = files.filter(({ path }) => !path.startsWith(`pointCloud_implicit_${METHOD}`));
  await open(page);
  await dropFiles(page, "mine", brought);
  await expect(row(page, "PC3")).toBeVisible();
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const { name, bytes } = await save(page, "Save PC3");
  expect(name).toBe(`PC3-${METHOD}.zip`);
  const entries = unzipSync(bytes);
  const place = (role: string) => `pointCloud_${role}_${METHOD}/PC3_${role}.txt`;
  expect(Object.keys(entries)).toEqual([place("primitives"), place("parametric"), place("implicit"), "fit4cad.json"]);
  const text = (path: string) => new TextDecoder().decode(entries[path]);
  expect(text(place("primitives"))).toBe(files.find(({ path }) => path === place("primitives"))?.text);
  const note = JSON.parse(text("fit4cad.json")) as { engine: string; protocol: string; files: { path: string; sha256: string }[] };
  expect([note.engine, note.protocol]).toEqual([VERSION, "definition"]);
  for (const { path, sha256: sum } of note.files) expect(sum).toBe(sha256(entries[path] ?? ""));
});

test("the command of a sample makes and scores the same sample", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await open(page);
  await page.getByRole("button", { name: "Add data" }).click();
  await page.getByLabel("Seed").fill("7");
  await page.getByLabel("Noise").fill("0.001");
  await page.getByRole("button", { name: /^Flange/ }).click();
  const name = "flange-noise0.001-seed7";
  await expect(row(page, name)).toBeVisible();
  await page.getByRole("tab", { name: "Fit", exact: true }).click();
  await page.getByRole("radio", { name: "PG" }).check({ force: true });
  await page.getByLabel("Smallest", { exact: true }).fill("12");
  await page.getByRole("button", { name: `Fit ${name}`, exact: true }).click();
  await expect(page.locator("table.fits tbody")).toContainText(/\d\.\d{4}/, { timeout: 45_000 });
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const line = (await page.getByTestId("command").textContent()) ?? "";
  expect(line).toContain(`fit4cad generate flange --noise 0.001 --seed 7 --imperfect --name ${name} --out ${name} && `);
  expect(line).toContain(` && fit4cad fit ${name} --method pg --smallest 12 --seed 1 --out fits && fit4cad score bracket ${name} fits`);
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await page.getByRole("button", { name: "Copy as command" }).click();
  await expect.poll(copied).toBe(line);
  await page.getByRole("button", { name: "Copy as Python" }).click();
  await expect.poll(copied).toContain("import fit4cad\n");
  const python = await copied();
  expect(python).toContain(`    fit4cad.generate("flange", name="${name}", noise=0.001, seed=7),\n]\n`);
  expect(python).toContain('for model in [samples[1]]:\n    model.fit("pg", smallest=12, seed=1)\n');
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect.poll(copied).toBe(await page.getByLabel("Link", { exact: true }).inputValue());
  const { bytes } = await save(page, "Save CSV");
  const folder = test.info().outputPath("command");
  await mkdir(folder, { recursive: true });
  const script = `fit4cad() { '${process.execPath}' '${join(ROOT, "bin/fit4cad.mjs")}' "$@"; }; ${line} --format csv`;
  const out = execFileSync("bash", ["-c", script], { cwd: folder, encoding: "utf8" });
  const scored = out.slice(out.indexOf("model,method"));
  expect(scored).toBe(bytes.toString());
  const interpreter = join(ROOT, ".tools/python/bin/python");
  if (existsSync(interpreter)) {
    const said = execFileSync(interpreter, ["-c", python], { cwd: folder, encoding: "utf8" });
    const means = said.trim().split("\n").map((row) => Number(/'DSC': ([\d.e-]+)/.exec(row)?.[1]));
    const column = scored.split("\n")[0]?.split(",").indexOf("DSC") ?? -1;
    const theirs = scored.trim().split("\n").slice(1).map((row) => Number(row.split(",")[column]));
    expect(means).toEqual(theirs.slice(0, means.length));
  }
});
