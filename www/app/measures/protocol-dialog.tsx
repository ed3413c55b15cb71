// The sheet on the two protocols. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";
import { protocolShown } from "./protocol-shown";

const load: Load = () => import("./protocol-sheet");

export function ProtocolDialog(): JSX.Element {
  return (
    <Dialog open={protocolShown} title="Two protocols" className="protocols">
      <Lazy load={load} title="what they are" />
    </Dialog>
  );
}
