// The steps of the lesson on scores. Every figure they check comes from the engine's report.

import type { JSX } from "preact";
import { Exercise } from "../exercise";
import type { Step } from "../frame";
import * as format from "../../ui/format";
import { Accuracy, Confusion, Formulas, type CountMeasure } from "./figures";
import { rest, score, type Preset } from "./state";

export interface ScoreStep extends Step {
  /** The painting that the step begins with. */
  readonly begins: Preset;
  /** Which true primitive is looked at. */
  readonly looks: 0 | 1;
  readonly shows: "outcome" | "prediction";
  /** Controls that the step needs beyond the brush. */
  readonly needs?: "shift" | "rest";
}

function Figures({ stressed }: { stressed?: readonly CountMeasure[] }): JSX.Element {
  return (
    <>
      <Confusion />
      <Formulas stressed={stressed} />
    </>
  );
}

const wall = () => score.value?.report.primitives[0];
const floor = () => score.value?.report.primitives[1];
const value = (name: CountMeasure) => wall()?.[name] ?? null;
const written = (...names: CountMeasure[]) =>
  names.map((name) => `${name} is ${format.measure(name, value(name))}`).join(", ") + ".";
const both = (name: CountMeasure) =>
  `The wall has ${name} ${format.measure(name, wall()?.[name])}, the floor ${format.measure(name, floor()?.[name])}`;
const somePrediction = (check: (MFE: number, dHaus: number) => boolean) =>
  score.value?.report.predictions.some(({ MFE, dHaus }) => MFE !== null && dHaus !== null && check(MFE, dHaus)) ?? false;

interface TaskProps extends Omit<Parameters<typeof Exercise>[0], "solved" | "standing"> {
  readonly solved: () => boolean;
  /** The measures of the wall that say where the reader stands, */
  readonly on?: readonly CountMeasure[];
  /** or other words for it. */
  readonly standing?: string;
}

/** An exercise on what the engine says of the painting; before it has there is nothing to check. */
function Task({ solved, on = [], standing = written(...on), ...rest }: TaskProps): JSX.Element {
  return <Exercise {...rest} solved={score.value ? solved() : undefined} standing={standing} />;
}

