// A submission to the standing table, checked step by step as the table will check it, and scored.

import { few } from "../../../www/shared/results/scores.mjs";
import { oneLine } from "../../../www/shared/text.mjs";
import { inOneLine } from "../diagnostics.mjs";
import { evaluate } from "../evaluate.mjs";
import { progress } from "../terminal.mjs";
import { bareName, scored, setScores } from "./entry.mjs";

/**
 * @typedef {import("../engine.mjs").Engine} Engine
 * @typedef {import("../inputs.mjs").File} File
 * @typedef {import("../../engine/engine.js").PlacedFile} PlacedFile
 * @typedef {import("../../../www/shared/results/scores.mjs").SetScores} SetScores
 * @typedef {(line: import("./words.mjs").Line) => Promise<void>} Say
 */

/** Findings told one by one; the rest is counted. */
const MOST_TOLD = 10;

export class Submission {
  #engine;
  #files;
  #set;
  /** Of the answers' folders; empty until it is known. */
  method;

  /**
   * @param {Engine} engine
   * @param {readonly File[]} files
   * @param {import("../../../www/shared/results/sets.mjs").ModelSet} set
   * @param {string | undefined} method
   */
  constructor(engine, files, set, method) {
    this.#engine = engine;
    this.#files = files;
    this.#set = set;
    this.method = method ?? "";
  }

  /**
   * The scores, or nothing where a step failed; each says how it went.
   * @param {Say} say
   * @param {ReadonlyMap<string, number> | undefined} times
   * @returns {Promise<SetScores | undefined>}
   */
  async check(say, times) {
    const groups = await this.#models(say);
    if (!groups || !(await this.#whose(say, groups)) || !(await this.#answers(say, groups))) return undefined;
    const placed = [...groups.values()].flatMap((files) => files.filter(({ method }) => method === undefined || method === this.method));
    return this.#score(say, placed, times);
  }

  /**
   * The files of each model of the set, with cloud and truth.
   * @param {Say} say
   */
  async #models(say) {
    const { models: wanted, id } = this.#set;
    const { models } = this.#engine.group(this.#files.map(({ path }) => path), {});
    /** @type {Map<string, readonly PlacedFile[]>} */
    const groups = new Map();
    let isWhole = true;
    for (const name of wanted) {
      const own = models.filter((group) => bareName(group.name) === name && ["cloud", "primitives"].every((role) => group.files.some((file) => file.role === role && file.method === undefined)));
      const [first, second] = own;
      if (first && second) {
        isWhole = false;
        await say({ mark: "✗", text: `${name}: there are several models of this name, ${oneLine(first.name)} and ${oneLine(second.name)}: give only the files of the set ${id}` });
      } else if (first) groups.set(name, first.files);
    }
    const lacking = wanted.filter((name) => !groups.has(name));
    if (!isWhole) return undefined;
    if (lacking.length > 0) {
      await say({ mark: "✗", text: `the set ${id} has ${few(lacking)}, of which there is no cloud with its ground truth among the files` });
      return undefined;
    }
    await say({ mark: "✓", text: `${wanted.length} models of the set ${id}, each with its cloud and ground truth` });
    return groups;
  }

  /**
   * Whose answers they are.
   * @param {Say} say
   * @param {ReadonlyMap<string, readonly PlacedFile[]>} groups
   */
  async #whose(say, groups) {
    const found = [...new Set([...groups.values()].flatMap((files) => files.flatMap(({ method }) => method ?? [])))];
    if (this.method === "" && found.length === 1) this.method = found[0] ?? "";
    if (this.method !== "" && found.includes(this.method)) return true;
    const why =
      found.length === 0
        ? "there are no answers: put them in a folder named after the method (pointCloud_primitives_MINE, or MINE)"
        : `say whose answers they are: ${found.map((name) => `--method ${oneLine(name)}`).join(" or ")}`;
    await say({ mark: "✗", text: why });
    return false;
  }

