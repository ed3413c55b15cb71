// How a page hears that a worker of its has ended, whatever ended it: the worker holds a lock by its own name
// as long as it lives. Nothing need be asked of it, so it is heard also of one that is busy.

/** Sent to the page once the lock is held. */
const ALIVE = "alive";

export function isAlive(message: unknown): boolean {
  return message === ALIVE;
}

/**
 * Holds the lock until the worker ends. Where the browser has no locks, as on a page that came over an unsafe
 * connection, the page hears of errors alone.
 */
export function stayAlive(): void {
  // A question that cannot be read can have no answer: the page hears of the end.
  self.addEventListener("messageerror", () => self.close());
  const locks = navigator.locks as LockManager | undefined;
  void locks?.request(self.name, () => {
    self.postMessage(ALIVE);
    return new Promise<never>(() => undefined);
  });
}
