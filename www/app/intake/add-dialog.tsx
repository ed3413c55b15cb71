// The sheet that brings data. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";
import { adding } from "./adding";

const load: Load = () => import("./add-sheet");

export function AddDialog(): JSX.Element {
  return (
    <Dialog open={adding} title="Add data" className="add">
      <Lazy load={load} title="the ways to bring data" />
    </Dialog>
  );
}
