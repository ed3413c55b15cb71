// The pages, and the panels of the scoring page. A new one is a line here and a folder of its own.

import type { ComponentChildren } from "preact";
import type { Load } from "../ui/lazy";
import { HOME, type PageDefinition } from "./router";
import { diagnosticsBadge } from "../diagnostics/badge";

export interface PanelDefinition {
  readonly id: string;
  readonly title: string;
  /** A figure or mark beside the title; may read signals. */
  readonly badge?: () => ComponentChildren;
  readonly load: Load;
}

export const PAGES: readonly PageDefinition[] = [
  { id: HOME, title: "Score", load: () => import("./workspace") },
];

export const PANELS: readonly PanelDefinition[] = [
  { id: "measures", title: "Measures", load: () => import("../scores/panel") },
  { id: "primitives", title: "Primitives", load: () => import("../primitives/panel") },
  { id: "overlooked", title: "Overlooked", load: () => import("../overlooked/panel") },
  { id: "diagnostics", title: "Diagnostics", badge: diagnosticsBadge, load: () => import("../diagnostics/panel") },
  { id: "files", title: "Files", load: () => import("../files/panel") },
];
