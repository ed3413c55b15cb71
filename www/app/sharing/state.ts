// What the page knows of its link before the part that reads links has come.

import { signal } from "@preact/signals";
import { isShared } from "../state/fragment";
import { takeBack } from "../state/settings";
import type { Claim, SharedResults } from "./shared";

export type Opened =
  | { readonly kind: "none" }
  | { readonly kind: "damaged"; readonly message: string }
  | { readonly kind: "shared"; readonly results: SharedResults };

export const opened = signal<Opened>({ kind: "none" });

/** Version of the engine on this page, once a link has asked for it. */
export const engineHere = signal<string | undefined>(undefined);

/** The panel that shows the claims of the link. */
export const SHARED_PANEL = "shared";

export function isLinkOpen(): boolean {
  return opened.value.kind === "shared";
}

/** How many claims of the link there are, are verified here and differ. */
export const standing = signal({ all: 0, verified: 0, differs: 0 });

/** Takes the link, and the settings it came with, off the page and out of the address. The models stay. */
export function closeLink(): void {
  opened.value = { kind: "none" };
  takeBack();
  if (isShared(location.hash)) history.replaceState(null, "", `${location.pathname}${location.search}`);
}

/** What is being had again just now. */
export interface Rebuilding {
  /** Claims whose figures are awaited. */
  readonly awaited: ReadonlySet<Claim>;
  readonly stop: () => void;
}

export const rebuilding = signal<Rebuilding | undefined>(undefined);

/** Ends the making of samples, the download and the fits that a link asked for. What is here stays. */
export function stopRebuilding(): void {
  rebuilding.peek()?.stop();
}
