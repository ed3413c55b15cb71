// Drops as a person makes them: files and folders from the disk, let go over the page.

import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { expect, type Page } from "@playwright/test";
import { zipSync } from "fflate";
import type { Fixture } from "./engine";

/** Writes files below a folder. */
export async function writeAll(folder: string, files: readonly Fixture[]): Promise<void> {
  for (const { path, text } of files) {
    const target = join(folder, path);
    await mkdir(dirname(target), { recursive: true });
    await writeFile(target, text);
  }
}

/** The files as one zip. */
export function zipOf(files: readonly Fixture[]): Buffer {
  const entries = files.map(({ path, text }) => [path, new TextEncoder().encode(text)] as const);
  return Buffer.from(zipSync(Object.fromEntries(entries)));
}

/** What a person does who holds paths of the disk over the page, one act at a time. */
export async function dragging(page: Page, paths: readonly string[]): Promise<(type: "dragEnter" | "dragOver" | "drop") => Promise<unknown>> {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: [...paths], dragOperationsMask: 1 };
  return (type) => session.send("Input.dispatchDragEvent", { type, x: 300, y: 300, data });
}

/** Drags paths of the disk over the page and, once the page says so, lets go. */
export async function drop(page: Page, paths: readonly string[]): Promise<void> {
  const drag = await dragging(page, paths);
  // The browser hands nothing to a page that it has not painted yet.
  await expect(async () => {
    await drag("dragEnter");
    await drag("dragOver");
    await expect(page.locator(".dropzone")).toBeVisible({ timeout: 500 });
  }).toPass();
  await drag("drop");
}
