// @ts-check

/** The methods whose results for the test set the public repository has. */
export const PUBLISHED_METHODS = /** @type {const} */ (["HT", "PG"]);

/** @typedef {(typeof PUBLISHED_METHODS)[number]} PublishedMethod */
