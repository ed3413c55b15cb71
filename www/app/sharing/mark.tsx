// "as claimed", "verified here", and what lies between.

import type { JSX } from "preact";
import { Icon, type IconName } from "../ui/icon";
import type { JudgedClaim } from "./opened";
import { recomputingOf, type Recomputing } from "./rebuild";

interface Look {
  readonly kind: "good" | "warning" | "error" | "note";
  readonly icon: IconName;
  readonly text: string;
  readonly meaning: string;
}

function lookOf(row: JudgedClaim): Look {
  const { verdict } = row;
  switch (verdict.kind) {
    case "verified":
      return {
        kind: "good",
        icon: "check",
        text: "verified here",
        meaning: "The same files were scored on this computer and gave the same figures, to the last digit.",
      };
    case "differs":
      return {
        kind: "error",
        icon: "error",
        text: "figures differ",
        meaning: `The same files were scored on this computer and gave other figures: ${verdict.differences.map(({ figure }) => figure).join(", ")}.`,
      };
    case "other files":
      return {
        kind: "warning",
        icon: "error",
        text: `other ${verdict.parts.join(" and ")}`,
        meaning: "A model of this name is here, but its files are not those the claim was made for.",
      };
    case "uncheckable":
      return {
        kind: "note",
        icon: "note",
        text: "cannot be checked",
        meaning: "The link was made on a page that could not hash files, so it does not say which files it is about.",
      };
    case "claimed":
      return CLAIMED[recomputingOf(row)];
  }
}

const NOTE = { kind: "note", icon: "note" } as const;

const CLAIMED: Readonly<Record<Recomputing, Look>> = {
  "under way": { ...NOTE, text: "being recomputed", meaning: "The link says how this was made; it is being made again on this computer." },
  failed: {
    kind: "error",
    icon: "error",
    text: "fit failed",
    meaning: "The link says how this was fitted, but the fit failed on this computer. The reason is told above.",
  },
  "not done": {
    ...NOTE,
    text: "not recomputed",
    meaning: "The link says how this was made. It can be made again on this computer: press the button beside “As claimed” above.",
  },
  "not possible": {
    ...NOTE,
    text: "as claimed",
    meaning: "Drop the ground truth and the submission on the page to have them scored and compared.",
  },
};

export function VerdictMark({ row }: { row: JudgedClaim }): JSX.Element {
  const { kind, icon, text, meaning } = lookOf(row);
  return (
    <span class={`mark ${kind}`} title={meaning}>
      <Icon name={icon} />
      {text}
    </span>
  );
}
