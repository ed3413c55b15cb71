import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { commandLine } = await pageModule("export/command.ts");

const onScreen = (change) => ({ paths: [], samples: [], protocol: "definition", ...change });

/** The arguments of each call of `fit4cad` in a line, as a POSIX shell understands it. */
function understood(line) {
  const script = `fit4cad() { for word in "$@"; do printf '%s\\0' "$word"; done; printf '\\n\\0'; }\n${line}`;
  const { stdout, stderr } = spawnSync("sh", ["-c", script], { encoding: "utf8" });
  assert.equal(stderr, "");
  const calls = [[]];
  for (const word of stdout.split("\0").slice(0, -1)) {
    if (word === "\n") calls.push([]);
    else calls.at(-1).push(word);
  }
  return calls.slice(0, -1);
}

test("folders and zips are named once, loose files each", () => {
  const paths = ["set/PC1.txt", "set/HT/PC1_primitives.txt", "more.zip/PC2.txt", "PC10.txt", "PC9.txt"];
  assert.equal(commandLine(onScreen({ paths })), "fit4cad score more.zip PC9.txt PC10.txt set");
});

test("the protocol is said where it is not the default", () => {
  const line = commandLine(onScreen({ paths: ["PC1.txt"], protocol: "published" }));
  assert.equal(line, "fit4cad score PC1.txt --protocol published");
});

test("a sample is made first, with what was said about it and nothing else", () => {
  const samples = [{ part: "flange", options: { noise: 0.001, seed: 3 } }];
  assert.deepEqual(understood(commandLine(onScreen({ samples, paths: ["mine/PC1.txt"] }))), [
    ["generate", "flange", "--seed", "3", "--noise", "0.001", "--imperfect", "--out", "flange"],
    ["score", "flange", "mine"],
  ]);
});

test("whatever a folder is called, the shell takes it for one name", () => {
  const names = ["my results", "it's", "$(touch x)", "`x`", "a;b", "a&&b", "*", "~", "#1", "größe", 'say "x"', "a\nb", "back\\slash", "!x"];
  for (const name of names) {
    const line = commandLine(onScreen({ paths: [`${name}/PC1.txt`] }));
    assert.deepEqual(understood(line), [["score", name]], line);
  }
  assert.deepEqual(understood(commandLine(onScreen({ paths: ["--format/PC1.txt"] }))), [["score", "./--format"]]);
});

test("nothing on screen gives no line", () => {
  assert.equal(commandLine(onScreen()), undefined);
});
