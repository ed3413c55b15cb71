// Version 2 of a case in a link: version 1, and the version of the engine it was made with. It is frozen
// as that is.

import { ByteReader, ByteWriter } from "../../sharing/codec/bytes";
import type { Case } from "../case";
import type { LinkedCase } from "./linked";
import { readCase, writeCase } from "./version1";

export function write({ of, engine = "" }: LinkedCase): Uint8Array<ArrayBuffer> {
  const out = new ByteWriter();
  out.text(engine);
  writeCase(out, of);
  return out.finish();
}

export function read(bytes: Uint8Array<ArrayBuffer>): LinkedCase {
  const from = new ByteReader(bytes);
  const engine = from.text();
  const of: Case = readCase(from);
  from.end();
  return { of, ...(engine !== "" && { engine }) };
}
