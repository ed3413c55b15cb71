// The primitives by type: what is shown, what a click in the picture finds, and what is shown alone.

import type { JSX, TargetedKeyboardEvent } from "preact";
import { signal } from "@preact/signals";
import { COLOUR_MODES, isMeantBy } from "../stage/colouring";
import { colourMode, unsegmentedShown } from "../stage/display";
import {
  asideLooks,
  hidden,
  hiddenCount,
  locked,
  nameOfRef,
  restHidden,
  setHidden,
  setLocked,
  setRestHidden,
  showAll,
  showOnly,
  unlockAll,
} from "../stage/isolation";
import { reports } from "../stage/reports";
import { hoveredPrimitive, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import * as format from "../ui/format";
import { Glyph, Icon } from "../ui/icon";
import { Seen } from "../ui/seen";
import { Swatch } from "../ui/swatch";
import { UNSEGMENTED } from "../view/palette";
import { listed, type Kind, type Listed } from "./listed";
import "./tree.css";

/** On the grid of the page's icons. */
const GLYPHS = {
  eye: "M1.5 8C4.5 3.4 11.5 3.4 14.5 8C11.5 12.6 4.5 12.6 1.5 8M8 6a2 2 0 1 1 0 4a2 2 0 0 1 0-4",
  shut: "M1.5 8C4.5 3.4 11.5 3.4 14.5 8C11.5 12.6 4.5 12.6 1.5 8M3 13L13 3",
  lock: "M3.5 7.2h9v6.3h-9zM5.2 7.2V5a2.8 2.8 0 0 1 5.6 0v2.2",
  open: "M3.5 7.2h9v6.3h-9zM5.2 7.2V4.6a2.8 2.8 0 0 1 5.4-.9",
} as const;

/** Types whose primitives are not listed, by their names in this tree. */
const folded = signal<ReadonlySet<string>>(new Set());

/** The children stand before its own controls. */
export function PrimitiveTree({ children }: { children: JSX.Element }): JSX.Element {
  const sections = listed.value;
  if (sections.length === 0) return <p class="empty">Choose a model that has a ground truth or a submission, or fit one under Fit.</p>;
  return (
    <div class="primitive-tree" onKeyDown={walk} onMouseLeave={() => (hoveredPrimitive.value = undefined)}>
      <div class="tree-tools">
        {children}
        <button type="button" disabled={hiddenCount.value === 0} title="Show all (A, Esc)" onClick={showAll}>
          Show all
        </button>
        <button type="button" disabled={locked.value.size === 0} title="Unlock all (Esc)" onClick={unlockAll}>
          Unlock all
        </button>
        <label class="check">
          <input
            type="checkbox"
            checked={asideLooks.value === "faint"}
            onChange={(event) => (asideLooks.value = event.currentTarget.checked ? "faint" : "gone")}
          />
          Hidden ones faint
        </label>
        {(colourMode.value === "figure" || colourMode.value === "outcome") && (
          <p class="hint">“{COLOUR_MODES.find(({ id }) => id === colourMode.value)?.title}” colours points by what became of them: choose another colour to hide primitives.</p>
        )}
        <p class="hint">A click in the picture does not find what is locked. Arrow keys walk the list, Escape shows all again.</p>
      </div>
      {sections.map(({ side, title, kinds }) => (
        <section key={side}>
          <h3>{title}</h3>
          <ul class="tree-kinds">
            {kinds.map((kind) => (
              <Branch key={kind.type} name={`${side} ${kind.type}`} all={`all ${kind.title}${side === sections[0]?.side ? "" : ` of ${title}`}`} kind={kind} />
            ))}
            {side === sections[0]?.side && <Rest />}
          </ul>
        </section>
      ))}
    </div>
  );
}

function Branch({ name, all, kind }: { name: string; all: string; kind: Kind }): JSX.Element {
  const open = !folded.value.has(name);
  const fold = () => {
    const next = new Set(folded.value);
    if (open) next.add(name);
    else next.delete(name);
    folded.value = next;
  };
  return (
    <li class="tree-kind">
      <div class="tree-row kind">
        <button type="button" class="row-name" aria-expanded={open} onClick={fold}>
          <Icon name={open ? "down" : "up"} />
          {kind.title} {format.integer(kind.primitives.length)}
        </button>
        <Acts name={all} refs={kind.primitives.map(({ ref }) => ref)} />
      </div>
      {open && (
        <Seen
          as="ul"
          items={kind.primitives}
          draw={(primitive, place) => (
            <li key={nameOfRef(primitive.ref)} {...place}>
              <Leaf primitive={primitive} />
            </li>
          )}
        />
      )}
    </li>
  );
}

function Leaf({ primitive }: { primitive: Listed }): JSX.Element {
  const { ref, number, name, points, colour } = primitive;
  return (
    <div
      class="tree-row"
      data-hidden={hidden.value.has(nameOfRef(ref)) || undefined}
      data-hovered={isMeantBy(reports.value, hoveredPrimitive.value, ref) || undefined}
      onMouseEnter={() => (hoveredPrimitive.value = ref)}
    >
      <button
        type="button"
        class="row-name"
        aria-label={`${name}, ${format.plural(points, "point")}`}
        aria-pressed={isMeantBy(reports.value, selectedPrimitive.value, ref)}
        onClick={() => togglePrimitive(ref)}
      >
        <Swatch colour={colour} />
        {number}
        <span class="points">{format.integer(points)}</span>
      </button>
      <Acts name={name} refs={[ref]} />
    </div>
  );
}

/** The points of no primitive: nothing to lock, and never alone. */
function Rest(): JSX.Element {
  const shown = unsegmentedShown.value === "on" && !restHidden.value;
  const turn = () => {
    setRestHidden(shown);
    if (!shown) unsegmentedShown.value = "on";
  };
  return (
    <li class="tree-kind">
      <div class="tree-row kind" data-hidden={!shown || undefined}>
        <span class="row-name">
          <Swatch colour={UNSEGMENTED} />
          Unsegmented
        </span>
        <Toggle pressed={!shown} label="Hide unsegmented points" icon={shown ? "eye" : "shut"} onClick={turn} />
      </div>
    </li>
  );
}

/** Eye, lock and “only” of one primitive or of all of a type. */
function Acts({ name, refs }: { name: string; refs: readonly PrimitiveRef[] }): JSX.Element {
  const share = (of: ReadonlyMap<string, PrimitiveRef>): boolean | "mixed" => {
    const count = refs.filter((ref) => of.has(nameOfRef(ref))).length;
    return count === 0 ? false : count === refs.length ? true : "mixed";
  };
  const [isHidden, isLocked] = [share(hidden.value), share(locked.value)];
  const all = () => listed.value.flatMap(({ kinds }) => kinds.flatMap(({ primitives }) => primitives.map(({ ref }) => ref)));
  return (
    <>
      <Toggle pressed={isHidden} label={`Hide ${name}`} icon={isHidden === true ? "shut" : "eye"} onClick={() => setHidden(refs, isHidden !== true)} />
      <Toggle pressed={isLocked} label={`Lock ${name}`} icon={isLocked === true ? "lock" : "open"} onClick={() => setLocked(refs, isLocked !== true)} />
      <button type="button" class="only" aria-label={`Show only ${name}`} onClick={() => showOnly(refs, all())}>
        Only
      </button>
    </>
  );
}

interface ToggleProps {
  readonly pressed: boolean | "mixed";
  readonly label: string;
  readonly icon: keyof typeof GLYPHS;
  readonly onClick: () => void;
}

function Toggle({ pressed, label, icon, onClick }: ToggleProps): JSX.Element {
  return (
    <button type="button" class="icon" aria-pressed={pressed} aria-label={label} title={label} onClick={onClick}>
      <Glyph path={GLYPHS[icon]} />
    </button>
  );
}

/** Arrows walk from row to row in a column of buttons, and from button to button in a row. */
function walk(event: TargetedKeyboardEvent<HTMLElement>): void {
  const button = event.target instanceof Element ? event.target.closest("button") : null;
  const row = button?.closest(".tree-row");
  if (!button || !row) return;
  const buttonsOf = (of: Element) => [...of.querySelectorAll("button")];
  const rows = [...event.currentTarget.querySelectorAll(".tree-row")];
  const at = buttonsOf(row).indexOf(button);
  const place = rows.indexOf(row);
  const to = rows[{ ArrowDown: place + 1, ArrowUp: place - 1, Home: 0, End: rows.length - 1 }[event.key] ?? -1];
  const beside = { ArrowRight: at + 1, ArrowLeft: at - 1 }[event.key];
  const next = to ? (buttonsOf(to)[at] ?? buttonsOf(to)[0]) : beside === undefined ? undefined : buttonsOf(row)[beside];
  if (!next) return;
  event.preventDefault();
  event.stopPropagation();
  next.focus();
}
