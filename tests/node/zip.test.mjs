// The zip reader that page and command line share.

import assert from "node:assert/strict";
import { test } from "node:test";
import { strFromU8, strToU8, zipSync } from "fflate";
import { Damaged, memory } from "../../www/shared/zip/source.mjs";
import { generator } from "./random.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";

/**
 * What a zip in memory holds.
 * @param {Uint8Array} bytes
 * @param {Partial<import("../../www/shared/zip/zip.mjs").Limits>} limits
 */
const listed = (bytes, limits = {}) => listZip(memory(bytes), { ...STREAMED, ...limits });

/** @param {import("../../www/shared/zip/zip.mjs").Entry} entry */
const text = (entry) => strFromU8(entry.read());

test("stored and deflated entries are read, in any order, whatever their names", () => {
  const long = "1 2 3 ".repeat(1000);
  const zip = zipSync({ "a/größe 1.txt": [strToU8("stored"), { level: 0 }], "b.TXT": strToU8(long), "c/": new Uint8Array() });
  const { entries, problems } = listed(zip);
  assert.deepEqual(entries.map(({ path }) => path), ["a/größe 1.txt", "b.TXT"]);
  assert.deepEqual(entries.toReversed().map(text), [long, "stored"]);
  assert.deepEqual(problems, []);
});

test("an entry is had a part at a time, forwards without unpacking anything twice, and backwards too", () => {
  const random = generator(3);
  const whole = strToU8(Array.from({ length: 40_000 }, () => String(random())).join("\n"));
  for (const level of /** @type {const} */ ([0, 6])) {
    const zip = zipSync({ "a.txt": [whole, { level }] });
    const source = memory(zip);
    let read = 0;
    const counted = (/** @type {number} */ from, /** @type {number} */ to) => {
      read += to - from;
      return source.bytes(from, to);
    };
    const [entry] = listZip({ ...source, bytes: counted }, STREAMED).entries;
    assert.ok(entry);
    read = 0;
    for (let from = 0; from < whole.length; from += 10_000) {
      const to = Math.min(whole.length, from + 10_000);
      assert.deepEqual(entry.part(from, to), whole.subarray(from, to));
    }
    assert.ok(read < 1.1 * zip.length, `${read} bytes read of ${zip.length}`);
    assert.deepEqual(entry.part(5, 9), whole.subarray(5, 9));
    assert.deepEqual(entry.part(600_000, 600_009), whole.subarray(600_000, 600_009));
    // What was damaged on the way is told at the end.
    const at = 40 + Math.floor(whole.length / 4);
    zip[at] = 255 - (zip[at] ?? 0);
    const [damaged] = listed(zip).entries;
    assert.throws(() => damaged.part(whole.length - 5, whole.length), Damaged);
  }
});

test("a zip within other bytes is read where it begins, one with a comment to its end", () => {
  const zip = zipSync({ "a.txt": strToU8("here") });
  const commented = new Uint8Array([...zip, ...strToU8("a comment")]);
  commented[zip.length - 2] = 9;
  const buffer = new Uint8Array([7, 7, 7, ...commented]).subarray(3);
  assert.deepEqual(listed(buffer).entries.map(text), ["here"]);
});

test("the entries of a large zip are read once or twice, however many they are", () => {
  const names = Array.from({ length: 16_000 }, (_, index) => `set/PC${index}.txt`);
  const zip = zipSync(Object.fromEntries(names.map((name) => [name, strToU8(name)])), { level: 0 });
  let read = 0;
  const source = memory(zip);
  const counted = (/** @type {number} */ from, /** @type {number} */ to) => {
    read += to - from;
    return source.bytes(from, to);
  };
  assert.deepEqual(listZip({ ...source, bytes: counted }, STREAMED).entries.map(text), names);
  assert.ok(read < 2 * zip.length, `${read} bytes read of ${zip.length}`);
});

