// What a view shows, and the choice of it: the truth or any submission of the model.

import type { JSX } from "preact";
import { modelById } from "../state/models";
import { rightIsTruth, selectedModel, selectModel, showLeft } from "../state/selection";
import { scene } from "../state/scene";
import { sides } from "./display";
import { nameOf } from "./key";

const TRUTH = "truth";
/** A submission may be called anything. */
const SUBMISSION = "submission ";

export function SideName({ at }: { at: "left" | "right" }): JSX.Element | null {
  const state = scene.value;
  const entry = modelById(selectedModel.value);
  if (state.kind !== "ready" || entry?.status.kind !== "scored") return null;
  const { methods, hasTruth } = entry.status.result.info;
  const shown = sides.value[at === "left" ? 0 : 1];
  if (methods.length === 0) return <span class={`side-name ${at}`}>{hasTruth ? "Truth" : "Points"}</span>;
  const choose = (value: string) => {
    const method = value === TRUTH ? undefined : value.slice(SUBMISSION.length);
    if (at === "left") showLeft(method);
    else {
      rightIsTruth.value = method === undefined;
      if (method !== undefined) selectModel(entry.id, method);
    }
  };
  return (
    <label class={`side-name ${at}`}>
      <span class="visually-hidden">{at === "left" ? "Left view" : "Right view"}</span>
      <select
        value={shown === "truth" ? TRUTH : SUBMISSION + nameOf(shown, state.scene)}
        onChange={(event) => choose(event.currentTarget.value)}
      >
        {hasTruth && <option value={TRUTH}>Truth</option>}
        {methods.map((method) => (
          <option key={method} value={SUBMISSION + method}>
            {method}
          </option>
        ))}
      </select>
    </label>
  );
}
