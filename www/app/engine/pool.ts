// A pool of single-threaded workers behind one queue.
//
// Ending a worker is the only way to stop wasm that is running, so that is what aborting does; a
// new worker is started when the next job needs one. Jobs are self-contained and settle their own
// promise, hence results do not depend on how many workers there are.

import type * as Comlink from "comlink";
import { LiveWorker } from "./live-worker";
import { Queue, type Urgency } from "./queue";

export interface JobOptions {
  readonly signal?: AbortSignal;
  readonly urgency?: Urgency;
  /** By which it can be hastened while it waits. */
  readonly name?: string;
}

interface Job<Api> {
  readonly work: (api: Comlink.Remote<Api>) => Promise<unknown>;
  readonly settle: (outcome: { value: unknown } | { error: unknown }) => void;
  readonly signal: AbortSignal | undefined;
}

interface Seat<Api> {
  readonly worker: LiveWorker<Api>;
  job: Job<Api> | undefined;
}

export class WorkerPool<Api> {
  readonly #spawn: (onEnd: () => void) => LiveWorker<Api>;
  readonly #size: number;
  readonly #seats = new Set<Seat<Api>>();
  readonly #queue = new Queue<Job<Api>>();
  /** Jobs not settled yet, by what aborts them: one listener a signal, however many jobs it has. */
  readonly #abortable = new WeakMap<AbortSignal, Set<Job<Api>>>();
  readonly #named = new Map<string, Job<Api>>();

  /** `spawn` starts a worker that tells when it ends of itself. */
  constructor(spawn: (onEnd: () => void) => LiveWorker<Api>, size: number) {
    this.#spawn = spawn;
    this.#size = Math.max(1, size);
  }

  /** Runs `work` on the next free worker. Rejects with the signal's reason when aborted, and where the worker ends before it is done. */
  run<T>(work: (api: Comlink.Remote<Api>) => Promise<T>, options: JobOptions = {}): Promise<T> {
    const { signal, urgency = "foreground", name } = options;
    return new Promise<T>((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      const job: Job<Api> = {
        work,
        signal,
        settle: (outcome) => {
          this.#forget(job, name);
          if ("value" in outcome) resolve(outcome.value as T);
          else reject(outcome.error);
        },
      };
      if (signal) this.#heed(signal, job);
      if (name !== undefined) this.#named.set(name, job);
      this.#queue.put(job, urgency);
      this.#advance();
    });
  }

  /** Has a job done next that waits in line, if there is one of that name. */
  hasten(name: string): void {
    const job = this.#named.get(name);
    if (job && this.#queue.has(job)) this.#queue.put(job, "foreground");
  }

  #heed(signal: AbortSignal, job: Job<Api>): void {
    const jobs = this.#abortable.get(signal);
    if (jobs) {
      jobs.add(job);
      return;
    }
    this.#abortable.set(signal, new Set([job]));
    signal.addEventListener("abort", () => this.#abort(signal), { once: true });
  }

  #forget(job: Job<Api>, name: string | undefined): void {
    if (name !== undefined && this.#named.get(name) === job) this.#named.delete(name);
    if (job.signal) this.#abortable.get(job.signal)?.delete(job);
  }

  #advance(): void {
    while (this.#queue.size > 0) {
      const seat = [...this.#seats].find(({ job }) => job === undefined) ?? this.#newSeat();
      const job = seat && this.#queue.take();
      if (!seat || !job) return;
      seat.job = job;
      void this.#perform(seat, job);
    }
  }

  async #perform(seat: Seat<Api>, job: Job<Api>): Promise<void> {
    try {
      const value = await job.work(seat.worker.api);
      if (seat.job !== job) return;
      seat.job = undefined;
      job.settle({ value });
    } catch (error) {
      if (seat.job !== job) return;
      // After an exception the wasm memory may be in any state, and used up: the next job starts afresh.
      this.#dismiss(seat);
      job.settle({ error });
    }
    this.#advance();
  }

  #newSeat(): Seat<Api> | undefined {
    if (this.#seats.size >= this.#size) return undefined;
    // One that ends while it has a job is dismissed when that fails.
    const seat: Seat<Api> = { worker: this.#spawn(() => this.#seats.delete(seat)), job: undefined };
    this.#seats.add(seat);
    return seat;
  }

  #dismiss(seat: Seat<Api>): void {
    seat.job = undefined;
    this.#seats.delete(seat);
    seat.worker.end();
  }

  #abort(signal: AbortSignal): void {
    const jobs = this.#abortable.get(signal) ?? [];
    this.#abortable.delete(signal);
    for (const seat of [...this.#seats]) if (seat.job?.signal === signal) this.#dismiss(seat);
    for (const job of jobs) {
      this.#queue.remove(job);
      job.settle({ error: signal.reason });
    }
    this.#advance();
  }
}
