// The lessons there are, in the order to take them.

export interface LessonInfo {
  readonly id: string;
  readonly title: string;
  readonly about: string;
}

export const LESSONS: readonly LessonInfo[] = [
  {
    id: "lesson-score",
    title: "What a score means",
    about: "Paint a prediction on a part of two primitives and watch the counts and measures move.",
  },
  {
    id: "lesson-hough",
    title: "The Hough transform",
    about: "From a point's curve in parameter space to persistent peaks, a choice of type and a segmentation.",
  },
  {
    id: "lesson-growing",
    title: "Primitive growing",
    about: "Surface variation, sharp points, growing regions, and the motions that slide a region over itself.",
  },
  {
    id: "lesson-forms",
    title: "Implicit and parametric",
    about: "One surface, two vectors, and why the sign of one of them decides a published figure.",
  },
  {
    id: "lesson-protocols",
    title: "How to win by protocol",
    about: "Drop and merge the segments of a part, and watch eight evaluation scripts disagree about the result.",
  },
  {
    id: "lesson-cad",
    title: "From a drawing to a score",
    about: "Sample the faces of a CAD part as you like, fit the points, score the answer, and take it back to CAD.",
  },
];
