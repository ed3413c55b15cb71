// Whether two lists say the same, whatever their blanks and marks.

/** What tells: names and numbers. Blanks, brackets and marks of assignment stand between. */
const WORD = /[^\s[\](){},;:=]+/g;

/**
 * Whether two texts hold the same names and numbers in the same order. A list with its primitives in another
 * order is another: no text tells it from a perfect answer of its own. O(length).
 */
export function sameWords(a: string, b: string): boolean {
  const others = b.matchAll(WORD);
  for (const [word] of a.matchAll(WORD)) {
    const other = others.next();
    if (other.done || !isSame(word, other.value[0])) return false;
  }
  return others.next().done === true;
}

/** Also of numbers that are written differently: `7`, `07`, `7.0`. */
function isSame(a: string, b: string): boolean {
  return a === b || Number(a) === Number(b);
}
