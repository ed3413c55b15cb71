// Short messages, shown for a while and announced to screen readers.

import { signal } from "@preact/signals";

export interface Notice {
  readonly text: string;
  readonly kind: "info" | "error";
}

export const notice = signal<Notice | undefined>(undefined);

const SHOWN_MS = 8000;
let timer: ReturnType<typeof setTimeout> | undefined;

export function notify(text: string, kind: Notice["kind"] = "info"): void {
  clearTimeout(timer);
  notice.value = { text, kind };
  timer = setTimeout(dismiss, SHOWN_MS);
}

export function dismiss(): void {
  clearTimeout(timer);
  notice.value = undefined;
}
