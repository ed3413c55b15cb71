// The sheet that lists the keys. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";
import { keysShown } from "./shown";

const load: Load = () => import("./sheet");

export function KeyDialog(): JSX.Element {
  return (
    <Dialog open={keysShown} title="Keyboard" className="keys">
      <Lazy load={load} title="the keys" />
    </Dialog>
  );
}
