// A patch of a primitive's colour. It repeats what stands beside it, so it is hidden from screen readers.

import type { JSX } from "preact";

export function Swatch({ colour }: { colour: string }): JSX.Element {
  return <span class="swatch" aria-hidden="true" style={{ backgroundColor: colour }} />;
}
