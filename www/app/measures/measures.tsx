// What every measure is: formula, range, what is good, where the paper defines it.

import type { ComponentChildren, JSX } from "preact";
import type { Measure, Protocol } from "../engine/contract";

export interface MeasureText {
  readonly name: string;
  readonly formula: JSX.Element;
  readonly meaning: string;
  readonly range: string;
  readonly good: "higher" | "lower";
  readonly mean: string;
  readonly section: string;
}

const CLASSIFICATION = "Quality indicators: Performance measures of the point classification";
const ACCURACY = "Quality indicators: Approximation accuracy";
const OVER_TRUTH = "Mean over the ground-truth primitives; one without a match enters as 0.";
const OVER_PREDICTED = "Mean over the predicted primitives that have a surface.";

export const CLASSIFICATION_MEASURES = ["DSC", "PPV", "TPR", "TNR", "NPV", "ACC"] as const satisfies Measure[];
export const ACCURACY_MEASURES = ["MFE", "dHaus", "d1"] as const satisfies Measure[];
export const MEASURES: readonly Measure[] = [...CLASSIFICATION_MEASURES, ...ACCURACY_MEASURES];

/** Whether a measure is a share of 1. */
export function isShare(measure: Measure): boolean {
  return (CLASSIFICATION_MEASURES as readonly Measure[]).includes(measure);
}

function Formula({ left, children }: { left: ComponentChildren; children: ComponentChildren }) {
  return (
    <math display="block">
      <mrow>
        {left}
        <mo>=</mo>
        {children}
      </mrow>
    </math>
  );
}

function Ratio({ name, over, under }: { name: string; over: string[]; under: string[] }) {
  const sum = (terms: string[]) => (
    <mrow>
      {terms.map((term, i) => [i > 0 && <mo>+</mo>, <mtext>{term}</mtext>])}
    </mrow>
  );
  return (
    <Formula left={<mtext>{name}</mtext>}>
      <mfrac>
        {sum(over)}
        {sum(under)}
      </mfrac>
    </Formula>
  );
}

const distanceToSurface = (
  <mrow>
    <mi>d</mi>
    <mo stretchy={false}>(</mo>
    <mi>x</mi>
    <mo>,</mo>
    <mi>𝒮</mi>
    <mo stretchy={false}>)</mo>
  </mrow>
);
const predictedSet = (
  <msub>
    <mi>𝒫</mi>
    <mi>S</mi>
  </msub>
);
const elementOfPrediction = (
  <mrow>
    <mi>x</mi>
    <mo>∈</mo>
    {predictedSet}
  </mrow>
);

