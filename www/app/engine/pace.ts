// How often the page is told of what comes in by the thousand.

/** Once a frame is as often as anybody sees. */
const FRAME_MS = 16;
/** Of the time, at most this share goes into showing what has come. */
const SHARE = 0.1;
/** However long showing takes, nobody waits longer for it. */
const LONGEST_MS = 1000;

/**
 * Shows what has come, soon after each call and many calls together. What it takes to show grows with what there is;
 * the pauses grow with it, so that the whole of `n` things takes time in proportion to `n`, not to its square.
 */
export function paced(show: () => void): () => void {
  let asked = false;
  let pause = FRAME_MS;
  const go = () => {
    asked = false;
    const start = performance.now();
    show();
    // Components are drawn anew before the next task.
    setTimeout(() => {
      const took = performance.now() - start;
      pause = Math.min(LONGEST_MS, Math.max(FRAME_MS, took * (1 / SHARE - 1)));
    });
  };
  return () => {
    if (asked) return;
    asked = true;
    setTimeout(go, pause);
  };
}
