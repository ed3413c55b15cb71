// Has what was brought and made back after a reload, and keeps it from then on, in this browser alone.

import { batch, effect } from "@preact/signals";
import { latest } from "../engine/latest";
import { clear, contents } from "../state/contents";
import { bring, brought, names, overrides } from "../state/inbox";
import { keeping } from "../state/kept";
import { madeModels, madeSubmissions, putBackMade } from "../state/made";
import { notify } from "../state/notices";
import * as format from "../ui/format";
import { read, write, type Work } from "./store";

/** Changes come in bursts: a folder of files, a fit after the other. */
const PAUSE_MS = 300;

/** The tab that holds it keeps its work; what two tabs kept would be a mixture of both. */
const LOCK = "fit4cad-work";

const OTHER_TAB = "Another tab of this page keeps its work; what you do in this one is gone with it.";

/** Puts back what was kept and keeps what changes from now on. */
export async function keepWork(): Promise<void> {
  try {
    if (!(await isOurs())) {
      keeping.value = { kind: "refused", why: OTHER_TAB };
      // Said before anything is done here, not only where files are listed.
      notify(OTHER_TAB);
      return;
    }
    const kept = await read();
    await putBack(kept);
    follow(kept);
  } catch (error) {
    refuse(error);
  }
}

/** Whether no other tab keeps its work. Then none will before this one is closed. */
function isOurs(): Promise<boolean> {
  return new Promise((resolve, reject) => {
    const held = navigator.locks.request(LOCK, { ifAvailable: true }, (lock) => {
      resolve(lock !== null);
      // Held for as long as the page is there.
      return lock ? new Promise<void>(() => undefined) : undefined;
    });
    held.catch(reject);
  });
}

async function putBack(kept: Work): Promise<void> {
  if (kept.files.size + kept.models.size === 0) return;
  batch(() => {
    // What has come meanwhile is newer.
    overrides.value = { ...Object.fromEntries(kept.overrides), ...overrides.value };
    names.value = new Map([...kept.names, ...names.value]);
    putBackMade(kept.models, kept.submissions);
  });
  await bring([...kept.files.values()].filter(({ path }) => !brought.value.has(path)), []);
  notify(`${format.plural(contents.value.length, "model")} of your last visit.`, "info", { title: "Remove everything", run: clear });
}

function work(): Work {
  return {
    files: brought.value,
    // The sample that opens the page comes by itself, as long as nothing was made of it.
    models: new Map([...madeModels.value].filter(([name, { makesRoom }]) => !makesRoom || madeSubmissions.value.has(name))),
    submissions: madeSubmissions.value,
    overrides: new Map(Object.entries(overrides.value)),
    names: new Map([...names.value].filter(([path]) => brought.value.has(path))),
  };
}

function follow(kept: Work): void {
  let written = kept;
  const save = latest(async (now: Work) => {
    await write(written, now);
    written = now;
    keeping.value = { kind: "on", bytes: sizeOf(now) };
  });
  let timer: ReturnType<typeof setTimeout> | undefined;
  const flush = () => {
    clearTimeout(timer);
    save(work()).catch(refuse);
  };
  effect(() => {
    // Read here, so that the effect follows it.
    void work();
    clearTimeout(timer);
    timer = setTimeout(flush, PAUSE_MS);
  });
  // The last chance before a tab is closed or put to sleep.
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") flush();
  });
}

function sizeOf({ files, models, submissions }: Work): number {
  const made = [...models.values(), ...[...submissions.values()].flatMap((each) => [...each.values()])];
  const blobs = [...files.values(), ...made.flatMap((each) => each.files)];
  const parts = [...files.values()].flatMap(({ step }) => step ?? []);
  return [...blobs, ...parts].reduce((sum, { data }) => sum + data.size, 0);
}

/** Nothing is kept any more; who leaves with work that is lost is asked first. */
function refuse(error: unknown): void {
  const full = error instanceof DOMException && error.name === "QuotaExceededError";
  const why = full
    ? "There is no room in this browser to keep what is on the page: it is gone when the page is left."
    : "This browser keeps nothing, as in a private window: what is on the page is gone when it is left.";
  keeping.value = { kind: "refused", why };
  addEventListener("beforeunload", (event) => {
    if (madeSubmissions.value.size > 0 || work().models.size > 0) event.preventDefault();
  });
}
