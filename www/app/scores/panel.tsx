// The summary: every measure of every submission.

import type { JSX } from "preact";
import { rulesOf } from "../measures/protocols";
import { methods, scoredRows } from "../state/models";
import { protocol, remembered } from "../state/settings";
import * as format from "../ui/format";
import { NothingScored } from "./nothing";
import { PaperTable } from "./paper";
import { SubmissionTable } from "./submissions";

const LAYOUTS = [
  { id: "submissions", title: "One row per submission" },
  { id: "paper", title: "As in the paper" },
] as const;

const layout = remembered("table", "submissions", LAYOUTS.map(({ id }) => id));

export default function ScoresPanel(): JSX.Element {
  const rows = scoredRows.value;
  if (rows.length === 0) return <NothingScored />;
  const rules = rulesOf(protocol.value);
  const caption = `Means over primitives, ${rules}`;
  return (
    <>
      <div class="panel-tools">
        <p>
          {format.plural(rows.length, "submission")} of {format.plural(methods.value.length, "method")}
        </p>
        <fieldset class="switch">
          <legend class="visually-hidden">Layout of the table</legend>
          {LAYOUTS.map(({ id, title }) => (
            <label key={id}>
              <input type="radio" name="table-layout" checked={layout.value === id} onChange={() => (layout.value = id)} />
              <span>{title}</span>
            </label>
          ))}
        </fieldset>
      </div>
      {layout.value === "paper" ? <PaperTable caption={caption} /> : <SubmissionTable caption={caption} />}
    </>
  );
}
