// Missing data: what has been cut away, and with what to cut.

import type { JSX } from "preact";
import * as format from "../ui/format";
import { Choice } from "../ui/choice";
import { removed, withAxis } from "./blocks";
import type { Cut } from "./case";
import { NumberField } from "./number-field";
import { current, edit, made } from "./state";
import { focusLasso } from "./lasso-layer";
import { ball, ballPoint, cutBall, inBall, placeBall, placeBallOn, reach, tool } from "./tools";

export function MissingSection(): JSX.Element {
  return (
    <section aria-labelledby="studio-missing">
      <h3 id="studio-missing">Missing data</h3>
      <Choice
        label="Tool"
        value={tool.value}
        options={[["turn", "Turn"], ["lasso", "Lasso"], ["ball", "Ball"]]}
        onChange={(next) => (tool.value = next)}
      />
      {tool.value === "turn" && <p class="hint">Take the lasso or the ball to cut points away. The ground truth follows.</p>}
      {tool.value === "lasso" && (
        <>
          <p class="hint">
            Draw around points in the view, or{" "}
            <button type="button" class="link" onClick={focusLasso}>
              place a rectangle
            </button>{" "}
            by keyboard: arrow keys move it, with Shift they size it, Enter cuts.
          </p>
          <Choice
            label="Cut"
            value={reach.value}
            options={[["through", "all the way through"], ["seen", "as deep as is seen"]]}
            onChange={(next) => (reach.value = next)}
          />
        </>
      )}
      {tool.value === "ball" && <BallForm />}
      <CutList />
    </section>
  );
}

function BallForm(): JSX.Element {
  const { centre, radius } = ball.value ?? { centre: [0, 0, 0] as const, radius: 1 };
  const count = (made.value?.result.positions.length ?? 0) / 3;
  return (
    <>
      <p class="hint">Click a point in the view, or give its number or the centre here.</p>
      <div class="studio-fields">
        <NumberField
          label="Point number"
          value={ballPoint.value === undefined ? undefined : ballPoint.value + 1}
          min={1}
          max={Math.max(1, count)}
          whole
          hint="Empty while the ball is on no point"
          onValue={(value) => placeBallOn(value - 1)}
        />
        <NumberField label="Radius" value={radius} min={1e-9} step={Math.max(radius / 10, 1e-9)} onValue={(value) => placeBall({ radius: value })} />
        <span />
        {(["x", "y", "z"] as const).map((axis, at) => (
          <NumberField
            key={axis}
            label={`Centre ${axis}`}
            value={centre[at] ?? 0}
            min={-1e9}
            max={1e9}
            onValue={(value) => placeBall({ centre: withAxis(centre, at, value) })}
          />
        ))}
        <button type="button" class="wide" disabled={inBall.value.length === 0} onClick={cutBall}>
          Cut {format.plural(inBall.value.length, "point")}
        </button>
      </div>
    </>
  );
}

function CutList(): JSX.Element | null {
  const { cuts } = current.value;
  // Effects are those of the case made last, which may be a step behind.
  const effects = made.value && made.value.of.cuts === cuts ? made.value.result.cuts : [];
  if (cuts.length === 0) return null;
  return (
    <ol class="cuts" aria-label="Cuts">
      {cuts.map((cut, place) => {
        const effect = effects[place];
        const name = `${cut.kind === "ball" ? "Ball" : "Lasso"} ${place + 1}`;
        return (
          <li key={place}>
            <span>
              <strong>{name}</strong> {describe(cut)}
              {effect && `: ${format.plural(effect.points, "point")}`}
              {effect && effect.vanished.length > 0 && `; ${vanished(effect.vanished)}`}
            </span>
            <button
              type="button"
              class="link"
              aria-label={`Take back ${name}`}
              onClick={() => edit({ cuts: removed(cuts, place) }, `Take back ${name.toLowerCase()}`)}
            >
              Take back
            </button>
          </li>
        );
      })}
    </ol>
  );
}

function describe(cut: Cut): string {
  if (cut.kind === "ball") return `of radius ${Number(cut.radius.toPrecision(3))}`;
  return Number.isFinite(cut.depth) ? "as deep as was seen" : "all the way through";
}

/** In words: which primitives lost their last point. */
export function vanished(numbers: readonly number[]): string {
  return numbers.length === 1 ? `primitive ${numbers[0]} is gone` : `primitives ${numbers.join(", ")} are gone`;
}
