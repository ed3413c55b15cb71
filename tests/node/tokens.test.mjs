// The sheet of the page's few values (www/styles/tokens.css): complete in both themes, all of it used, nothing used
// that is not in it, and every ink readable on its ground.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

const ROOT = join(import.meta.dirname, "../..");
const SHEET = "www/styles/tokens.css";
/** Without what more contrast changes. */
const [sheet = ""] = readFileSync(join(ROOT, SHEET), "utf8").split("@media");

/** Names and values that a block of the sheet sets, by what its selector ends with. @param {string} selector */
function block(selector) {
  const rules = [...sheet.matchAll(/([^{}]+)\{([^{}]*)\}/g)].filter(([, head = ""]) => head.trim().endsWith(selector));
  return new Map(rules.flatMap(([, , body = ""]) => [...body.matchAll(/(--[a-z-]+):\s*([^;]+);/g)].map(([, name = "", value = ""]) => [name, value])));
}

const [sizes, light, dark] = [block(":root"), block('[data-theme="light"]'), block(':root[data-theme="dark"]')];

/** Everything of the page that may use a value, but the sheet. */
const sources = ["www/styles", "www/app"].flatMap((folder) =>
  readdirSync(join(ROOT, folder), { recursive: true, encoding: "utf8" })
    .filter((path) => /\.(css|tsx?)$/.test(path))
    .map((path) => ({ path: join(folder, path), text: readFileSync(join(ROOT, folder, path), "utf8") })),
).filter(({ path }) => path !== SHEET);

test("the dark theme sets what the light one sets", () => {
  assert.ok(sizes.size > 5 && light.size >= 20);
  assert.deepEqual([...dark.keys()].sort(), [...light.keys()].sort());
});

test("what is used is in the sheet or set by an element, and what is in the sheet is used", () => {
  const known = new Set([...sizes.keys(), ...light.keys()]);
  const all = sources.map(({ text }) => text).join("\n");
  for (const { path, text } of sources) {
    for (const [, name = ""] of text.matchAll(/var\((--[a-z-]+)/g)) {
      const isSet = known.has(name) || new RegExp(`["']${name}["']`).test(all);
      assert.ok(isSet, `${path} uses ${name}, which neither ${SHEET} nor an element sets`);
    }
  }
  for (const name of known) assert.ok(new RegExp(`(var\\(${name}|["']${name}["'])`).test(all), `nothing uses ${name}`);
});

/** Relative luminance (WCAG 2). @param {string} hex */
function luminance(hex) {
  const channels = [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255);
  const [r = 0, g = 0, b = 0] = channels.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

test("every ink is readable on its grounds, in both themes", () => {
  const grounds = ["--page", "--surface", "--raised", "--stage"];
  const pairs = [
    ...["--ink", "--ink-soft", "--accent", "--error", "--warning", "--good"].flatMap((ink) => grounds.map((ground) => [ink, ground])),
    ...["--error", "--warning", "--good", "--accent"].map((ink) => [ink, `${ink}-soft`]),
    ["--ink", "--hover"],
    ["--ink-soft", "--hover"],
    ["--accent-ink", "--accent"],
  ];
  for (const [theme, values] of /** @type {const} */ ([["light", light], ["dark", dark]])) {
    for (const [ink = "", ground = ""] of pairs) {
      const [a, b] = [luminance(values.get(ink) ?? ""), luminance(values.get(ground) ?? "")];
      const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      assert.ok(contrast >= 4.5, `${ink} on ${ground}, ${theme}: ${contrast.toFixed(2)}`);
    }
  }
});
