// Downloads public models, or one zip, and hands them on like anything dropped.

import { signal } from "@preact/signals";
import { takeDownloaded } from "../intake/intake";
import type { BroughtFile, Unplaced } from "../state/inbox";
import { notify } from "../state/notices";
import type { SetName } from "../state/origin";
import { plural } from "../ui/format";
import { filesOf, type PublicFile } from "./catalogue";
import { fetchFile, type FetchOptions } from "./fetch";
import { isPublicBase } from "./source";

/** As many as a browser asks of one host at a time over HTTP/1. */
const PARALLEL = 6;
/** The largest public file is a tenth of this. */
const MAX_FILE_BYTES = 32 * 2 ** 20;
/** The whole public repository is a quarter of this. */
const MAX_ZIP_BYTES = 256 * 2 ** 20;

export interface Download {
  readonly what: string;
  /** What `done` counts: the files settled, or the bytes of a single one. */
  readonly unit: "files" | "bytes";
  readonly done: number;
  /** Of how many, where known. */
  readonly total: number | undefined;
  /** Bytes received. */
  readonly bytes: number;
}

/** What a download came to, where it was not simply all that was asked for. */
export interface Shortfall {
  readonly summary: string;
  /** Files that are missing, with the reason. */
  readonly files: readonly Unplaced[];
}

/** The download under way; there is one at a time. */
export const download = signal<Download | undefined>(undefined);
export const shortfall = signal<Shortfall | undefined>(undefined);

let stopper = new AbortController();

export function stopDownload(): void {
  stopper.abort(new Stopped());
}

class Stopped extends Error {}

export interface Wanted {
  readonly set: SetName;
  readonly numbers: readonly number[];
  readonly withResults: boolean;
}

/** How a download ended: with all that was asked for, with less, or stopped by the reader. What arrived is taken in any case. */
export type Ending = "complete" | "short" | "stopped";

export async function downloadModels(base: URL, { set, numbers, withResults }: Wanted, stopped?: AbortSignal): Promise<Ending> {
  const models = numbers.map((number) => filesOf(set, number, withResults));
  const total = models.flat().length;
  // A copy that the page's address names may hold anything.
  const named = isPublicBase(base) ? {} : { named: base.href };
  const start: Download = { what: plural(models.length, `${set} model`), unit: "files", done: 0, total, bytes: 0 };
  return run(start, stopped, async (options) => {
    const arrival = new Arrival();
    const ended = await inParallel(models.flat(), async (file) => {
      const fetched = await fetchFile(new URL(file.address, base), { ...options, limit: MAX_FILE_BYTES });
      if (fetched.kind === "file") arrival.files.push({ path: file.path, data: fetched.data, publicModel: file.model, ...named });
      else if (fetched.kind === "failed") arrival.lack(file, fetched.reason);
      else arrival.lack(file, `${base.host} has no ${file.address} (404).`);
      arrival.settled.add(file);
      progress({ done: 1 });
    });
    // Half a model is of no use; one whose files are all settled is as good as it gets.
    const complete = models.filter((files) => files.every((file) => arrival.settled.has(file)));
    return { ...arrival.of(complete), ended, taken: complete.length, wanted: models.length };
  });
}

/** What a downloaded zip is called on the page. */
export function fileName(address: URL): string {
  return address.pathname.split("/").at(-1) ?? "data.zip";
}

/** Opens a zip by its address. */
export async function downloadZip(address: URL): Promise<Ending> {
  const path = fileName(address);
  return run({ what: path, unit: "bytes", done: 0, total: undefined, bytes: 0 }, undefined, async (options) => {
    const onPiece: FetchOptions["onPiece"] = (bytes, whole) => {
      options.onPiece(bytes, whole);
      progress({ done: bytes }, whole);
    };
    try {
      const fetched = await fetchFile(address, { ...options, onPiece, limit: MAX_ZIP_BYTES });
      if (fetched.kind === "file") return { files: [{ path, data: fetched.data, named: address.href }], lacking: [], notes: [], taken: 1, wanted: 1 };
      const reason = fetched.kind === "failed" ? fetched.reason : `${address.host} has no such file (404).`;
      return { files: [], lacking: [{ path: address.href, reason }], notes: [], taken: 0, wanted: 1 };
    } catch (error) {
      return { files: [], lacking: [], notes: [], ended: asError(error), taken: 0, wanted: 1 };
    }
  });
}

