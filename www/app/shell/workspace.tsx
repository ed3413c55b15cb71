// The scoring page: models, views, panels.

import type { JSX } from "preact";
import { ModelList } from "../models/list";
import { Stage } from "../stage/stage";
import { alone, tables } from "../state/extent";
import { Panels } from "./panels";
import { Splitter, viewsShare } from "./splitter";

export default function Workspace(): JSX.Element {
  return (
    <div
      class="workspace"
      data-alone={alone.value || undefined}
      data-tables={tables.value}
      style={{ "--views": `${viewsShare.value}fr`, "--panels": `${100 - viewsShare.value}fr` }}
    >
      <ModelList />
      <Stage />
      <Splitter />
      <Panels />
    </div>
  );
}
