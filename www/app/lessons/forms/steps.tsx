// The steps of the lesson on both forms.

import { Exercise } from "../exercise";
import type { Step } from "../frame";
import { comparison, factor, predicted, sliders, truthSliders } from "./state";
import { BothForms, Compared, written } from "./vectors";

export interface FormsStep extends Step {
  /** Whether the true surface is shown beside the predicted one. */
  readonly compares?: boolean;
  readonly factors?: boolean;
  readonly noises?: boolean;
}

const definition = () => comparison.value?.definition ?? undefined;
const published = () => comparison.value?.published ?? undefined;
const moved = () => JSON.stringify(sliders.value) !== JSON.stringify(truthSliders.value);

export const STEPS: readonly FormsStep[] = [
  {
    title: "One surface, two vectors",
    text: () => (
      <>
        <p>
          A submission may describe each primitive by a <b>parametric</b> vector, by an <b>implicit</b> one, or both. The
          parametric form says how to <i>make</i> points: x = <b>a</b> cos u + <b>b</b> sin u + v <b>c</b> + <b>d</b> for
          a cylinder. The implicit form says how to <i>test</i> them: a polynomial that is zero on the surface.
        </p>
        <p>Move the surface with the sliders and see both vectors change.</p>
        <Exercise
          task="Make the cylinder’s implicit vector have its z² entry equal to 1 and its x² entry equal to 0: turn its axis onto the x-axis."
          solved={
            predicted.value?.surface.type === "Cylinder"
              ? Math.abs((predicted.value.implicit[2] ?? 0) - 1) < 0.001 && Math.abs(predicted.value.implicit[0] ?? 1) < 0.001
              : false
          }
          standing={`The surface is a ${predicted.value?.surface.type.toLowerCase() ?? "…"}; x² has ${written(Math.abs(predicted.value?.implicit[0] ?? 0))}, z² has ${written(Math.abs(predicted.value?.implicit[2] ?? 0))}.`}
          hint="Tilt the axis by 90° and leave the heading at 0°."
          learnt="The second-order part of a cylinder about the unit vector w is I − wwᵀ: a direction in it costs nothing along the axis."
        />
        <BothForms />
      </>
    ),
  },
  {
    title: "The same surface, other numbers",
    factors: true,
    text: () => (
      <>
        <p>
          Multiply an implicit vector by any number but zero, and the polynomial is zero on the very same points. So the
          vector is only known up to a factor, and two vectors are compared after both are scaled to norm 1. That leaves
          the sign.
        </p>
        <Exercise
          task="Multiply the vector by a negative number and look at d1 by definition."
          solved={factor.value < 0 && (definition() ?? 1) < 1e-9}
          standing={`The factor is ${factor.value}, d1 by definition is ${written(definition())}.`}
          hint="Below the picture, choose −1. If the surface was moved, put it back first."
          learnt="The definition takes the sign that makes the first nonzero entry positive, which is to say: the smaller of |v − v′|₁ and |v + v′|₁."
        />
        <Compared />
      </>
    ),
  },
  {
    title: "d1 measures coefficients, not distances",
    compares: true,
    text: () => (
      <>
        <p>
          <b>d1</b> is the sum of the absolute differences of the two unit vectors. It has no unit and knows nothing of
          where the points lie: the same move weighs little or much, depending on how large the other coefficients are.
        </p>
        <Exercise
          task="Move the surface until d1 by definition exceeds 0.5."
          solved={(definition() ?? 0) > 0.5 && moved()}
          standing={`d1 is ${written(definition())}.`}
          hint="Tilt the axis: it enters the second-order entries, which are the large ones here."
          learnt="MFE and the directed Hausdorff distance look at the points; d1 looks at the equation. A method can be good in one and not in the other."
        />
        <Compared />
      </>
    ),
  },
  {
    title: "A sign that noise decides",
    compares: true,
    noises: true,
    text: () => (
      <>
        <p>
          The authors’ script chooses the sign another way: if <i>any</i> pair of entries has opposite signs, it negates
          the predicted vector. Where an entry should be zero, rounding leaves ±10⁻¹⁸, and its sign is chance.
        </p>
        <Exercise
          task="Make the published d1 exceed 1 while d1 by definition stays under 0.001."
          solved={comparison.value && (published() ?? 0) > 1 && (definition() ?? 1) < 0.001}
          standing={`By definition ${written(definition())}, as published ${written(published())}.`}
          hint="Put the surface back, and set one entry that is zero, such as 2xy, to ∓10⁻¹⁸."
          learnt="Two vectors that agree to eighteen digits are as far apart as opposite ones: the script compares v with −v′."
        />
        <Compared />
      </>
    ),
  },
  {
    title: "What became of PC14",
    compares: true,
    noises: true,
    text: () => (
      <>
        <p>
          In the paper’s table the Hough method has d1 = 1.264 on model PC14 and 1.203 on PC10: the worst figures of all,
          on models that it fits well by every other measure. They are mostly sign flips. By definition the same files
          have <b>0.0007</b> and <b>0.0165</b>.
        </p>
        <p>
          The playground scores by definition unless told otherwise. The switch <b>Published</b> in the header repeats the
          script, so that a score can be set beside the paper’s.
        </p>
        <Exercise
          task="Make a good fit look bad, as on PC14: a surface that is really moved, by so little that d1 by definition is under 0.05 but not 0, with a published d1 over 1."
          solved={comparison.value && moved() && (definition() ?? 1) < 0.05 && (definition() ?? 0) > 1e-6 && (published() ?? 0) > 1}
          standing={`By definition ${written(definition())}, as published ${written(published())}.`}
          hint="Change the radius by 0.01, and spoil a zero entry such as 2xy by ∓10⁻¹⁸."
          learnt="When a figure stands out, ask what computes it."
        />
        <Compared />
      </>
    ),
  },
];
