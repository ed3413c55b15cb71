// What the rest of the field reports of the submissions on the page.

import { computed, effect, signal } from "@preact/signals";
import { FIGURES } from "../../generated/declared/figures.js";
import { FIGURE_SCALE } from "../../generated/declared/figure-scale.js";
import { NORMALISATIONS } from "../../generated/declared/normalisations.js";
import { BY, type Reported } from "../../shared/formats/field-sums.mjs";
import type { FieldStrata, FieldSums, Particulars } from "../../worker/protocol";
import { engine } from "../engine/client";
import type { By, FieldReport, FigureScale } from "../engine/contract";
import { latest } from "../engine/latest";
import { survey, type Survey } from "../engine/survey";
import { modelById, models } from "../state/models";
import { notify } from "../state/notices";
import { remembered } from "../state/settings";

export const EPSILONS = ["0.001", "0.005", "0.01", "0.02", "0.05"] as const;

export const normalisation = remembered("normalisation", FIGURE_SCALE.normalisation, NORMALISATIONS.map(({ name }) => name));
export const epsilon = remembered<string>("epsilon", String(FIGURE_SCALE.epsilon), EPSILONS);

/** What true primitives are told apart by. */
export const by = remembered<By>("stratum", "size", BY);

export const scale = computed<FigureScale>(() => ({ normalisation: normalisation.value, epsilon: Number(epsilon.value) }));

/** One survey a scale: what was asked once is there when the reader comes back to it. */
const surveys = new Map<string, Survey<readonly FieldReport[]>>();

function surveyOf(wanted: FigureScale): Survey<readonly FieldReport[]> {
  const key = `${wanted.normalisation} ${wanted.epsilon}`;
  let known = surveys.get(key);
  if (!known) {
    known = survey((api, source) => api.field(source, wanted));
    surveys.set(key, known);
  }
  return known;
}

export const current = computed(() => surveyOf(scale.value));

/** The reports that are there, and the models about which there are none, with the reason. */
export const answers = computed(() => {
  const outcomes = current.value.outcomes.value;
  const reports: FieldReport[] = [];
  const failed: { readonly id: string; readonly reason: string }[] = [];
  for (const { id, source } of models.value) {
    const outcome = outcomes.get(source.key);
    // A model is called on the page what no other is, whatever its files say.
    if (outcome?.kind === "answered") reports.push(...outcome.answer.map((report) => ({ ...report, model: id })));
    else if (outcome?.kind === "failed") failed.push({ id, reason: outcome.message });
  }
  return { reports, failed };
});

/** One survey a normalisation: they take time, and only two of the views show them. */
const particularsBy = new Map<string, Survey<Particulars>>();

function particularsOf(wanted: string): Survey<Particulars> {
  let known = particularsBy.get(wanted);
  if (!known) {
    known = survey((api, source) => api.particulars(source, wanted));
    particularsBy.set(wanted, known);
  }
  return known;
}

export const particulars = computed(() => particularsOf(normalisation.value));

/** The reports whose particulars are there, with them. */
export const reported = computed<readonly Reported[]>(() => {
  const outcomes = particulars.value.outcomes.value;
  return answers.value.reports.flatMap((report) => {
    const outcome = outcomes.get(modelById(report.model)?.source.key ?? "");
    return outcome?.kind === "answered" ? withParticulars(report, outcome.answer) : [];
  });
});

/** A report with what belongs to it. */
export function withParticulars<R extends FieldReport>(report: R, { conditions, segments }: Particulars): R & Reported {
  return { ...report, conditions, segments: segments[report.method] ?? [] };
}

/** What sums up the reports, once the engine has answered. */
export const sums = signal<FieldSums | undefined>(undefined);

/** The same by strata, of the reports whose particulars are there. */
export const strata = signal<FieldStrata | undefined>(undefined);

const WANTED = FIGURES.map(({ key, title, better }) => ({ key, title, better }));

const sumUpStrata = latest(async ({ reports, stratum }: { reports: readonly Reported[]; stratum: By }) => {
  strata.value = reports.length > 0 ? await engine.run((api) => api.fieldStrata(reports, stratum, WANTED)) : undefined;
});

/** Asks about the particulars of every model, also of those that come, and tells the reports apart by them, until the result is called. */
export function followStrata(): () => void {
  const ends = [
    effect(() => {
      const asking = particulars.value;
      const scored = models.value.filter(({ status }) => status.kind === "scored");
      queueMicrotask(() => asking.ask(scored.map(({ source }) => source)));
    }),
    effect(() => {
      sumUpStrata({ reports: reported.value, stratum: by.value }).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
    }),
  ];
  return () => ends.forEach((end) => end());
}

const sumUp = latest(async (reports: readonly FieldReport[]) => {
  sums.value = reports.length > 0 ? await engine.run((api) => api.fieldSums(reports, WANTED)) : undefined;
});

/** Asks about every model, also about those that come, and sums up what is answered, until the result is called. */
export function follow(): () => void {
  const ends = [
    effect(() => {
      const asking = current.value;
      const scored = models.value.filter(({ status }) => status.kind === "scored");
      queueMicrotask(() => asking.ask(scored.map(({ source }) => source)));
    }),
    effect(() => {
      sumUp(answers.value.reports).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
    }),
  ];
  return () => ends.forEach((end) => end());
}
