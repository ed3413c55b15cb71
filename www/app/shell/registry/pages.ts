// The pages. A new one is a line here and a folder of its own.

import { HOME } from "../../state/router";
import type { Load } from "../../ui/lazy";

export interface PageDefinition {
  readonly id: string;
  readonly title: string;
  readonly load: Load;
  /** The page whose link stands for this one in the header. */
  readonly under?: string;
  /** Whether it is about the models on the page: only then does a first visit find a sample there. */
  readonly showsModels?: true;
}

export const PAGES: readonly PageDefinition[] = [
  { id: HOME, title: "Score", showsModels: true, load: () => import("../workspace") },
  { id: "results", title: "Results", load: () => import("../../results/page") },
  { id: "lessons", title: "Lessons", load: () => import("../../lessons/index") },
  { id: "lesson-score", title: "What a score means", under: "lessons", load: () => import("../../lessons/score/page") },
  { id: "lesson-hough", title: "The Hough transform", under: "lessons", load: () => import("../../lessons/hough/page") },
  { id: "lesson-growing", title: "Primitive growing", under: "lessons", load: () => import("../../lessons/growing/page") },
  { id: "lesson-forms", title: "Implicit and parametric", under: "lessons", load: () => import("../../lessons/forms/page") },
  { id: "lesson-protocols", title: "How to win by protocol", under: "lessons", load: () => import("../../lessons/protocols/page") },
  { id: "lesson-cad", title: "From a drawing to a score", under: "lessons", load: () => import("../../lessons/cad/page") },
  { id: "studio", title: "Studio", load: () => import("../../studio/page") },
  { id: "statistics", title: "Statistics", showsModels: true, load: () => import("../../statistics/page") },
];
