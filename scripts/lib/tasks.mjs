// Tasks of a page's own thread: how long each kept it, and how much of that it worked.

/** @typedef {{ wall: number, own: number }} Task milliseconds on the clock, and of the processor */
/** @typedef {{ name: string, ph: string, pid: number, tid: number, dur?: number, tdur?: number }} Traced */

/** What tells of tasks, and of the marks that a page sets. */
const CATEGORIES = ["toplevel", "blink.user_timing"];
/** Set by the page, so that its thread is told from those of the browser's own pages. */
const MARK = "this is the page";

/**
 * The tasks of the page's own thread while `act` goes on. Waiting for a renderer, and for a processor that others are
 * using, is in their time on the clock and not in that of the processor.
 * @param {import("@playwright/test").Page} page
 * @param {() => Promise<unknown>} act
 * @returns {Promise<Task[]>}
 */
export async function tasksWhile(page, act) {
  const browser = page.context().browser();
  if (!browser) throw new Error("the page is in no browser");
  await browser.startTracing(page, { categories: CATEGORIES });
  await act();
  await page.evaluate((mark) => performance.mark(mark), MARK);
  /** @type {{ traceEvents: Traced[] }} */
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString("utf8"));
  const own = traceEvents.find(({ name }) => name === MARK);
  if (!own) throw new Error("the page's thread is not in the trace");
  return traceEvents
    .filter(({ name, ph, pid, tid }) => ph === "X" && name.endsWith("RunTask") && pid === own.pid && tid === own.tid)
    .map(({ dur = 0, tdur = 0 }) => ({ wall: dur / 1000, own: tdur / 1000 }));
}
