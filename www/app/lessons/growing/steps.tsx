// The steps of the lesson on primitive growing.

import type { JSX } from "preact";
import * as format from "../../ui/format";
import { Exercise } from "../exercise";
import type { Step } from "../frame";
import { MeanScore } from "../mean-score";
import { Histogram } from "./histogram";
import { amount, CRUMB, grown, lastStep, partition, pieces, region, segmentation, slippage, variation } from "./state";

export interface GrowingStep extends Step {
  readonly shows: "variation" | "sharp" | "growth" | "regions" | "pieces" | "segmentation";
  readonly tools: readonly ("eta" | "growth" | "regions" | "motion" | "split" | "segment")[];
}

const large = () => (partition.value?.sizes ?? []).filter((size) => size >= CRUMB).length;

/** The paper's table of invariance classes. */
const CLASSES: readonly (readonly [string, string, string])[] = [
  ["planar", "3", "plane"],
  ["spherical", "3", "sphere"],
  ["cylindrical", "2", "cylinder"],
  ["helical", "2", "none"],
  ["prismatic", "1", "undersegmented"],
  ["revolute", "1", "cone or torus"],
  ["complex", "0", "undersegmented"],
];

export const STEPS: readonly GrowingStep[] = [
  {
    title: "Surface variation",
    shows: "variation",
    tools: [],
    text: () => (
      <>
        <p>
          Primitive growing begins with neighbourhoods. For each point and its 15 nearest neighbours the covariance matrix
          has three eigenvalues λ₁ ≤ λ₂ ≤ λ₃. The <b>surface variation</b>
        </p>
        <p>σ = λ₁ / (λ₁ + λ₂ + λ₃)</p>
        <p>
          is 0 where the neighbourhood is flat, and at most ⅓. It is large where the neighbourhood reaches over an edge.
          Dark points are flat, pale ones are not.
        </p>
        <Bars />
      </>
    ),
  },
  {
    title: "The threshold η",
    shows: "sharp",
    tools: ["eta"],
    text: () => (
      <>
        <p>
          Points above a threshold are taken to lie on <b>sharp edges</b>. The threshold is set as a share: η = 0.8 means
          that the top 20 % are sharp. The paper lets the user choose η between 0.65 and 0.95; our fitter reads it off
          the histogram.
        </p>
        <Bars />
        <Exercise
          task={`Raise η until regions leak through the edges: fewer than four regions of ${CRUMB} points or more are left.`}
          solved={partition.value ? large() < 4 : undefined}
          standing={`There are ${large()} such regions, and ${Math.round((100 * (partition.value?.sharp ?? 0)) / Math.max(1, variation.value.length))} % of the points are sharp.`}
          hint="A high η leaves gaps in the edges, and regions run together through them."
          learnt="Every choice of η loses somewhere: low, and thin faces are all edge; high, and regions leak."
        />
      </>
    ),
  },
  {
    title: "Seeds and growing regions",
    shows: "growth",
    tools: ["eta", "growth"],
    text: () => (
      <>
        <p>
          A seed takes its nearest neighbours that are not sharp into its region; they are seeds in their turn, until
          nothing is left to take. Then the next seed begins another region. Let the regions grow step by step.
        </p>
        <Exercise
          task="Grow all regions to their end."
          solved={partition.value ? grown.value >= lastStep() && lastStep() > 0 : undefined}
          standing={`Step ${grown.value} of ${lastStep()}.`}
          hint="The slider below the picture goes to the last step; “One step” goes there one by one."
          learnt="Regions end at sharp points, which belong to none. Where two faces meet without an edge, as a plane runs into a bend, one region covers both."
        />
      </>
    ),
  },
  {
    title: "Slippage: the motions that a region allows",
    shows: "regions",
    tools: ["regions"],
    text: () => (
      <>
        <p>
          Which rigid motions slide a region over itself? A motion with rotation <b>r</b> and translation <b>t</b> moves
          the point x by r × x + t; it is <b>slippable</b> where that is across the normal everywhere. The squares of the
          motion along the normals are summed in a 6 × 6 matrix: each eigenvalue near zero is a slippable motion.
        </p>
        <p>Click a region, or choose one below the picture.</p>
        {slippage.value ? <Eigenvalues /> : <p class="hint">{region.value === undefined ? "No region is chosen." : "This region is too small."}</p>}
        <Exercise
          task="Find a planar region."
          solved={slippage.value ? slippage.value.class === "planar" : false}
          standing={slippage.value ? `The region is ${slippage.value.class}.` : "No region is chosen."}
          hint="The largest regions of a bracket are its legs’ faces; try the regions in order."
          learnt="Three motions: slide both ways, and turn about the normal. A sphere allows three as well, all of them turns."
        />
      </>
    ),
  },
  {
    title: "See it slide",
    shows: "regions",
    tools: ["regions", "motion"],
    text: () => (
      <>
        <p>
          Choose a region and one of its slippable motions, and move the slider: a ghost of the region moves away. It
          stays on the surface that the region is part of.
        </p>
        <Exercise
          task="Move a ghost along a slippable motion, at least by a third of the slider."
          solved={slippage.value ? Math.abs(amount.value) >= 1 / 3 : false}
          standing={slippage.value ? `The ${slippage.value.class} region allows ${slippage.value.motions.length || "no"} motions here.` : "No region is chosen."}
          hint="A complex region allows none: take another."
          learnt="That a surface slides over itself is what makes it a primitive in the sense of ISO 17450."
        />
        {slippage.value && <Eigenvalues />}
      </>
    ),
  },
  {
    title: "Splitting by RANSAC",
    shows: "pieces",
    tools: ["regions", "split"],
    text: () => (
      <>
        <p>
          A <b>prismatic</b> region slides one way only; a <b>complex</b> one not at all. Such regions are usually several
          surfaces that meet without a sharp edge. RANSAC splits them: it draws minimal sets of points, lets each give a
          surface, and keeps the surface that holds most points; then it goes on with the rest.
        </p>
        <Exercise
          task="Find a region that is neither planar, cylindrical nor spherical, and split it into at least two surfaces."
          solved={
            slippage.value && pieces.value
              ? !["planar", "cylindrical", "spherical"].includes(slippage.value.class) && pieces.value.length >= 2
              : false
          }
          standing={
            slippage.value
              ? `The region is ${slippage.value.class}${pieces.value ? `, and holds ${format.plural(pieces.value.length, "surface")}` : ""}.`
              : "No region is chosen."
          }
          hint="Begin with the largest region: the outside of both legs and the bend between them."
          learnt="Each surface found is one of the five types: the classes that no primitive has are gone."
        />
        {pieces.value && (
          <ul>
            {pieces.value.map(({ type, support }, at) => (
              <li key={at}>
                {type}, {format.plural(support.length, "point")}
              </li>
            ))}
          </ul>
        )}
      </>
    ),
  },
  {
    title: "The segmentation and its score",
    shows: "segmentation",
    tools: ["segment"],
    text: () => (
      <>
        <p>
          At last sharp points are given to the primitive whose surface they lie on. Run the whole method on this part.
        </p>
        <Exercise
          task="Run the fitter and see its score."
          solved={segmentation.value !== undefined}
          standing={
            segmentation.value
              ? `${segmentation.value.report.predicted} primitives found; the truth has ${segmentation.value.report.truth}.`
              : "It has not run yet."
          }
          hint="The button is below the picture. It takes a few seconds."
          learnt="Compare it with what the Hough transform finds: on the Score page both run on any cloud."
        />
        {segmentation.value && <MeanScore report={segmentation.value.report} />}
      </>
    ),
  },
];

function Bars(): JSX.Element | null {
  const { threshold, sharp } = partition.value ?? {};
  if (threshold === undefined || sharp === undefined) return null;
  return <Histogram values={variation.value} threshold={threshold} sharp={sharp} />;
}

function Eigenvalues(): JSX.Element | null {
  const found = slippage.value;
  if (!found) return null;
  return (
    <>
      <table class="formulas">
        <caption>Eigenvalues, smallest first</caption>
        <tbody>
          <tr>
            {found.eigenvalues.map((value, at) => (
              <td key={at} class="numeric">
                {value < 0.0001 ? "0.0000" : value.toFixed(4)}
              </td>
            ))}
          </tr>
        </tbody>
      </table>
      <table class="formulas">
        <caption>ISO GPS invariance classes (the paper’s table)</caption>
        <thead>
          <tr>
            <th scope="col">Class</th>
            <th scope="col">Slippable motions</th>
            <th scope="col">Primitive</th>
          </tr>
        </thead>
        <tbody>
          {CLASSES.map(([name, count, primitive]) => (
            <tr key={name} data-stressed={name === found.class}>
              <th scope="row">{name}</th>
              <td>{count}</td>
              <td>{primitive}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}
