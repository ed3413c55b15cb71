// Drops as a person makes them: files and folders from the disk, let go over the page.

import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import type { Page } from "@playwright/test";
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

/** Drags paths of the disk over the page and lets go. */
export async function drop(page: Page, paths: readonly string[]): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: [...paths], dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"] as const) {
    await session.send("Input.dispatchDragEvent", { type, x: 300, y: 300, data });
  }
  await session.detach();
}
