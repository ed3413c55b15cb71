// Fetches one file, no longer than allowed.

export type Fetched =
  | { readonly kind: "file"; readonly data: Blob }
  | { readonly kind: "missing" }
  | { readonly kind: "failed"; readonly reason: string };

/** The host could not be reached at all: asking for further files is of no use. */
export class Unreachable extends Error {
  constructor(readonly host: string) {
    super(
      navigator.onLine
        ? `${host} could not be reached. Check the connection, and whether something blocks it, and try again.`
        : `You are offline, and ${host} cannot be reached. What is on the page keeps working; try again once connected.`,
    );
  }
}

export interface FetchOptions {
  /** Largest size in bytes. */
  readonly limit: number;
  readonly signal: AbortSignal;
  /** Told of every piece that arrives, and of the whole size where the host says it. */
  readonly onPiece: (bytes: number, whole: number | undefined) => void;
}

/** Throws `Unreachable`, or what `signal` was aborted with. */
export async function fetchFile(address: URL, { limit, signal, onPiece }: FetchOptions): Promise<Fetched> {
  try {
    const response = await fetch(address, { signal, credentials: "omit", referrerPolicy: "no-referrer" });
    if (response.status === 404) return { kind: "missing" };
    if (!response.ok) return { kind: "failed", reason: refusalOf(response) };
    // Some hosts answer with their start page where they have no such file.
    if (response.headers.get("content-type")?.startsWith("text/html")) return { kind: "missing" };
    // Of what is sent; it says nothing of the content where that is compressed.
    const length = response.headers.has("content-encoding") ? 0 : Number(response.headers.get("content-length"));
    const pieces: Uint8Array<ArrayBuffer>[] = [];
    let size = 0;
    for (const reader = response.body?.getReader(); reader; ) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.byteLength;
      if (size > limit) {
        await reader.cancel();
        return { kind: "failed", reason: `It is larger than ${limit / 2 ** 20} MiB and was not taken.` };
      }
      pieces.push(value);
      onPiece(value.byteLength, length > 0 ? length : undefined);
    }
    return { kind: "file", data: new Blob(pieces) };
  } catch (error) {
    signal.throwIfAborted();
    // The browser tells a page no more than that it failed.
    if (error instanceof TypeError) throw new Unreachable(address.host);
    throw error;
  }
}

function refusalOf({ status }: Response): string {
  const why = status === 429 ? "too many requests; wait a few minutes" : status >= 500 ? "its own fault; try again" : "refused";
  return `The host answered ${status} (${why}).`;
}
