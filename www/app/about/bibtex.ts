// A work as a bibliography has it: a line to read, and an entry for BibTeX.

import type { Work } from "../../../CITATION.cff";

/** Authors, title, journal or version, year. */
export function lineOf(work: Work): string {
  const names = work.authors.map((author) => ("name" in author ? author.name : `${initials(author["given-names"])} ${author["family-names"]}`));
  const place = [work.journal, work.volume && String(work.volume), work.version && `version ${work.version}`, yearOf(work)];
  return `${names.join(", ")}: ${work.title}${work.journal ? "." : ","} ${place.filter((part) => part).join(", ")}.`;
}

export function bibtexOf(work: Work): string {
  const fields: readonly (readonly [name: string, value: string | undefined])[] = [
    ["author", work.authors.map(bibtexName).join(" and ")],
    // A second pair of braces keeps the capitals.
    ["title", `{${escaped(work.title)}}`],
    ["journal", work.journal && escaped(work.journal)],
    ["volume", work.volume?.toString()],
    ["pages", work.start && work.end ? `${work.start}--${work.end}` : undefined],
    ["year", yearOf(work)],
    ["doi", work.doi],
    ["version", work.version],
    ["url", work["repository-code"] ?? work.url],
  ];
  const lines = fields.flatMap(([name, value]) => (value ? [`  ${name} = {${value}}`] : []));
  return `@${work.type === "article" ? "article" : "software"}{${keyOf(work)},\n${lines.join(",\n")}\n}\n`;
}

function yearOf(work: Work): string | undefined {
  return work.year?.toString() ?? work["date-released"]?.slice(0, 4);
}

/** The first author's name, the year and the first word of the title: `romanengo2022fit4cad`. */
function keyOf(work: Work): string {
  const [first] = work.authors;
  const name = first && !("name" in first) ? first["family-names"] : "";
  const [word = ""] = work.title.split(/[^\p{L}\p{N}]+/u);
  return `${name}${yearOf(work) ?? ""}${word}`.toLowerCase();
}

function bibtexName(author: Work["authors"][number]): string {
  // A group's name is not one of a person: braces keep it whole.
  return "name" in author ? `{${escaped(author.name)}}` : `${escaped(author["family-names"])}, ${escaped(author["given-names"])}`;
}

/** What means something else to TeX. */
function escaped(text: string): string {
  return text.replace(/[&%$#_{}]/g, "\\$&");
}

function initials(given: string): string {
  return given.split(/\s+/).map((name) => `${name[0]}.`).join(" ");
}
