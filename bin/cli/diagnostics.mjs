// How a diagnostic reads in the terminal.

/** `file:line:column: severity: message (found …, expected …). hint` */
export function inOneLine({ severity, file, line, column, message, found, expected, hint }) {
  const place = line === undefined || line === null ? "" : `:${line}:${column}`;
  const details = [found && `found ${found}`, expected && `expected ${expected}`].filter(Boolean);
  const detail = details.length > 0 ? ` (${details.join(", ")})` : "";
  return `${file}${place}: ${severity}: ${message}${detail}${hint ? `. ${hint}` : ""}`;
}
