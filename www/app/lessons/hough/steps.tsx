// The steps of the lesson on the Hough transform.

import type { JSX } from "preact";
import type { SurfaceInfo } from "../../../generated/engine/engine.js";
import * as format from "../../ui/format";
import { Exercise } from "../exercise";
import type { Step } from "../frame";
import { MeanScore } from "../mean-score";
import { all, cell, cellInfo, family, gamma, maxima, part, point, polished, segmentation, share, slice, voted } from "./state";

export interface HoughStep extends Step {
  /** Which controls stand below the pictures. */
  readonly tools: readonly ("point" | "vote" | "threshold" | "peaks" | "segment")[];
  /** What the accumulator shows. */
  readonly shows: "nothing" | "voted" | "all";
}

const top = () => all.value.reduce((most, votes) => Math.max(most, votes), 0);
const votesOfCell = () => cellInfo.value?.voters.length ?? 0;
const kept = () => maxima.value.filter((each) => each.kept).length;
const plural = format.plural;

export function written(surface: SurfaceInfo): string {
  const at = (values: readonly number[]) => `(${values.map((each) => each.toFixed(3).replace("-", "−")).join(", ")})`;
  switch (surface.type) {
    case "Plane":
      return `normal ${at(surface.normal)}, offset ${surface.offset.toFixed(3)}`;
    case "Cylinder":
      return `axis ${at(surface.axis)} through ${at(surface.centre)}, radius ${surface.radius.toFixed(3)}`;
    case "Cone":
      return `apex ${at(surface.apex)}, axis ${at(surface.axis)}, half-angle ${((surface.halfAngle * 180) / Math.PI).toFixed(1)}°`;
    case "Sphere":
      return `centre ${at(surface.centre)}, radius ${surface.radius.toFixed(3)}`;
    case "Torus":
      return `centre ${at(surface.centre)}, axis ${at(surface.axis)}, radii ${surface.majorRadius.toFixed(3)} and ${surface.minorRadius.toFixed(3)}`;
  }
}