test("the directory of a zip64 is found where it says", () => {
  const zip = zipSync({ "a.txt": strToU8("a"), "b.txt": strToU8("b") });
  const end = zip.length - 22;
  const at = new DataView(zip.buffer).getUint32(end + 16, true);
  const zip64 = new Uint8Array(zip.length + 56 + 20);
  zip64.set(zip.subarray(0, end));
  zip64.set(zip.subarray(end), end + 76);
  const view = new DataView(zip64.buffer);
  view.setUint32(end, 0x06064b50, true);
  view.setBigUint64(end + 32, 2n, true);
  view.setBigUint64(end + 40, BigInt(end - at), true);
  view.setBigUint64(end + 48, BigInt(at), true);
  view.setUint32(end + 56, 0x07064b50, true);
  view.setBigUint64(end + 64, BigInt(end), true);
  view.setUint16(end + 76 + 10, 0xffff, true);
  view.setUint32(end + 76 + 16, 0xffffffff, true);
  assert.deepEqual(listed(zip64).entries.map(text), ["a", "b"]);
});

test("a zip cut off or changed anywhere is listed, reported or read, and nothing else", () => {
  const zip = zipSync({ "a.txt": strToU8("1 2 3 ".repeat(50)), "b.txt": [strToU8("stored"), { level: 0 }] });
  /** @param {Uint8Array} bytes */
  const opened = (bytes) => {
    try {
      for (const entry of listed(bytes).entries) {
        assert.ok(entry.read().length <= 300);
      }
    } catch (error) {
      assert.ok(error instanceof Damaged, String(error));
      assert.match(error.message, /^it (is no zip|cannot be unpacked|is damaged|is listed in the zip but|is encrypted)/);
    }
  };
  for (let at = 0; at < zip.length; at += 1) {
    opened(zip.subarray(0, at));
    for (const bit of [0, 3, 7]) {
      const changed = zip.slice();
      changed[at] ^= 1 << bit;
      opened(changed);
    }
  }
});

test("an encrypted entry says so", () => {
  const zip = zipSync({ "a.txt": strToU8("secret") });
  const header = zip.findLastIndex((byte, at) => byte === 0x50 && zip[at + 2] === 1 && zip[at + 3] === 2);
  zip[header + 8] |= 1;
  const [entry] = listed(zip).entries;
  assert.throws(() => entry.read(), /it is encrypted/);
});

/**
 * The problems of a zip as lines.
 * @param {ReturnType<typeof listed>} listing
 */
const told = ({ problems }) => problems.map(({ path, severity, message }) => `${path}: ${severity}: ${message}`);

/** Two stored files; where the directory's headers of a zip begin. */
const stored = () => zipSync({ "a.txt": strToU8("one"), "b.txt": strToU8("two") }, { level: 0 });
/** @param {Uint8Array} zip */
const directoryOf = (zip) => new DataView(zip.buffer).getUint32(zip.length - 22 + 16, true);

test("a stored entry whose bytes are not those of its checksum is refused, the others are read", () => {
  const zip = stored();
  zip[zip.indexOf("o".charCodeAt(0))] ^= 1;
  const [first, second] = listed(zip).entries;
  assert.throws(() => first.read(), /it is damaged: its checksum/);
  assert.equal(text(second), "two");
});

test("a deflated entry with a wrong checksum is refused too", () => {
  const zip = zipSync({ "a.txt": strToU8("1 2 3 ".repeat(100)) });
  zip[directoryOf(zip) + 16] ^= 1;
  assert.throws(() => listed(zip).entries[0].read(), /it is damaged: its checksum/);
});

test("an entry longer or shorter than its directory says is refused, whichever way it is packed", () => {
  for (const [level, by] of /** @type {const} */ ([[0, 1], [0, -1], [6, 1], [6, -1]])) {
    const zip = zipSync({ "a.txt": strToU8("1 2 3 ".repeat(100)) }, { level });
    const view = new DataView(zip.buffer);
    const size = directoryOf(zip) + 24;
    view.setUint32(size, view.getUint32(size, true) + by, true);
    // The entry's own header agrees with the directory.
    view.setUint32(22, view.getUint32(22, true) + by, true);
    assert.throws(() => listed(zip).entries[0].read(), /it is damaged: it holds (more|less) than/, `${level} ${by}`);
  }
});

test("sizes that differ between an entry's own header and the directory are refused", () => {
  const zip = stored();
  new DataView(zip.buffer).setUint32(18, 5, true);
  assert.throws(() => listed(zip).entries[0].read(), /its own header states other sizes/);
});

