// A pool of single-threaded workers behind one queue.
//
// Ending a worker is the only way to stop wasm that is running, so that is what aborting does; a
// new worker is started when the next job needs one. Jobs are self-contained and settle their own
// promise, hence results do not depend on how many workers there are.

import * as Comlink from "comlink";

/**
 * A job's place in the queue: what the reader waits for goes before what runs in the background,
 * and that before long work that is done whenever nothing else is.
 */
export type Urgency = (typeof URGENCIES)[number];

const URGENCIES = ["foreground", "background", "idle"] as const;

function rank({ urgency }: { urgency: Urgency }): number {
  return URGENCIES.indexOf(urgency);
}

export interface JobOptions {
  readonly signal?: AbortSignal;
  readonly urgency?: Urgency;
}

interface Job<Api> {
  readonly work: (api: Comlink.Remote<Api>) => Promise<unknown>;
  readonly settle: (outcome: { value: unknown } | { error: unknown }) => void;
  readonly signal: AbortSignal | undefined;
  readonly urgency: Urgency;
}

interface Seat<Api> {
  readonly worker: Worker;
  readonly api: Comlink.Remote<Api>;
  job: Job<Api> | undefined;
}

export class WorkerPool<Api> {
  readonly #spawn: () => Worker;
  readonly #size: number;
  readonly #seats: Seat<Api>[] = [];
  #queue: Job<Api>[] = [];

  constructor(spawn: () => Worker, size: number) {
    this.#spawn = spawn;
    this.#size = Math.max(1, size);
  }

  /** Runs `work` on the next free worker. Rejects with the signal's reason when aborted. */
  run<T>(work: (api: Comlink.Remote<Api>) => Promise<T>, options: JobOptions = {}): Promise<T> {
    const { signal, urgency = "foreground" } = options;
    return new Promise<T>((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      const onAbort = () => this.#abort(job);
      const job: Job<Api> = {
        work,
        signal,
        urgency,
        settle: (outcome) => {
          signal?.removeEventListener("abort", onAbort);
          if ("value" in outcome) resolve(outcome.value as T);
          else reject(outcome.error);
        },
      };
      signal?.addEventListener("abort", onAbort, { once: true });
      this.#enqueue(job);
      this.#advance();
    });
  }

  #enqueue(job: Job<Api>): void {
    const lessUrgent = this.#queue.findIndex((other) => rank(other) > rank(job));
    this.#queue.splice(lessUrgent < 0 ? this.#queue.length : lessUrgent, 0, job);
  }

  #advance(): void {
    while (this.#queue.length > 0) {
      const seat = this.#seats.find((candidate) => candidate.job === undefined) ?? this.#newSeat();
      const job = seat && this.#queue.shift();
      if (!seat || !job) return;
      seat.job = job;
      void this.#perform(seat, job);
    }
  }

  async #perform(seat: Seat<Api>, job: Job<Api>): Promise<void> {
    try {
      const value = await job.work(seat.api);
      if (seat.job !== job) return;
      seat.job = undefined;
      job.settle({ value });
    } catch (error) {
      if (seat.job !== job) return;
      // After an exception the wasm memory may be in any state: start the next job afresh.
      this.#end(seat);
      job.settle({ error });
    }
    this.#advance();
  }

  #newSeat(): Seat<Api> | undefined {
    if (this.#seats.length >= this.#size) return undefined;
    const worker = this.#spawn();
    const seat: Seat<Api> = { worker, api: Comlink.wrap<Api>(worker), job: undefined };
    worker.addEventListener("error", (event) => {
      const job = seat.job;
      this.#end(seat);
      job?.settle({ error: new Error(event.message || "A worker could not be started.") });
      this.#advance();
    });
    this.#seats.push(seat);
    return seat;
  }

  #end(seat: Seat<Api>): void {
    seat.job = undefined;
    seat.worker.terminate();
    const at = this.#seats.indexOf(seat);
    if (at >= 0) this.#seats.splice(at, 1);
  }

  #abort(job: Job<Api>): void {
    const seat = this.#seats.find((candidate) => candidate.job === job);
    if (seat) this.#end(seat);
    else this.#queue = this.#queue.filter((other) => other !== job);
    job.settle({ error: job.signal?.reason });
    this.#advance();
  }
}
