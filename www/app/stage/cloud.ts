// Whether two lists of coordinates are the same cloud: a model is opened anew for each submission.

export function isSameCloud(a: Float32Array, b: Float32Array): boolean {
  return a.length === b.length && a.every((value, at) => Object.is(value, b[at]));
}
