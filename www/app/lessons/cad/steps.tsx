// The steps of the lesson on parts from CAD. Every figure they check is the engine's.

import type { JSX } from "preact";
import { Swatch } from "../../ui/swatch";
import * as format from "../../ui/format";
import { segmentColour } from "../../view/palette";
import { Exercise } from "../exercise";
import type { Step } from "../frame";
import { MeanScore } from "../mean-score";
import { dsc, faces, how, part, seen, segmentation, total, written, type How } from "./state";

export interface CadStep extends Step {
  /** The points that the step begins with. */
  readonly begins: How;
  readonly tools: readonly ("spread" | "noise" | "fit" | "back")[];
}

const EVEN: How = { points: 1000, spread: "even", views: 1, noise: 0 };

/** Fewest points of a face, and most of all, that the first exercise asks for. */
const FEWEST = 30;
const MOST = 3000;
/** Most viewpoints that the second takes. */
const VIEWS = 5;
const FOUND = 0.99;
const LOST = 0.85;

function Faces(): JSX.Element {
  return (
    <table class="formulas">
      <caption>{format.plural(faces.value.length, "face")} of the drawing</caption>
      <thead>
        <tr>
          <th scope="col">Face</th>
          <th scope="col" class="numeric">
            Area, mm²
          </th>
          <th scope="col" class="numeric">
            Points
          </th>
        </tr>
      </thead>
      <tbody>
        {faces.value.map(({ face, type, area, points, primitive }) => (
          <tr key={String(face)}>
            <th scope="row">
              {primitive !== null && <Swatch colour={segmentColour(primitive - 1)} />} {type ?? "none"}
            </th>
            <td class="numeric">{area.toFixed(0)}</td>
            <td class="numeric">
              <b>{format.integer(points)}</b>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Score(): JSX.Element | null {
  const found = segmentation.value;
  return found ? <MeanScore report={found.report} /> : null;
}

const fewest = () => Math.min(...faces.value.map(({ points }) => points));
/** Where a fit stands, in words. */
function standing(): string {
  const found = segmentation.value;
  if (!found) return "Nothing was fitted to these points yet.";
  return `${format.plural(found.primitives.length, "primitive")} found, mean DSC ${(dsc.value ?? 0).toFixed(3)}.`;
}
/** Undefined while there are no points. */
const ready = (solved: boolean) => (part.value ? solved : undefined);

export const STEPS: readonly CadStep[] = [
  {
    title: "A drawing has no points",
    begins: EVEN,
    tools: [],
    text: () => (
      <>
        <p>
          This plate was never scanned. It is a <b>STEP</b> file, as every CAD system writes: twelve faces, each a
          surface of known type and parameters, cut out by its edges. All five families are among them.
        </p>
        <p>
          The points were laid <b>exactly</b> on the faces, each as dense as the others, and the face of every point is
          known. So points and truth come from one source, and nobody labels anything by hand.
        </p>
        <Exercise
          task={`Give every face at least ${FEWEST} points with no more than ${format.integer(MOST)} in all.`}
          solved={ready(fewest() >= FEWEST && total.value <= MOST)}
          standing={`${format.integer(total.value)} points; the smallest face has ${format.integer(fewest())}.`}
          hint="Draw the slider Points to the right."
          learnt="The number of points is set by the smallest face: at an even density the largest has more than twenty times as many."
        />
        <Faces />
      </>
    ),
  },
  {
    title: "What a scanner sees",
    begins: { ...EVEN, points: 4000, spread: "scan" },
    tools: ["spread"],
    text: () => (
      <>
        <p>
          The benchmark’s clouds are <b>even</b>. Samplers of meshes give <b>random</b> ones. A <b>scan</b> is taken from
          viewpoints: what is seen aslant has fewer points, and what is hidden from all of them has none.
        </p>
        <Exercise
          task={`With the scan, have all faces seen from at most ${VIEWS} viewpoints.`}
          solved={ready(how.value.spread === "scan" && how.value.views <= VIEWS && seen.value === faces.value.length)}
          standing={`${seen.value} of ${faces.value.length} faces have points.`}
          hint="One viewpoint never sees a side and the side behind it. Add some, one by one."
          learnt="A face that is hidden from every viewpoint is in no list of the truth: no method is asked for what nobody could have seen."
        />
        <Faces />
      </>
    ),
  },
  {
    title: "From points to primitives",
    begins: EVEN,
    tools: ["spread", "fit"],
    text: () => (
      <>
        <p>
          Now the fitter gets the points and <b>nothing else</b>: no faces, no types. What it finds is set beside the faces of the
          drawing, and every true primitive is scored by the best match it has.
        </p>
        <Exercise
          task={`Reach a mean DSC of ${FOUND} with no more than ${format.integer(MOST)} points.`}
          solved={ready((dsc.value ?? 0) >= FOUND && total.value <= MOST)}
          standing={standing()}
          hint="A small face of a handful of points is easily overlooked. Take more points, and fit them again."
          learnt="The score is not of the method alone, but of the method on clouds of a certain density: whoever publishes one says which."
        />
        <Score />
      </>
    ),
  },
  {
    title: "What noise costs",
    begins: { ...EVEN, points: 6000 },
    tools: ["noise", "fit"],
    text: () => (
      <>
        <p>
          The points lie exactly on the surfaces, as no scanner’s do. <b>Noise</b> moves each of them: its standard
          deviation in each coordinate is a share of the diagonal of the plate. The truth stays what it was.
        </p>
        <Exercise
          task={`Find a noise at which the mean DSC of a fit is under ${LOST}.`}
          solved={ready(dsc.value !== undefined && dsc.value < LOST)}
          standing={standing()}
          hint="Draw the slider Noise to the right, and fit the points again."
          learnt="Where the noise is as large as a fillet, the fillet is gone: what is lost first is what is smallest."
        />
        <Score />
      </>
    ),
  },
  {
    title: "And back",
    begins: { ...EVEN, points: 6000 },
    tools: ["noise", "fit", "back"],
    text: () => {
      const found = segmentation.value?.primitives.length ?? 0;
      const read = written.value?.read;
      return (
        <>
          <p>
            What was found are surfaces with parameters, so it can go where the drawing came from. Each becomes a face,
            cut out by the outline of its points, in a STEP file that CAD systems open.
          </p>
          <Exercise
            task="Fit the points, write what was found as STEP, and read that again: as many faces as there were primitives."
            solved={ready(read !== undefined && found > 0 && read.faces.length === found && read.lost === 0)}
            standing={read ? `${format.plural(found, "primitive")} written, ${format.plural(read.faces.length, "face")} read.` : standing()}
            hint="Fit the points first, then press Write and read again."
            learnt={
              <>
                From a drawing to points, to primitives, to a score, and to a drawing again. Drop STEP files of your own on the
                page, or make a benchmark of a folder of them with <code>fit4cad import</code>.
              </>
            }
          />
          {read && (
            <table class="formulas">
              <caption>Faces of the file that was written</caption>
              <tbody>
                {read.faces.map(({ face, type, area }) => (
                  <tr key={String(face)}>
                    <th scope="row">{type ?? "none"}</th>
                    <td class="numeric">{area.toFixed(0)} mm²</td>
                  </tr>
                ))}
              </tbody>
            </table>
          )}
        </>
      );
    },
  },
];
