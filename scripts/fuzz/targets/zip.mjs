// The zip reader: whatever the bytes, it lists, tells what is wrong or reads, within its limits.

import assert from "node:assert/strict";
import { strToU8, zipSync } from "fflate";
import { Damaged, memory } from "../../../www/shared/zip/source.mjs";
import { listZip } from "../../../www/shared/zip/zip.mjs";

const LIMITS = { entryBytes: 2 ** 20, totalBytes: 2 ** 21, entries: 50, depth: 2 };

/** @type {import("../targets.mjs").Body} */
export const body = {
  seeds() {
    const plain = zipSync({ "PC1.txt": strToU8("1 2 3\n".repeat(40)), "a/PC1_primitives.txt": [strToU8("Primitive1:=[1 2];"), { level: 0 }] });
    const commented = new Uint8Array([...plain, ...strToU8("PK\u{5}\u{6} a comment")]);
    commented[plain.length - 2] = commented.length - plain.length;
    return [
      ...[plain, commented, zipSync({})],
      zipSync({ "inner.zip": [plain, { level: 0 }], "größe.txt": strToU8("x"), "b/": new Uint8Array() }),
      zipSync({ "zeros.txt": new Uint8Array(2 ** 20 + 5) }),
      zipSync(Object.fromEntries(Array.from({ length: 60 }, (_, at) => [`${at}`, new Uint8Array()]))),
    ];
  },
  run(input) {
    try {
      const { entries, problems } = listZip(memory(input), LIMITS);
      assert.ok(entries.length <= LIMITS.entries);
      for (const { message } of problems) assert.ok(message.length > 0);
      let total = 0;
      for (const { path, size, read } of entries) {
        assert.equal(typeof path, "string");
        try {
          const { length } = read();
          assert.equal(length, size);
          assert.ok(length <= LIMITS.entryBytes);
          total += length;
        } catch (error) {
          if (!(error instanceof Damaged)) throw error;
        }
      }
      assert.ok(total <= LIMITS.totalBytes);
    } catch (error) {
      if (!(error instanceof Damaged)) throw error;
    }
  },
};
