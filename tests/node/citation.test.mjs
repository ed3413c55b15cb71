// What the page says of how to cite it, from CITATION.cff.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { parse } from "yaml";
import { ROOT } from "../../scripts/lib/paths.mjs";
import { pageModule } from "./page.mjs";

const { bibtexOf, lineOf } = await pageModule("about/bibtex.ts");
const citation = parse(readFileSync(join(ROOT, "CITATION.cff"), "utf8"));

test("the paper is an article, with capitals kept and signs of TeX escaped", () => {
  assert.equal(
    bibtexOf(citation["preferred-citation"]).replace(/^ {2}(volume|pages) = .*\n/gm, ""),
    `@article{romanengo2022fit4cad,
  author = {Romanengo, Chiara and Raffo, Andrea and Qie, Yifan and Anwer, Nabil and Falcidieno, Bianca},
  title = {{Fit4CAD: A point cloud benchmark for fitting simple geometric primitives in CAD objects}},
  journal = {Computers \\& Graphics},
  year = {2022},
  doi = {10.1016/j.cag.2021.09.013}
}
`,
  );
});

test("the playground is software, with its version", () => {
  assert.match(bibtexOf(citation), /^@software\{\d{4}fit4cad,\n {2}author = \{\{The Fit4CAD Playground authors\}\},\n/);
  assert.ok(bibtexOf(citation).includes(`  version = {${citation.version}}`));
});

test("engine, package, citation and changelog are of one version", () => {
  const version = /^version = "(.+)"$/m.exec(readFileSync(join(ROOT, "Cargo.toml"), "utf8"))?.[1];
  for (const file of ["package.json", "package-lock.json"]) {
    assert.equal(JSON.parse(readFileSync(join(ROOT, file), "utf8")).version, version, file);
  }
  assert.equal(citation.version, version);
  assert.equal(/^## ([\d.]+)/m.exec(readFileSync(join(ROOT, "CHANGELOG.md"), "utf8"))?.[1], version);
});

test("a work is told in a line", () => {
  const article = { type: "article", title: "On B&Bs", authors: [{ "family-names": "Doe", "given-names": "Jo Ann" }], journal: "Acta", volume: 3, start: 7, end: 9, year: 1999 };
  assert.equal(lineOf(article), "J. A. Doe: On B&Bs. Acta, 3, 1999.");
  assert.match(bibtexOf(article), /title = \{\{On B\\&Bs\}\},\n {2}journal = \{Acta\},\n {2}volume = \{3\},\n {2}pages = \{7--9\}/);
});
