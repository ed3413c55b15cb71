// How models come on the page, and which of them comes into view then.

import { contents } from "./contents";
import { bring, unplaced, type BroughtFile, type Unplaced } from "./inbox";
import { freeName, madeModels } from "./made";
import { notify } from "./notices";
import type { Origin } from "./origin";
import { selectModel } from "./selection";
import type { ModelFile } from "../../worker/protocol";

/** Takes files in and shows the first model they make or change. `lacking` are files that could not even be opened. */
export async function receive(files: readonly BroughtFile[], lacking: readonly Unplaced[] = []): Promise<void> {
  const before = new Set(contents.value.map(({ source }) => source.key));
  await bring(files, lacking);
  const fresh = contents.value.filter(({ source }) => !before.has(source.key));
  const first = fresh[0];
  if (first) selectModel(first.id);
  const count = (n: number, what: string) => `${n} ${what}${n === 1 ? "" : "s"}`;
  notify(
    `${count(files.length, "file")} received: ${count(fresh.length, "model")} new or changed` +
      (unplaced.value.length > 0 ? `, ${count(unplaced.value.length, "file")} not placed (see Diagnostics).` : "."),
  );
}

/** How a model comes on the page: into view, aside of what is in view, or until something is brought. */
export type Entrance = "shown" | "quiet" | "opening";

/** Puts a model on the page that was made here, beside what is there: where its name is taken, it gets a number. The result is its name. */
export function addMade(wanted: string, origin: Origin, files: readonly ModelFile[], how: Entrance): string | undefined {
  // It makes room for what was brought while it was being made, too.
  if (how === "opening" && contents.value.length > 0) return undefined;
  const name = freeName(wanted, new Set(contents.value.map(({ id }) => id)));
  madeModels.value = new Map(madeModels.value).set(name, { origin, files, makesRoom: how === "opening" });
  if (how !== "quiet") selectModel(name);
  return name;
}

/** Asks for a model made here that is on the page already: it stays, whatever is brought. */
export function keepMade(name: string, how: Entrance): void {
  const known = madeModels.value.get(name);
  if (!known || how === "opening") return;
  if (known.makesRoom) madeModels.value = new Map(madeModels.value).set(name, { ...known, makesRoom: false });
  if (how === "shown") selectModel(name);
}
