// Public models and zips by their address. No test asks the real host: its answers are made here.

import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page, Route } from "@playwright/test";
import { expect, measuresIn, open, picture, row, rows, test } from "./support/test";
import { drop, writeAll, zipOf } from "./support/drop";
import { filesOf, METHOD, scoreOf, type Fixture } from "./support/engine";
import { keptFiles } from "./support/kept";
import { claims, linkOf, openLink } from "./support/sharing";

/** As raw GitHub answers: to anyone. */
const CORS = { "access-control-allow-origin": "*" };
const PUBLIC = "https://raw.githubusercontent.com/chiararomanengo/Fit4CAD/main/";

test("a training model arrives by its number from the public repository", async ({ page }) => {
  const files = filesOf("bracket", "PC7");
  const asked = await serve(page, PUBLIC, training(files));
  await open(page);
  expect(asked, "nothing is asked for before Download").toEqual([]);
  const sheet = await openSheet(page);
  await sheet.getByRole("radio", { name: /Training set/ }).check();
  await sheet.getByLabel("Models", { exact: true }).fill("7");
  await expect(sheet.getByText("1 model, 4 files")).toBeVisible();
  await sheet.getByRole("button", { name: "Download", exact: true }).click();
  await expect(page.locator(".models > ul li")).toHaveCount(1);
  await expect(page.locator(".models > ul li")).toContainText("PC7");
  await expect(page.locator(".models > ul li")).toContainText("truth only");
  await expect(sheet).toBeHidden();
  expect(asked.sort()).toEqual(
    ["", "_implicit", "_parametric", "_primitives"].map((role) => `dataset/training_set/PC7${role}.txt`).sort(),
  );
});

test("test models bring the published results of HT and PG, which are scored", async ({ page }) => {
  const two = filesOf("bracket", "PC2");
  const four = filesOf("flange", "PC4");
  await serve(page, PUBLIC, [...testSet(two), ...testSet(four)]);
  await open(page);
  await download(page, "2, 4");
  await expect(rows(page)).toHaveCount(4);
  expect(await measuresIn(row(page, "PC2").filter({ hasText: "HT" }))).toEqual(scoreOf(two).mean);
  // PG publishes no surfaces: its classification is the same, its accuracy cannot be told.
  const segmentation = scoreOf(two.filter(({ path }) => !/(parametric|implicit)_/.test(path)));
  expect(await measuresIn(row(page, "PC2").filter({ hasText: "PG" }))).toEqual(segmentation.mean);
});

test("the link of public models fetches what the sharer looked at, and the rest when asked", async ({ page }) => {
  const [two, four] = [filesOf("bracket", "PC2"), filesOf("flange", "PC4")];
  const asked = await serve(page, PUBLIC, [...testSet(two), ...testSet(four), ...training(filesOf("housing", "PC2"))]);
  await open(page);
  await download(page, "2, 4");
  await expect(rows(page)).toHaveCount(4);
  await row(page, "PC4").filter({ hasText: "HT" }).getByRole("rowheader").getByRole("button").click();
  const link = await linkOf(page);
  asked.length = 0;
  await openLink(page, link);
  await expect(page.locator(".models > ul li")).toHaveText(/PC4/);
  await expect(claims(page).filter({ hasText: "PC4" })).toContainText("verified here");
  expect(asked.every((path) => path.includes("PC4"))).toBe(true);
  await page.getByRole("button", { name: "Download 1 public model" }).click();
  await expect(page.locator(".banner")).toContainText("Verified here.");
  await expect(page.locator(".stage h2")).toHaveText("PC2");
  // The training set has a PC2 as well.
  expect(asked.every((path) => !path.includes("training_set"))).toBe(true);
});

test("a submission that comes alone for a public model is offered the public cloud", async ({ page }) => {
  const files = filesOf("bracket", "PC7");
  const asked = await serve(page, PUBLIC, training(files));
  await open(page);
  const folder = test.info().outputPath("mine");
  await writeAll(folder, files.filter(({ path }) => path.includes(METHOD)));
  await drop(page, [folder]);
  await page.getByRole("tab", { name: /^Diagnostics/ }).click();
  await expect(page.getByRole("button", { name: "Get PC7 of the test set" })).toBeVisible();
  expect(asked).toEqual([]);
  await page.getByRole("button", { name: "Get PC7 of the training set" }).click();
  await expect(row(page, "PC7")).toHaveCount(0);
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(row(page, "PC7")).toContainText(METHOD);
});

