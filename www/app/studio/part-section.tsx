// What the case is made of: blocks, a sample part, or a model on the page.

import type { JSX } from "preact";
import { PARTS } from "../../generated/declared/parts.js";
import { truthOnly } from "../state/content";
import { models } from "../state/models";
import { BlockList } from "./block-list";
import { FIRST, type Base } from "./case";
import { current, edit } from "./state";

export function PartSection(): JSX.Element {
  const { name, base } = current.value;
  const chosen = choiceOf(base);
  const loaded = models.value.filter(({ source }) => source.files.some(({ role }) => role === "cloud"));
  // A model taken off the page is still the case's; one that only got other submissions is the same.
  const gone = base.kind === "files" && !loaded.some(({ source }) => truthOnly(source).key === base.source.key);

  const choose = (choice: string) => {
    const [kind = "", ...rest] = choice.split(":");
    const which = rest.join(":");
    if (kind === "blocks") {
      edit({ ...FIRST, sampling: current.value.sampling }, "Begin with blocks");
    } else if (kind === "sample") {
      edit({ name: which, base: { kind: "sample", part: which }, cuts: [] }, `Open ${which}`);
    } else {
      const entry = loaded.find(({ id }) => id === which);
      if (entry) edit({ name: `${entry.id.split("/").at(-1)}-case`, base: { kind: "files", source: truthOnly(entry.source) }, cuts: [] }, `Open ${entry.id}`);
    }
  };

  return (
    <section aria-labelledby="studio-part">
      <h3 id="studio-part">Part</h3>
      <div class="studio-fields wide">
        <label>
          <span>Made of</span>
          <select value={chosen} onChange={(event) => choose(event.currentTarget.value)}>
            <option value="blocks">Building blocks</option>
            <optgroup label="Sample parts">
              {PARTS.map(({ name: part, title }) => (
                <option key={part} value={`sample:${part}`}>
                  {title}
                </option>
              ))}
              {base.kind === "sample" && !PARTS.some(({ name: part }) => part === base.part) && (
                <option value={chosen}>{base.part}</option>
              )}
            </optgroup>
            {(loaded.length > 0 || gone) && (
              <optgroup label="Models on the page">
                {loaded.map(({ id }) => (
                  <option key={id} value={`files:${id}`}>
                    {id}
                  </option>
                ))}
                {gone && <option value={chosen}>{base.source.name}</option>}
              </optgroup>
            )}
          </select>
        </label>
        <label>
          <span>Name</span>
          <input
            type="text"
            value={name}
            maxLength={60}
            spellcheck={false}
            data-committed={name}
            onChange={(event) => {
              const given = event.currentTarget.value.trim();
              if (given === "") event.currentTarget.value = name;
              else edit({ name: given }, `Name it ${given}`);
            }}
          />
        </label>
      </div>
      {base.kind === "blocks" ? (
        <BlockList blocks={base.blocks} />
      ) : (
        <p class="hint">
          {base.kind === "files"
            ? "Its points and ground truth are taken as they are; noise and outliers come on top."
            : PARTS.find(({ name: part }) => part === base.part)?.description}
        </p>
      )}
      {base.kind !== "files" && <p class="hint">Drop files anywhere on the page to have your own models among the choices.</p>}
    </section>
  );
}

function choiceOf(base: Base): string {
  switch (base.kind) {
    case "blocks":
      return "blocks";
    case "sample":
      return `sample:${base.part}`;
    case "files":
      return `files:${base.source.name}`;
  }
}
