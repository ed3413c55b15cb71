// What the sections of the benchmark share: timing, printing, holding a figure against its bar.

import { align } from "../../www/shared/formats/align.mjs";

/** @typedef {string | { text: string, bar: string, met: boolean }} Cell */

export class Bench {
  /** Bars that were not reached. */
  missed = 0;
  /** The tables so far, for a README. */
  markdown = "";

  /** @param {import("../../bin/cli/engine.mjs").Engine} engine */
  constructor(engine) {
    this.engine = engine;
  }

  /**
   * Median seconds of several runs, the first one left out: it warms the compiler up.
   * @param {number} runs
   * @param {() => void} body
   */
  seconds(runs, body) {
    body();
    const times = Array.from({ length: runs }, () => {
      const start = performance.now();
      body();
      return (performance.now() - start) / 1000;
    });
    return median(times);
  }

  /**
   * The same of a body that is waited for.
   * @param {number} runs
   * @param {() => Promise<unknown>} body
   */
  async secondsOf(runs, body) {
    await body();
    /** @type {number[]} */
    const times = [];
    for (let run = 0; run < runs; run += 1) {
      const start = performance.now();
      await body();
      times.push((performance.now() - start) / 1000);
    }
    return median(times);
  }

  /**
   * Prints a figure and, where there is one, its bar: `{ most }` or `{ least }`.
   * @param {string} label
   * @param {number} value
   * @param {string} unit
   * @param {{ most?: number | undefined, least?: number | undefined, digits?: number }} bar
   */
  figure(label, value, unit, { most, least, digits = 2 } = {}) {
    const shown = `${value.toFixed(digits)} ${unit}`;
    const bar = most ?? least;
    if (bar === undefined) {
      console.log(`  ${label.padEnd(52)} ${shown.padStart(14)}`);
      return;
    }
    const met = most === undefined ? value >= bar : value <= bar;
    this.missed += met ? 0 : 1;
    const sign = most === undefined ? "≥" : "≤";
    const ratio = value / bar;
    console.log(
      `  ${label.padEnd(52)} ${shown.padStart(14)}   bar ${sign} ${bar} ${unit}, ${ratio.toFixed(2)} of it: ${met ? "met" : "MISSED"}`,
    );
  }

  /**
   * Prints a table and keeps it as Markdown. A cell is a text, or `{ text, bar, met }` for a figure
   * with a bar to reach.
   * @param {{ title: string, note?: string | undefined, head: readonly string[], rows: readonly (readonly Cell[])[], textColumns?: number }} table
   */
  table({ title, note, head, rows, textColumns = 1 }) {
    const cells = rows.map((row) => row.map((cell) => this.#judged(cell)));
    console.log(`\n  ${title}${note ? `\n  ${note}` : ""}`);
    console.log(align([head, ...cells], textColumns).replace(/^/gm, "    "));
    const rule = head.map((_, column) => (column < textColumns ? ":--" : "--:"));
    const lines = [head, rule, ...cells].map((row) => `| ${row.join(" | ")} |\n`);
    this.markdown += `\n### ${title}\n${note ? `${note}\n` : ""}\n${lines.join("")}`;
  }

  /** @param {Cell} cell */
  #judged(cell) {
    if (typeof cell === "string") {
      return cell;
    }
    this.missed += cell.met ? 0 : 1;
    return `${cell.text} (${cell.bar}${cell.met ? "" : ", missed"})`;
  }

  /** @param {string} text */
  note(text) {
    console.log(`  ${text}`);
  }
}

/** @param {readonly number[]} values */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  const [below = NaN, above = NaN] = [sorted[sorted.length % 2 === 1 ? middle : middle - 1], sorted[middle]];
  return (below + above) / 2;
}

/** @param {readonly number[]} values */
export function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/**
 * What the body gives, and the processor time it took: other work on the machine does not count.
 * @template T
 * @param {() => T} body
 */
export function timed(body) {
  const before = process.cpuUsage();
  const value = body();
  const { user, system } = process.cpuUsage(before);
  return { value, seconds: (user + system) / 1e6 };
}
