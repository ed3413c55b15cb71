// Where the browser keeps what was brought and made: one record a file, model, list of submissions and correction.

import { openDB, type DBSchema } from "idb";
import type { Override } from "../engine/contract";
import type { BroughtFile } from "../state/inbox";
import type { MadeModel, MadeSubmission } from "../state/made";

interface Kept extends DBSchema {
  /** By path. */
  files: { key: string; value: BroughtFile };
  /** By name. */
  models: { key: string; value: MadeModel };
  /** By the name of the model they are for. */
  submissions: { key: string; value: ReadonlyMap<string, MadeSubmission> };
  /** By the path of the file that is corrected. */
  overrides: { key: string; value: Override };
  /** The name of the model that a file is of, by the file's path. */
  names: { key: string; value: string };
}

/** Everything that is kept, each kind by its key. */
export interface Work {
  readonly files: ReadonlyMap<string, BroughtFile>;
  readonly models: ReadonlyMap<string, MadeModel>;
  readonly submissions: ReadonlyMap<string, ReadonlyMap<string, MadeSubmission>>;
  readonly overrides: ReadonlyMap<string, Override>;
  readonly names: ReadonlyMap<string, string>;
}

const KINDS = ["files", "models", "submissions", "overrides", "names"] as const;

/** One more wherever there is a new kind of records. Where they change their shape, let them have another name. */
const VERSION = 2;

const opened = () =>
  openDB<Kept>("fit4cad", VERSION, {
    upgrade: (database) => {
      for (const kind of KINDS) {
        if (!database.objectStoreNames.contains(kind)) database.createObjectStore(kind);
      }
    },
  });

/** What was kept last. @throws where the browser keeps nothing, as in some private windows. */
export async function read(): Promise<Work> {
  const database = await opened();
  const all = database.transaction(KINDS);
  const of = async <Kind extends (typeof KINDS)[number]>(kind: Kind) => {
    const store = all.objectStore(kind);
    const [keys, values] = await Promise.all([store.getAllKeys(), store.getAll()]);
    return new Map(keys.map((key, at) => [key, values[at] as Kept[Kind]["value"]]));
  };
  const [files, models, submissions] = await Promise.all([of("files"), of("models"), of("submissions")]);
  const [overrides, names] = await Promise.all([of("overrides"), of("names")]);
  await all.done;
  database.close();
  return { files, models, submissions, overrides, names };
}

/** So many records are handed over at once: a thousand files are copied in 50 ms, and somebody may be scrolling. */
const TOGETHER = 50;

/** Writes what has changed between two states of the work, whole or not at all. @throws where there is no room for it. */
export async function write(before: Work, now: Work): Promise<void> {
  const database = await opened();
  try {
    const change = database.transaction(KINDS, "readwrite");
    const steps = KINDS.flatMap((kind) => {
      const store = change.objectStore(kind);
      const [old, fresh]: [ReadonlyMap<string, unknown>, ReadonlyMap<string, unknown>] = [before[kind], now[kind]];
      const gone = [...old.keys()].filter((key) => !fresh.has(key)).map((key) => () => store.delete(key));
      const put = [...fresh].filter(([key, value]) => old.get(key) !== value).map(([key, value]) => () => store.put(value as never, key));
      return [...gone, ...put];
    });
    // Waited for together with the steps: where one fails, both do.
    const done = change.done;
    done.catch(() => undefined);
    for (let from = 0; from < steps.length; from += TOGETHER) {
      // The transaction stays open, as its last request has just been answered.
      await Promise.all(steps.slice(from, from + TOGETHER).map((step) => step()));
    }
    await done;
  } finally {
    database.close();
  }
}
