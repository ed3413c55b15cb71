// A cross-section beside the cut of the views: the points near its plane, and the curves in which the surfaces meet it.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { isMeantBy } from "../stage/colouring";
import { CutAxis, CutPlace } from "../stage/cut-fields";
import { cutAcross, CUTS } from "../stage/display";
import { nameOf } from "../stage/key";
import { reports } from "../stage/reports";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedPrimitive, togglePrimitive } from "../state/selection";
import * as format from "../ui/format";
import { Swatch } from "../ui/swatch";
import { curvesOf, Drawing, type Curve } from "./drawing";
import { draw, drawnSide, follow, offered, section, thickness, type Section } from "./state";
import "./section.css";

export default function SectionPanel(): JSX.Element {
  useEffect(follow, []);
  if (offered.value.length === 0) return <p class="empty">Choose a model that has a ground truth or a submission, or fit one under Fit.</p>;
  return (
    <div class="section-panel">
      <div class="panel-tools">
        <label>
          Cut across{" "}
          <CutAxis />
        </label>
        {cutAcross.value !== "none" && (
          <>
            <label class="slide">
              Place
              <CutPlace />
            </label>
            <label class="slide">
              Thickness
              <input
                type="range"
                min={0.001}
                max={0.1}
                step={0.001}
                value={thickness.value}
                aria-valuetext={`${(100 * thickness.value).toFixed(1)} % of the diagonal`}
                onInput={(event) => (thickness.value = event.currentTarget.valueAsNumber)}
              />
            </label>
          </>
        )}
        <Whose />
      </div>
      {cutAcross.value === "none" ? (
        <Uncut />
      ) : section.value ? (
        <Cross section={section.value} />
      ) : (
        <p class="empty">Cutting…</p>
      )}
    </div>
  );
}

/** Before there is a cut: what it will show, and the three ways to have it. */
function Uncut(): JSX.Element {
  return (
    <div class="empty">
      <p>
        A cut opens the views at one place. Here it shows the points near it, and the lines, circles and other curves in which
        the fitted surfaces meet it. Escape takes it back.
      </p>
      <p class="cuts">
        {CUTS.map(
          ({ id, title }) =>
            id !== "none" && (
              <button key={id} type="button" onClick={() => (cutAcross.value = id)}>
                Cut across {title}
              </button>
            ),
        )}
      </p>
    </div>
  );
}

function Whose(): JSX.Element | null {
  const state = scene.value;
  if (state.kind !== "ready" || offered.value.length < 2) return null;
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">Curves of</legend>
      {offered.value.map((side) => (
        <label key={side}>
          <input type="radio" name="section-of" checked={side === drawnSide.value} onChange={() => draw(side)} />
          <span>{format.capitalised(nameOf(side, state.scene))}</span>
        </label>
      ))}
    </fieldset>
  );
}

function Cross({ section: shown }: { section: Section }): JSX.Element {
  const curves = curvesOf(shown);
  const { info, cut } = shown;
  const at = `${"xyz"[cut.axis]} = ${Number(info.at.toPrecision(4))}`;
  const label = `Section at ${at}: ${format.plural(info.points.length, "point")} within ${Number((info.thickness / 2).toPrecision(3))} of it, ${format.plural(curves.length, "primitive")} met`;
  return (
    <div class="section-body">
      <Drawing section={shown} curves={curves} label={label} />
      <div class="section-words">
        <p role="status">{label}.</p>
        <ul onMouseLeave={() => (hoveredPrimitive.value = undefined)}>
          {curves.map((curve) => (
            <Met key={curve.ref.index} curve={curve} />
          ))}
        </ul>
      </div>
    </div>
  );
}

function Met({ curve: { ref, name, meeting, colour } }: { curve: Curve }): JSX.Element {
  return (
    <li data-hovered={isMeantBy(reports.value, hoveredPrimitive.value, ref) || undefined} onMouseEnter={() => (hoveredPrimitive.value = ref)}>
      <button type="button" class="row-name" aria-pressed={isMeantBy(reports.value, selectedPrimitive.value, ref)} onClick={() => togglePrimitive(ref)}>
        <Swatch colour={colour} />
        {name}, {meeting}
      </button>
    </li>
  );
}
