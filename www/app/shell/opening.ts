// What is on the page from the start: what its address names, else a sample.

import { effect } from "@preact/signals";
import { dataAsked, openData } from "../public/address";
import { openFirstSample } from "../samples/samples";
import { openAddress } from "../sharing/share";
import { models } from "../state/models";
import { page } from "../state/router";
import type { PageDefinition } from "./registry/pages";

/** Opens what the address names. A lesson needs no models: there it waits until a page is shown that does. */
export function openFirst(pages: readonly PageDefinition[]): void {
  const linked = openAddress();
  let waiting = true;
  effect(() => {
    const shown = pages.find(({ id }) => id === page.value);
    if (!waiting || !shown?.showsModels) return;
    waiting = false;
    // Not within the effect: what is read here must not bring it back.
    queueMicrotask(() => void fill(linked));
  });
}

async function fill(linked: Promise<boolean>): Promise<void> {
  const named = await linked;
  // What an address names is not the reader's own work, neither to be mixed with it nor to be kept.
  if (!named && dataAsked() === undefined) await keepOwn();
  // The sample is there to look at meanwhile, and makes room for what arrives.
  if (!named && models.value.length === 0) await openFirstSample();
  await openData();
}

/** The work of the last visit, where the browser has it. */
async function keepOwn(): Promise<void> {
  try {
    const { keepWork } = await import("../keeping/keep");
    await keepWork();
  } catch {
    // That part of the page did not arrive: it works without.
  }
}

/** The same for an embedded view, which shows nothing that its address does not name. */
export async function openNamed(): Promise<void> {
  await openAddress();
  await openData();
}
