// Text in which `backticks` set off what comes from a file. It is never read as markup.

import type { JSX } from "preact";

export function Marked({ text }: { text: string }): JSX.Element {
  // Every second part stood between backticks.
  return <>{text.split("`").map((part, at) => (at % 2 === 1 ? <code key={at}>{part}</code> : part))}</>;
}
