// The steps of the lesson on protocols. Every figure they check is the engine's.

import type { JSX } from "preact";
import type { Figure } from "../../engine/contract";
import { PROTOCOLS_OF_FIELD } from "../../field/figures";
import { Exercise } from "../exercise";
import type { Step } from "../frame";
import { Scores } from "./figures";
import { groups, isDropped, lists, ofTruth, report, valueOf, type Preset } from "./state";

export interface ProtocolStep extends Step {
  /** The prediction that the step begins with. */
  readonly begins: Preset;
}

interface TaskProps extends Omit<Parameters<typeof Exercise>[0], "solved" | "standing"> {
  readonly solved: () => boolean;
  /** The protocols that say where the reader stands. */
  readonly on: readonly Figure[];
}

function Task({ solved, on, ...rest }: TaskProps): JSX.Element {
  const standing = on.map((key) => `${titleOf(key)} says ${valueOf(key).toFixed(3)}`).join(", ") + ".";
  return (
    <>
      <Exercise {...rest} solved={report.value ? solved() : undefined} standing={standing} />
      <Scores stressed={on} />
    </>
  );
}

function titleOf(key: Figure): string {
  return PROTOCOLS_OF_FIELD.find((figure) => figure.key === key)?.title ?? key;
}

const dropped = () => groups.value.filter((_, place) => isDropped(place)).length;
const widest = () => {
  const values = PROTOCOLS_OF_FIELD.map(({ key }) => valueOf(key));
  return Math.max(...values) - Math.min(...values);
};

export const STEPS: readonly ProtocolStep[] = [
  {
    title: "One answer, eight scores",
    begins: "truth",
    text: () => (
      <>
        <p>
          An angle bracket. On the left is the truth, on the right a prediction, which begins as the truth itself. Below the
          picture you can <b>drop</b> a segment, <b>merge</b> it with another, drop all segments under a number of
          points, or predict only some of the points. The table says what eight protocols make of what is left.
        </p>
        <p>
          Each is somebody’s evaluation script. They agree on a perfect answer, or nearly: look at the third.
        </p>
        <Task
          task="Make two protocols differ by more than 0.5."
          solved={() => widest() > 0.5}
          on={[]}
          hint="Raise the threshold, and watch which figures stay."
          learnt="The same lists of points, and which number a paper prints hangs on whose script was run."
        />
      </>
    ),
  },
  {
    title: "One face is enough",
    begins: "truth",
    text: () => (
      <>
        <p>
          <b>ParseNet</b> and <b>HPNet</b> match one to one and average over the pairs that come of it. A true segment
          without a partner is in no pair, so missing it costs nothing.
        </p>
        <Task
          task="Score 1 by ParseNet and by HPNet with SPFN under 0.2."
          solved={() => valueOf("parsenet") > 0.9999 && valueOf("hpnet") > 0.9999 && valueOf("spfn") < 0.2}
          on={["parsenet", "hpnet", "spfn"]}
          hint="Predict what is surest, and nothing else: the button Largest only, or the threshold drawn all the way up."
          learnt="A method that finds one face wins by two protocols. Read such a mean beside the number of primitives that were found."
        />
      </>
    ),
  },
  {
    title: "The truth is not good enough",
    begins: "truth",
    text: () => (
      <>
        <p>
          SPFN’s code removes predictions of <b>fewer than 0.5 %</b> of the points before it scores the answers of
          networks. What is so small cannot be found any more, not even by the truth.
        </p>
        <Task
          task="Drop at least one segment without moving the figure of SPFN, < 0.5 % removed, while plain SPFN falls."
          solved={() => dropped() > 0 && valueOf("spfn") < 0.9999 && Math.abs(valueOf("spfn-large") - valueOf("spfn-large", ofTruth.value)) < 1e-9}
          on={["spfn-large", "spfn"]}
          hint="Choose the smallest segment in the list: it is last."
          learnt="With the rule on, a method that finds small faces and one that does not look alike."
        />
      </>
    ),
  },
  {
    title: "One prediction may serve many",
    begins: "truth",
    text: () => (
      <>
        <p>
          <b>Fit4CAD</b> gives each true segment the prediction with which it shares most points, and one prediction may
          serve many. The one-to-one protocols let only one of them keep it: the others are missed.
        </p>
        <Task
          task="Get Fit4CAD’s DSC at least 0.1 above SPFN."
          solved={() => valueOf("fit4cad") - valueOf("spfn") >= 0.1}
          on={["fit4cad", "spfn"]}
          hint="Merge segments of about the same size, two at a time; In pairs does that for all."
          learnt="Merging two equal faces leaves each a DSC of 0.67; one to one, one of them has IoU 0.5 and the other nothing."
        />
      </>
    ),
  },
  {
    title: "About there",
    begins: "truth",
    text: () => (
      <>
        <p>
          <b>NVDNet</b> compares by distance: a pair is a hit where the points of both are near each other on average, at
          five thresholds. It does not ask how many of the points were found.
        </p>
        <Task
          task="Get NVDNet’s F1 over 0.7 with PQ 0."
          solved={() => valueOf("nvdnet") > 0.7 && valueOf("pq") === 0}
          on={["nvdnet", "pq"]}
          hint="Begin with the truth, and predict only some of the points of every segment."
          learnt="Two points in three are missing, and none is far from one that is not. Distances forgive what sets do not: they answer another question."
        />
      </>
    ),
  },
  {
    title: "What none of it fools",
    begins: "merged",
    text: () => (
      <>
        <p>
          <b>F1@0.5</b> and <b>PQ</b> count both ways: a missed primitive and an invented one cost the same, and half
          right is wrong. Nothing that was tried so far moves them up.
        </p>
        <Task
          task="From this merged answer, reach PQ over 0.8."
          solved={() => valueOf("pq") > 0.8}
          on={["pq", "f1"]}
          hint="There is no trick: take the merged segments apart again. Drop one and keep it, and it stands on its own."
          learnt={`That is the strict one: ${lists.value.length} predicted primitives, each of them right. A result is worth reading where it holds by several protocols.`}
        />
      </>
    ),
  },
];
