// How models come on the page, and which of them comes into view then.

import { contents } from "./contents";
import { bring, unplaced, type BroughtFile, type Unplaced } from "./inbox";
import { freeName } from "./identity";
import { madeModels } from "./made";
import { notify, type Offer } from "./notices";
import type { Origin } from "./origin";
import { selectModel } from "./selection";
import { plural } from "../ui/format";
import { isSameCloud, joinTwins, twinsAmong, type Twin } from "./twins";
import type { ModelFile } from "../../worker/protocol";

/**
 * Takes files in and shows the first model they make or change. `lacking` are files that could not even be opened. Where
 * what comes may be a model of its own as well as a submission, the likelier is taken and the other offered, once for all.
 */
export async function receive(files: readonly BroughtFile[], lacking: readonly Unplaced[] = []): Promise<void> {
  const before = new Set(contents.value.map(({ source }) => source.key));
  const known = new Set(contents.value.map(({ id }) => id));
  await bring(files, lacking);
  if (files.length === 0) return tellLack(lacking);
  const fresh = contents.value.filter(({ source }) => !before.has(source.key));
  const twins = twinsAmong(fresh.filter(({ id }) => !known.has(id)));
  if (fresh[0]) selectModel(fresh[0].id);
  const text = `${plural(files.length, "file")} received: ${plural(fresh.length, "model")} new or changed`;
  const rest = unplaced.value.length > 0 ? `, ${plural(unplaced.value.length, "file")} not placed (see Diagnostics).` : ".";
  const same = await Promise.all(twins.map(isSameCloud));
  if (twins.length === 0) notify(text + rest);
  else if (same.every((each) => each)) join(twins);
  else keepApart(twins);
}

/** Nothing came: says why, as far as a line can. */
function tellLack(lacking: readonly Unplaced[]): void {
  const [one] = lacking;
  if (!one) return;
  notify(lacking.length === 1 ? `${one.path}: ${one.reason}` : `None of ${plural(lacking.length, "file")} could be opened (see Diagnostics).`, "error");
}

/** Takes what came for submissions, and offers to have models of their own instead. */
function join(twins: readonly Twin[]): void {
  const part = joinTwins(twins);
  show(twins, "old");
  const what = twins.length === 1 ? `a submission for ${twins[0]?.old.id}` : `submissions for ${twins.length} models`;
  ask(`Taken as ${what} of the same cloud.`, `Make ${twins.length === 1 ? "a new model" : "new models"}`, () => {
    part();
    keepApart(twins);
  });
}

/** Leaves what came as models of their own, and offers to have submissions instead. */
function keepApart(twins: readonly Twin[]): void {
  show(twins, "fresh");
  const [one] = twins;
  const what = twins.length === 1 ? `the new model ${one?.fresh.id}, beside ${one?.old.id}` : `${twins.length} new models, beside those of their names`;
  ask(`Taken as ${what}.`, `Make ${twins.length === 1 ? `a submission for ${one?.old.id}` : "submissions for those"}`, () => join(twins));
}

function show(twins: readonly Twin[], which: keyof Twin): void {
  const first = twins[0]?.[which];
  if (first) selectModel(first.id);
}

function ask(text: string, title: string, run: Offer["run"]): void {
  notify(text, "info", { title, run });
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
