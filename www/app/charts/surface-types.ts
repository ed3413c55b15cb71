// The types of surfaces, and what is none of them.

import { OTHER_TYPE } from "../../generated/declared/other-type.js";
import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";
import type { SurfaceType } from "../engine/contract";
import { typeColour } from "../view/palette";

export const OTHER = OTHER_TYPE;
export const TYPES: readonly string[] = [...SURFACE_TYPES.map(({ name }) => name), OTHER];

export function typeName(type: SurfaceType | null | undefined): string {
  return type ?? OTHER;
}

export { typeColour };
