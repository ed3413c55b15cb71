import { existsSync } from "node:fs";
import { join } from "node:path";
import AxeBuilder from "@axe-core/playwright";
import { readFragment, writeFragment } from "../../www/app/sharing/codec/link";
import { expect, measuresIn, open, picture, row, rows, test } from "./support/test";
import { filesOf, scoreOf, scoreOfSample } from "./support/engine";
import { drop, zipOf } from "./support/drop";
import { claims, dropFiles, linkOf, openLink } from "./support/sharing";

/** A link with its results changed, as a cheat would. */
function tampered(link: string, change: (results: ReturnType<typeof readFragment>) => ReturnType<typeof readFragment>): string {
  const [page = "", fragment = ""] = link.split("#");
  return page + writeFragment(change(readFragment(fragment)));
}

test("a shared link shows its figures as claimed, and as verified once the same files are dropped", async ({ page }) => {
  const [bracket, flange] = [filesOf("bracket", "PC7"), filesOf("flange", "PC8")];
  await open(page);
  await dropFiles(page, "mine", [...bracket, ...flange]);
  await expect(rows(page)).toHaveCount(2);
  await openLink(page, await linkOf(page));
  await expect(claims(page)).toHaveCount(2);
  await expect(claims(page).getByText("as claimed")).toHaveCount(2);
  await expect(page.locator(".banner")).toContainText("As claimed.");
  const claimed = claims(page).filter({ hasText: "PC7" });
  for (const value of Object.values(scoreOf(bracket).mean)) {
    await expect(claimed.locator(`td[title="${value}"]`)).not.toHaveCount(0);
  }
  await picture(page, "shared-claimed");

  await dropFiles(page, "theirs", bracket);
  await expect(claimed).toContainText("verified here");
  await expect(claims(page).filter({ hasText: "PC8" })).toContainText("as claimed");
  await expect(page.locator(".banner")).toContainText("1 verified here");
  // The same files under another name bear the figures out, but not the name.
  const other = await dropFiles(page, "theirs too", filesOf("flange", "renamed"));
  const renamed = claims(page).filter({ hasText: "PC8" });
  await expect(renamed).toContainText("called otherwise here");
  await expect(renamed).toContainText("your files: model “renamed”");
  await expect(page.locator(".banner")).toContainText("1 of files that are called otherwise here");
  await picture(page, "shared-renamed");
  expect(other).toContain("theirs too");
  await dropFiles(page, "and again", flange);
  await expect(page.locator(".banner")).toContainText("Verified here.");
  await picture(page, "shared-verified");
  // On a phone the figures are far down the page.
  await page.setViewportSize({ width: 360, height: 640 });
  await page.getByRole("button", { name: "Show the figures" }).click();
  await expect(page.getByRole("tab", { name: /^Shared/ })).toBeInViewport();
  await expect(claims(page).first()).toBeInViewport();
  await picture(page, "shared-narrow");
});

test("a figure that was tampered with is shown beside the one found here", async ({ page }) => {
  const files = filesOf("bracket", "PC7");
  const { DSC } = scoreOf(files).mean;
  await open(page);
  await dropFiles(page, "mine", files);
  await expect(row(page, "PC7")).toBeVisible();
  const lie = (value: number) => (link: string) =>
    tampered(link, (results) => ({
      ...results,
      engine: "0.0.1",
      claims: results.claims.map((claim) => ({ ...claim, mean: { ...claim.mean, DSC: value } })),
    }));
  const link = await linkOf(page);
  await openLink(page, lie(0.9)(link));
  await expect(claims(page)).toContainText("as claimed");
  await expect(claims(page)).toContainText("0.9000");
  await dropFiles(page, "theirs", files);
  await expect(claims(page)).toContainText("figures differ");
  await expect(claims(page).locator("del")).toHaveText("claimed 0.9000");
  await expect(claims(page).locator("ins")).toHaveText(`found here ${DSC?.toFixed(4)}`);
  await expect(page.locator(".banner")).toContainText("The figures differ.");
  await expect(page.locator(".banner")).toContainText(/Claimed with engine 0\.0\.1, checked with engine \d+\.\d+\.\d+/);
  await picture(page, "shared-differs");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);

  // One bit is enough; then all digits are shown.
  const next = (DSC ?? 0) + 2 ** -53;
  await openLink(page, lie(next)(link));
  await dropFiles(page, "again", files);
  await expect(claims(page).locator("del")).toHaveText(`claimed ${next}`);
  await expect(claims(page).locator("ins")).toHaveText(`found here ${DSC}`);
});

