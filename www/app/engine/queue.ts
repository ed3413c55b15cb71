// Jobs in line, the urgent ones first. What is put in, taken out, hastened or given up costs the same
// however many there are.

/**
 * A job's place in the queue: what the reader waits for goes before what runs in the background,
 * and that before long work that is done whenever nothing else is.
 */
export type Urgency = (typeof URGENCIES)[number];

const URGENCIES = ["foreground", "background", "idle"] as const;

interface Line<T> {
  /** In order of arrival. Who has left since is passed over when its turn comes. */
  readonly arrivals: T[];
  /** Place of the next. */
  next: number;
}

export class Queue<T extends object> {
  readonly #lines: Readonly<Record<Urgency, Line<T>>> = {
    foreground: { arrivals: [], next: 0 },
    background: { arrivals: [], next: 0 },
    idle: { arrivals: [], next: 0 },
  };
  /** In which line a job stands. */
  readonly #places = new Map<T, Urgency>();

  get size(): number {
    return this.#places.size;
  }

  /** Puts a job at the end of its line; one that stands in another leaves that. */
  put(job: T, urgency: Urgency): void {
    if (this.#places.get(job) === urgency) return;
    this.#places.set(job, urgency);
    this.#lines[urgency].arrivals.push(job);
  }

  /** Whether the job stands in line. */
  has(job: T): boolean {
    return this.#places.has(job);
  }

  remove(job: T): void {
    this.#places.delete(job);
  }

  /** Takes out the job whose turn it is. */
  take(): T | undefined {
    for (const urgency of URGENCIES) {
      const line = this.#lines[urgency];
      while (line.next < line.arrivals.length) {
        const job = line.arrivals[line.next++];
        if (!job || this.#places.get(job) !== urgency) continue;
        this.#places.delete(job);
        return job;
      }
      line.arrivals.length = 0;
      line.next = 0;
    }
    return undefined;
  }
}
