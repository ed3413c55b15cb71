// What models are on the page, and of what files each is made: what was brought, what was made here,
// and how the engine sorted it decide that alone.

import { batch, computed } from "@preact/signals";
import type { Grouping } from "../engine/contract";
import type { FitRequest, ModelFile, ModelSource } from "../../worker/protocol";
import { sourceOf } from "./content";
import { brought, discard, discardAll, grouping, keepBrought, overrides } from "./inbox";
import { forget, forgetAll, keepAllMade, madeModels, madeSubmissions, onlyOpening, putSubmission, removeSubmission, type MadeModel, type Submissions } from "./made";
import { notify } from "./notices";
import type { Origin } from "./origin";

/** A model as its files. The same object as long as nothing of it changes. */
export interface Content {
  /** Unique on the page; the model's name. */
  readonly id: string;
  readonly number: number | undefined;
  readonly origin: Origin;
  readonly source: ModelSource;
}

type GroupedFiles = Grouping["models"][number]["files"];

const broughtContents = computed<readonly Content[]>(() =>
  grouping.value.models.flatMap(({ name, number, files }) => {
    const present = withContent(files);
    // Files may have gone since the heap was sorted.
    return present.length > 0 ? [{ id: name, number, origin: originOf(files), source: sourceOf(name, present) }] : [];
  }),
);

const BY_NAME = new Intl.Collator("en", { numeric: true });

const madeContents = computed<readonly Content[]>(() =>
  [...madeModels.value].sort(([a], [b]) => BY_NAME.compare(a, b)).map(([name, model]) => contentOf(name, model)),
);

/** In the engine's order, by number, then by name; after them those made here. Never in order of arrival. */
export const contents = computed<readonly Content[]>(() => {
  const names = new Set(broughtContents.value.map(({ id }) => id));
  const all = [...broughtContents.value, ...madeContents.value.filter(({ id }) => !names.has(id))];
  return all.map((content) => withSubmissions(content, madeSubmissions.value.get(content.id)));
});

/** Whether nothing was brought or asked for yet: there is nothing, or the sample that opens the page. */
export const untouched = computed(() => broughtContents.value.length === 0 && onlyOpening.value);

const byId = computed(() => new Map(contents.value.map((content) => [content.id, content])));

/** Adds a submission made here (by a fitter) to a model that is on the page. */
export function addSubmission(name: string, method: string, files: readonly ModelFile[], request: FitRequest): void {
  if (byId.value.has(name)) putSubmission(name, method, { files, request });
}

/** Takes a model off the page, with its files. */
export function remove(id: string): void {
  const content = byId.value.get(id);
  if (!content) return;
  undoably(`${id} was removed.`, () => {
    forget(id);
    discard(new Set(content.source.files.map(({ path }) => path)));
  });
}

/** Takes a submission made here off its model. */
export function removeMade(id: string, method: string): void {
  undoably(`${method} of ${id} was removed.`, () => removeSubmission(id, method));
}

/** Takes everything off the page. */
export function clear(): void {
  undoably("Everything was removed.", () => {
    forgetAll();
    discardAll();
  });
}

/** Removes something, and offers to have it back for as long as the message stands. */
function undoably(text: string, removal: () => void): void {
  const back = [keepBrought(), keepAllMade()];
  batch(removal);
  notify(text, "info", { title: "Undo", run: () => batch(() => back.forEach((put) => put())) });
}

/** A model whose cloud and truth are those of one public model, as downloaded and not corrected, is that model. */
function originOf(files: GroupedFiles): Origin {
  const own = files.filter(({ method }) => method === undefined);
  const [first] = own.map(({ path }) => brought.value.get(path)?.publicModel);
  const same = own.every(({ path }) => {
    const { publicModel } = brought.value.get(path) ?? {};
    return publicModel?.set === first?.set && publicModel?.number === first?.number && overrides.value[path] === undefined;
  });
  return first && same ? { kind: "public", model: first } : { kind: "files" };
}

function withContent(files: GroupedFiles): ModelFile[] {
  return files.flatMap((file) => {
    const data = brought.value.get(file.path)?.data;
    return data ? [{ ...file, data }] : [];
  });
}

const ofMade = new WeakMap<MadeModel, Content>();

function contentOf(name: string, model: MadeModel): Content {
  let content = ofMade.get(model);
  if (content?.id !== name) {
    content = { id: name, number: undefined, origin: model.origin, source: sourceOf(name, model.files) };
    ofMade.set(model, content);
  }
  return content;
}

const completed = new WeakMap<Content, { readonly made: Submissions; readonly content: Content }>();

function withSubmissions(content: Content, made: Submissions | undefined): Content {
  if (!made || made.size === 0) return content;
  const known = completed.get(content);
  if (known?.made === made) return known.content;
  const files = [...made.values()].flatMap((submission) => submission.files);
  const whole = { ...content, source: sourceOf(content.id, [...content.source.files, ...files]) };
  completed.set(content, { made, content: whole });
  return whole;
}
