// Versions of the engine, as a link has them.

/** A version as Cargo writes it; a link may have any text there. */
const VERSION = /^\d{1,9}\.\d{1,9}\.\d{1,9}(?:[-+][\w.+-]{1,32})?$/;

/** The version, to stand in a sentence. */
export function versionWords(engine: string): string {
  return VERSION.test(engine) ? `engine ${engine}` : "an engine that does not tell its version";
}