test("the benchmark's own results are shared in under 2,000 characters and verified", async ({ page }) => {
  const shared = process.env["FIT4CAD_SHARED"] ?? join(import.meta.dirname, "../../../shared");
  const sample = join(shared, "fit4cad/test_sample");
  test.skip(!existsSync(sample), "needs the benchmark's files in ../shared/fit4cad or $FIT4CAD_SHARED/fit4cad");
  await open(page);
  await drop(page, [sample]);
  await expect(rows(page)).toHaveCount(20);
  const link = await linkOf(page);
  expect(link.length).toBeLessThan(2000);
  await openLink(page, link);
  await expect(claims(page)).toHaveCount(10);
  await drop(page, [sample]);
  await expect(page.locator(".banner")).toContainText("Verified here.", { timeout: 60_000 });
  await page.getByRole("tab", { name: "Comparison" }).click();
  await expect(page.locator(".differences tbody tr")).toHaveCount(10);
  // The published HT against itself.
  await expect(page.getByRole("row", { name: /^Won, lost, even/ }).getByRole("cell").first()).toHaveText("0, 0, 10");
});

test("other files under the same name do not verify a claim", async ({ page }) => {
  await open(page);
  await dropFiles(page, "mine", filesOf("bracket", "PC7"));
  await expect(row(page, "PC7")).toBeVisible();
  await openLink(page, await linkOf(page));
  await expect(claims(page)).toHaveCount(1);
  await dropFiles(page, "other", filesOf("bracket", "PC7", { seed: 9 }));
  await expect(claims(page)).toContainText("other ground truth and submission");
});

test("the link of a sample makes the scene again, with selection, colours and protocol", async ({ page }) => {
  await open(page);
  const model = (await rows(page).getByRole("rowheader").textContent()) ?? "";
  await page.getByRole("radio", { name: "Published" }).check({ force: true });
  await page.getByLabel("Colour").selectOption({ label: "The paper's figure" });
  await page.getByRole("tab", { name: "Primitives" }).click();
  await page.locator(".panel tbody .row-name").nth(2).click();
  const canvas = page.locator(".canvas-box canvas");
  await canvas.focus();
  for (let turn = 0; turn < 6; turn++) await page.keyboard.press("ArrowLeft");
  const link = await linkOf(page);
  const { view, models, protocol } = readFragment(link.split("#")[1] ?? "");
  expect(models[0]?.origin).toEqual({ kind: "sample", part: model, options: {} });
  expect(view?.camera).toBeDefined();

  await page.evaluate(() => localStorage.clear());
  await openLink(page, link);
  await expect(page.locator(".banner")).toContainText(`Recomputed from the link. 1 shared result under the published protocol: the sample ${model} with its imperfect submission`);
  await expect(claims(page).locator(`td[title="${scoreOfSample(model, protocol).mean.PPV}"]`)).not.toHaveCount(0);
  await expect(page.getByLabel("Colour")).toHaveValue("figure");
  await expect(page.getByRole("radio", { name: "Published" })).toBeChecked();
  await page.getByRole("tab", { name: "Primitives" }).click();
  await expect(page.locator(".panel tbody tr").nth(2)).toHaveAttribute("aria-current", "true");
  // The camera ends where the sharer's was: the same link comes out again.
  const again = readFragment((await linkOf(page)).split("#")[1] ?? "").view;
  expect(again?.primitive).toEqual(view?.primitive);
  for (const [at, value] of (view?.camera?.rotation ?? []).entries()) {
    expect(again?.camera?.rotation[at]).toBeCloseTo(value, 4);
  }
  expect(again?.camera?.height).toBeCloseTo(view?.camera?.height ?? NaN, 2);
});