export const MEASURE_TEXT: Readonly<Record<Measure, MeasureText>> = {
  DSC: {
    name: "Sørensen–Dice index",
    formula: <Ratio name="DSC" over={["2 TP"]} under={["2 TP", "FP", "FN"]} />,
    meaning: "How well the matched primitive and the true one coincide, as one figure. Also called F₁ score.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  PPV: {
    name: "Positive predictive value (precision)",
    formula: <Ratio name="PPV" over={["TP"]} under={["TP", "FP"]} />,
    meaning: "Share of the matched primitive's points that are right. Merging neighbours lowers it.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  TPR: {
    name: "True positive rate (sensitivity)",
    formula: <Ratio name="TPR" over={["TP"]} under={["TP", "FN"]} />,
    meaning: "Share of the true primitive's points that were found. Splitting a primitive lowers it.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  TNR: {
    name: "True negative rate (specificity)",
    formula: <Ratio name="TNR" over={["TN"]} under={["TN", "FP"]} />,
    meaning: "Share of the points outside the true primitive that were left out. Near 1 whenever a primitive is small against its model.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  NPV: {
    name: "Negative predictive value",
    formula: <Ratio name="NPV" over={["TN"]} under={["TN", "FN"]} />,
    meaning: "Share of the points left out that really do not belong. Near 1 whenever a primitive is small against its model.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  ACC: {
    name: "Accuracy",
    formula: <Ratio name="ACC" over={["TP", "TN"]} under={["TP", "TN", "FP", "FN"]} />,
    meaning: "Share of all decisions that are right. The many true negatives hold it near 1: read it beside DSC.",
    range: "0 to 1",
    good: "higher",
    mean: OVER_TRUTH,
    section: CLASSIFICATION,
  },
  MFE: {
    name: "Mean fitting error",
    formula: (
      <Formula left={<mtext>MFE</mtext>}>
        <mfrac>
          <mn>1</mn>
          <mrow>
            <mo>|</mo>
            {predictedSet}
            <mo>|</mo>
          </mrow>
        </mfrac>
        <munder>
          <mo>∑</mo>
          {elementOfPrediction}
        </munder>
        <mfrac>
          {distanceToSurface}
          <mi>l</mi>
        </mfrac>
      </Formula>
    ),
    meaning: "Mean distance of the predicted primitive's points to its own surface 𝒮, over the diagonal l of their bounding box.",
    range: "0 upwards; 0.01 is one per cent of the primitive's size",
    good: "lower",
    mean: OVER_PREDICTED,
    section: ACCURACY,
  },
  dHaus: {
    name: "Directed Hausdorff distance",
    formula: (
      <Formula
        left={
          <msub>
            <mi>d</mi>
            <mtext>Haus</mtext>
          </msub>
        }
      >
        <munder>
          <mo>max</mo>
          {elementOfPrediction}
        </munder>
        <mfrac>
          {distanceToSurface}
          <mi>l</mi>
        </mfrac>
      </Formula>
    ),
    meaning: "The worst distance of the predicted primitive's points to its own surface 𝒮, over the diagonal l of their bounding box.",
    range: "0 upwards; 0.01 is one per cent of the primitive's size",
    good: "lower",
    mean: OVER_PREDICTED,
    section: ACCURACY,
  },
  d1: {
    name: "Coefficient distance",
    formula: (
      <Formula
        left={
          <mrow>
            <msub>
              <mi>d</mi>
              <mn>1</mn>
            </msub>
            <mo>(</mo>
            <mi>v</mi>
            <mo>,</mo>
            <mi>v′</mi>
            <mo>)</mo>
          </mrow>
        }
      >
        <msub>
          <mrow>
            <mo>‖</mo>
            <mi>v</mi>
            <mo>−</mo>
            <mi>v′</mi>
            <mo>‖</mo>
          </mrow>
          <mn>1</mn>
        </msub>
      </Formula>
    ),
    meaning: "How far the implicit coefficients of prediction and truth are apart, both scaled to norm 1 and given the same sign.",
    range: "0 upwards; pairs of different type have none",
    good: "lower",
    mean: "Mean over the predicted primitives whose partner has the same type.",
    section: ACCURACY,
  },
};

/** What the chosen protocol changes about a measure, or nothing. */
export function protocolNote(measure: Measure, protocol: Protocol): string | undefined {
  if (protocol === "definition") return undefined;
  switch (measure) {
    case "PPV":
      return "In the published tables this column holds what is defined as TPR: the authors' script hands prediction and truth over in the other order.";
    case "TPR":
      return "In the published tables this column holds what is defined as PPV: the authors' script hands prediction and truth over in the other order.";
    case "TNR":
      return "In the published tables this column holds what is defined as NPV, for the same reason PPV and TPR are swapped. Points without a true primitive are left out.";
    case "NPV":
      return "In the published tables this column holds what is defined as TNR, for the same reason PPV and TPR are swapped. Points without a true primitive are left out.";
    case "ACC":
      return "Points without a true primitive are left out of the count.";
    case "d1":
      return "The published sign rule flips a vector when any pair of entries differs in sign, and primitives without a partner count as perfect. Most large published values are such flips.";
    default:
      return undefined;
  }
}
