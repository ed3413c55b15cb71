// What the sections of the benchmark share: timing, printing, holding a figure against its bar.

import { align } from "../../bin/formats/align.mjs";

export class Bench {
  /** Bars that were not reached. */
  missed = 0;
  /** The tables so far, for a README. */
  markdown = "";

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

  /**
   * Prints a table and keeps it as Markdown. A cell is a text, or `{ text, bar, met }` for a figure
   * with a bar to reach.
   */
  table({ title, note, head, rows, textColumns = 1 }) {
    const cells = rows.map((row) => row.map((cell) => this.#judged(cell)));
    console.log(`\n  ${title}${note ? `\n  ${note}` : ""}`);
    console.log(align([head, ...cells], textColumns).replace(/^/gm, "    "));
    const rule = head.map((_, column) => (column < textColumns ? ":--" : "--:"));
    const lines = [head, rule, ...cells].map((row) => `| ${row.join(" | ")} |\n`);
    this.markdown += `\n### ${title}\n${note ? `${note}\n` : ""}\n${lines.join("")}`;
  }

  #judged(cell) {
    if (typeof cell === "string") {
      return cell;
    }
    this.missed += cell.met ? 0 : 1;
    return `${cell.text} (${cell.bar}${cell.met ? "" : ", missed"})`;
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

export function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** What the body gives, and the processor time it took: other work on the machine does not count. */
export function timed(body) {
  const before = process.cpuUsage();
  const value = body();
  const { user, system } = process.cpuUsage(before);
  return { value, seconds: (user + system) / 1e6 };
}
