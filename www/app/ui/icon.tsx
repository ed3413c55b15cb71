// The page's few icons, drawn on a 16-unit grid.

import type { JSX } from "preact";

const PATHS = {
  add: "M8 3v10M3 8h10",
  close: "M4 4l8 8M12 4l-8 8",
  help: "M6 6a2 2 0 1 1 2.6 1.9c-.4.2-.6.5-.6 1v.6M8 12v.2",
  sun: "M8 5.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6M8 1.5v1.4M8 13.1v1.4M1.5 8h1.4M13.1 8h1.4M3.4 3.4l1 1M11.6 11.6l1 1M12.6 3.4l-1 1M4.4 11.6l-1 1",
  moon: "M13 9.6A5.5 5.5 0 0 1 6.4 3a5.5 5.5 0 1 0 6.6 6.6z",
  half: "M8 2.5a5.5 5.5 0 1 1 0 11a5.5 5.5 0 0 1 0-11zM8 2.5v11M8 4.5l4.2 0M8 7l5.2 0M8 9.5l5 0M8 12l3.5 0",
  search: "M7 2.8a4.2 4.2 0 1 1 0 8.4a4.2 4.2 0 0 1 0-8.4M10.2 10.2l3.3 3.3",
  error: "M8 2l6.2 11.2H1.8zM8 6.2v3.4M8 11.4v.2",
  note: "M8 2.2a5.8 5.8 0 1 1 0 11.6a5.8 5.8 0 0 1 0-11.6M8 7.4v3.4M8 5v.2",
  check: "M3 8.6l3.2 3.2L13 4.8",
  again: "M13 8a5 5 0 1 1-1.6-3.7M13 2.2v3h-3",
  copy: "M5.5 5.5v-3h8v8h-3M2.5 5.5h8v8h-8z",
  share: "M11 4.5a1.8 1.8 0 1 1 3.6 0a1.8 1.8 0 1 1-3.6 0M1.4 8a1.8 1.8 0 1 1 3.6 0a1.8 1.8 0 1 1-3.6 0M11 11.5a1.8 1.8 0 1 1 3.6 0a1.8 1.8 0 1 1-3.6 0M4.9 7.2l6.2-2.1M4.9 8.8l6.2 2.1",
  up: "M3.5 10.2L8 5.8l4.5 4.4",
  down: "M3.5 5.8L8 10.2l4.5-4.4",
  spread: "M9.5 2.5h4v4M13.5 2.5L9 7M6.5 13.5h-4v-4M2.5 13.5L7 9",
  shrink: "M13 7H9V3M9 7l4.5-4.5M3 9h4v4M7 9l-4.5 4.5",
  drop: "M8 2v8M4.6 6.8L8 10.2l3.4-3.4M2.5 10.5v3h11v-3",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }): JSX.Element {
  return <Glyph path={PATHS[name]} />;
}

/** An icon that only a part of the page has. */
export function Glyph({ path }: { path: string }): JSX.Element {
  return (
    <svg class="glyph" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d={path} />
    </svg>
  );
}
