// The scoring page: models, views, panels.

import type { JSX } from "preact";
import { ModelList } from "../models/list";
import { Stage } from "../stage/stage";
import { Panels } from "./panels";

export default function Workspace(): JSX.Element {
  return (
    <div class="workspace">
      <ModelList />
      <Stage />
      <Panels />
    </div>
  );
}