test("the link of a fit on this page repeats it, and what stood beside it", async ({ page }) => {
  await open(page);
  await page.getByRole("tab", { name: "Fit", exact: true }).click();
  const panel = page.getByRole("tabpanel");
  await panel.getByRole("radio", { name: "PG" }).check({ force: true });
  await panel.getByLabel("Smallest", { exact: true }).fill("12");
  await panel.getByLabel("Seed", { exact: true }).fill("5");
  await panel.getByRole("button", { name: /^Fit / }).click();
  await expect(page.getByLabel("Right view").locator("option:checked")).toHaveText("PG", { timeout: 45_000 });
  await page.getByLabel("Left view").selectOption({ label: "Imperfect" });
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(rows(page)).toHaveCount(2);
  const scored = await measuresIn(rows(page).filter({ hasText: "PG" }));
  const link = await linkOf(page);
  const { claims: shared, view } = readFragment(link.split("#")[1] ?? "");
  expect(shared.map(({ fitted }) => fitted)).toEqual([{ method: "pg", seed: 5, parameters: { smallest: 12 } }]);
  expect(view).toMatchObject({ method: "PG", left: "Imperfect" });

  await openLink(page, link);
  await expect(page.locator(".banner")).toContainText("Recomputed from the link.", { timeout: 45_000 });
  await expect(claims(page)).toContainText("recomputed from the link");
  await expect(claims(page)).toContainText("PG (seed 5, smallest 12) on the sample bracket");
  await expect(claims(page).locator(`td[title="${scored["DSC"]}"]`)).not.toHaveCount(0);
  await expect(page.getByLabel("Right view").locator("option:checked")).toHaveText("PG");
  await expect(page.getByLabel("Left view").locator("option:checked")).toHaveText("Imperfect");
});

test("a link's sample stands beside another of its part; one stop ends its fits, and what was not repeated says so", async ({ page }) => {
  await open(page);
  const part = (await rows(page).getByRole("rowheader").textContent()) ?? "";
  const link = tampered(await linkOf(page), (results) => ({
    ...results,
    models: results.models.map((model) => ({ ...model, inputs: "0123456789abcdef", origin: { kind: "sample", part, options: { seed: 9 } } })),
    claims: [
      ...results.claims,
      ...[1, 2, 3, 4, 5, 6].flatMap((seed) =>
        results.claims.map((claim) => ({ ...claim, method: `PG ${seed}`, fitted: { method: "pg" as const, seed, parameters: {} } })),
      ),
    ],
  }));
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  // The sample is made unasked; none of the fits is in view.
  const rest = page.getByRole("button", { name: /^(Make|Repeat)/ });
  await expect(rest).toHaveText(/^Repeat 6 fits \(about \d s\)$/);
  await rest.click();
  await page.getByRole("button", { name: "Stop recomputing" }).click();
  await expect(page.locator(".banner")).toContainText("not recomputed");
  await expect(page.getByRole("button", { name: /^Stop/ })).toHaveCount(0);
  await expect(claims(page).filter({ hasText: "not recomputed" })).not.toHaveCount(0);
  await expect(rest).toHaveText(/^Repeat \d fits? \(about \d s\)$/);
  await picture(page, "shared-stopped");
  await rest.click();
  await expect(page.locator(".notice")).toHaveText(/^\d fits? of the link repeated here\.$/, { timeout: 45_000 });
  await page.getByRole("tab", { name: "Measures" }).click();
  await expect(row(page, part)).toHaveCount(1);
  await expect(row(page, `${part}-seed9`)).toHaveCount(7);
});

test("fits of a link that fail tell why, and are offered again", async ({ page }) => {
  await open(page);
  const wrong = (method: string, parameters: Record<string, number>) => ({ method, submission: "0123456789abcdef", fitted: { method: "pg" as const, seed: 1, parameters } });
  const fits = [wrong("PG", { smallest: 5.5 }), wrong("PG 2", { smallest: 5.5, tolerance: 0.01 }), wrong("PG 3", { wisdom: 1 })];
  const link = tampered(await linkOf(page), (results) => ({
    ...results,
    claims: [...results.claims, ...fits.flatMap((fit) => results.claims.map((claim) => ({ ...claim, ...fit })))],
  }));
  await openLink(page, link);
  const banner = page.locator(".banner");
  await banner.getByRole("button", { name: /^Repeat 3 fits/ }).click();
  await expect(banner).toContainText("3 whose fit failed. “PG” of “bracket” and 1 more: `smallest` must be a whole number");
  await expect(banner).toContainText("(1 other reason: see the figures)");
  const reasons = page.getByRole("list", { name: "Fits that failed" }).getByRole("listitem");
  await expect(reasons).toHaveText([/^“PG” of “bracket” and 1 more: `smallest` must be a whole number.*not 5\.5/, /^“PG 3” of “bracket”: there is no parameter `wisdom`/]);
  await expect(claims(page).filter({ hasText: "fit failed" })).toHaveCount(3);
  await picture(page, "shared-failed");
  await banner.getByRole("button", { name: /^Repeat 3 fits/ }).click();
  await expect(page.locator(".notice")).toHaveText("0 of 3 fits of the link repeated here; 3 failed.");
  await expect(banner).toContainText("3 whose fit failed");
});

