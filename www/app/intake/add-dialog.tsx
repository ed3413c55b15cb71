// The sheet that brings data. What is in it is fetched a while after a model is seen, or when it is first opened.

import type { JSX } from "preact";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { currentView } from "../stage/current";
import { scene } from "../state/scene";
import { Dialog } from "../ui/dialog";
import { fetchAhead, Lazy, type Load } from "../ui/lazy";
import { adding } from "./adding";

const load: Load = () => import("./add-sheet");

/** What the reader waits for comes first. */
const LATER_MS = 1000;

/** The page is for bringing data: the sheet is there though the network goes before it is opened. */
function fetchOnceSeen(): () => void {
  return effect(() => {
    if (scene.value.kind !== "ready" || !currentView.value) return undefined;
    const later = setTimeout(() => fetchAhead(load), LATER_MS);
    return () => clearTimeout(later);
  });
}

export function AddDialog(): JSX.Element {
  useEffect(fetchOnceSeen, []);
  return (
    <Dialog open={adding} title="Add data" className="add">
      <Lazy load={load} title="the ways to bring data" />
    </Dialog>
  );
}
