// "as claimed", "verified here", and what lies between; with what was scored here, where anything was.

import type { JSX } from "preact";
import { Icon, type IconName } from "../ui/icon";
import { wordsOf } from "./basis";
import type { JudgedClaim } from "./judge";
import { named, nameWords } from "./names";
import { recomputingOf, type Recomputing } from "./rebuild";

interface Look {
  readonly kind: "good" | "again" | "warning" | "error" | "note";
  readonly icon: IconName;
  readonly text: string;
  /** What was scored, or why it counts for less. */
  readonly detail?: string;
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
        detail: `${wordsOf(verdict.basis)}${verdict.folder === undefined ? "" : ` in ${named(verdict.folder)}`}`,
        meaning: "Files that are the reader's or the public's, and are called so there, were scored on this computer and gave the same figures, to the last digit.",
      };
    case "recomputed":
      return {
        kind: "again",
        icon: "again",
        text: "recomputed from the link",
        detail: wordsOf(verdict.basis),
        meaning:
          "The link says how to have this again. It was done on this computer and gave the same figures, to the last digit. " +
          "Nothing bears out what the link calls it.",
      };
    case "renamed":
      return {
        kind: "warning",
        icon: "note",
        text: "called otherwise here",
        detail: `${wordsOf(verdict.basis)}: ${nameWords(verdict.names)}`,
        meaning: "The same files were scored on this computer and gave the same figures, but they are not called what the link calls them.",
      };
    case "copied":
      return {
        kind: "warning",
        icon: "note",
        text: "the ground truth itself",
        detail: wordsOf(verdict.basis),
        meaning: "The same files gave the same figures, but the submission's list of points is the ground truth's own file.",
      };
    case "repeated":
      return {
        kind: "note",
        icon: "copy",
        text: `repeats ${named(verdict.earlier.method)} on ${named(verdict.earlier.model)}`,
        meaning: `This row is about the very files that a row above is about (${wordsOf(verdict.basis)}). It says nothing new.`,
      };
    case "differs":
      return {
        kind: "error",
        icon: "error",
        text: "figures differ",
        detail: wordsOf(verdict.basis),
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
        meaning:
          verdict.where === "link"
            ? "The link was made on a page that could not hash files, so it does not say which files it is about."
            : "This page was not loaded over a safe connection, where browsers do not hash files: open it over https.",
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
  const { kind, icon, text, detail, meaning } = lookOf(row);
  return (
    <span class={`mark ${kind}`} title={meaning}>
      <Icon name={icon} />
      <span>
        {text}
        {detail !== undefined && <small>{detail}</small>}
      </span>
    </span>
  );
}
