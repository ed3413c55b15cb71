// What the browser keeps for the next visit.

import type { Page } from "@playwright/test";

interface KeptFile {
  readonly path: string;
  /** How many points were asked for, of a part from CAD. */
  readonly points: number | undefined;
}

/** The files that are kept by now. */
export function keptFiles(page: Page): Promise<KeptFile[]> {
  return page.evaluate(
    () =>
      new Promise<KeptFile[]>((resolve) => {
        const opening = indexedDB.open("fit4cad");
        opening.onsuccess = () => {
          const asking = opening.result.transaction("files").objectStore("files").getAll();
          asking.onsuccess = () => {
            opening.result.close();
            const files = asking.result as { path: string; step?: { options: { points?: number } } }[];
            resolve(files.map(({ path, step }) => ({ path, points: step?.options.points })));
          };
        };
      }),
  );
}