test("what unpacks to more than can come of its bytes takes no memory", () => {
  const zip = zipSync({ "a.txt": strToU8("1 2 3 ".repeat(100)) });
  const view = new DataView(zip.buffer);
  const size = STREAMED.entryBytes - 1;
  view.setUint32(directoryOf(zip) + 24, size, true);
  view.setUint32(22, size, true);
  const before = process.memoryUsage().arrayBuffers;
  assert.throws(() => listed(zip).entries[0].read(), /it holds less/);
  assert.ok(process.memoryUsage().arrayBuffers - before < 1e6);
});

test("an entry that is too large leaves the others, and so does one that is too much", () => {
  const zip = zipSync({ "a.txt": strToU8("1".repeat(50)), "b.txt": strToU8("2".repeat(10)), "c.txt": strToU8("3".repeat(10)), "d.txt": strToU8("4".repeat(5)) });
  const large = listed(zip, { entryBytes: 20 });
  assert.deepEqual(large.entries.map(({ path }) => path), ["b.txt", "c.txt", "d.txt"]);
  assert.match(told(large)[0], /^a\.txt: error: it is too large to be unpacked/);
  const much = listed(zip, { totalBytes: 60 });
  assert.deepEqual(much.entries.map(({ path }) => path), ["b.txt", "c.txt", "d.txt"]);
  assert.match(told(much)[0], /^a\.txt: error: it is not unpacked: with smaller files/);
});

test("marks of an end within the comment do not hide the directory", () => {
  const zip = stored();
  const comment = new Uint8Array(400).fill(0x50);
  for (let at = 0; at + 4 <= comment.length; at += 22) comment.set([0x50, 0x4b, 5, 6], at);
  const commented = new Uint8Array([...zip, ...comment]);
  new DataView(commented.buffer).setUint16(zip.length - 2, comment.length, true);
  assert.deepEqual(listed(commented).entries.map(text), ["one", "two"]);
});

test("of several files of one name the last is used, and that is said", () => {
  const zip = stored();
  const name = directoryOf(zip) + 46;
  zip[zip.indexOf("b".charCodeAt(0), name)] = "a".charCodeAt(0);
  const listing = listed(zip);
  assert.deepEqual(listing.entries.map(({ path, read }) => [path, strFromU8(read())]), [["a.txt", "two"]]);
  assert.deepEqual(told(listing), ["a.txt: warning: the zip holds several files of this name; the last is used"]);
});

test("a zip within a zip is opened, one within that is told, a damaged one leaves the others", () => {
  /** @param {Record<string, Uint8Array>} deeper */
  const inner = (deeper) => zipSync({ "x.txt": strToU8("inner"), ...deeper });
  const zip = zipSync({ "a.zip": inner({ "b.zip": inner({}) }), "c.zip": strToU8("none"), "d.txt": strToU8("outer") });
  const listing = listed(zip);
  assert.deepEqual(listing.entries.map(({ path, read }) => [path, strFromU8(read())]), [["a.zip/x.txt", "inner"], ["d.txt", "outer"]]);
  assert.deepEqual(told(listing), [
    "a.zip/b.zip: error: a zip within a zip within a zip is not opened",
    "c.zip: error: it is no zip, or a damaged one: its directory cannot be read",
  ]);
});

test("files within zips count together", () => {
  /** @param {number} count */
  const many = (count) => Object.fromEntries(Array.from({ length: count }, (_, at) => [`${at}.txt`, strToU8("x")]));
  const zip = zipSync({ "a.zip": zipSync(many(6)), "b.zip": zipSync(many(6)) });
  const listing = listed(zip, { entries: 10 });
  assert.equal(listing.entries.length, 6);
  assert.match(told(listing)[0], /^b\.zip: error: it holds more than/);
});

test("only what is asked for is read from the source", () => {
  const zip = zipSync({ "a.txt": [strToU8("1 2 3 ".repeat(100_000)), { level: 0 }], "b.txt": strToU8("here") });
  let bytes = 0;
  const source = {
    size: zip.length,
    bytes: (/** @type {number} */ from, /** @type {number} */ to) => {
      bytes += to - from;
      return zip.subarray(from, to);
    },
  };
  const [, entry] = listZip(source, STREAMED).entries;
  assert.equal(text(entry), "here");
  // The end of the file is searched for the directory, as far as a comment may reach.
  assert.ok(bytes < 0x10000 + 1000, `${bytes} of ${zip.length}`);
});
