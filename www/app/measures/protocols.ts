// The protocols, as the engine declares them.

import { PROTOCOLS } from "../../generated/declared/protocols.js";
import type { Protocol } from "../engine/contract";

export { PROTOCOLS };

/** How scores by a protocol come about, to go on a sentence. */
export function rulesOf(protocol: Protocol): string {
  return PROTOCOLS.find(({ name }) => name === protocol)?.rules ?? protocol;
}
