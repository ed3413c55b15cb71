// Tasks of a page's own thread that take long, and how much of each it waits for the renderer.

/** @typedef {{ start: number, duration: number, drawing: number }} Task in milliseconds */
/** @typedef {Window & { longTasks: [number, number][], drawn: [number, number][] }} Watched the page's window with what is taken in it */

/** Runs in the page before anything of it does: takes long tasks, and when the renderer is called and for how long. */
export function drawingApart() {
  /** @type {[number, number][]} */
  const longTasks = [];
  /** @type {[number, number][]} */
  const drawn = [];
  Object.assign(window, { longTasks, drawn });
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) longTasks.push([startTime, duration]);
  }).observe({ type: "longtask", buffered: true });
  /** Calls of less are too many to hold, and too short to tell. */
  const SHORT_MS = 0.2;
  /** @param {(this: unknown, ...details: unknown[]) => unknown} call */
  const timed = (call) =>
    /** @this {unknown} @param {unknown[]} details */
    function (...details) {
      const start = performance.now();
      const value = call.apply(this, details);
      const took = performance.now() - start;
      if (took > SHORT_MS) drawn.push([start, took]);
      return value;
    };
  /** @param {object} owner @param {string} name */
  const wrap = (owner, name) => {
    const found = Object.getOwnPropertyDescriptor(owner, name);
    if (!found) return;
    if (typeof found.value === "function") Object.defineProperty(owner, name, { ...found, value: timed(found.value) });
    // A canvas that changes its size waits for what is drawn on it.
    else if (found.set) Object.defineProperty(owner, name, { ...found, set: timed(found.set) });
  };
  for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) wrap(WebGL2RenderingContext.prototype, name);
  for (const name of ["getContext", "width", "height"]) wrap(HTMLCanvasElement.prototype, name);
}

/**
 * The long tasks so far.
 * @param {import("@playwright/test").Page} page
 * @returns {Promise<Task[]>}
 */
export function tasksOf(page) {
  return page.evaluate(() => {
    const { longTasks, drawn } = /** @type {Watched} */ (/** @type {unknown} */ (window));
    return longTasks.map(([start, duration]) => {
      const within = drawn.filter(([at]) => at >= start && at < start + duration);
      return { start, duration, drawing: within.reduce((sum, [, took]) => sum + took, 0) };
    });
  });
}
