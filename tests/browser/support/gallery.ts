// Leafs through the pictures that the tests have taken: tests/screenshots/index.html.

import { existsSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const FOLDER = join(import.meta.dirname, "../../screenshots");

/** Runs once, after all tests. */
export default function writeGallery(): void {
  if (!existsSync(FOLDER)) return;
  const names = readdirSync(FOLDER)
    .filter((name) => name.endsWith(".png"))
    .map((name) => name.slice(0, -".png".length))
    .sort();
  const groupOf = (name: string) => /^[a-z]+/i.exec(name)?.[0] ?? name;
  const sections = [...new Set(names.map(groupOf))].map((title) => {
    const figures = names.filter((name) => groupOf(name) === title).map((name) => {
      const address = `${encodeURIComponent(name)}.png`;
      return `<figure><a href="${address}"><img src="${address}" alt="" loading="lazy"></a><figcaption>${escaped(name)}</figcaption></figure>`;
    });
    return `<section><h2>${escaped(title)}</h2>${figures.join("\n")}</section>`;
  });
  writeFileSync(join(FOLDER, "index.html"), PAGE.replace("<!-- pictures -->", () => sections.join("\n")));
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

const PAGE = `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <meta name="color-scheme" content="light dark">
    <title>Fit4CAD Playground: the page in its states</title>
    <style>
      body { max-width: 90rem; margin: 1rem auto; padding: 0 1rem; font: 0.9rem system-ui, sans-serif; }
      section { display: grid; grid-template-columns: repeat(auto-fill, minmax(18rem, 1fr)); gap: 1rem; align-items: start; }
      h2 { grid-column: 1 / -1; margin: 1rem 0 0; font-size: 1rem; }
      figure { margin: 0; }
      img { max-width: 100%; max-height: 24rem; border: 1px solid #8888; }
    </style>
  </head>
  <body>
    <h1>The page in its states</h1>
    <!-- pictures -->
  </body>
</html>
`;
