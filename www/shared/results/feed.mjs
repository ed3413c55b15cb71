// @ts-check
// What changed in the standing table, as a JSON Feed (version 1.1): built from what the folders say.

/** @typedef {import("./method.mjs").Method} Method */

/**
 * @param {readonly { id: string, method: Method, sets: readonly string[] }[]} rows
 * @param {string} home address of the page, ending in a slash; relative where it is not known
 */
export function feedOf(rows, home) {
  const items = rows.flatMap(({ id, method, sets }) => {
    const url = addressOf(home, id);
    const scored = sets.length > 0 ? ` Scored on ${sets.join(", ")}.` : "";
    const of = (/** @type {string} */ day, /** @type {string} */ key, /** @type {string} */ title, /** @type {string} */ text) => ({
      id: `${url}#${key}`,
      url,
      title,
      content_text: text,
      date_published: `${day}T00:00:00Z`,
    });
    return [
      of(method.added, "added", `${method.name} is in the table`, `${authorsOf(method)}, ${method.year}.${scored}`),
      ...method.changes.map(({ day, what }, at) => of(day, `change-${at + 1}`, `${method.name} changed`, what)),
    ];
  });
  items.sort((one, other) => other.date_published.localeCompare(one.date_published) || one.id.localeCompare(other.id));
  const feed = {
    version: "https://jsonfeed.org/version/1.1",
    title: "Fit4CAD Playground: results",
    home_page_url: `${home}?page=results`,
    feed_url: `${home}results/feed.json`,
    description: "Methods that came into the standing table, and what changed in it.",
    items,
  };
  return `${JSON.stringify(feed, null, 2)}\n`;
}

/**
 * The lasting address of a row.
 * @param {string} home
 * @param {string} id
 */
export function addressOf(home, id) {
  return `${home}?page=results&method=${id}`;
}

/**
 * Its authors in a line.
 * @param {Pick<Method, "authors">} method
 */
export function authorsOf({ authors }) {
  return authors.map((author) => ("name" in author ? author.name : `${author.given} ${author.family}`)).join(", ");
}
