// The sheet that lists the keys.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Dialog } from "../ui/dialog";
import { keysOn, type ShortcutGroup } from "./shortcuts";

export const keysShown = signal(false);

const TABLES: ShortcutGroup["shortcuts"] = [
  { key: "", shown: "↑ ↓", what: "Walk the rows", run: () => undefined },
  { key: "", shown: "Enter", what: "Select the row", run: () => undefined },
];

export function KeySheet({ groups }: { groups: readonly ShortcutGroup[] }): JSX.Element {
  return (
    <Dialog open={keysShown} title="Keyboard" className="keys">
      <div class="key-groups">
        {[...groups, { title: "In tables", shortcuts: TABLES }].map(({ title, shortcuts }) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {shortcuts.map(({ key, shown, what }) => (
                <div key={what}>
                  <dt>
                    <kbd>{shown ?? key}</kbd>
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
    </Dialog>
  );
}
