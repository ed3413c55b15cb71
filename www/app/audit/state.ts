// The audits of the models on the page, and what they found.

import { computed } from "@preact/signals";
import type { Finding, PrimitiveAudit } from "../engine/contract";
import { survey } from "../engine/survey";
import { models } from "../state/models";
import { truthOnly } from "../state/content";
import type { AuditedModel } from "../../worker/protocol";

export const audits = survey<AuditedModel>((api, source) => api.audit(source));

export function auditAll(): void {
  audits.ask(models.value.map(({ source }) => truthOnly(source)));
}

/** Every model, with its audit where there is one already. */
export const audited = computed(() =>
  models.value.map((entry) => ({ entry, outcome: audits.outcomes.value.get(truthOnly(entry.source).key) })),
);

/** A finding, or that there could be no audit. */
export interface FoundIn extends Finding {
  readonly key: string;
  readonly model: string;
  /** Place of the primitive in the truth; absent where it is about a file, or a primitive that is not there. */
  readonly place: number | undefined;
}

export const found = computed<readonly FoundIn[]>(() =>
  audited.value.flatMap(({ entry: { id }, outcome }): FoundIn[] => {
    if (outcome?.kind === "failed") {
      const finding = { primitive: null, check: "file", severity: "error", value: null, limit: null, message: outcome.message, hint: "" } as const;
      return [{ ...finding, key: id, model: id, place: undefined }];
    }
    const audit = outcome?.answer.audit;
    return (audit?.findings ?? []).map((finding, at) => ({
      ...finding,
      key: `${id} ${at}`,
      model: id,
      place: audit && placeOf(audit.primitives, finding.primitive),
    }));
  }),
);

function placeOf(primitives: readonly PrimitiveAudit[], number: number | null): number | undefined {
  const place = primitives.findIndex((primitive) => primitive.number === number);
  return place < 0 ? undefined : place;
}
