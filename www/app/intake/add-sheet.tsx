// The ways to bring data.

import type { JSX } from "preact";
import { FILE_KINDS } from "../../generated/declared/file-kinds.js";
import { STEP_ENDINGS } from "../../shared/step.mjs";
import { PublicForm } from "../public/form";
import { SampleForm } from "../samples/form";
import { adding } from "./add-dialog";
import { takeChosen } from "./intake";
import { PasteForm } from "./paste";

export default function AddSheet(): JSX.Element {
  return (
    <>
      <section>
        <h3>Your files</h3>
        <p>
          Point clouds, ground truth and results: single files, folders, or zips, also the zip of the whole public
          repository. Drop them anywhere on the page, or choose them here. They are read in your browser and never
          leave it.
        </p>
        <details>
          <summary>What is read</summary>
          <dl class="kinds">
            {FILE_KINDS.map(({ endings, title, meaning }) => (
              <div key={title}>
                <dt>
                  {title} <code>{endings.map((ending) => `.${ending}`).join(" ")}</code>
                </dt>
                <dd>{meaning}</dd>
              </div>
            ))}
            <div>
              <dt>
                STEP <code>{STEP_ENDINGS.map((ending) => `.${ending}`).join(" ")}</code>
              </dt>
              <dd>a part from CAD becomes a model: points exactly on its faces, evenly spread, and the truth of which face each is of</dd>
            </div>
          </dl>
        </details>
        <div class="row">
          <Chooser label="Choose files or zips" />
          <Chooser label="Choose a folder" folder />
        </div>
      </section>
      <section>
        <h3>Public models by number</h3>
        <PublicForm onTaken={() => (adding.value = false)} />
      </section>
      <section>
        <h3>A sample part</h3>
        <SampleForm onMade={() => (adding.value = false)} />
      </section>
      <section>
        <h3>Paste text</h3>
        <PasteForm onTaken={() => (adding.value = false)} />
      </section>
    </>
  );
}

/** What a chooser of files offers; what it holds is told by its content. */
const ACCEPTED = [...FILE_KINDS.flatMap(({ endings }) => endings), ...STEP_ENDINGS, "zip"].map((ending) => `.${ending}`).join(",");

function Chooser({ label, folder = false }: { label: string; folder?: boolean }): JSX.Element {
  return (
    <label class="button">
      {label}
      <input
        type="file"
        class="visually-hidden"
        multiple
        {...(folder ? { webkitdirectory: true } : { accept: ACCEPTED })}
        onChange={(event) => {
          const input = event.currentTarget;
          if (!input.files || input.files.length === 0) return;
          adding.value = false;
          // The list empties with the input, which must be empty for the same files to be chosen again.
          void takeChosen(input.files).finally(() => (input.value = ""));
        }}
      />
    </label>
  );
}
