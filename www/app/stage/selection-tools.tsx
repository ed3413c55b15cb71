// What can be done with the selected primitive.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { scene } from "../state/scene";
import { selectedPrimitive } from "../state/selection";
import { Icon } from "../ui/icon";
import { frameSelected, hiddenCount, hideSelected, isLocked, isolated, locked, lockSelected, showAll, toggleIsolated, unlockAll } from "./isolation";
import { wordsFor } from "./tooltip";

const name = computed(() => {
  const ref = selectedPrimitive.value;
  const state = scene.value;
  return ref && state.kind === "ready" ? wordsFor(state.scene, ref.side, ref.index) : undefined;
});

export function SelectionTools(): JSX.Element | null {
  const ref = selectedPrimitive.value;
  if (!name.value && hiddenCount.value === 0 && locked.value.size === 0) return null;
  return (
    <div class="selection-tools" role="group" aria-label="Selected primitive">
      {name.value && (
        <>
          <strong>{name.value}</strong>
          <button type="button" title="Frame (F)" onClick={frameSelected}>
            Frame
          </button>
          <button type="button" title="Isolate (I)" aria-pressed={isolated.value} onClick={toggleIsolated}>
            Isolate
          </button>
          <button type="button" title="Hide (H)" onClick={hideSelected}>
            Hide
          </button>
          <button type="button" title="Lock: a click in the picture does not find it (L)" aria-pressed={ref !== undefined && isLocked(ref)} onClick={lockSelected}>
            Lock
          </button>
        </>
      )}
      {hiddenCount.value > 0 && (
        <button type="button" title="Show all (A, Esc)" onClick={showAll}>
          Show {hiddenCount.value} hidden
        </button>
      )}
      {locked.value.size > 0 && (
        <button type="button" title="Unlock all (Esc)" onClick={unlockAll}>
          Unlock {locked.value.size}
        </button>
      )}
      {name.value && (
        <button type="button" class="icon" aria-label="Deselect" title="Deselect (Esc)" onClick={() => (selectedPrimitive.value = undefined)}>
          <Icon name="close" />
        </button>
      )}
    </div>
  );
}
