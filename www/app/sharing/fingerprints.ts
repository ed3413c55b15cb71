// The fingerprints by which a link knows files again.

import { filesOfMethod, hashed } from "../export/hashes";
import type { HashedFile } from "../../../bin/formats/results.mjs";
import type { ModelFile } from "../../worker/protocol";
import { FINGERPRINT_BYTES, type Fingerprint } from "./shared";

export interface Fingerprints {
  /** Of the cloud and the ground truth. */
  readonly inputs: Fingerprint | undefined;
  /** Of the submission. */
  readonly submission: Fingerprint | undefined;
}

/** Undefined where the browser does not hash (a page that came over an unsafe connection). */
export async function fingerprintsOf(files: readonly ModelFile[], method: string): Promise<Fingerprints> {
  const all = await hashed(filesOfMethod(files, method));
  return {
    inputs: await fingerprint(all.filter((file) => file.method === undefined)),
    submission: await fingerprint(all.filter((file) => file.method === method)),
  };
}

/** Over what the files hold and what they are, not over what they are called. */
async function fingerprint(files: readonly HashedFile[]): Promise<Fingerprint | undefined> {
  if (files.length === 0 || files.some(({ sha256 }) => sha256 === null)) return undefined;
  const lines = files.map(({ role, sha256 }) => `${role} ${sha256}\n`).sort();
  const digest = await crypto.subtle.digest("SHA-256", new TextEncoder().encode(lines.join("")));
  const bytes = Array.from(new Uint8Array(digest, 0, FINGERPRINT_BYTES));
  return bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
