// Words and what they mean, in two columns for the help.

const WIDTH = 98;
const INDENT = 2;

/**
 * Lines of words and their meanings, the meanings wrapped. A word too long for its column stands on
 * a line of its own.
 * @param {readonly (readonly [word: string, meaning: string])[]} entries
 * @param {number} column where the meanings begin
 */
export function terms(entries, column) {
  const lines = entries.flatMap(([word, meaning]) => {
    const [first = "", ...others] = wrapped(meaning, WIDTH - column);
    const head = " ".repeat(INDENT) + word;
    const rest = others.map((line) => " ".repeat(column) + line);
    return head.length < column - 1
      ? [head.padEnd(column) + first, ...rest]
      : [head, " ".repeat(column) + first, ...rest];
  });
  return lines.map((line) => `${line.trimEnd()}\n`).join("");
}

/**
 * A text as lines of at most so many characters, where its words allow it.
 * @param {string} text
 * @param {number} width
 */
function wrapped(text, width) {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(" ")) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= width) {
      lines[lines.length - 1] = `${last} ${word}`;
    } else {
      lines.push(word);
    }
  }
  return lines;
}
