// The sheet to share and export. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";
import { sharing } from "./share";

const load: Load = () => import("./sheet");

export function ShareDialog(): JSX.Element {
  return (
    <Dialog open={sharing} title="Share and export" className="share">
      <Lazy load={load} title="sharing" />
    </Dialog>
  );
}
