// The panels of the scoring page. A new one is a line here and a folder of its own.

import type { ComponentChildren } from "preact";
import type { Load } from "../../ui/lazy";
import { diagnosticsBadge } from "../../diagnostics/badge";
import { sharedBadge } from "../../sharing/badge";
import { isLinkOpen, SHARED_PANEL } from "../../sharing/opened";

export interface PanelDefinition {
  readonly id: string;
  readonly title: string;
  /** A figure or mark beside the title; may read signals. */
  readonly badge?: () => ComponentChildren;
  /** Whether there is anything to show just now; may read signals. */
  readonly offered?: () => boolean;
  readonly load: Load;
}

export const PANELS: readonly PanelDefinition[] = [
  { id: "measures", title: "Measures", load: () => import("../../scores/panel") },
  { id: "primitives", title: "Primitives", load: () => import("../../primitives/panel") },
  { id: "overlooked", title: "Overlooked", load: () => import("../../overlooked/panel") },
  { id: "charts", title: "Charts", load: () => import("../../charts/panel") },
  { id: "fit", title: "Fit", load: () => import("../../fit/panel") },
  { id: "diagnostics", title: "Diagnostics", badge: diagnosticsBadge, load: () => import("../../diagnostics/panel") },
  { id: "audit", title: "Audit", load: () => import("../../audit/panel") },
  { id: "comparison", title: "Comparison", load: () => import("../../comparison/panel") },
  { id: "field", title: "Protocols", load: () => import("../../field/panel") },
  { id: "files", title: "Files", load: () => import("../../files/panel") },
  { id: SHARED_PANEL, title: "Shared", offered: isLinkOpen, badge: sharedBadge, load: () => import("../../sharing/panel") },
];
