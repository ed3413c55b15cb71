// A worker of which every question is answered, whatever becomes of it: where it cannot be started, an answer
// cannot be read, or it ends without a word, what was asked of it fails, and whoever keeps it is told.

import * as Comlink from "comlink";
import { isAlive } from "../../worker/alive";

/** A worker has ended before it answered. */
export class WorkerEnded extends Error {
  constructor(message: string) {
    super(message);
    this.name = "WorkerEnded";
  }
}

interface Options {
  /** What it is to the reader: “The engine”. */
  readonly title: string;
  /** Told once when it ends of itself, with the reason. */
  readonly onEnd?: (reason: WorkerEnded) => void;
}

export class LiveWorker<Api> {
  /** What it can be asked. */
  readonly api: Comlink.Remote<Api>;
  readonly #worker: Worker;
  readonly #options: Options;
  /** What to call for each question that is not answered yet. */
  readonly #unanswered = new Set<(reason: WorkerEnded) => void>();
  #ended: WorkerEnded | undefined;

  /** `start` starts it by the given name, which is its own and no other's. Its script is to call `stayAlive`. */
  constructor(start: (name: string) => Worker, options: Options) {
    const { title } = options;
    const name = `${title} ${Date.now().toString(36)}${Math.random().toString(36).slice(2)}`;
    this.#options = options;
    this.#worker = start(name);
    this.api = this.#answering(Comlink.wrap<Api>(this.#worker));
    this.#worker.addEventListener("error", ({ message }) => this.#fail(message || `${title} could not be started.`));
    this.#worker.addEventListener("messageerror", () => this.#fail(`An answer of ${title} could not be read.`));
    this.#worker.addEventListener("message", ({ data }) => {
      if (!isAlive(data)) return;
      // The browser hands the lock on when its holder is gone, however it went.
      void navigator.locks.request(name, () => this.#fail(`${title} ended without a word. The browser may have run out of memory.`));
    });
  }

  /** Ends it; what is not answered yet fails. */
  end(): void {
    this.#end(new WorkerEnded(`${this.#options.title} was stopped.`));
  }

  #fail(message: string): void {
    if (this.#ended) return;
    const reason = new WorkerEnded(message);
    this.#end(reason);
    this.#options.onEnd?.(reason);
  }

  #end(reason: WorkerEnded): void {
    if (this.#ended) return;
    this.#ended = reason;
    this.#worker.terminate();
    for (const reject of this.#unanswered) reject(reason);
    this.#unanswered.clear();
  }

  /** The same questions, each of which fails when the worker ends before it is answered. */
  #answering(remote: Comlink.Remote<Api>): Comlink.Remote<Api> {
    type Question = (...details: unknown[]) => Promise<unknown>;
    const questions = new Map<string | symbol, Question | undefined>([["then", undefined]]);
    const ask = (name: string | symbol) => {
      const question = (remote as unknown as Record<string | symbol, Question>)[name];
      return (...details: unknown[]) => this.#ask(() => question?.(...details));
    };
    const get = (_: object, name: string | symbol) => {
      if (!questions.has(name)) questions.set(name, ask(name));
      return questions.get(name);
    };
    return new Proxy({}, { get }) as Comlink.Remote<Api>;
  }

  #ask<T>(question: () => Promise<T> | undefined): Promise<T | undefined> {
    return new Promise((resolve, reject) => {
      if (this.#ended) {
        reject(this.#ended);
        return;
      }
      this.#unanswered.add(reject);
      const settled = () => this.#unanswered.delete(reject);
      Promise.resolve(question()).then(resolve, reject).finally(settled);
    });
  }
}
