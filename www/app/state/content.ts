// Names for the content of models: equal keys mean equal content.

import type { ModelFile, ModelSource } from "../../worker/protocol";

const identities = new WeakMap<Blob, number>();
let lastIdentity = 0;

/** A model of these files. Content is told by the identity of its blobs, so that a changed file makes a changed key. */
export function sourceOf(name: string, files: readonly ModelFile[]): ModelSource {
  const parts = files.map(({ path, role, method, first, data }) => {
    const identity = identities.get(data) ?? ++lastIdentity;
    identities.set(data, identity);
    return `${path}|${role}|${method ?? ""}|${first ?? 1}|${identity}`;
  });
  return { key: [name, ...parts].join("\n"), name, files };
}

const truths = new WeakMap<ModelSource, ModelSource>();

/** The model without its submissions. What becomes of those does not change it. */
export function truthOnly(source: ModelSource): ModelSource {
  let truth = truths.get(source);
  if (!truth) {
    truth = sourceOf(source.name, source.files.filter(({ method }) => method === undefined));
    truths.set(source, truth);
  }
  return truth;
}

/** The model without one of its submissions. */
export function without({ name, files }: ModelSource, submission: string): ModelSource {
  return sourceOf(name, files.filter(({ method }) => method !== submission));
}
