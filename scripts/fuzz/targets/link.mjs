// Links: what is read is written again as it was, what is not is told of, and nothing else comes of it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync, inflateSync } from "fflate";
import { crc32 } from "../../../www/shared/crc32.mjs";
import { pageModule } from "../../../tests/node/page.mjs";
import { ROOT } from "../../lib/paths.mjs";

/** @returns {Promise<import("../targets.mjs").Body>} */
export async function load() {
  const { readFragment, writeFragment } = await pageModule("sharing/codec/link.ts");
  const { toBase64Url, fromBase64Url } = await pageModule("sharing/codec/base64url.ts");
  const fixtures = ["share-version-1.json", "share-version-2.json"].map((name) => JSON.parse(readFileSync(join(ROOT, "tests/node/fixtures", name), "utf8")));

  /** A fragment around a content, as `fragment-format.ts` frames it: mutated within, not torn at its checksum. @param {number} version @param {Uint8Array} content */
  const frame = (version, content) => {
    const length = [];
    for (let rest = content.length; ; rest >>= 7) {
      length.push(rest >= 0x80 ? (rest & 0x7f) | 0x80 : rest);
      if (rest < 0x80) break;
    }
    const packed = Uint8Array.from([...length, ...deflateSync(content, { level: 1 })]);
    return `#share=${version}.${toBase64Url(Uint8Array.from([...new Uint8Array(Uint32Array.of(crc32(packed)).buffer), ...packed]))}`;
  };
  /** The content of a fragment, with its version before it. @param {string} fragment */
  const contentOf = (fragment) => {
    const [, version, text] = /=(\d+)\.(.*)$/s.exec(fragment) ?? [];
    const framed = fromBase64Url(text ?? "");
    let at = 4;
    while ((framed[at] ?? 0) >= 0x80) at += 1;
    return Uint8Array.from([Number(version), ...inflateSync(framed.subarray(at + 1))]);
  };
  return {
    seeds: () => fixtures.flatMap(fragmentsOf).map(contentOf),
    run(input) {
      // One in eight as text, torn anywhere.
      const version = input[0] ?? 0;
      const fragment = version % 8 === 7 ? new TextDecoder().decode(input.subarray(1)) : frame(version % 3 || 2, input.subarray(1));
      let read;
      try {
        read = readFragment(fragment);
      } catch (error) {
        assert.ok(error instanceof Error && error.name === "Damaged", String(error instanceof Error ? error.stack : error));
        assert.match(error.message, /^This link/);
        return;
      }
      assert.ok(JSON.stringify(read).length < 2 ** 22);
      assert.deepEqual(readFragment(writeFragment(read)), read);
    },
  };
}

/**
 * The fragments in a fixture, however deep.
 * @param {unknown} value
 * @returns {string[]}
 */
function fragmentsOf(value) {
  if (typeof value === "string") return value.includes("share=") ? [value.slice(value.indexOf("share="))] : [];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(fragmentsOf) : [];
}
