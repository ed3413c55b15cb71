// The two protocols in plain words.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Dialog } from "../ui/dialog";

export const protocolShown = signal(false);

const DIFFERENCES: readonly { what: string; definition: string; published: string }[] = [
  {
    what: "Points that count",
    definition: "every point of the cloud",
    published: "only points listed by a ground-truth primitive",
  },
  {
    what: "PPV and TPR",
    definition: "as defined: TP/(TP+FP) and TP/(TP+FN)",
    published: "swapped: the column headed PPV holds TPR, and the other way round",
  },
  {
    what: "TNR and NPV",
    definition: "as defined: TN/(TN+FP) and TN/(TN+FN)",
    published: "swapped, for the same reason",
  },
  { what: "DSC and ACC", definition: "as in the paper", published: "as in the paper" },
  {
    what: "d1: which sign",
    definition: "the sign that makes the distance smaller",
    published: "negated when any pair of entries differs in sign, even −1e−18 against 1e−18",
  },
  {
    what: "d1: no partner, or another type",
    definition: "has no d1; other types are counted as type errors",
    published: "counts as a perfect 0 in the mean, or is left out where the vectors differ in length",
  },
  {
    what: "MFE and directed Hausdorff",
    definition: "exact distance to the whole surface",
    published: "the same: the authors' random sampling does not repeat and is not imitated",
  },
];

export function ProtocolDialog(): JSX.Element {
  return (
    <Dialog open={protocolShown} title="Two protocols" className="protocols">
      <p>
        <strong>Definition</strong> computes the paper's formulas exactly. Use it to judge a method.{" "}
        <strong>Published</strong> repeats what the authors' evaluation scripts do, so that a score can stand beside the
        paper's two tables. The scripts hand prediction and truth to a helper in the other order, which is why four
        published columns are swapped in pairs.
      </p>
      <table>
        <caption class="visually-hidden">How the protocols differ</caption>
        <thead>
          <tr>
            <th scope="col">What</th>
            <th scope="col">Definition</th>
            <th scope="col">Published</th>
          </tr>
        </thead>
        <tbody>
          {DIFFERENCES.map(({ what, definition, published }) => (
            <tr key={what}>
              <th scope="row">{what}</th>
              <td>{definition}</td>
              <td>{published}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        In both, each true primitive is matched with the predicted one it shares most points with; of equals, the first.
        A true primitive that shares no point with any prediction scores DSC, PPV and TPR 0 in the mean, so predicting nothing never pays.
      </p>
    </Dialog>
  );
}
