// The sheet that lists the keys.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { aboutShown } from "../about/dialog";
import { Dialog } from "../ui/dialog";
import { keysOn, type ShortcutGroup } from "./shortcuts";

export const keysShown = signal(false);

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

export function KeySheet({ groups }: { groups: readonly ShortcutGroup[] }): JSX.Element {
  return (
    <Dialog open={keysShown} title="Keyboard" className="keys">
      <div class="key-groups">
        {[...groups.map(explained), ...ELSEWHERE].map(({ title, keys }) => (
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
    </Dialog>
  );
}

function explained({ title, shortcuts }: ShortcutGroup): Explained {
  return { title, keys: shortcuts.map(({ key, shown, what }) => [shown ?? key, what]) };
}
