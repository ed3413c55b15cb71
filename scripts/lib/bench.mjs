// What the sections of the benchmark share: timing, printing, holding a figure against its bar.

export class Bench {
  /** Bars that were not reached. */
  missed = 0;

  constructor(engine) {
    this.engine = engine;
  }

  /** Median seconds of several runs, the first one left out: it warms the compiler up. */
  seconds(runs, body) {
    body();
    const times = Array.from({ length: runs }, () => {
      const start = performance.now();
      body();
      return (performance.now() - start) / 1000;
    });
    return median(times);
  }

  /** Prints a figure and, where there is one, its bar: `{ most }` or `{ least }`. */
  figure(label, value, unit, { most, least, digits = 2 } = {}) {
    const shown = `${value.toFixed(digits)} ${unit}`;
    const bar = most ?? least;
    if (bar === undefined) {
      console.log(`  ${label.padEnd(52)} ${shown.padStart(14)}`);
      return;
    }
    const met = most === undefined ? value >= least : value <= most;
    this.missed += met ? 0 : 1;
    const sign = most === undefined ? "≥" : "≤";
    const ratio = most === undefined ? value / least : value / most;
    console.log(
      `  ${label.padEnd(52)} ${shown.padStart(14)}   bar ${sign} ${bar} ${unit}, ${ratio.toFixed(2)} of it: ${met ? "met" : "MISSED"}`,
    );
  }

  note(text) {
    console.log(`  ${text}`);
  }
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
