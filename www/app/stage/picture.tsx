// The selected model's points.

import type { JSX } from "preact";
import { scene } from "../state/scene";

export function Picture(): JSX.Element {
  const state = scene.value;
  return <p class="empty">{state.kind}</p>;
}
