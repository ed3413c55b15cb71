// JSON: everything, as the engine reports it.

export function json(reports) {
  return `${JSON.stringify(reports, null, 2)}\n`;
}
