// The models on the page: search, sort, status, choose.

import type { JSX } from "preact";
import { computed, signal } from "@preact/signals";
import { taking } from "../intake/intake";
import type { Measure, ModelInfo } from "../engine/contract";
import { MEASURES } from "../measures/measures";
import { untouched } from "../state/contents";
import { models, type ModelEntry } from "../state/models";
import { resumeScoring } from "../state/scoring";
import { protocol } from "../state/settings";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import * as format from "../ui/format";
import { Icon } from "../ui/icon";
import { Seen, type Place } from "../ui/seen";
import { FrontDoor } from "./front-door";

type Order = "model" | "points" | "diagnostics" | Measure;

const search = signal("");
const order = signal<Order>("model");

/** The figure a model is listed with: of the method selected elsewhere where it has it, else of its first. */
function reportOf(entry: ModelEntry) {
  if (entry.status.kind !== "scored") return undefined;
  const { reports } = entry.status.result;
  const chosen = reports.find(({ method }) => method === selectedMethod.value) ?? reports[0];
  return chosen?.[protocol.value];
}

function figureOf(entry: ModelEntry, by: Order): number | null | undefined {
  if (entry.status.kind !== "scored" || by === "model") return undefined;
  const { info } = entry.status.result;
  if (by === "points") return info.points;
  if (by === "diagnostics") return info.diagnostics.length;
  return reportOf(entry)?.mean[by];
}

const listed = computed(() => {
  const words = search.value.trim().toLowerCase().split(/\s+/);
  const found = models.value.filter(({ id }) => words.every((word) => id.toLowerCase().includes(word)));
  const by = order.value;
  if (by === "model") return found;
  // What needs attention comes first: errors from the largest, scores from the lowest.
  const largestFirst = by === "points" || by === "diagnostics" || by === "MFE" || by === "dHaus" || by === "d1";
  const missing = largestFirst ? -Infinity : Infinity;
  const value = (entry: ModelEntry) => figureOf(entry, by) ?? missing;
  return [...found].sort((a, b) => (largestFirst ? value(b) - value(a) : value(a) - value(b)));
});

const SEARCH_ID = "model-search";

export function focusSearch(): void {
  document.getElementById(SEARCH_ID)?.focus();
}

export function ModelList(): JSX.Element {
  const shown = listed.value;
  const total = models.value.length;
  const stopped = models.value.filter(({ status }) => status.kind === "stopped").length;
  const counted = shown.length === total ? format.plural(total, "model") : `${shown.length} of ${total} models`;
  return (
    <aside class="models" aria-label="Models" data-untouched={untouched.value || undefined}>
      <div class="models-tools">
        <label class="search">
          <span class="visually-hidden">Search the models</span>
          <Icon name="search" />
          <input
            id={SEARCH_ID}
            type="search"
            placeholder="Search"
            value={search.value}
            onInput={(event) => (search.value = event.currentTarget.value)}
          />
        </label>
        <label class="order">
          <span class="visually-hidden">List by</span>
          <select value={order.value} onChange={(event) => (order.value = event.currentTarget.value as Order)}>
            <option value="model">by name</option>
            <option value="points">by points</option>
            <option value="diagnostics">by diagnostics</option>
            {MEASURES.map((measure) => (
              <option key={measure} value={measure}>
                by {measure}, worst first
              </option>
            ))}
          </select>
        </label>
      </div>
      <p class="count">
        <span aria-live="polite">{counted}</span>
        {stopped > 0 && (
          <button type="button" class="link" onClick={resumeScoring}>
            Score {format.integer(stopped)} stopped
          </button>
        )}
      </p>
      {total > 0 && (
        <Seen
          as="ul"
          items={shown}
          handle="button"
          draw={(entry, place) => <Item key={entry.id} entry={entry} by={order.value} place={place} />}
        />
      )}
      {taking.value && total === 0 && <p class="empty">Reading files…</p>}
      {untouched.value && !taking.value && <FrontDoor sample={total > 0} />}
    </aside>
  );
}

function Item({ entry, by, place }: { entry: ModelEntry; by: Order; place: Place }): JSX.Element {
  const { id, status, origin } = entry;
  const report = reportOf(entry);
  const measure: Measure = by === "model" || by === "points" || by === "diagnostics" ? "DSC" : by;
  const findings = status.kind === "scored" ? status.result.info.diagnostics : [];
  const worst = findings.some(({ severity }) => severity === "error") ? "error" : "warning";
  const counts = findings.filter(({ severity }) => severity !== "note").length;
  return (
    <li {...place}>
      <button type="button" aria-current={id === selectedModel.value ? "true" : undefined} onClick={() => selectModel(id)}>
        <span class="name">
          {id}
          {origin.kind === "sample" && <small>sample</small>}
        </span>
        {counts > 0 && (
          <span class={`mark ${worst}`} title={format.plural(counts, "diagnostic")}>
            <Icon name="error" />
            {counts}
            <span class="visually-hidden"> diagnostics</span>
          </span>
        )}
        <span class="figure">
          {status.kind === "scored" && (report ? format.measure(measure, report.mean[measure]) : whyUnscored(status.result.info))}
          {status.kind === "waiting" && <span class="waiting">scoring</span>}
          {status.kind === "stopped" && "stopped"}
          {status.kind === "failed" && <span class="mark error">failed</span>}
        </span>
        <span class="detail">
          {status.kind === "scored" &&
            [format.plural(status.result.info.points, "point"), ...status.result.info.methods].join(" · ")}
          {status.kind === "failed" && status.message}
        </span>
      </button>
    </li>
  );
}

function whyUnscored({ hasTruth, methods }: ModelInfo): string {
  if (hasTruth) return "truth only";
  return methods.length > 0 ? "no truth" : "points only";
}