test("a missing file is named and the rest is scored", async ({ page, complaints }) => {
  const lost = "dataset/test_set/pointCloud_parametric/PC3_parametric.txt";
  const files = testSet(filesOf("bracket", "PC3")).filter(({ path }) => path !== lost);
  await serve(page, PUBLIC, files);
  await open(page);
  const sheet = await download(page, "3");
  await expect(rows(page)).toHaveCount(2);
  await expect(sheet.locator(".outcome")).toContainText(`${lost} did not arrive`);
  await page.keyboard.press("Escape");
  await page.getByRole("tab", { name: /Diagnostics/ }).click();
  await expect(page.getByRole("tabpanel")).toContainText(lost);

  // What comes later takes nothing back that is still so.
  await page.getByRole("button", { name: "Add data" }).click();
  const note = { name: "notes.dat", mimeType: "text/plain", buffer: Buffer.from("nothing") };
  await page.getByLabel("Choose files or zips").setInputFiles(note);
  await expect(page.getByRole("tabpanel")).toContainText("notes.dat");
  await expect(page.getByRole("tabpanel")).toContainText(lost);
  forgive(complaints, /404/);
});

test("results that were never published are only noted", async ({ page, complaints }) => {
  const files = testSet(filesOf("bracket", "PC3")).filter(({ path }) => !path.includes("_PG"));
  await serve(page, PUBLIC, files);
  await open(page);
  const sheet = await download(page, "3");
  await expect(rows(page)).toHaveCount(1);
  await expect(sheet.locator(".outcome")).toContainText("the models are complete without");
  await expect(sheet.locator(".outcome li")).toHaveText(/pointCloud_primitives_PG\/PC3_primitives\.txt/);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id }) => id)).toEqual([]);
  await picture(page, "sheet-public-models");
  forgive(complaints, /404/);
});

test("without a network the page says so", async ({ page, context, complaints }) => {
  const sheetCame = page.waitForResponse(/\/add-sheet-[^/]+\.js$/);
  await open(page);
  // The sheet is fetched a while after a model is seen, with what it is made of.
  await sheetCame;
  await page.waitForTimeout(500);
  await context.setOffline(true);
  const sheet = await download(page, "1");
  await expect(sheet.locator(".outcome")).toContainText("You are offline, and raw.githubusercontent.com cannot be reached");
  await expect(rows(page)).toHaveCount(1);
  // The service worker, which is fetched a while after the page, may be on its way.
  forgive(complaints, /ERR_INTERNET_DISCONNECTED|fetching the script/);
});

test("a file beyond all measure is left, as is one the host refuses, and the rest is taken", async ({ page, complaints }) => {
  const files = testSet(filesOf("bracket", "PC3"));
  await serve(page, PUBLIC, files);
  await page.route(`${PUBLIC}dataset/test_set/pointCloud_implicit/*`, (route) => answer(route, Buffer.alloc(33 * 2 ** 20, " ")));
  await page.route(`${PUBLIC}MATLAB/pointCloud_primitives_PG/*`, (route) => route.fulfill({ status: 429, headers: CORS }));
  await open(page);
  const sheet = await download(page, "3");
  const left = sheet.locator(".outcome li");
  await expect(left.filter({ hasText: "pointCloud_implicit/PC3" })).toContainText("larger than 32 MiB");
  await expect(left.filter({ hasText: "PG" })).toContainText("429 (too many requests");
  await expect(row(page, "PC3")).toHaveCount(1);
  await expect(row(page, "PC3")).toContainText("HT");
  forgive(complaints, /429/);
});

test("numbers that make no sense are explained", async ({ page }) => {
  await open(page);
  const sheet = await openSheet(page);
  const numbers = sheet.getByLabel("Models", { exact: true });
  const button = sheet.getByRole("button", { name: "Download", exact: true });
  for (const [text, answer] of [
    ["", "from 1 to 35"],
    ["36", "outside this set"],
    ["0", "outside this set"],
    ["5-2", "Write 2-5"],
    ["two", "“two” is no number"],
  ] as const) {
    await numbers.fill(text);
    await expect(sheet.locator("#public-count")).toContainText(answer);
    await expect(button).toBeDisabled();
  }
  await numbers.fill("1 - 3, PC3 9");
  await expect(sheet.locator("#public-count")).toHaveText("4 models, 32 files");
  await expect(button).toBeEnabled();
});

test("a stopped download keeps the models that had arrived", async ({ page }) => {
  const first = training(filesOf("bracket", "PC1"));
  await serve(page, PUBLIC, first);
  // The second model never ends.
  await page.route(`${PUBLIC}dataset/training_set/PC2*`, () => {});
  await open(page);
  const sheet = await openSheet(page);
  await sheet.getByRole("radio", { name: /Training set/ }).check();
  await sheet.getByLabel("Models", { exact: true }).fill("1-2");
  await sheet.getByRole("button", { name: "Download", exact: true }).click();
  await expect(sheet.getByText("4 of 8 files")).toBeVisible();
  await sheet.getByRole("button", { name: "Stop the download" }).click();
  await expect(sheet.locator(".outcome")).toContainText("Download stopped. 1 of 2 taken.");
  await expect(page.locator(".models > ul li")).toHaveCount(1);
  await expect(page.locator(".models > ul li")).toContainText("PC1");
});

