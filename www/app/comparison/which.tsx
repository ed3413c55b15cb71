// Which models are compared with which, why the others are not, and the reader's say in it.

import type { JSX } from "preact";
import type { Signal } from "@preact/signals";
import * as format from "../ui/format";
import { Seen } from "../ui/seen";
import { TEST_MODELS } from "../../shared/published/figures.mjs";
import type { Match, Said } from "../../shared/published/match.mjs";
import type { Candidate } from "./candidate";

interface Props {
  readonly candidates: readonly Candidate[];
  readonly said: Signal<Readonly<Record<string, Said>>>;
}

const BY_COUNTS = "";
const NONE = "none";

export function Which({ candidates, said }: Props): JSX.Element {
  const left = candidates.filter(({ match }) => match.kind !== "matched").length;
  const say = (id: string, value: string) => {
    const { [id]: _, ...others } = said.value;
    said.value = value === BY_COUNTS ? others : { ...others, [id]: value === NONE ? null : value };
  };
  return (
    <details class="which" open={left === candidates.length}>
      <summary>
        Which models are test models
        {left > 0 && ` (${format.plural(left, "model")} not compared)`}
      </summary>
      <p class="hint">
        A model counts as a test model where name, number of points and number of true primitives agree. You may know
        better.
      </p>
      <Seen
        as="ul"
        items={candidates}
        draw={({ entry: { id }, match }, place) => (
          <li key={id} {...place}>
            {id}{" "}
            <select
              aria-label={`Which test model ${id} is`}
              value={valueOf(said.value[id])}
              onChange={(event) => say(id, event.currentTarget.value)}
            >
              <option value={BY_COUNTS}>by name and counts</option>
              <option value={NONE}>is no test model</option>
              {TEST_MODELS.map(({ name }) => (
                <option key={name} value={name}>
                  is {name}
                </option>
              ))}
            </select>{" "}
            <span class="hint">{explain(match)}</span>
          </li>
        )}
      />
    </details>
  );
}

function valueOf(said: Said | undefined): string {
  return said === undefined ? BY_COUNTS : (said ?? NONE);
}

function explain(match: Match): string {
  switch (match.kind) {
    case "matched":
      return match.said ? "as you say" : `is ${match.model}`;
    case "unlike":
      return `named like ${match.model}, but not that model: ${match.reason}`;
    case "none":
      return "no test model of that name";
  }
}
