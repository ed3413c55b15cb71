// @ts-check
// What methods are told apart by.

export const KINDS = /** @type {const} */ ([
  { name: "hough", title: "Hough transform" },
  { name: "growing", title: "Region growing" },
  { name: "ransac", title: "RANSAC" },
  { name: "learned", title: "Learned" },
  { name: "other", title: "Other" },
]);

/**
 * What a kind is called.
 * @param {(typeof KINDS)[number]["name"]} kind
 */
export function titleOfKind(kind) {
  return KINDS.find(({ name }) => name === kind)?.title ?? kind;
}