test("a copy of the repository on the page's own host takes its place, a foreign one does not", async ({ page, baseURL }) => {
  const files = filesOf("bracket", "PC5");
  await serve(page, `${baseURL}copy/`, testSet(files));
  await page.goto("./?source=copy");
  await expect(rows(page)).toHaveCount(1);
  await download(page, "5");
  await expect(row(page, "PC5")).toHaveCount(2);
  await expect.poll(async () => (await keptFiles(page)).length, { message: "files that the browser keeps" }).toBe(testSet(files).length);
  await page.goto("./?source=https://example.org/copy");
  // The work of the visit before.
  await expect(row(page, "PC5")).toHaveCount(2);
  const sheet = await openSheet(page);
  await expect(sheet.getByRole("alert")).toContainText("own host");
  await expect(sheet.getByRole("button", { name: "Download", exact: true })).toHaveCount(0);
});

test("?data= opens a zip of the same host", async ({ page }) => {
  const files = filesOf("bracket", "PC6");
  await page.route("**/course/week1.zip", (route) => answer(route, zipOf(files)));
  await page.goto("./?data=course/week1.zip");
  await expect(row(page, "PC6")).toBeVisible();
  await expect(rows(page)).toHaveCount(1);
  expect(await measuresIn(row(page, "PC6"))).toEqual(scoreOf(files).mean);
});

test("?data= opens a zip of raw GitHub", async ({ page }) => {
  await page.route("https://raw.githubusercontent.com/somebody/results/main/all.zip", (route) =>
    answer(route, zipOf(filesOf("bracket", "PC6"))),
  );
  await page.goto("./?data=https://raw.githubusercontent.com/somebody/results/main/all.zip");
  await expect(row(page, "PC6")).toBeVisible();
});

for (const [what, address, why] of [
  ["another host", "https://example.org/all.zip", "own host"],
  ["a host that only begins alike", "https://raw.githubusercontent.com.example.org/all.zip", "own host"],
  ["another scheme", "data:application/zip;base64,UEsFBg.zip", "own host"],
  ["what is no zip", "index.html", "end in .zip"],
] as const) {
  test(`?data= refuses ${what}, says why and asks for nothing`, async ({ page }) => {
    const asked: string[] = [];
    page.on("request", (request) => asked.push(request.url()));
    await page.goto(`./?data=${encodeURIComponent(address)}`);
    await expect(page.locator(".notice")).toContainText(why);
    await expect(rows(page)).toHaveCount(1);
    expect(asked).not.toContain(new URL(address, page.url()).href);
  });
}

test("?data= of a zip that is not there says so", async ({ page }) => {
  await page.goto("./?data=nowhere.zip");
  await expect(page.locator(".notice")).toContainText("has no such file");
});

async function openSheet(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Add data" }).click();
  return page.getByRole("dialog", { name: "Add data" });
}

/** Downloads models of the test set. */
async function download(page: Page, numbers: string): Promise<Locator> {
  const sheet = await openSheet(page);
  await sheet.getByLabel("Models", { exact: true }).fill(numbers);
  await sheet.getByRole("button", { name: "Download", exact: true }).click();
  return sheet;
}

/** Stands in for a host; the paths asked for are noted. */
async function serve(page: Page, base: string, files: readonly Fixture[]): Promise<string[]> {
  const texts = new Map(files.map(({ path, text }) => [path, text]));
  const asked: string[] = [];
  await page.route(`${base}**`, (route) => {
    const path = route.request().url().slice(base.length);
    asked.push(path);
    return answer(route, texts.get(path));
  });
  return asked;
}

function answer(route: Route, body: string | Buffer | undefined): Promise<void> {
  return route.fulfill(body === undefined ? { status: 404, headers: CORS } : { body, headers: CORS, contentType: "text/plain" });
}

/** The layout of the training set: everything in one folder, no results. */
function training(files: readonly Fixture[]): Fixture[] {
  return files
    .filter(({ path }) => !path.includes(METHOD))
    .map(({ path, text }) => ({ path: `dataset/training_set/${path.split("/").at(-1)}`, text }));
}

/** The layout of the test set, with the same results published for HT and, without surfaces, for PG. */
function testSet(files: readonly Fixture[]): Fixture[] {
  return files.flatMap(({ path, text }) => {
    if (!path.includes(METHOD)) return [{ path: `dataset/test_set/${path}`, text }];
    const of = (method: string) => ({ path: `MATLAB/${path.replace(METHOD, method)}`, text });
    return path.startsWith("pointCloud_primitives") ? [of("HT"), of("PG")] : [of("HT")];
  });
}

/** The browser itself logs every request that fails; here that is what was wanted. */
function forgive(complaints: string[], what: RegExp): void {
  const others = complaints.filter((text) => !what.test(text));
  complaints.splice(0, complaints.length, ...others);
}
