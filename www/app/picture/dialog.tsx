// The sheet to save a picture. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { picturing } from "../stage/current";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";

const load: Load = () => import("./sheet");

export function PictureDialog(): JSX.Element {
  return (
    <Dialog open={picturing} title="Save a picture" className="save-picture">
      <Lazy load={load} title="the picture" />
    </Dialog>
  );
}
