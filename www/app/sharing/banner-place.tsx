// Where the banner of a link stands. It is fetched with the part of the page that reads links.

import type { JSX } from "preact";
import { Lazy, type Load } from "../ui/lazy";
import { opened } from "./state";

const load: Load = () => import("./banner");

export function SharedBanner(): JSX.Element | null {
  return opened.value.kind === "none" ? null : <Lazy load={load} title="the link" />;
}
