// The fragment that holds results: `#share=2.…`, the version, then checksum, length and the deflated
// content in base64url.

import { deflateSync, inflateSync } from "fflate";
import { bare, MARK } from "../fragment";
import type { SharedResults } from "../shared";
import { fromBase64Url, toBase64Url } from "./base64url";
import { ByteReader, ByteWriter, Damaged } from "./bytes";
import { crc32 } from "./crc32";
import * as version1 from "./version1";
import * as version2 from "./version2";

const CURRENT = 2;
const READERS: Readonly<Record<number, (bytes: Uint8Array<ArrayBuffer>) => SharedResults>> = {
  1: version1.read,
  2: version2.read,
};

/** Longest fragment that is read or written. Thirty-five models of one method take about an eighth. */
export const MAX_FRAGMENT = 32_768;
/** What the content of a link may unpack to. */
const MAX_CONTENT_BYTES = 131_072;

const CRC_BYTES = 4;

/** The fragment, with its `#`. Throws a `RangeError` where there is more than a link can hold. */
export function writeFragment(results: SharedResults): string {
  const content = version2.write(results);
  const packed = new ByteWriter();
  packed.whole(content.length);
  packed.raw(deflateSync(content, { level: 9, mem: 8 }));
  const body = packed.finish();
  const framed = new ByteWriter();
  framed.raw(new Uint8Array(Uint32Array.of(crc32(body)).buffer));
  framed.raw(body);
  const fragment = `#${MARK}${CURRENT}.${toBase64Url(framed.finish())}`;
  if (content.length > MAX_CONTENT_BYTES || fragment.length > MAX_FRAGMENT) {
    throw new RangeError("These are more results than one link can hold. Choose fewer methods or models.");
  }
  return fragment;
}

/** Reads a fragment of any version there has been. Throws `Damaged`, with words for the reader. */
export function readFragment(fragment: string): SharedResults {
  const text = bare(fragment);
  if (text.length > MAX_FRAGMENT) throw new Damaged("This link is longer than any that the playground makes.");
  const found = /^share=(\d{1,4})\.(.*)$/s.exec(text);
  if (!found) throw new Damaged("This link is damaged: it does not say which version it is.");
  const read = READERS[Number(found[1])];
  if (!read) {
    throw new Damaged("This link was made by a newer version of the playground. Reload the page to get that version.");
  }
  try {
    return read(unpack(fromBase64Url(found[2] ?? "")));
  } catch (error) {
    const why = error instanceof Damaged ? error.message : "it cannot be unpacked";
    throw new Damaged(`This link is damaged: ${why}. Ask for it again, and copy all of it.`);
  }
}

function unpack(framed: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const from = new ByteReader(framed);
  const [checksum] = new Uint32Array(from.raw(CRC_BYTES).buffer);
  const body = framed.subarray(CRC_BYTES);
  if (crc32(body) !== checksum) throw new Damaged("some of its characters are missing or wrong");
  const length = from.whole(MAX_CONTENT_BYTES);
  // One byte more than announced, so that content which is longer shows; no more is ever allocated.
  const content = inflateSync(from.raw(from.left), { out: new Uint8Array(length + 1) });
  if (content.length !== length) throw new Damaged("its length is not the one it names");
  return content.slice();
}
