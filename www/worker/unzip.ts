// Opens one zip: every file in it, also those of a zip within, as blobs.

import * as Comlink from "comlink";
import { stayAlive } from "./alive";
import { unzipped, type Unzipped } from "./unzipped";

const unzipper = {
  open(path: string, data: Blob): Unzipped {
    // A blob is read piece by piece: a zip need not fit into memory.
    const reader = new FileReaderSync();
    const bytes = (from: number, to: number) => new Uint8Array(reader.readAsArrayBuffer(data.slice(from, to)));
    return unzipped(path, { size: data.size, bytes });
  },
};

export type UnzipWorker = typeof unzipper;

stayAlive();
Comlink.expose(unzipper);
