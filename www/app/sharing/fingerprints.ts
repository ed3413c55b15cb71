// The fingerprints by which a link knows files again.

import { engine } from "../engine/client";
import { filesOfMethod, hashed } from "../export/hashes";
import type { HashedFile } from "../../shared/formats/results.mjs";
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
  const [truth, submission] = [undefined, method].map((owner) => all.filter((file) => file.method === owner)) as [HashedFile[], HashedFile[]];
  return {
    inputs: await fingerprint(truth),
    submission: await fingerprint(submission),
  };
}

/** What is to be known of files that may bear a claim out. */
export interface Evidence extends Fingerprints {
  /** Whether the submission's list of points says what the ground truth's file says. */
  readonly copiesTruth: boolean;
}

export async function evidenceOf(files: readonly ModelFile[], method: string): Promise<Evidence> {
  const prints = await fingerprintsOf(files, method);
  return { ...prints, copiesTruth: await copiesTruth(files, method) };
}

async function copiesTruth(files: readonly ModelFile[], method: string): Promise<boolean> {
  const [own, submitted] = [undefined, method].map((owner) => files.find((file) => file.role === "primitives" && file.method === owner));
  return own !== undefined && submitted !== undefined && engine.run((api) => api.sayTheSame(own.data, submitted.data), { urgency: "background" });
}

/** Over what the files hold and what they are, not over what they are called. */
export async function fingerprint(files: readonly HashedFile[]): Promise<Fingerprint | undefined> {
  if (files.length === 0 || files.some(({ sha256 }) => sha256 === null)) return undefined;
  const lines = files.map(({ role, sha256 }) => `${role} ${sha256}\n`).sort();
  const digest = await crypto.subtle.digest("SHA-256", new TextEncoder().encode(lines.join("")));
  const bytes = Array.from(new Uint8Array(digest, 0, FINGERPRINT_BYTES));
  return bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