  /**
   * Whether every model is answered, once.
   * @param {Say} say
   * @param {ReadonlyMap<string, readonly PlacedFile[]>} groups
   */
  async #answers(say, groups) {
    const own = [...groups].map(([name, files]) => ({ name, roles: files.flatMap(({ role, method }) => (method === this.method ? [role] : [])) }));
    const lacking = own.filter(({ roles }) => !roles.includes("primitives")).map(({ name }) => name);
    if (lacking.length > 0) {
      await say({ mark: "✗", text: `${this.method} gives no primitives for ${few(lacking)}: every model has to be answered; where nothing was found, by an empty file` });
    }
    if (lacking.length > 0) return false;
    const surfaces = own.filter(({ roles }) => roles.some((role) => role !== "primitives")).length;
    const come = surfaces === own.length ? "all with surfaces" : `${surfaces} with files of surfaces`;
    await say({ mark: "✓", text: `${own.length} answers of ${this.method}, ${come}` });
    return true;
  }

  /**
   * @param {Say} say
   * @param {readonly PlacedFile[]} placed
   * @param {ReadonlyMap<string, number> | undefined} times
   */
  async #score(say, placed, times) {
    const wanted = new Set(placed.map(({ path }) => path));
    const files = this.#files.filter(({ path }) => wanted.has(path));
    const { results, diagnostics, engine } = await evaluate(this.#engine, files, {
      report: (model, method) => ({ method: method ?? "", row: scored(model, method ?? "", { name: bareName(model.info().name), inputs: {}, answers: {} }), found: model.info().diagnostics }),
      progress: (text) => progress.show(`scoring ${text}`),
    });
    const findings = [...new Set(inOneLine(engine, [...diagnostics, ...results.flatMap(({ found }) => found)]))];
    for (const line of findings.slice(0, MOST_TOLD)) await say({ mark: "!", text: line });
    if (findings.length > MOST_TOLD) await say({ mark: "!", text: `and ${findings.length - MOST_TOLD} findings more; fit4cad score tells them all` });
    const own = results.filter(({ method }) => method === this.method);
    const lacking = this.#set.models.filter((name) => !own.some(({ row }) => row.entry.model === name));
    if (lacking.length > 0) {
      await say({ mark: "✗", text: `${few(lacking)} could not be scored` });
      return undefined;
    }
    const rows = own.map(({ row: { entry, field }, files: read }) => {
      const hashes = (/** @type {boolean} */ answers) => hashesOf(read.filter(({ method }) => (method !== undefined) === answers));
      const seconds = times?.get(entry.model);
      const { inputs: _, answers: __, ...rest } = entry;
      return { entry: { ...rest, ...(seconds === undefined ? {} : { seconds }), inputs: hashes(false), answers: hashes(true) }, field };
    });
    const order = this.#set.models;
    rows.sort((one, other) => order.indexOf(one.entry.model) - order.indexOf(other.entry.model));
    const found = setScores(engine, this.#set.id, rows);
    const untimed = times ? order.filter((name) => !times.has(name)) : [];
    if (untimed.length > 0) await say({ mark: "!", text: `there is no time of ${few(untimed)}` });
    const { surfacesFitted, definition: { DSC: dsc } } = found.summary;
    if (surfacesFitted > 0) await say({ mark: "!", text: `surfaces were fitted here to the labels of ${surfacesFitted} answers, and the table says so` });
    await say({ mark: "✓", text: `scored by every protocol with engine ${found.engine}${dsc ? `: mean DSC ${dsc.mean.toFixed(4)}` : ""}` });
    return found;
  }
}

/**
 * The SHA-256 of files by what each is: of several that are the same, as a file for each primitive, all.
 * @param {readonly { role: string, sha256: string | null }[]} files
 */
function hashesOf(files) {
  /** @type {Map<string, string[]>} */
  const all = new Map();
  for (const { role, sha256 } of files) if (sha256 !== null) all.set(role, [...(all.get(role) ?? []), sha256]);
  return Object.fromEntries(Array.from(all, ([role, hashes]) => [role, hashes.length === 1 ? hashes[0] ?? "" : hashes]));
}
