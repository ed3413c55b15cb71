// A patch of a primitive's colour. It repeats what stands beside it, so it is hidden from screen readers.

import type { JSX } from "preact";
import { css, primitiveColour, UNSEGMENTED } from "./palette";

export function Swatch({ index }: { index: number | undefined }): JSX.Element {
  const colour = index === undefined ? UNSEGMENTED : primitiveColour(index);
  return <span class="swatch" aria-hidden="true" style={{ backgroundColor: css(colour) }} />;
}
