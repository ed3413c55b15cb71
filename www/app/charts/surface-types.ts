// The five types of surface, and what is none of them.

import type { SurfaceType } from "../engine/contract";
import { TYPE_COLOURS } from "../stage/colouring";
import { UNSEGMENTED } from "../view/palette";

export const OTHER = "Other";
export const TYPES: readonly string[] = [...Object.keys(TYPE_COLOURS), OTHER];

export function typeName(type: SurfaceType | null | undefined): string {
  return type ?? OTHER;
}

export function typeColour(name: string): string {
  return TYPE_COLOURS[name] ?? UNSEGMENTED;
}