export const STEPS: readonly ScoreStep[] = [
  {
    title: "One part, two primitives",
    begins: "nothing",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          A niche: its <b>wall</b> is half a cylinder, its <b>floor</b> a plane. On the left is the truth, on the right
          what becomes of your prediction. A prediction is nothing but lists of points; up to four of them are called A
          to D here.
        </p>
        <p>
          Paint prediction A over the wall with the brush, in either picture. Without a pointer, use <b>Grow</b>,{" "}
          <b>Shrink</b> and the two shifts.
        </p>
        <Task
          task="Find at least half of the wall’s points."
          solved={() => (value("TPR") ?? 0) >= 0.5}
          standing={`You have found ${format.integer(score.value?.counts[0]?.tp ?? 0)} of ${format.integer(wall()?.size ?? 0)}.`}
          hint="Widen the brush and drag it along the wall, or press Grow again and again."
          learnt="The primitive of the prediction that shares most points with the wall is its match; here that is A."
        />
        <Confusion />
      </>
    ),
  },
  {
    title: "Four counts",
    begins: "sloppy",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          Each true primitive is a question asked of every point: is it one of mine? The match answers, and each point
          falls into one of four counts. Points of the wall that A lists are <b>true positives</b>, other points that A
          lists <b>false positives</b>; points of the wall that A lacks are <b>false negatives</b>, and all the rest{" "}
          <b>true negatives</b>.
        </p>
        <p>The six measures are ratios of these counts. Paint and erase, and watch which ones move.</p>
        <Task
          task="Leave no false positive, without emptying the prediction."
          solved={() => score.value?.counts[0]?.fp === 0 && score.value.counts[0].tp > 0}
          standing={`There are ${format.integer(score.value?.counts[0]?.fp ?? 0)} false positives and ${format.integer(score.value?.counts[0]?.tp ?? 0)} true ones.`}
          hint="Choose Erase and brush over the floor; the red points on the right are the false positives. Shrink takes them away too."
          learnt="TNR and PPV are 1 now: both only ask about false positives."
        />
        <Figures />
      </>
    ),
  },
  {
    title: "PPV: is what it lists right?",
    begins: "truth",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          The <b>positive predictive value</b> is the share of the listed points that are right. It does not ask how much
          was missed: a timid method that lists a handful of sure points is perfect by it.
        </p>
        <Task
          task="Reach PPV 1 with DSC under 0.5 for the wall."
          solved={() => value("PPV") === 1 && (value("DSC") ?? 1) < 0.5}
          on={["PPV", "DSC"]}
          hint="Every point that A lists must be on the wall, but they should be few: press Clear, then paint a spot in the middle of the wall."
          learnt="PPV alone rewards a method that hardly predicts. DSC counts what is missed as well."
        />
        <Figures stressed={["PPV", "DSC"]} />
      </>
    ),
  },
  {
    title: "TPR: is everything found?",
    begins: "truth",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          <b>Sensitivity</b>, the true positive rate, is the share of the wall that was found. It does not ask what else
          was listed: a greedy method is perfect by it.
        </p>
        <Task
          task="Reach TPR 1 with PPV under 0.75 for the wall."
          solved={() => value("TPR") === 1 && (value("PPV") ?? 1) < 0.75}
          on={["TPR", "PPV"]}
          hint="Keep all of the wall in A and add points of the floor: Grow does it ring by ring."
          learnt="PPV and TPR pull in opposite directions. That is why the authors’ swap of the two in their script is not a detail: each says what the other hides."
        />
        <Figures stressed={["TPR", "PPV"]} />
      </>
    ),
  },
  {
    title: "DSC: both at once",
    begins: "sloppy",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          The <b>Sørensen-Dice index</b> is the harmonic mean of PPV and TPR: it is high only where both are. The score of
          a model is the mean over all its true primitives, so the floor counts as much as the wall although it has fewer
          points.
        </p>
        <Task
          task="Raise the mean DSC of wall and floor above 0.9."
          solved={() => (score.value?.report.mean.DSC ?? 0) > 0.9}
          standing={`${both("DSC")}; the mean is ${format.measure("DSC", score.value?.report.mean.DSC)}.`}
          hint="The floor needs a prediction of its own: choose B and paint the floor; erase it from A."
          learnt="A small primitive that is missed costs as much as a large one: the mean is over primitives, not over points."
        />
        <Figures stressed={["DSC"]} />
      </>
    ),
  },
  {
    title: "TNR and NPV: the points that are not asked for",
    begins: "truth",
    looks: 0,
    shows: "outcome",
    text: () => (
      <>
        <p>
          TNR and NPV ask the same two questions about the points <i>outside</i> the wall. TNR is the share of them that
          A leaves alone, NPV the share of what A leaves alone that is right to be left alone.
        </p>
        <Task
          task="Reach TNR 1 with DSC under 0.3, but above 0."
          solved={() => value("TNR") === 1 && (value("DSC") ?? 1) < 0.3 && (value("DSC") ?? 0) > 0}
          on={["TNR", "DSC"]}
          hint="No false positive, and few true ones: Clear, then paint a spot of the wall."
          learnt="Whoever predicts little has few false positives, and TNR is content."
        />
        <Task
          task="Reach NPV 1 with ACC under 0.8."
          solved={() => value("NPV") === 1 && (value("ACC") ?? 1) < 0.8}
          on={["NPV", "ACC"]}
          hint="NPV is 1 where nothing of the wall is missed: keep the whole wall in A and Grow it over much of the floor, but not over all of it."
          learnt="Whoever predicts much misses little, and NPV is content. With nothing left unpredicted NPV would be 0/0."
        />
        <Figures stressed={["TNR", "NPV"]} />
      </>
    ),
  },
  {
    title: "Why ACC and TNR are nearly always near 1",
    begins: "sloppy",
    looks: 0,
    shows: "outcome",
    needs: "rest",
    text: () => (
      <>
        <p>
          A part of the benchmark has dozens of primitives. For each of them nearly all points are true negatives, and
          ACC and TNR count those. Add the rest of a larger part below: the prediction on the wall stays as it is, its
          DSC does not move, and ACC and TNR rise all by themselves.
        </p>
        <Task
          task="Get ACC over 0.95 with TPR under 0.1, but above 0."
          solved={() => (value("ACC") ?? 0) > 0.95 && (value("TPR") ?? 1) < 0.1 && (value("TPR") ?? 0) > 0}
          on={["ACC", "TPR"]}
          hint="Clear, paint a tiny spot of the wall, and let the part have 40,000 more points."
          learnt={`With ${format.integer(rest.value)} points elsewhere, a prediction that misses nine tenths of the wall is “95 % accurate”. Compare methods by DSC, PPV and TPR.`}
        />
        <Figures stressed={["ACC", "TNR", "DSC"]} />
      </>
    ),
  },
  {
    title: "Over-segmentation",
    begins: "truth",
    looks: 0,
    shows: "prediction",
    text: () => (
      <>
        <p>
          A method that splits the wall into pieces lists nothing wrong. But only one piece is the wall’s match, the one
          that shares most points with it; the other pieces are not looked at by any classification measure. So
          over-segmentation costs TPR and leaves PPV at 1.
        </p>
        <Task
          task="Cut the wall into at least three predictions: PPV 1 and TPR under 0.5."
          solved={() => {
            const spurious = score.value?.report.hidden.spurious.length ?? 0;
            return value("PPV") === 1 && (value("TPR") ?? 1) < 0.5 && spurious >= 2;
          }}
          standing={`${written("PPV", "TPR")} ${format.plural(score.value?.report.hidden.spurious.length ?? 0, "prediction")} match no true primitive.`}
          hint="The button “Wall in three” does it; or erase two thirds of A and paint them with C and D."
          learnt="The playground names predictions that match nothing as spurious, since the paper’s measures do not show them."
        />
        <Figures stressed={["PPV", "TPR"]} />
      </>
    ),
  },
  {
    title: "Under-segmentation",
    begins: "truth",
    looks: 0,
    shows: "prediction",
    text: () => (
      <>
        <p>
          The other way round, one prediction may cover several primitives. It then is the match of each of them: TPR is
          1 for all, and PPV falls.
        </p>
        <Task
          task="Let one prediction be the match of both wall and floor, with TPR 1 for both."
          solved={() => score.value?.report.hidden.merged.length === 2 && wall()?.TPR === 1 && floor()?.TPR === 1}
          standing={`${both("TPR")}; ${format.plural(score.value?.report.hidden.merged.length ?? 0, "primitive")} share a match.`}
          hint="The button “All as one” does it; or Clear B and Grow A until it covers everything."
          learnt="A merged pair looks perfect by TPR. Over- and under-segmentation are told apart by which of PPV and TPR falls."
        />
        <Figures stressed={["PPV", "TPR"]} />
      </>
    ),
  },
  {
    title: "A shared edge",
    begins: "edge",
    looks: 1,
    shows: "outcome",
    text: () => (
      <>
        <p>
          The points of the arc lie on the cylinder <i>and</i> on the plane, and the truth lists them in both. A method
          that gives every point to one primitive only must lose some: here the arc went to the wall, and the floor lacks
          it.
        </p>
        <Task
          task="Reach DSC 1 for both wall and floor."
          solved={() => wall()?.DSC === 1 && floor()?.DSC === 1}
          standing={`${both("DSC")}.`}
          hint="Choose B and paint the arc where the wall meets the floor, without erasing it from A. “The truth” shows how."
          learnt="Points may be in several predictions. On thin parts with long edges this is worth some hundredths of DSC."
        />
        <Figures stressed={["DSC", "TPR"]} />
      </>
    ),
  },
  {
    title: "MFE notices a surface that is off",
    begins: "truth",
    looks: 1,
    shows: "prediction",
    needs: "shift",
    text: () => (
      <>
        <p>
          The <b>mean fitting error</b> is the mean distance of a prediction’s points to its own surface, over the
          diagonal of their box. Truth plays no part in it. Each prediction here has the surface of the primitive it
          covers; move that surface with the slider, and every point is a little off.
        </p>
        <Task
          task="Get a prediction with MFE over 0.02 whose directed Hausdorff distance is less than twice as large."
          solved={() => somePrediction((MFE, dHaus) => MFE > 0.02 && dHaus < 2 * MFE)}
          standing={accuracies()}
          hint="Leave the points alone and move the surfaces by 0.06 or more."
          learnt="A surface that is off everywhere moves mean and maximum alike, and the classification measures not at all."
        />
        <Accuracy />
      </>
    ),
  },
  {
    title: "The directed Hausdorff distance notices one stray point",
    begins: "truth",
    looks: 1,
    shows: "prediction",
    needs: "shift",
    text: () => (
      <>
        <p>
          The <b>directed Hausdorff distance</b> is the largest of those distances. One wrong point among a thousand is
          enough to move it; the mean hardly notices.
        </p>
        <Task
          task="Get a prediction with a directed Hausdorff distance over 0.2 and MFE under 0.01."
          solved={() => somePrediction((MFE, dHaus) => dHaus > 0.2 && MFE < 0.01)}
          standing={accuracies()}
          hint="Put the surfaces back to 0, choose B, take the smallest brush and click once high up on the wall; or press “One stray point”."
          learnt="That is all of it: six counts-based measures, two distances. The ninth, d1, compares coefficients and has a lesson of its own."
        />
        <Accuracy />
      </>
    ),
  },
];

function accuracies(): string {
  const rows = score.value?.report.predictions ?? [];
  return rows
    .map(({ prediction, MFE, dHaus }) => `${"ABCD"[prediction - 1]}: MFE ${format.measure("MFE", MFE)}, dHaus ${format.measure("dHaus", dHaus)}`)
    .join("; ");
}
