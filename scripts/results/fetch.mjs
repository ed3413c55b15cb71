// Fetches an archive that somebody named: no larger, and no longer, than allowed, and only if it is the one meant.

import { createHash } from "node:crypto";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

/** An archive that could not be had; the message says why. */
export class Unfetched extends Error {}

/** The whole public repository is a quarter of this. */
const MOST_BYTES = 256 * 2 ** 20;
const MOST_MILLISECONDS = 5 * 60_000;

/**
 * Puts the archive of an address into a folder, under a name of its hash; gives the path. Throws `Unfetched`.
 * @param {string} folder
 * @param {string} address
 * @param {{ sha256?: string | undefined, mirrors?: readonly string[] }} how `mirrors`: FROM=TO, where addresses that begin so are to be had
 */
export async function fetchInto(folder, address, { sha256, mirrors = [] }) {
  const content = await fetched(mirrored(address, mirrors), address);
  const found = createHash("sha256").update(content).digest("hex");
  if (sha256 !== undefined && found !== sha256) {
    throw new Unfetched(`${address} has the SHA-256 ${found}, not ${sha256}: it is another archive than the one that was meant`);
  }
  const path = join(folder, `${found}.zip`);
  writeFileSync(path, content);
  return path;
}

/**
 * @param {string} address
 * @param {readonly string[]} mirrors
 */
function mirrored(address, mirrors) {
  for (const mirror of mirrors) {
    const at = mirror.indexOf("=");
    if (at > 0 && address.startsWith(mirror.slice(0, at))) return mirror.slice(at + 1) + address.slice(at);
  }
  return address;
}

/**
 * @param {string} place
 * @param {string} address as it is told
 */
async function fetched(place, address) {
  /** @type {Uint8Array[]} */
  const pieces = [];
  let size = 0;
  try {
    const response = await fetch(place, { signal: AbortSignal.timeout(MOST_MILLISECONDS), credentials: "omit" });
    if (!response.ok) throw new Unfetched(`${address} could not be had: the host answered ${response.status}`);
    for await (const piece of response.body ?? []) {
      size += piece.byteLength;
      if (size > MOST_BYTES) throw new Unfetched(`${address} is larger than ${MOST_BYTES / 2 ** 20} MiB`);
      pieces.push(piece);
    }
  } catch (error) {
    if (error instanceof Unfetched) throw error;
    throw new Unfetched(`${address} could not be had: ${error instanceof Error ? error.message : String(error)}`);
  }
  return Buffer.concat(pieces);
}
