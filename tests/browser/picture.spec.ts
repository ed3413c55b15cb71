// Pictures to keep: what is in the file, not what is on the screen.

import { readFile } from "node:fs/promises";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect, open, picture, test } from "./support/test";

interface Saved {
  readonly name: string;
  readonly size: readonly [number, number];
  /** Upper left corner, r g b a. */
  readonly corner: readonly number[];
  /** Number of different opaque, coloured pixels in the lowest tenth. */
  readonly coloursBelow: number;
  /** Share of pixels that are coloured, not grey. */
  readonly coloured: number;
  /** What is written in the file. */
  readonly about: string;
}

async function save(page: Page): Promise<Saved> {
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save PNG" }).click();
  const file = await waiting;
  const bytes = await readFile(await file.path());
  const png = bytes.toString("base64");
  const about = /iTXtfit4cad\0{5}(\{.+?\]\})/s.exec(bytes.toString("latin1"))?.[1] ?? "";
  const seen = await page.evaluate(async (png) => {
    const bytes = Uint8Array.from(atob(png), (character) => character.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!context) throw new Error("no 2D context");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const below = new Set<string>();
    let coloured = 0;
    for (let at = 0; at < data.length; at += 4) {
      const [r = 0, g = 0, b = 0, a = 0] = data.subarray(at, at + 4);
      if (a < 255 || Math.max(r, g, b) - Math.min(r, g, b) < 48) continue;
      coloured++;
      if (at / 4 / image.width > 0.9 * image.height) below.add(`${r} ${g} ${b}`);
    }
    return {
      size: [image.width, image.height] as const,
      corner: [...data.subarray(0, 4)],
      coloursBelow: below.size,
      coloured: (4 * coloured) / data.length,
    };
  }, png);
  await expect(page.getByRole("dialog", { name: "Save a picture" })).toBeHidden();
  return { name: file.suggestedFilename(), about, ...seen };
}

test("a picture is saved in the size and on the ground asked for, with a legend or without", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await open(page);
  // The part made small, so that what is colourful below it is the legend.
  await page.locator(".canvas-box canvas").focus();
  for (let step = 0; step < 6; step++) await page.keyboard.press("-");
  const sheet = page.getByRole("dialog", { name: "Save a picture" });
  await page.getByRole("button", { name: "Save picture" }).click();
  await expect(sheet.getByRole("img")).toBeVisible();
  await sheet.getByLabel("Width").fill("600");
  await sheet.getByLabel("Height").fill("400");
  await sheet.getByRole("radio", { name: "White" }).check({ force: true });
  await picture(page, "sheet-picture-dark");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const white = await save(page);
  expect(white).toMatchObject({ name: "bracket-segments.png", size: [600, 400], corner: [255, 255, 255, 255] });
  expect(white.coloured).toBeGreaterThan(0.005);
  expect(JSON.parse(white.about)).toMatchObject({ protocol: "definition", files: expect.arrayContaining([expect.objectContaining({ path: "pointCloud/bracket.txt" })]) });
  // A swatch for each primitive, however the part lies.
  expect(white.coloursBelow).toBeGreaterThan(8);

  // The scale of distances is the legend then.
  await page.getByLabel("Colour").selectOption("distance");
  await page.locator("body").press("c");
  await sheet.getByRole("radio", { name: "Transparent" }).check({ force: true });
  await picture(page, "sheet-picture-transparent");
  const clear = await save(page);
  expect(clear.name).toBe("bracket-distance.png");
  expect(clear.corner[3]).toBe(0);
  expect(clear.coloursBelow).toBeGreaterThan(60);

  await page.getByRole("button", { name: "Save picture" }).click();
  await sheet.getByLabel("With legend").uncheck();
  await sheet.getByLabel("Height").fill("9000");
  await sheet.getByRole("button", { name: "Save PNG" }).click();
  await expect(sheet, "larger than any picture may be").toBeVisible();
  await sheet.getByLabel("Width").fill("800");
  await sheet.getByLabel("Height").fill("200");
  expect(await save(page)).toMatchObject({ size: [800, 200], coloursBelow: 0 });
});
