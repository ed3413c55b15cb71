// The import of a STEP file under way, at the foot of the page: seen whatever panel is shown.

import type { JSX } from "preact";
import { importing } from "../intake/step";
import { capitalised } from "../ui/format";

export function ImportingWork(): JSX.Element | null {
  const state = importing.value;
  if (!state) return null;
  return (
    <div class="work">
      <button type="button" onClick={state.stop}>
        Stop importing
      </button>
      <progress id="importing" max={1} value={state.share} />
      <label for="importing">
        {capitalised(state.stage)}: {state.path}
      </label>
    </div>
  );
}
