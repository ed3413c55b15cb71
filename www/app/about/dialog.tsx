// The sheet that says what this is. What is in it is fetched when it is first opened.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Dialog } from "../ui/dialog";
import { Lazy, type Load } from "../ui/lazy";

export const aboutShown = signal(false);

const load: Load = () => import("./sheet");

export function AboutDialog(): JSX.Element {
  return (
    <Dialog open={aboutShown} title="About" className="about">
      <Lazy load={load} title="the text" />
    </Dialog>
  );
}