test("a damaged link says so, and the page works on", async ({ page }) => {
  await open(page);
  const link = await linkOf(page);
  await openLink(page, link.slice(0, -5));
  await expect(page.getByRole("alert")).toContainText("This link is damaged");
  await expect(rows(page)).toHaveCount(1);
  await picture(page, "shared-damaged");
  await page.getByRole("button", { name: "Close the link" }).click();
  await expect(page.locator(".banner")).toHaveCount(0);
  expect(new URL(page.url()).hash).toBe("");
});

test("a link that names no files says that it cannot be checked", async ({ page }) => {
  await open(page);
  const nameless = tampered(await linkOf(page), (results) => ({
    ...results,
    claims: results.claims.map(({ submission: _, ...claim }) => claim),
  }));
  await openLink(page, nameless);
  await expect(claims(page)).toContainText("cannot be checked");
  await expect(page.locator(".banner")).toContainText("they cannot be checked");
});

test("a link cannot verify itself: what it says how to have is recomputed, and one result is one, whatever it is called", async ({ page }) => {
  await open(page);
  const forged = tampered(await linkOf(page), ({ models: [model], claims: [claim], ...rest }) => ({
    ...rest,
    models: Array.from({ length: 35 }, (_, at) => ({ ...model!, name: `PC${at + 1}` })),
    claims: Array.from({ length: 35 }, (_, at) => ({ ...claim!, model: at, method: "MyNet (ours)" })),
  }));
  for (const address of [forged, forged.replace("#", "?embed#")]) {
    await openLink(page, address);
    await expect(claims(page)).toHaveCount(35);
    await expect(claims(page).first()).toContainText("recomputed from the link");
    await expect(claims(page).first()).toContainText("the sample bracket with its imperfect submission");
    await expect(claims(page).filter({ hasText: "repeats “MyNet (ours)” on “PC1”" })).toHaveCount(34);
    const standing = page.locator(".banner, .embed .bar");
    await expect(standing).toContainText("Recomputed from the link. 35 shared results, all of them one and the same");
    await expect(standing).toContainText("What the link calls them is not borne out.");
    await expect(page.locator("tfoot")).toContainText("34 of 35 repeat others");
    await expect(page.getByText(/verified here/i)).toHaveCount(0);
  }
  await openLink(page, forged);
  await expect(claims(page).first()).toContainText("recomputed from the link");
  await expect(page.locator(".banner")).not.toHaveAttribute("data-kind", "good");
  for (const theme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme: theme });
    await picture(page, `shared-recomputed-${theme}`);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  }
  await page.setViewportSize({ width: 360, height: 640 });
  await page.getByRole("button", { name: "Show the figures" }).click();
  await picture(page, "shared-recomputed-360");
});

test("files that the address itself names bear a claim out no better", async ({ page }) => {
  const files = filesOf("bracket", "PC7");
  await open(page);
  await dropFiles(page, "mine", files);
  await expect(row(page, "PC7")).toBeVisible();
  const link = await linkOf(page);
  await page.route("**/forged/week1.zip", (route) => route.fulfill({ body: zipOf(files), contentType: "application/zip" }));
  await openLink(page, link.replace("#", "?data=forged/week1.zip#"));
  await expect(claims(page)).toContainText("recomputed from the link");
  await expect(claims(page)).toContainText(/files of http.*\/forged\/week1\.zip/);
  // The same files from the reader's own hand.
  await dropFiles(page, "theirs", files);
  await expect(claims(page)).toContainText("verified here");
});

test("a submission that is the ground truth itself, and files that match in part, are told", async ({ page }) => {
  const files = filesOf("bracket", "PC7");
  const truth = new Map(files.map(({ path, text }) => [path, text]));
  // With blanks of its own, which change no digit.
  const copied = files.map(({ path, text }) => ({ path, text: path.includes("_Imperfect") ? `${truth.get(path.replace("_Imperfect", ""))}\n ` : text }));
  await open(page);
  await dropFiles(page, "mine", copied);
  await expect(row(page, "PC7")).toBeVisible();
  const link = await linkOf(page);
  await openLink(page, link);
  // Without its surfaces it is another submission.
  await dropFiles(page, "part", copied.filter(({ path }) => !/_(parametric|implicit)_Imperfect/.test(path)));
  await expect(claims(page)).toContainText("other submission");
  await dropFiles(page, "whole", copied);
  await expect(claims(page)).toContainText("the ground truth itself");
  await expect(page.locator(".banner")).toContainText("1 of the ground truth itself");
});

