// Before there is a figure: what the models lack for one, and what can be done with what they have.

import type { JSX } from "preact";
import { adding } from "../intake/adding";
import { PageLink } from "../navigation/page-link";
import { models } from "../state/models";
import { showPanel } from "../state/panels";
import * as format from "../ui/format";

/** How many models have what; those that have a truth and a submission are scored. */
interface Having {
  readonly truth: number;
  readonly found: number;
  readonly neither: number;
}

function having(): Having {
  const has = { truth: 0, found: 0, neither: 0 };
  for (const { status } of models.value) {
    if (status.kind !== "scored") continue;
    const { hasTruth, methods } = status.result.info;
    has[hasTruth ? "truth" : methods.length > 0 ? "found" : "neither"] += 1;
  }
  return has;
}

export function NothingScored(): JSX.Element {
  const waiting = models.value.some(({ status }) => status.kind === "waiting");
  if (waiting) return <p class="empty">Scoring…</p>;
  if (models.value.length === 0) return <p class="empty">No models yet.</p>;
  const { truth, found, neither } = having();
  return (
    <section class="nothing" aria-label="What can be done">
      <p>
        Nothing to score: a model needs its ground truth and at least one submission. {lacking(truth, found, neither)}
      </p>
      <ul>
        {truth + neither > 0 && (
          <Way to="Find the primitives" act={() => showPanel("fit")}>
            By Hough transform or primitive growing, here{truth > 0 ? "; what is found is a submission, and scored at once" : ""}.
          </Way>
        )}
        {truth > 0 && (
          <Way to="Add a submission" act={() => (adding.value = true)}>
            What a method found: primitives as the benchmark writes them, or a label for each point. A folder named after the
            method is enough.
          </Way>
        )}
        {found + neither > 0 && (
          <Way to="Add the ground truth" act={() => (adding.value = true)}>
            Beside its cloud, with the same name. Files that were taken for something else are corrected under Files.
          </Way>
        )}
        {truth + found > 0 && (
          <Way to="Look at the primitives" act={() => showPanel("primitives")}>
            Each with its type, points and surface, in the table and in the picture.
          </Way>
        )}
        {truth > 0 && (
          <Way to="Check the truth" act={() => showPanel("audit")}>
            Whether its points lie on its surfaces, and whether its two forms say the same.
          </Way>
        )}
        {truth > 0 && (
          <li>
            <PageLink id="statistics" class="button">
              Count what is in it
            </PageLink>
            <small>Primitives by type and size, as a table for a paper.</small>
          </li>
        )}
      </ul>
    </section>
  );
}

/** What is there, where the models differ or there is only one kind. */
function lacking(truth: number, found: number, neither: number): string {
  const parts = [
    truth > 0 && `${format.plural(truth, "model")} ${has(truth)} a ground truth and no submission`,
    found > 0 && `${format.plural(found, "model")} ${has(found)} submissions and no ground truth`,
    neither > 0 && `${format.plural(neither, "model")} ${has(neither)} points only`,
  ].filter((part) => part !== false);
  return parts.length > 0 ? `${parts.join(", ")}.` : "";
}

function has(count: number): string {
  return count === 1 ? "has" : "have";
}

function Way({ to, act, children }: { to: string; act: () => void; children: string | readonly string[] }): JSX.Element {
  return (
    <li>
      <button type="button" onClick={act}>
        {to}
      </button>
      <small>{children}</small>
    </li>
  );
}
