// What comes under the name of a model that is there may be a model of its own, or a submission for that one.

import { batch } from "@preact/signals";
import { contents, type Content } from "./contents";
import { freeName } from "./identity";
import { bareName, brought, discard, override, type BroughtFile } from "./inbox";

/** A model that has come, and the one of its name that was there. */
export interface Twin {
  readonly fresh: Content;
  readonly old: Content;
}

const cloudOf = ({ source }: Content) => source.files.find(({ role }) => role === "cloud");
const segmentationOf = ({ source }: Content) => source.files.filter(({ role }) => role !== "cloud");

/** The pairs for which there is a choice: both came as files, and the new one has a cloud and one segmentation. */
export function twinsAmong(fresh: readonly Content[]): Twin[] {
  const isBrought = ({ source }: Content) => source.files.some(({ path }) => brought.value.has(path));
  const old = new Map(contents.value.filter((each) => !fresh.includes(each) && isBrought(each)).map((each) => [bareName(each.id), each]));
  return fresh.flatMap((each) => {
    const segmentation = segmentationOf(each);
    const twin = old.get(bareName(each.id));
    const isSingle = segmentation.length > 0 && segmentation.every(({ method }) => method === undefined);
    return twin && isSingle && cloudOf(each) && cloudOf(twin) ? [{ fresh: each, old: twin }] : [];
  });
}

/** Whether both have one cloud, byte for byte: then the new one is hardly a model of its own. */
export async function isSameCloud({ fresh, old }: Twin): Promise<boolean> {
  const [a, b] = [cloudOf(fresh)?.data, cloudOf(old)?.data];
  if (!a || !b || a.size !== b.size) return false;
  for (let from = 0; from < a.size; from += PIECE) {
    const [one, other] = await Promise.all([a, b].map(async (each) => new Uint8Array(await each.slice(from, from + PIECE).arrayBuffer())));
    if (!one || !other || one.some((byte, at) => byte !== other[at])) return false;
  }
  return true;
}

/** Bytes that are compared at a time. */
const PIECE = 1 << 22;

/** Makes submissions of the new models; the result makes them models of their own again. */
export function joinTwins(twins: readonly Twin[]): () => void {
  const clouds = new Map<string, BroughtFile>();
  batch(() => {
    for (const { fresh, old } of twins) {
      const taken = new Set(old.source.files.flatMap(({ method }) => method ?? []));
      const method = freeName("submission", taken);
      for (const { path } of segmentationOf(fresh)) override(path, { model: old.id, method });
      const path = cloudOf(fresh)?.path ?? "";
      const cloud = brought.value.get(path);
      if (cloud) clouds.set(path, cloud);
    }
    discard(new Set(clouds.keys()));
  });
  return () =>
    batch(() => {
      for (const { path } of twins.flatMap(({ fresh }) => segmentationOf(fresh))) override(path, {});
      brought.value = new Map([...brought.value, ...clouds]);
    });
}
