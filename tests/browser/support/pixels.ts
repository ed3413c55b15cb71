// What a picture shows, by its content: how much of it is coloured, and in how many colours.

import type { Locator, Page } from "@playwright/test";

export interface Content {
  /** Share of pixels with a colour, not grey. */
  readonly coloured: number;
  /** Number of clearly different hues (twelfths of the circle) with at least 0.1 % of the pixels. */
  readonly hues: number;
  /** Share of nearly black pixels. */
  readonly black: number;
}

export interface Part {
  readonly left: number;
  readonly right: number;
}

export const LEFT: Part = { left: 0, right: 0.5 };
export const RIGHT: Part = { left: 0.5, right: 1 };

/** Content of a vertical stripe of what is on the screen. */
export async function contentOf(page: Page, element: Locator, { left, right }: Part): Promise<Content> {
  const png = (await element.screenshot()).toString("base64");
  return page.evaluate(
    async ({ png, left, right }) => {
      const bytes = Uint8Array.from(atob(png), (character) => character.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const from = Math.round(image.width * left);
      const width = Math.round(image.width * right) - from;
      const canvas = new OffscreenCanvas(width, image.height);
      const context = canvas.getContext("2d");
      if (!context) throw new Error("no 2D context");
      context.drawImage(image, -from, 0);
      const { data } = context.getImageData(0, 0, width, image.height);
      const total = data.length / 4;
      const hues = new Array<number>(12).fill(0);
      let coloured = 0;
      let black = 0;
      for (let at = 0; at < data.length; at += 4) {
        const [r = 0, g = 0, b = 0] = data.subarray(at, at + 3);
        const [high, low] = [Math.max(r, g, b), Math.min(r, g, b)];
        if (high < 24) black++;
        if (high - low < 48) continue;
        coloured++;
        const sector = high === r ? (g - b) / (high - low) : high === g ? 2 + (b - r) / (high - low) : 4 + (r - g) / (high - low);
        const hue = Math.floor(2 * ((sector + 6) % 6));
        hues[hue] = (hues[hue] ?? 0) + 1;
      }
      return {
        coloured: coloured / total,
        black: black / total,
        hues: hues.filter((count) => count > total / 1000).length,
      };
    },
    { png, left, right },
  );
}