/** Of no files that anybody has. */
const UNKNOWN = { submission: "0123456789abcdef" };

test("a link of two hundred fits starts none that is not in view, and says what all of them take", async ({ page }) => {
  await open(page);
  const link = tampered(await linkOf(page), (results) => ({
    ...results,
    claims: Array.from({ length: 200 }, (_, seed) =>
      results.claims.map((claim) => ({ ...claim, ...UNKNOWN, method: `PG ${seed}`, fitted: { method: "pg" as const, seed, parameters: {} } })),
    ).flat(),
  }));
  await openLink(page, link);
  const rest = page.locator(".banner").getByRole("button", { name: /^Repeat/ });
  await expect(rest).toHaveText(/^Repeat 200 fits \(about \d+ s\)$/);
  await expect(page.locator(".banner")).toContainText("200 not recomputed");
  await rest.click();
  await page.getByRole("button", { name: "Stop recomputing" }).click();
  await expect(rest).toHaveText(/^Repeat 1\d\d fits|^Repeat 200 fits/);
});

test("what a link has done unasked ends where it takes longer than it should", async ({ page }) => {
  await page.clock.install();
  await open(page);
  const link = tampered(await linkOf(page), (results) => ({
    ...results,
    models: results.models.map((model) => ({ ...model, origin: { kind: "sample" as const, part: "bracket", options: { spacing: 0.0025 } } })),
    claims: results.claims.map((claim) => ({ ...claim, ...UNKNOWN, method: "PG", fitted: { method: "pg" as const, seed: 1, parameters: {} } })),
    view: { model: 0, method: "PG" },
  }));
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await expect(page.getByRole("button", { name: "Stop recomputing" })).toBeVisible();
  await page.clock.fastForward(21_000);
  await expect(page.locator(".notice")).toContainText("took longer than 20 s and was stopped");
  await expect(page.getByRole("button", { name: /^(Make 1 sample, repeat|Repeat) 1 fit/ })).toBeVisible();
});

test("a link's protocol and arrangement are shown with it, and are not the reader's own for later visits", async ({ page }) => {
  await open(page);
  const link = tampered(await linkOf(page), (results) => ({
    ...results,
    protocol: "published",
    view: { ...results.view!, arrangement: "wipe", camera: { target: [0, 0, 0], rotation: [0, 0, 0, 1], height: 100, projection: "orthographic" } },
  }));
  await openLink(page, link);
  const published = page.getByRole("radio", { name: "Published" });
  await expect(published).toBeChecked();
  await expect(page.getByLabel("Arrangement")).toHaveValue("wipe");
  const kept = () => page.evaluate(() => ["protocol", "arrangement", "projection"].map((key) => localStorage.getItem(`fit4cad.${key}`)));
  expect(await kept()).toEqual(["definition", "split", "perspective"]);
  await page.getByRole("button", { name: "Close the link" }).click();
  await expect(page.getByRole("radio", { name: "Definition" })).toBeChecked();
  // What the reader chooses while a link is open is the reader's own.
  await openLink(page, link);
  await page.getByRole("radio", { name: "Definition" }).check({ force: true });
  await published.check({ force: true });
  expect((await kept())[0]).toBe("published");
});

test("a link made with another engine says so, and is no mismatch for that", async ({ page }) => {
  await open(page);
  const link = tampered(await linkOf(page), (results) => ({ ...results, engine: "0.0.1" }));
  await openLink(page, link);
  await expect(page.locator(".banner")).toContainText(/Recomputed from the link\..* Claimed with engine 0\.0\.1, checked with engine \d/);
  await expect(page.locator(".banner")).not.toHaveAttribute("data-kind", "error");
  // The version is the link's own text, and no place for a verdict.
  await openLink(page, tampered(link, (results) => ({ ...results, engine: "0.1.0. Nobody doubts it" })));
  await expect(page.locator(".banner")).toContainText("Claimed with an engine that does not tell its version");
  await expect(page.getByText("Nobody doubts it")).toHaveCount(0);
});

