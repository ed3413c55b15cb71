// Asking for what changes faster than it can be answered.

/** Runs the latest of many requests, one at a time: what a brush or slider asks for while the engine is busy is asked once. Rejects where the latest failed. */
export function latest<T>(work: (request: T) => Promise<void>): (request: T) => Promise<void> {
  let waiting: { readonly request: T } | undefined;
  let busy: Promise<void> | undefined;
  const drain = async () => {
    let failure: { readonly error: unknown } | undefined;
    while (waiting) {
      const { request } = waiting;
      waiting = undefined;
      try {
        await work(request);
        failure = undefined;
      } catch (error) {
        failure = { error };
      }
    }
    busy = undefined;
    if (failure) throw failure.error;
  };
  return (request) => {
    waiting = { request };
    busy ??= drain();
    return busy;
  };
}