export const STEPS: readonly HoughStep[] = [
  {
    title: "A family of surfaces",
    tools: [],
    shows: "nothing",
    text: () => (
      <>
        <p>
          The Hough transform turns the question round. Instead of asking which surface fits the points, it asks which
          surfaces of a <b>family</b> pass through each point, and looks for those that many points agree on. Choose a
          family below the picture.
        </p>
        <p>
          A surface of the family is a point in <b>parameter space</b>. A cylinder has five parameters, and a picture has
          two axes; so three are held at those of one face of this part: axis and radius. (The fitter itself finds them
          first, on coarser accumulators.) The square is what remains.
          {slice.value && ` To the right: ${slice.value.columns.name}. Upwards: ${slice.value.rows.name}.`}
        </p>
        {slice.value && (
          <p>
            Held: <b>{slice.value.base.type}</b>, {written(slice.value.base)}.
          </p>
        )}
        {part.value && (
          <p class="hint">
            The part has {plural(part.value.positions.length / 3, "point")}, with a little noise, as measured points would.
          </p>
        )}
      </>
    ),
  },
  {
    title: "One point and its Γ",
    tools: ["point"],
    shows: "nothing",
    text: () => (
      <>
        <p>
          Click a point of the part. All surfaces of the family through that point P make a curve in the square:{" "}
          <b>Γ<sub>P</sub></b>, its Hough transform. The cells that it crosses light up.
        </p>
        {family.value === "Cylinder" && (
          <p>For the centres of cylinders of one radius it is a circle of that radius about the point, seen along the axis.</p>
        )}
        {family.value === "Plane" && <p>For turn and offset of a plane it is a sinusoid, as in the classical transform for lines.</p>}
        <Exercise
          task="Find a point that lights at least 12 cells."
          solved={point.value === undefined ? false : gamma.value.length >= 12}
          standing={point.value === undefined ? "No point is chosen." : `Point ${format.integer(point.value + 1)} lights ${plural(gamma.value.length, "cell")}.`}
          hint="Try another point; without a pointer, “Another point” does it. A point far from every surface of the slice lights few."
          learnt="One point alone says little: every cell it lights is a surface through it."
        />
      </>
    ),
  },
  {
    title: "A cell is a surface",
    tools: ["point"],
    shows: "all",
    text: () => (
      <>
        <p>
          Now the other way: click a cell of the square, or walk there with the arrow keys. The cell’s centre is one
          surface of the family, drawn in the part. The points whose Γ crosses the cell have <b>voted</b> for it; they are
          highlighted.
        </p>
        <Exercise
          task={`Find a cell with more than half as many votes as the highest one, which has ${top() || "…"}.`}
          solved={cell.value === undefined ? false : votesOfCell() > top() / 2}
          standing={cell.value === undefined ? "No cell is chosen." : `The cell has ${plural(votesOfCell(), "vote")}.`}
          hint="Pale cells have many votes."
          learnt="Points that lie on one surface of the family all vote for its cell; what else falls there is chance."
        />
        {cellInfo.value && (
          <p>
            {cellInfo.value.surface.type}, {written(cellInfo.value.surface)}.
          </p>
        )}
      </>
    ),
  },
  {
    title: "All points vote",
    tools: ["vote"],
    shows: "voted",
    text: () => (
      <>
        <p>
          Each point in its turn raises every cell of its Γ by one. The heights together are the <b>accumulator</b>{" "}
          function 𝓗. Let the points vote one by one, by the hundred, or all.
        </p>
        <p>Curves cross everywhere by chance. Where a surface really is, they keep crossing in the same cell.</p>
        <Exercise
          task="Let all points vote."
          solved={voted.value > 0 && voted.value === (part.value?.positions.length ?? 0) / 3}
          standing={`${format.integer(voted.value)} of ${format.integer((part.value?.positions.length ?? 0) / 3)} have voted.`}
          hint="The button “All” does it at once."
          learnt="The relief shows the landscape better than colours do: switch to it below."
        />
      </>
    ),
  },
  {
    title: "Peaks that persist",
    tools: ["threshold"],
    shows: "all",
    text: () => (
      <>
        <p>
          The landscape has {plural(maxima.value.length, "local maximum").replace("maximums", "maxima")}, and most are
          ripples on the flank of another. <b>Topological persistence</b> tells them apart: let the water sink from the
          highest top. Each maximum is <i>born</i> as an island when the water reaches it, and <i>dies</i> when its island
          meets that of a higher one. Birth less death is how long it lives.
        </p>
        <p>
          In the diagram, tops far above the diagonal live long. The paper keeps those whose persistence is at least{" "}
          <b>10 %</b> of the highest; move the threshold and watch spurious maxima die.
        </p>
        <Exercise
          task={
            family.value === "Cylinder"
              ? "The flange has six bolt holes of this radius, yet seven peaks stand apart from all others. Choose a threshold that keeps exactly these seven."
              : "Choose a threshold that keeps fewer than ten peaks, but at least one."
          }
          solved={family.value === "Cylinder" ? kept() === 7 : kept() > 0 && kept() < 10}
          standing={`At ${Math.round(share.value * 100)} % there ${kept() === 1 ? "is 1 peak" : `are ${kept()} peaks`} left.`}
          hint="Look for the wide gap between the red dots and the rest, and put the line into it."
          learnt="Persistence cannot know what a peak is made of: one of the seven is no bolt hole. Polishing, the next step, finds it out. And small faces need a low threshold, at which ripples of large ones come along."
        />
      </>
    ),
  },
  {
    title: "Polish the peaks",
    tools: ["peaks"],
    shows: "all",
    text: () => (
      <>
        <p>
          A peak is only as exact as its cell is small. The fitter takes its voters as a start, fits the surface to those
          near it by least squares, and lets it grow over all connected points that lie on it. Choose peaks below.
        </p>
        <Exercise
          task="Polish a peak that holds on to at least 20 points."
          solved={polished.value ? polished.value.support.length >= 20 : false}
          standing={
            polished.value
              ? `The surface holds ${plural(polished.value.support.length, "point")}.`
              : cell.value === undefined
                ? "No peak is chosen."
                : "Too few points hold on to the surface of this cell: the peak is spurious."
          }
          hint="Take the peaks in order: the most persistent come first."
          learnt="A peak without a face behind it loses its points as the surface settles: votes from all over the part do not make a patch."
        />
        {polished.value && cellInfo.value && (
          <table class="formulas">
            <tbody>
              <tr>
                <th scope="row">cell</th>
                <td>{written(cellInfo.value.surface)}</td>
                <td class="numeric">{plural(cellInfo.value.voters.length, "vote")}</td>
              </tr>
              <tr>
                <th scope="row">polished</th>
                <td>{written(polished.value.surface)}</td>
                <td class="numeric">{plural(polished.value.support.length, "point")}</td>
              </tr>
            </tbody>
          </table>
        )}
      </>
    ),
  },
  {
    title: "Which type? MFE decides",
    tools: ["peaks"],
    shows: "all",
    text: () => (
      <>
        <p>
          The same points may be near surfaces of several families. The paper fits each and keeps the one of lowest{" "}
          <b>mean fitting error</b>. Choose a peak: the table shows every family’s best surface through its points.
        </p>
        {polished.value ? <Rivals /> : <p class="hint">No polished peak is chosen.</p>}
        <Exercise
          task="Find a peak where the lowest MFE and the family that the fitter keeps can be compared: choose any that polishes well."
          solved={polished.value ? polished.value.rivals.length >= 2 : false}
          standing={polished.value ? `${plural(polished.value.rivals.length, "family").replace("familys", "families")} could be fitted.` : "No polished peak is chosen."}
          hint="Take the first peak of the list."
          learnt="A family with more parameters always fits noise a little better: a cone includes the cylinders. So our fitter keeps, of those that fit about as well, the simplest."
        />
      </>
    ),
  },
  {
    title: "The segmentation and its score",
    tools: ["segment"],
    shows: "all",
    text: () => (
      <>
        <p>
          The whole method does this for every family, removes what the winners explain, and votes again until nothing is
          left to find. Run it on this part.
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
          learnt="This is the fitter of the playground: the Score page runs it on any cloud."
        />
        {segmentation.value && <MeanScore report={segmentation.value.report} />}
      </>
    ),
  },
];

function Rivals(): JSX.Element {
  return (
    <table class="formulas">
      <caption>Best surface of each family through the peak’s points</caption>
      <thead>
        <tr>
          <th scope="col">Family</th>
          <th scope="col">MFE</th>
          <th scope="col" />
        </tr>
      </thead>
      <tbody>
        {(polished.value?.rivals ?? []).map((rival) => (
          <tr key={rival.type} data-stressed={rival.kept}>
            <th scope="row">{rival.type}</th>
            <td class="numeric">{format.measure("MFE", rival.mfe)}</td>
            <td>{[rival.least && "lowest MFE", rival.kept && "kept"].filter(Boolean).join(", ")}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
