// Short messages, shown for a while and announced to screen readers.

import { signal } from "@preact/signals";

export interface Notice {
  readonly text: string;
  readonly kind: "info" | "error";
  /** What can be done about it. */
  readonly offer?: Offer;
}

export interface Offer {
  readonly title: string;
  readonly run: () => void;
}

export const notice = signal<Notice | undefined>(undefined);

const SHOWN_MS = 8000;
/** Time to find the button of what is offered, also by keyboard. */
const OFFERED_MS = 30_000;
let timer: ReturnType<typeof setTimeout> | undefined;

export function notify(text: string, kind: Notice["kind"] = "info", offer?: Offer): void {
  clearTimeout(timer);
  notice.value = offer ? { text, kind, offer } : { text, kind };
  timer = setTimeout(dismiss, offer ? OFFERED_MS : SHOWN_MS);
}

export function dismiss(): void {
  clearTimeout(timer);
  notice.value = undefined;
}
