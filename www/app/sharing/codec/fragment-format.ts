// A fragment that holds something: `#mark=1.…`, what it holds and the version, then checksum, length
// and the deflated content in base64url.

import { deflateSync, inflateSync } from "fflate";
import { bare } from "../../state/fragment";
import { fromBase64Url, toBase64Url } from "./base64url";
import { ByteReader, ByteWriter, Damaged } from "./bytes";
import { crc32 } from "../../../shared/crc32.mjs";

/** Longest fragment that is read or written. Results of thirty-five models take about an eighth. */
export const MAX_FRAGMENT = 32_768;
/** What the content of a link may unpack to. */
const MAX_CONTENT_BYTES = 131_072;

const CRC_BYTES = 4;

type Bytes = Uint8Array<ArrayBuffer>;

export interface FragmentFormat<Content> {
  /** What the fragment begins with, up to and with its `=`. */
  readonly mark: string;
  /** The version that is written. */
  readonly current: number;
  readonly write: (content: Content) => Bytes;
  /** By version: every one there has been. */
  readonly readers: Readonly<Record<number, (bytes: Bytes) => Content>>;
  /** What to say where there is more than a link can hold. */
  readonly tooMuch: string;
}

/** The fragment, with its `#`. Throws a `RangeError` where there is more than a link can hold. */
export function write<Content>(format: FragmentFormat<Content>, value: Content): string {
  const content = format.write(value);
  const packed = new ByteWriter();
  packed.whole(content.length);
  packed.raw(deflateSync(content, { level: 9, mem: 8 }));
  const body = packed.finish();
  const framed = new ByteWriter();
  framed.raw(new Uint8Array(Uint32Array.of(crc32(body)).buffer));
  framed.raw(body);
  const fragment = `#${format.mark}${format.current}.${toBase64Url(framed.finish())}`;
  if (content.length > MAX_CONTENT_BYTES || fragment.length > MAX_FRAGMENT) throw new RangeError(format.tooMuch);
  return fragment;
}

/** Reads a fragment of any version there has been. Throws `Damaged`, with words for the reader. */
export function read<Content>({ mark, readers }: FragmentFormat<Content>, fragment: string): Content {
  const text = bare(fragment);
  if (text.length > MAX_FRAGMENT) throw new Damaged("This link is longer than any that the playground makes.");
  const found = text.startsWith(mark) ? /^(\d{1,4})\.(.*)$/s.exec(text.slice(mark.length)) : null;
  if (!found) throw new Damaged("This link is damaged: it does not say which version it is.");
  const reader = readers[Number(found[1])];
  if (!reader) {
    throw new Damaged("This link was made by a newer version of the playground. Reload the page to get that version.");
  }
  try {
    return reader(unpack(fromBase64Url(found[2] ?? "")));
  } catch (error) {
    const why = error instanceof Damaged ? error.message : "it cannot be unpacked";
    throw new Damaged(`This link is damaged: ${why}. Ask for it again, and copy all of it.`);
  }
}

function unpack(framed: Bytes): Bytes {
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
