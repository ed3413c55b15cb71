// Which key does what.

import { adding } from "../intake/adding";
import { keysShown } from "../keyboard/shown";
import type { ShortcutGroup } from "../keyboard/shortcuts";
import { focusSearch } from "../models/list";
import { toggleProtocol } from "../measures/protocol-switch";
import { stopRebuilding } from "../sharing/state";
import { sharing } from "../sharing/share";
import { currentView, picturing } from "../stage/current";
import { takeBrushBack } from "../stage/brush";
import { frameSelected, hideSelected, lockSelected, showAll, takeAsideBack, toggleIsolated } from "../stage/isolation";
import { takeCutBack } from "../stage/display";
import { takeTapeBack, toggleMeasuring } from "../stage/tape";
import { cancelFitting } from "../state/fitting";
import { modelById, models } from "../state/models";
import { alone, toggleAlone, toggleTables } from "../state/extent";
import { showPanel } from "../state/panels";
import { cancelScoring } from "../state/scoring";
import { selectedMethod, selectedModel, selectedPrimitive, selectModel } from "../state/selection";
import { nextTheme } from "../state/settings";
import { PANELS } from "./registry/panels";

function stepModel(by: number): void {
  const list = models.value;
  const at = list.findIndex(({ id }) => id === selectedModel.value);
  const next = list[Math.min(list.length - 1, Math.max(0, at + by))];
  if (next) selectModel(next.id);
}

function nextMethod(): void {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return;
  const { methods } = status.result.info;
  const at = methods.findIndex((method) => method === selectedMethod.value);
  const next = methods[(at + 1) % methods.length];
  if (next !== undefined) selectModel(selectedModel.value, next);
}

/** Takes back one thing: what was chosen last. */
function leave(): void {
  if (takeTapeBack()) return;
  if (selectedPrimitive.value) selectedPrimitive.value = undefined;
  else if (alone.value) alone.value = false;
  else if (!takeBrushBack() && !takeAsideBack()) takeCutBack();
}

function stopWork(): void {
  stopRebuilding();
  cancelScoring();
  cancelFitting();
}

export const KEYS: readonly ShortcutGroup[] = [
  {
    title: "Everywhere",
    shortcuts: [
      { key: "?", what: "Show these keys", run: () => (keysShown.value = true) },
      { key: "o", shown: "O", what: "Add data", run: () => (adding.value = true) },
      { key: "s", shown: "S", what: "Share and export", run: () => (sharing.value = true) },
      { key: "c", shown: "C", what: "Save a picture of the view", run: () => (picturing.value = currentView.value !== undefined) },
      { key: "v", shown: "V", what: "Show the picture alone, or beside the tables", run: toggleAlone },
      { key: "d", shown: "D", what: "Fold the tables, or open them", run: toggleTables },
      { key: "e", shown: "E", what: "Measure between points that are clicked", run: toggleMeasuring },
      { key: "p", shown: "P", what: "Switch the protocol", run: toggleProtocol },
      { key: "t", shown: "T", what: "Change the theme", run: nextTheme },
      { key: "x", shown: "X", what: "Stop scoring and fitting", run: stopWork },
    ],
  },
  {
    title: "Selected primitive",
    shortcuts: [
      { key: "f", shown: "F", what: "Frame it, or everything", run: frameSelected },
      { key: "i", shown: "I", what: "Isolate it", run: toggleIsolated },
      { key: "h", shown: "H", what: "Hide it", run: hideSelected },
      { key: "l", shown: "L", what: "Lock it against clicks in the picture, or unlock it", run: lockSelected },
      { key: "a", shown: "A", what: "Show all again", run: showAll },
      { key: "Escape", shown: "Esc", what: "Take back the last point measured, the selection, the picture alone, the range of distances, what is hidden, what is locked, the clipping box, the cut", run: leave },
    ],
  },
  {
    title: "Models",
    shortcuts: [
      { key: "/", what: "Search the models", run: focusSearch },
      { key: "[", what: "Previous model", run: () => stepModel(-1) },
      { key: "]", what: "Next model", run: () => stepModel(1) },
      { key: "m", shown: "M", what: "Next method of this model", run: nextMethod },
    ],
  },
  {
    title: "Panels",
    shortcuts: PANELS.slice(0, 10).map(({ id, title, offered }, i) => ({
      key: String((i + 1) % 10),
      what: offered ? `${title}, where a link is open` : title,
      run: () => {
        if (offered?.() ?? true) showPanel(id);
      },
    })),
  },
];
