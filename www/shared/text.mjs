// @ts-check
// Names come from files and folders and may hold anything: what is shown of them.

/**
 * The text without the control characters that move a terminal's cursor or change its colours; tabs
 * and line ends stay.
 * @param {string} text
 */
export function printable(text) {
  // eslint-disable-next-line no-control-regex -- they are what is removed
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/g, "\ufffd");
}

/**
 * A clause as a sentence.
 * @param {string} clause
 */
export function sentence(clause) {
  return `${clause.charAt(0).toUpperCase()}${clause.slice(1)}.`;
}

/**
 * The text in one line: nothing in it ends a row, a comment or a cell.
 * @param {string} text
 */
export function oneLine(text) {
  // eslint-disable-next-line no-control-regex -- they are what is removed
  return text.replace(/[\u0000-\u001f\u007f-\u009f\u2028\u2029]/g, "\ufffd");
}
