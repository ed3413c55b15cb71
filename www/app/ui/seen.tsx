// Long lists of which only what is in sight is drawn, with room left for the rest. Rows are one line high each, hence
// all of one height. Keys reach every row, and rows say to screen readers which of how many they are.

import type { JSX, RefObject } from "preact";
import { useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";

/** As many are drawn whole: a list that short costs little, and the browser's own search finds all of it. */
const WHOLE = 200;
/** Rows drawn beyond either edge, so that there is something there before the next look. */
const MARGIN = 20;
/** What is drawn changes by as many rows at a time, not with every one that scrolls by. */
const STRIDE = 10;
/** Pixels, until a row has been measured. */
const ASSUMED_HEIGHT = 32;

/** To be spread on the element of an item: how its place is known to keys and screen readers. */
export interface Place {
  readonly "data-place": number;
  readonly "aria-setsize"?: number;
  readonly "aria-posinset"?: number;
  readonly "aria-rowindex"?: number;
}

interface Props<Item> {
  /** A list, or the body of a table. */
  readonly as: "ul" | "tbody";
  readonly items: readonly Item[];
  readonly draw: (item: Item, place: Place) => JSX.Element;
  /** Selects, within an item, what has the focus while keys walk the items; without it they do not. */
  readonly handle?: string;
  /** Rows of the table above its body; columns of the table. */
  readonly headRows?: number;
  readonly columns?: number;
  readonly onMouseLeave?: (() => void) | undefined;
}

interface Range {
  readonly from: number;
  readonly to: number;
}

export function Seen<Item>({ as: Box, items, draw, handle, headRows = 1, columns = 1, onMouseLeave }: Props<Item>): JSX.Element {
  const box = useRef<HTMLElement>(null);
  const seen = useSeen(box, items.length, handle);
  const drawn = (place: number) => {
    const item = items[place];
    return item === undefined ? null : draw(item, placeOf(Box, place, items.length, headRows));
  };
  return (
    <Box ref={box as RefObject<never>} onKeyDown={handle === undefined ? undefined : seen.walk} onMouseLeave={onMouseLeave}>
      {/* One list of keyed children: an item that stays is not made anew, and keeps the focus. */}
      {seen.spans.flatMap(({ from, to, height }, at) =>
        height === undefined ? Array.from({ length: to - from }, (_, i) => drawn(from + i)) : [gap(Box, at, height, columns)],
      )}
    </Box>
  );
}

function gap(box: "ul" | "tbody", at: number, pixels: number, columns: number): JSX.Element {
  const style = { height: `${pixels}px` };
  if (box === "ul") return <li key={`gap ${at}`} class="gap" aria-hidden="true" style={style} />;
  return (
    <tr key={`gap ${at}`} class="gap" aria-hidden="true">
      <td colSpan={columns} style={style} />
    </tr>
  );
}

/** Whether so many items are drawn in part only. */
export function isWindowed(count: number): boolean {
  return count > WHOLE;
}

function placeOf(box: "ul" | "tbody", place: number, count: number, headRows: number): Place {
  if (!isWindowed(count)) return { "data-place": place };
  return box === "ul"
    ? { "data-place": place, "aria-setsize": count, "aria-posinset": place + 1 }
    : { "data-place": place, "aria-rowindex": headRows + place + 1 };
}

/** Items from one place to before another: drawn, or a gap of some pixels. */
interface Span extends Range {
  readonly height?: number;
}

interface Seeing {
  readonly spans: readonly Span[];
  /** Arrow keys, Page up and down, Home and End walk the items. */
  readonly walk: (event: KeyboardEvent) => void;
}

function useSeen(box: RefObject<HTMLElement | null>, count: number, handle = ""): Seeing {
  const windowed = isWindowed(count);
  const range = useSignal<Range>({ from: 0, to: 2 * MARGIN });
  /** The item that has the focus stays, wherever it is scrolled to. */
  const held = useSignal<number | undefined>(undefined);
  const height = useSignal(ASSUMED_HEIGHT);
  /** The item that is to have the focus as soon as it is drawn. */
  const wanted = useRef<number | undefined>(undefined);

  const look = () => {
    const element = box.current;
    if (!element) return;
    const own = element.querySelector("[data-place]")?.getBoundingClientRect().height ?? 0;
    if (own > 0) height.value = own;
    const { top, bottom, start } = sightOf(element);
    const first = Math.floor((top - start) / height.peek()) - MARGIN;
    const last = Math.ceil((bottom - start) / height.peek()) + MARGIN;
    const from = Math.max(0, Math.floor(first / STRIDE) * STRIDE);
    const to = Math.max(from + STRIDE, Math.ceil(last / STRIDE) * STRIDE);
    if (from !== range.peek().from || to !== range.peek().to) range.value = { from, to };
  };

  useLayoutEffect(() => {
    if (!windowed) return undefined;
    look();
    const stop = new AbortController();
    const { signal } = stop;
    // Whatever scrolls: the list itself, a panel around it, or the page.
    addEventListener("scroll", look, { signal, capture: true, passive: true });
    addEventListener("resize", look, { signal });
    const sizes = new ResizeObserver(look);
    if (box.current?.parentElement) sizes.observe(box.current.parentElement);
    box.current?.addEventListener("focusin", ({ target }) => (held.value = placeAt(target)), { signal });
    box.current?.addEventListener("focusout", () => (held.value = undefined), { signal });
    const end = () => {
      stop.abort();
      sizes.disconnect();
    };
    return end;
  }, [windowed]);

  const focus = (place: number) => {
    const item = box.current?.querySelector<HTMLElement>(`[data-place="${place}"] ${handle}`);
    item?.focus();
    return item !== null && item !== undefined;
  };

  useLayoutEffect(() => {
    if (wanted.current !== undefined && focus(wanted.current)) wanted.current = undefined;
  });

  const reach = (place: number) => {
    if (focus(place) || !box.current) return;
    wanted.current = place;
    const { scroller, top, bottom, start } = sightOf(box.current);
    scroller.scrollBy({ top: start + (place + 0.5) * height.peek() - (top + bottom) / 2, behavior: "instant" });
  };

  const walk = (event: KeyboardEvent) => {
    const { target } = event;
    const at = placeAt(target);
    if (at === undefined || !box.current || !(target instanceof Element) || !target.matches(handle)) return;
    const { top, bottom } = sightOf(box.current);
    const page = Math.max(1, Math.floor((bottom - top) / height.peek()) - 1);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, PageDown: at + page, PageUp: at - page, Home: 0, End: count - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    reach(Math.min(count - 1, Math.max(0, to)));
  };

  return { spans: windowed ? spansOf(range.value, held.value, count, height.value) : [{ from: 0, to: count }], walk };
}

/** The place of the item that an element is in. */
function placeAt(element: EventTarget | null): number | undefined {
  const item = element instanceof Element ? element.closest<HTMLElement>("[data-place]") : null;
  return item ? Number(item.dataset["place"]) : undefined;
}

/** What scrolls the items, between which heights of the window they are in sight, and at which the first of them starts. */
function sightOf(box: HTMLElement): { scroller: Element; top: number; bottom: number; start: number } {
  let scroller: HTMLElement | null = box;
  while (scroller && !/auto|scroll/.test(getComputedStyle(scroller).overflowY)) scroller = scroller.parentElement;
  const edges = scroller?.getBoundingClientRect() ?? { top: 0, bottom: innerHeight };
  const own = box.getBoundingClientRect().top;
  return {
    scroller: scroller ?? document.documentElement,
    top: Math.max(0, edges.top),
    bottom: Math.min(innerHeight, edges.bottom),
    start: scroller === box ? own - box.scrollTop : own,
  };
}

/** What is drawn of so many items, and the gaps between. */
function spansOf({ from, to }: Range, held: number | undefined, count: number, height: number): Span[] {
  const begin = Math.min(from, Math.max(0, count - 1));
  const main = { from: begin, to: Math.min(to, count) };
  const apart = held !== undefined && held < count && (held < main.from || held >= main.to);
  const drawn = [main, ...(apart ? [{ from: held, to: held + 1 }] : [])].sort((a, b) => a.from - b.from);
  const spans: Span[] = [];
  let next = 0;
  for (const span of drawn) {
    if (span.from > next) spans.push({ from: next, to: span.from, height: (span.from - next) * height });
    spans.push(span);
    next = span.to;
  }
  if (next < count) spans.push({ from: next, to: count, height: (count - next) * height });
  return spans;
}