test("names in a link are text, and its numbers cannot make the page work without end", async ({ page }) => {
  await open(page);
  const link = await linkOf(page);
  const markup = "<img src=x onerror=\"document.title='injected'\">";
  const part = readFragment(link.split("#")[1] ?? "").models[0]?.origin;
  const hostile = tampered(link, (results) => ({
    ...results,
    engine: markup,
    models: results.models.map((model) => ({ ...model, name: markup, points: 2 ** 32 })),
    claims: results.claims.map((claim) => ({ ...claim, method: markup, predicted: 2 ** 32 })),
  }));
  await openLink(page, hostile);
  await expect(claims(page).getByRole("rowheader")).toHaveText(markup);
  await expect(page).toHaveTitle("Fit4CAD Playground");

  const endless = tampered(link, (results) => ({
    ...results,
    view: { model: 0, primitive: { side: "truth", index: 2 ** 32 }, camera: { target: [1e38, 0, 0], rotation: [0, 0, 0, 0], height: -1, projection: "perspective" } },
    models: results.models.map((model) => ({ ...model, origin: part?.kind === "sample" ? { ...part, options: { spacing: 1e-300, seed: -1.5 } } : { kind: "files" } })),
  }));
  await openLink(page, endless);
  await expect(claims(page)).toContainText("not recomputed");
  await page.getByRole("button", { name: /^Make 1 sample/ }).click();
  await expect(page.locator(".notice")).toContainText("could not be made");
});

test("an embedded link is to look at only, and opens full", async ({ page, context }) => {
  await open(page);
  const link = await linkOf(page);
  await openLink(page, link.replace("#", "?embed#"));
  await expect(claims(page)).toHaveCount(1);
  await expect(page.locator(".embed .bar")).toContainText("Recomputed from the link.");
  await expect(page.locator(".canvas-box canvas")).toBeVisible();
  await expect(page.getByRole("button", { name: "Add data" })).toHaveCount(0);
  await expect(page.locator(".canvas-state")).toHaveCount(0);
  await picture(page, "embed-light");
  await page.setViewportSize({ width: 360, height: 640 });
  await picture(page, "embed-narrow");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const opening = context.waitForEvent("page");
  await page.getByRole("link", { name: "Open full" }).click();
  const full = await opening;
  await expect(full.getByRole("button", { name: "Add data" }).first()).toBeVisible();
  await expect(claims(full)).toHaveCount(1);

  await page.goto("about:blank");
  await page.goto("./?embed");
  await expect(page.locator("main")).toContainText("This address holds no results");

  // A zip of results, without any link.
  const files = filesOf("flange", "PC6");
  await page.route("**/course/week1.zip", (route) => route.fulfill({ body: zipOf(files), contentType: "application/zip" }));
  await page.goto("./?embed&data=course/week1.zip");
  await expect(rows(page)).toHaveCount(1);
  expect(await measuresIn(row(page, "PC6"))).toEqual(scoreOf(files).mean);
  await expect(page.locator(".embed .bar")).toContainText("1 model");
  await expect(page.getByRole("link", { name: "Open full" })).toHaveAttribute("href", /\?data=/);
  await picture(page, "embed-data");
  await page.goto("./?embed&data=https://example.org/all.zip");
  await expect(page.getByRole("alert")).toContainText("own host");
});

test("an embedded zip that is cut short, empty or holds no model says what is wrong", async ({ page }) => {
  const whole = zipOf(filesOf("flange", "PC6"));
  const empty = Buffer.from([0x50, 0x4b, 5, 6, ...Array<number>(18).fill(0)]);
  const zips = {
    "short.zip": [whole.subarray(0, whole.length / 2), /“short\.zip” gave no model\. .*could not be (opened|read)/i],
    "none.zip": [Buffer.alloc(0), /“none\.zip” gave no model\./],
    "empty.zip": [empty, /“empty\.zip” gave no model\. There is no file in it\./],
    "photos.zip": [zipOf([{ path: "beach.jpg", text: "no text" }]), /“photos\.zip” gave no model\. photos\.zip\/beach\.jpg: /],
  } as const;
  for (const [name, [body, said]] of Object.entries(zips)) {
    await page.route(`**/${name}`, (route) => route.fulfill({ body, contentType: "application/zip" }));
    await page.goto(`./?embed&data=${name}`);
    await expect(page.getByRole("alert")).toContainText(said);
    await expect(page.getByText("Opening the data")).toHaveCount(0);
    await picture(page, `embed-${name.replace(".zip", "")}`);
  }
});
