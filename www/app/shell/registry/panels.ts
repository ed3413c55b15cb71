// The panels of the scoring page. A new one is a line here and a folder of its own.

import type { ComponentChildren } from "preact";
import type { Load } from "../../ui/lazy";
import { diagnosticsBadge } from "../../diagnostics/badge";
import { sharedBadge } from "../../sharing/badge";
import { anyStep, CAD_PANEL } from "../../state/step";
import { isLinkOpen, SHARED_PANEL } from "../../sharing/state";

export interface PanelDefinition {
  readonly id: string;
  readonly title: string;
  /** What it is for, in a line. */
  readonly what: string;
  /** A figure or mark beside the title; may read signals. */
  readonly badge?: () => ComponentChildren;
  /** Whether there is anything to show just now; may read signals. */
  readonly offered?: () => boolean;
  readonly load: Load;
}

export const PANELS: readonly PanelDefinition[] = [
  { id: "measures", title: "Measures", what: "The nine measures of every submission", load: () => import("../../scores/panel") },
  { id: "primitives", title: "Primitives", what: "Every primitive, true and found: its figures, surface and points", load: () => import("../../primitives/panel") },
  { id: "overlooked", title: "Overlooked", what: "What no measure shows: pieces too many, primitives shared or missed, points in none", load: () => import("../../overlooked/panel") },
  { id: "charts", title: "Charts", what: "How measures and distances are spread", load: () => import("../../charts/panel") },
  { id: "fit", title: "Fit", what: "Find the primitives of a cloud here", load: () => import("../../fit/panel") },
  { id: "diagnostics", title: "Diagnostics", what: "What is wrong with the files, and what to do", badge: diagnosticsBadge, load: () => import("../../diagnostics/panel") },
  { id: "audit", title: "Audit", what: "Whether a ground truth says what its points say", load: () => import("../../audit/panel") },
  { id: "comparison", title: "Comparison", what: "Two methods, model by model", load: () => import("../../comparison/panel") },
  { id: "field", title: "Protocols", what: "The same results by the rules of the field", load: () => import("../../field/panel") },
  { id: CAD_PANEL, title: "From CAD", what: "The faces of a STEP file: what became of each, and importing it in another way", offered: () => anyStep.value, load: () => import("../../cad/panel") },
  { id: "section", title: "Section", what: "A cross-section: the points near the cut, and the fitted curves through them", load: () => import("../../section/panel") },
  { id: "files", title: "Files", what: "Which file is taken for what, to be corrected", load: () => import("../../files/panel") },
  { id: SHARED_PANEL, title: "Shared", what: "What the link of this page holds, and whether it is borne out", offered: isLinkOpen, badge: sharedBadge, load: () => import("../../sharing/panel") },
];
