// Asking for what changes faster than it can be answered.

/** Runs the latest of many requests, one at a time: what a brush or slider asks for while the engine is busy is asked once. */
export function latest<T>(work: (request: T) => Promise<void>): (request: T) => Promise<void> {
  let waiting: { readonly request: T } | undefined;
  let busy: Promise<void> | undefined;
  const drain = async () => {
    try {
      while (waiting) {
        const { request } = waiting;
        waiting = undefined;
        await work(request);
      }
    } finally {
      busy = undefined;
    }
  };
  return (request) => {
    waiting = { request };
    busy ??= drain();
    return busy;
  };
}
