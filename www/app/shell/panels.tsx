// The panels under the views, one at a time, as tabs.

import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { tables, toggleTables } from "../state/extent";
import { showPanel, shownPanel, tabOf } from "../state/panels";
import { Icon } from "../ui/icon";
import { Lazy } from "../ui/lazy";
import { PANELS } from "./registry/panels";

export function Panels(): JSX.Element {
  const tabs = useRef<HTMLDivElement>(null);
  const offered = PANELS.filter((panel) => panel.offered?.() ?? true);
  const shown = offered.find(({ id }) => id === shownPanel.value) ?? offered[0];

  const open = tables.value === "open";

  // On a narrow window the tabs scroll sideways: the chosen one is kept in sight.
  useEffect(() => {
    const strip = tabs.current;
    const tab = strip?.querySelector('[aria-selected="true"]');
    if (!strip || !tab) return;
    const [around, own] = [strip.getBoundingClientRect(), tab.getBoundingClientRect()];
    if (own.left < around.left) strip.scrollLeft -= around.left - own.left;
    else if (own.right > around.right) strip.scrollLeft += own.right - around.right;
  }, [shown?.id]);

  const walk = (event: KeyboardEvent) => {
    const at = offered.findIndex(({ id }) => id === shown?.id);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: offered.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = offered[(to + offered.length) % offered.length];
    if (!next) return;
    showPanel(next.id);
    tabs.current?.querySelector<HTMLElement>(`#${tabOf(next.id)}`)?.focus();
  };

  return (
    <section class="panels" aria-label="Results">
      <div class="panels-head">
        <div class="tabs" role="tablist" aria-label="Panels" ref={tabs} onKeyDown={walk}>
          {offered.map(({ id, title, what, badge }) => (
            <button
              key={id}
              type="button"
              role="tab"
              id={tabOf(id)}
              aria-selected={id === shown?.id}
              aria-controls="panel"
              tabIndex={id === shown?.id ? 0 : -1}
              title={what}
              onClick={() => showPanel(id)}
            >
              {title}
              {badge?.()}
            </button>
          ))}
        </div>
        <button
          type="button"
          class="icon fold"
          aria-label="Tables"
          aria-expanded={open}
          title={open ? "Fold the tables (D)" : "Open the tables (D)"}
          onClick={toggleTables}
        >
          <Icon name={open ? "down" : "up"} />
        </button>
      </div>
      {shown && open && (
        <div class="panel" role="tabpanel" id="panel" aria-labelledby={tabOf(shown.id)} tabIndex={0}>
          <Lazy key={shown.id} load={shown.load} title={shown.title} />
        </div>
      )}
    </section>
  );
}
