// The sheet that lists the keys.

import type { JSX } from "preact";
import { aboutShown } from "../about/dialog";
import { KEYS } from "../shell/keys";
import { keysOn, type ShortcutGroup } from "./shortcuts";
import { keysShown } from "./shown";

interface Explained {
  readonly title: string;
  readonly keys: readonly (readonly [keys: string, what: string])[];
}

/** What tables and the view listen to themselves, while they have the focus. */
const ELSEWHERE: readonly Explained[] = [
  {
    title: "In tables and lists",
    keys: [
      ["↑ ↓", "Walk the rows"],
      ["Page ↑ ↓", "A screen up, down"],
      ["Home End", "First and last row"],
      ["Enter", "Select the row"],
    ],
  },
  {
    title: "In the primitives by type",
    keys: [
      ["↑ ↓", "Walk the types and primitives"],
      ["← →", "Name, eye, lock and “Only” of a row"],
      ["Enter", "Fold, select, hide, lock or show only it"],
    ],
  },
  {
    title: "In the chart of distances",
    keys: [
      ["← →", "Move a handle of the range by a bar; Page ↑ ↓ by four"],
      ["Esc", "Show all points in their colours again"],
    ],
  },
  {
    title: "In the view",
    keys: [
      ["← ↑ → ↓", "Turn; with Shift, move"],
      ["+ −", "Enlarge, reduce"],
      [", .", "Roll"],
      ["1 … 7", "Look from a side"],
      ["0", "Frame everything"],
      ["O", "Orthographic or perspective"],
    ],
  },
];

export default function KeySheet(): JSX.Element {
  return (
    <>
      <div class="key-groups">
        {[...KEYS.map(explained), ...ELSEWHERE].map(({ title, keys }) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {keys.map(([key, what]) => (
                <div key={what}>
                  <dt>
                    <kbd>{key}</kbd>
                  </dt>
                  <dd>{what}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
      <label class="check">
        <input
          type="checkbox"
          checked={keysOn.value === "on"}
          onChange={(event) => (keysOn.value = event.currentTarget.checked ? "on" : "off")}
        />
        Single-key shortcuts
      </label>
      <p>
        <button
          type="button"
          class="link"
          onClick={() => {
            keysShown.value = false;
            aboutShown.value = true;
          }}
        >
          About the playground: the paper, how to cite, licence, privacy
        </button>
      </p>
    </>
  );
}

function explained({ title, shortcuts }: ShortcutGroup): Explained {
  return { title, keys: shortcuts.map(({ key, shown, what }) => [shown ?? key, what]) };
}
