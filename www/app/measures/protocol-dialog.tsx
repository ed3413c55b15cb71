// The two protocols in plain words, fetched when they are first asked for.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";
import { goToPanel } from "../state/panels";
import { goTo, HOME } from "../state/router";

export const protocolShown = signal(false);

const load: Load = () => import("./protocol-sheet");

export function ProtocolDialog(): JSX.Element {
  return (
    <Dialog open={protocolShown} title="Two protocols" className="protocols">
      <Lazy load={load} title="the protocols" />
    </Dialog>
  );
}

/** Shows the submissions by every protocol. */
export function compareAll(): void {
  protocolShown.value = false;
  goTo(HOME);
  goToPanel("field");
}
