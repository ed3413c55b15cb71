// Whether what is on the page outlives it in this browser.

import { signal } from "@preact/signals";

export type Keeping =
  /** Not asked for yet, or not by this page: what a link shows is the link's. */
  | { readonly kind: "off" }
  | { readonly kind: "on"; readonly bytes: number }
  | { readonly kind: "refused"; readonly why: string };

export const keeping = signal<Keeping>({ kind: "off" });
