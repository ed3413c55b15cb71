import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import { expect, open, picture, row, test } from "./support/test";
import { dropFiles } from "./support/sharing";

/** Points of three faces of a cube, 14 × 14 each, and the face of each. */
const ROWS = Array.from({ length: 3 * 196 }, (_, at) => {
  const [u, v, face] = [(at % 14) * 0.1 + 0.05, (Math.floor(at / 14) % 14) * 0.1 + 0.05, Math.floor(at / 196)] as const;
  const point = [[u, v, 0], [u, 0, v], [0, u, v]][face] ?? [];
  return { point: point.map((value) => value.toFixed(3)), face };
});

const rows = (separator: string) => ROWS.map(({ point }) => `${point.join(separator)}\n`).join("");
const LABELS = ROWS.map(({ face }) => `${face}\n`).join("");
const PLY = `ply\nformat ascii 1.0\nelement vertex 588\nproperty float x\nproperty float y\nproperty float z\nproperty int label\nend_header\n${ROWS.map(({ point, face }) => `${point.join(" ")} ${face}\n`).join("")}`;

test("rows, PLY and labels find each other, are scored, and say that their surfaces were fitted", async ({ page }) => {
  await open(page);
  await dropFiles(page, "scans", [
    { path: "cube.csv", text: `x;y;z\n${rows(";")}` },
    { path: "cube_labels.txt", text: LABELS },
    { path: "Net/cube.ply", text: PLY },
  ]);
  await expect(row(page, "cube")).toContainText("Net");
  await expect(row(page, "cube")).toContainText("1.000");
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const section = page.locator("section", { hasText: "For other programs" });
  await expect(section).toContainText("Its surfaces were fitted here to the segments that were given.");
  await picture(page, "bring-share-light");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "bring-share-dark");
  await page.setViewportSize({ width: 360, height: 740 });
  await picture(page, "bring-share-narrow");
  const waiting = page.waitForEvent("download");
  await section.getByRole("button", { name: "Save Primitives, CSV" }).click();
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("cube_Net_primitives.csv");
  const table = await readFile(await download.path(), "utf8");
  expect(table.trim().split("\n")).toHaveLength(4);
  expect(table).toContain("0,Plane,196,");
});

test("types of points beside labels are a file of their own role, and kept to", async ({ page }) => {
  await open(page);
  await dropFiles(page, "typed", [
    { path: "a.xyz", text: rows(" ") },
    { path: "a_inst.txt", text: LABELS },
    { path: "Net/a_inst.txt", text: LABELS },
    { path: "Net/a_type.txt", text: LABELS.replaceAll("0", "1").replaceAll("2", "4") },
  ]);
  await expect(page.locator(".models > ul li")).toContainText("a");
  await page.getByRole("tab", { name: "Files" }).click();
  await expect(page.getByLabel("What typed/Net/a_type.txt is")).toHaveValue("types");
  await page.getByRole("tab", { name: /Diagnostics/ }).click();
  await expect(page.locator(".diagnostics")).toContainText("as ParseNet and HPNet number them");
});

test("a folder of clouds as CloudCompare's RANSAC saves them is the result of a method", async ({ page }) => {
  await open(page);
  const single = (face: number) =>
    ROWS.filter((row) => row.face === face).map(({ point }) => `${point.map((value) => Math.fround(Number(value)).toFixed(8)).join(" ")}\n`).join("");
  const files = [0, 1, 2].map((face) => ({ path: `RANSAC/Plane_000${face + 1}.txt`, text: single(face) }));
  await dropFiles(page, "scans", [
    { path: "cube.csv", text: `x;y;z\n${rows(";")}` },
    { path: "cube_labels.txt", text: LABELS },
    ...files,
    { path: "RANSAC/Leftovers.txt", text: "9 9 9\n" },
  ]);
  await expect(row(page, "cube")).toContainText("RANSAC");
  await expect(row(page, "cube")).toContainText("1.000");
  // Without a cloud beside them they are one, with its truth.
  await dropFiles(page, "alone", files);
  await expect(page.locator(".models > ul li").filter({ hasText: "RANSAC" }).filter({ hasText: "truth only" })).toHaveCount(1);
});

test("a long cloud is read in pieces and tells the line of what is wrong", async ({ page }) => {
  await open(page);
  const lines = Array.from({ length: 450_000 }, (_, at) => `${((at * 0.618034) % 1).toFixed(8)} ${((at * 0.754878) % 1).toFixed(8)} 0.00000000\n`);
  lines[400_000] = "1.0 x 2.0\n";
  await dropFiles(page, "long", [{ path: "long.xyz", text: lines.join("") }]);
  await expect(page.locator(".models > ul li")).toContainText("long");
  await page.getByRole("tab", { name: /Diagnostics/ }).click();
  await expect(page.locator(".diagnostics")).toContainText("400001");
});

test("what is read is listed where data is added", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Add data", exact: true }).first().click();
  await page.getByText("What is read").click();
  await expect(page.locator(".kinds")).toContainText(".ply");
  await picture(page, "bring-add-light");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test("the primitives of a bare cloud can be saved without a truth", async ({ page }) => {
  await open(page);
  await dropFiles(page, "bare", [{ path: "bare.xyz", text: rows(" ") }]);
  await expect(page.locator(".models > ul li")).toContainText("bare");
  await page.getByRole("tab", { name: "Fit" }).click();
  await page.getByRole("button", { name: "Fit bare" }).click();
  await expect(page.locator(".fit")).toContainText("no truth");
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await expect(page.getByText("There is no score to share yet")).toBeVisible();
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save Points, PLY binary" }).click();
  expect((await waiting).suggestedFilename()).toBe("bare_HT.ply");
});
