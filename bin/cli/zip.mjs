// Reading zips one entry at a time, with limits that keep a malicious one harmless.
//
// fflate's own reading walks the whole directory for every entry, which grows with the square of
// their number (16,000 entries took half a minute), so the directory is read here, once, and fflate
// unpacks. Layout: PKWARE, APPNOTE.TXT, sections 4.3.7, 4.3.12 to 4.3.16 and 4.5.3.

import { inflateSync } from "fflate";

/** Largest single file taken out of a zip. */
const MOST_ENTRY_BYTES = 256 << 20;
/** Most bytes that all files of a zip together may unpack to. */
const MOST_TOTAL_BYTES = 4 * 2 ** 30;
/** Most files in a zip. */
const MOST_ENTRIES = 100_000;

const END = { signature: 0x06054b50, size: 22, mostComment: 0xffff };
const END64_LOCATOR = { signature: 0x07064b50, size: 20 };
const END64 = { signature: 0x06064b50 };
const DIRECTORY_HEADER = { signature: 0x02014b50, size: 46 };
const LOCAL_HEADER = { signature: 0x04034b50, size: 30 };
const ZIP64_FIELD = 1;
/** Stands for a size or offset that is in the zip64 field. */
const ELSEWHERE = 0xffffffff;
const ENCRYPTED = 1;
const UTF8 = 1 << 11;
const STORED = 0;
const DEFLATED = 8;

/**
 * Lists the `.txt` files of a zip: `{ entries, problems }`, where an entry is `{ path, read() }`.
 * Nothing is unpacked before it is read. Linear in the number of entries. Throws where the bytes
 * are no zip, or a damaged one.
 */
export function listZip(bytes) {
  const entries = new Map();
  const problems = [];
  let total = 0;
  for (const header of directory(bytes)) {
    const { name, unpacked } = header;
    if (!/\.txt$/i.test(name)) {
      continue;
    }
    total += unpacked;
    if (unpacked > MOST_ENTRY_BYTES || total > MOST_TOTAL_BYTES) {
      problems.push({ path: name, message: "it is too large to be unpacked" });
      continue;
    }
    entries.set(name, { path: name, read: () => readEntry(bytes, header) });
  }
  return { entries: [...entries.values()], problems };
}

/** The headers of all entries. */
function directory(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const headers = [];
  try {
    let { count, at } = directoryPlace(view);
    if (count > MOST_ENTRIES) {
      throw new Error(`it holds more than ${MOST_ENTRIES} files`);
    }
    for (; count > 0; count -= 1) {
      const header = directoryHeader(bytes, view, at);
      headers.push(header);
      at = header.next;
    }
  } catch (error) {
    if (error instanceof RangeError) {
      throw new Error("it is no zip, or a damaged one: its directory cannot be read");
    }
    throw error;
  }
  return headers;
}

/** Number of entries and offset of the first header. Like all below, a RangeError for no zip. */
function directoryPlace(view) {
  const end = view.byteLength - END.size;
  const first = Math.max(0, end - END.mostComment);
  for (let at = end; at >= first; at -= 1) {
    if (view.getUint32(at, true) === END.signature) {
      return directoryPlace64(view, at) ?? { count: view.getUint16(at + 10, true), at: view.getUint32(at + 16, true) };
    }
  }
  throw new RangeError("no end of the directory");
}

function directoryPlace64(view, end) {
  const locator = end - END64_LOCATOR.size;
  if (locator < 0 || view.getUint32(locator, true) !== END64_LOCATOR.signature) {
    return undefined;
  }
  const at = uint64(view, locator + 8);
  expect(view, at, END64);
  return { count: uint64(view, at + 32), at: uint64(view, at + 48) };
}

function directoryHeader(bytes, view, at) {
  expect(view, at, DIRECTORY_HEADER);
  const half = (offset) => view.getUint16(at + offset, true);
  const word = (offset) => view.getUint32(at + offset, true);
  const nameAt = at + DIRECTORY_HEADER.size;
  const extraAt = nameAt + half(28);
  const extraEnd = extraAt + half(30);
  const flags = half(8);
  const name = Buffer.from(bytes.subarray(nameAt, extraAt)).toString(flags & UTF8 ? "utf8" : "latin1");
  const [unpacked, packed, offset] = withZip64([word(24), word(20), word(42)], view, extraAt, extraEnd);
  return { name, flags, method: half(10), packed, unpacked, offset, next: extraEnd + half(32) };
}

/** The sizes and offset with those that do not fit in 32 bits taken from the zip64 field, in order. */
function withZip64(values, view, from, end) {
  if (!values.includes(ELSEWHERE)) {
    return values;
  }
  let at = from;
  while (at + 4 <= end && view.getUint16(at, true) !== ZIP64_FIELD) {
    at += 4 + view.getUint16(at + 2, true);
  }
  if (at + 4 > end) {
    throw new RangeError("no zip64 field");
  }
  at -= 4;
  return values.map((value) => (value === ELSEWHERE ? uint64(view, (at += 8)) : value));
}

function uint64(view, at) {
  return Number(view.getBigUint64(at, true));
}

function expect(view, at, { signature }) {
  if (view.getUint32(at, true) !== signature) {
    throw new RangeError("another signature");
  }
}

function readEntry(bytes, { flags, method, packed, unpacked, offset }) {
  if (flags & ENCRYPTED) {
    throw new Error("it is encrypted; unpack the zip first");
  }
  const content = bytes.subarray(...contentOf(bytes, offset, packed));
  if (method === STORED) {
    return content;
  }
  if (method !== DEFLATED) {
    throw new Error(`it cannot be unpacked: compression method ${method} is not known; unpack the zip first`);
  }
  try {
    // The output buffer has the size that the directory states, so an entry that would unpack to
    // more is cut there instead of filling the memory.
    return inflateSync(content, { out: new Uint8Array(unpacked) });
  } catch (error) {
    throw new Error(`it cannot be unpacked: ${error.message}`);
  }
}

/** Where the packed bytes of an entry begin and end. */
function contentOf(bytes, offset, packed) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    expect(view, offset, LOCAL_HEADER);
    const start = offset + LOCAL_HEADER.size + view.getUint16(offset + 26, true) + view.getUint16(offset + 28, true);
    if (start + packed > bytes.length) {
      throw new RangeError("cut off");
    }
    return [start, start + packed];
  } catch {
    throw new Error("it is listed in the zip but not there");
  }
}
