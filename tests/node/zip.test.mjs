import assert from "node:assert/strict";
import { test } from "node:test";
import { strFromU8, strToU8, zipSync } from "fflate";
import { listZip } from "../../bin/cli/zip.mjs";

const text = (entry) => strFromU8(entry.read());

test("stored and deflated entries are read, in any order, whatever their names", () => {
  const long = "1 2 3 ".repeat(1000);
  const zip = zipSync({ "a/größe 1.txt": [strToU8("stored"), { level: 0 }], "b.TXT": strToU8(long), "c.png": strToU8("no") });
  const { entries, problems } = listZip(zip);
  assert.deepEqual(entries.map(({ path }) => path), ["a/größe 1.txt", "b.TXT"]);
  assert.deepEqual(entries.toReversed().map(text), [long, "stored"]);
  assert.deepEqual(problems, []);
});

test("a zip within other bytes is read where it begins, one with a comment to its end", () => {
  const zip = zipSync({ "a.txt": strToU8("here") });
  const commented = new Uint8Array([...zip, ...strToU8("a comment")]);
  commented[zip.length - 2] = 9;
  const buffer = new Uint8Array([7, 7, 7, ...commented]).subarray(3);
  assert.deepEqual(listZip(buffer).entries.map(text), ["here"]);
});

test("the entries of a large zip are read in time proportional to their number", () => {
  const names = Array.from({ length: 16_000 }, (_, index) => `set/PC${index}.txt`);
  const zip = zipSync(Object.fromEntries(names.map((name) => [name, strToU8(name)])), { level: 0 });
  const start = performance.now();
  assert.deepEqual(listZip(zip).entries.map(text), names);
  assert.ok(performance.now() - start < 5000, "time grows with the square of the number of entries");
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
  view.setBigUint64(end + 48, BigInt(at), true);
  view.setUint32(end + 56, 0x07064b50, true);
  view.setBigUint64(end + 64, BigInt(end), true);
  view.setUint16(end + 76 + 10, 0xffff, true);
  view.setUint32(end + 76 + 16, 0xffffffff, true);
  assert.deepEqual(listZip(zip64).entries.map(text), ["a", "b"]);
});

test("a zip cut off or changed anywhere is listed, reported or read, and nothing else", () => {
  const zip = zipSync({ "a.txt": strToU8("1 2 3 ".repeat(50)), "b.txt": [strToU8("stored"), { level: 0 }] });
  const opened = (bytes) => {
    try {
      for (const entry of listZip(bytes).entries) {
        assert.ok(entry.read().length <= 300);
      }
    } catch (error) {
      assert.match(error.message, /^it (is no zip|cannot be unpacked|is listed in the zip but|is encrypted)/);
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
  const [entry] = listZip(zip).entries;
  assert.throws(() => entry.read(), /it is encrypted/);
});
