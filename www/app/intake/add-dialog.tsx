// Every way to bring data, in one sheet. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";

/** Whether the sheet is shown. */
export const adding = signal(false);

const load: Load = () => import("./add-sheet");

export function AddDialog(): JSX.Element {
  return (
    <Dialog open={adding} title="Add data" className="add">
      <Lazy load={load} title="ways to add data" />
    </Dialog>
  );
}