/** What a download brought. */
interface Brought {
  readonly files: readonly BroughtFile[];
  /** Files that a model misses. */
  readonly lacking: readonly Unplaced[];
  /** Published results that there are not. */
  readonly notes: readonly Unplaced[];
  /** Why it ended early. */
  readonly ended?: Error | undefined;
  /** Of the models, or zips, wanted. */
  readonly taken: number;
  readonly wanted: number;
}

class Arrival {
  readonly files: BroughtFile[] = [];
  readonly settled = new Set<PublicFile>();
  private readonly lacking = new Map<PublicFile, string>();

  lack(file: PublicFile, reason: string): void {
    this.lacking.set(file, reason);
  }

  of(models: readonly PublicFile[][]): Pick<Brought, "files" | "lacking" | "notes"> {
    const wanted = models.flat();
    const paths = new Set(wanted.map(({ path }) => path));
    const lack = (isResult: boolean) =>
      wanted.flatMap((file) => {
        const reason = this.lacking.get(file);
        return reason !== undefined && file.isResult === isResult ? [{ path: file.path, reason }] : [];
      });
    return { files: this.files.filter(({ path }) => paths.has(path)), lacking: lack(false), notes: lack(true) };
  }
}

type Work = (options: Pick<FetchOptions, "signal" | "onPiece">) => Promise<Brought>;

async function run(start: Download, stopped: AbortSignal | undefined, work: Work): Promise<Ending> {
  if (download.value) return "short";
  stopper = new AbortController();
  stopped?.addEventListener("abort", stopDownload, { once: true });
  shortfall.value = undefined;
  pending = { done: 0, bytes: 0 };
  download.value = start;
  let brought: Brought;
  try {
    brought = await work({ signal: stopper.signal, onPiece: (bytes) => progress({ bytes }) });
  } finally {
    download.value = undefined;
    stopped?.removeEventListener("abort", stopDownload);
  }
  const { files, lacking, notes, ended } = brought;
  if (files.length + lacking.length > 0) await takeDownloaded({ files: [...files], refused: [...lacking] });
  if (!ended && lacking.length + notes.length === 0) return "complete";
  shortfall.value = { summary: summaryOf(brought), files: [...lacking, ...notes] };
  notify(shortfall.value.summary, lacking.length > 0 || (ended && !(ended instanceof Stopped)) ? "error" : "info");
  return ended instanceof Stopped ? "stopped" : "short";
}

function summaryOf({ ended, lacking, notes, taken, wanted }: Brought): string {
  const kept = taken === 0 ? "Nothing was taken." : `${taken} of ${wanted} taken.`;
  if (ended instanceof Stopped) return `Download stopped. ${kept}`;
  if (ended) return `${ended.message} ${kept}`;
  const parts = [];
  const [first] = lacking;
  if (lacking.length === 1 && first) parts.push(`${first.path} did not arrive: ${first.reason}`);
  else if (lacking.length > 1) parts.push(`${plural(lacking.length, "file")} did not arrive (see Diagnostics).`);
  if (notes.length > 0) parts.push(`${plural(notes.length, "file")} of published results did not arrive; the models are complete without.`);
  return parts.join(" ");
}

/** The status bar is drawn anew for each change, so changes reach it once a frame. */
let pending = { done: 0, bytes: 0 };
let scheduled = false;

function progress({ done = 0, bytes = 0 }: { done?: number; bytes?: number }, total?: number): void {
  pending = { done: pending.done + done, bytes: pending.bytes + bytes };
  if (scheduled) return;
  scheduled = true;
  setTimeout(() => {
    const { done, bytes } = pending;
    pending = { done: 0, bytes: 0 };
    scheduled = false;
    const now = download.value;
    if (now) download.value = { ...now, done: now.done + done, bytes: now.bytes + bytes, total: total ?? now.total };
  }, 16);
}

/**
 * Works on a few items at a time; ends all at the first error, which is returned. What one file
 * alone meets is no error but an answer.
 */
async function inParallel<T>(items: readonly T[], work: (item: T) => Promise<void>): Promise<Error | undefined> {
  const queue = [...items].reverse();
  let first: Error | undefined;
  const lane = async () => {
    for (let item = queue.pop(); item !== undefined && !first; item = queue.pop()) {
      try {
        await work(item);
      } catch (error) {
        first ??= asError(error);
        stopper.abort(first);
      }
    }
  };
  await Promise.all(Array.from({ length: PARALLEL }, lane));
  return first;
}

function asError(error: unknown): Error {
  return error instanceof Error ? error : new Error(String(error));
}
