// The frame of every lesson: text beside a live view, back and forth by buttons and keys.

import type { ComponentChildren, JSX } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { PageLink } from "../navigation/page-link";
import { goToStep, readStep, step } from "./steps";
import "./lessons.css";

export interface Step {
  readonly title: string;
  /** May read signals. */
  readonly text: () => ComponentChildren;
}

interface Props {
  readonly title: string;
  readonly steps: readonly Step[];
  /** The live view with its controls. */
  readonly children: ComponentChildren;
}

/** What has its own use for arrow keys. */
const KEEPS_ARROWS = "input, select, textarea, canvas, [role=slider], [role=application], [role=tab], .takes-arrows";
const FORTH = ["ArrowRight", "PageDown"];
const BACK = ["ArrowLeft", "PageUp"];

export function LessonFrame({ title, steps, children }: Props): JSX.Element {
  const last = steps.length;
  const at = Math.min(step.value, last);
  const shown = steps[at - 1];
  const text = useRef<HTMLDivElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  const before = useRef(at);

  useLayoutEffect(() => readStep(last), [last]);

  // Before the page is painted: a key pressed between that and a later effect would be lost.
  useLayoutEffect(() => {
    const listener = (event: KeyboardEvent) => {
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
      if (document.querySelector("dialog[open]")) return;
      const arrow = event.key.startsWith("Arrow");
      if (arrow && event.target instanceof Element && event.target.closest(KEEPS_ARROWS)) return;
      const by = FORTH.includes(event.key) ? 1 : BACK.includes(event.key) ? -1 : 0;
      if (by === 0) return;
      event.preventDefault();
      goToStep(step.value + by, last);
    };
    window.addEventListener("keydown", listener);
    return () => window.removeEventListener("keydown", listener);
  }, [last]);

  // A new step is read from its beginning, by eye and by screen reader. Before the page is painted: what the reader has
  // turned to since would lose the focus to the heading.
  useLayoutEffect(() => {
    if (before.current === at) return;
    before.current = at;
    text.current?.scrollTo(0, 0);
    heading.current?.focus({ preventScroll: true });
    if (text.current && text.current.getBoundingClientRect().top < 0) text.current.scrollIntoView();
  }, [at]);

  return (
    <div class="lesson">
      <div class="lesson-side">
        <nav class="lesson-nav" aria-label="Steps of the lesson">
          <button type="button" disabled={at === 1} onClick={() => goToStep(at - 1, last)}>
            ← Back
          </button>
          <select aria-label="Step" value={String(at)} onChange={(event) => goToStep(Number(event.currentTarget.value), last)}>
            {steps.map((each, place) => (
              <option key={each.title} value={String(place + 1)}>
                {place + 1}. {each.title}
              </option>
            ))}
          </select>
          <button type="button" class="primary" disabled={at === last} onClick={() => goToStep(at + 1, last)}>
            Next →
          </button>
        </nav>
        <div class="lesson-text" ref={text} tabIndex={0} role="region" aria-label="Text of the step">
          <p class="lesson-name">
            <PageLink id="lessons">Lessons</PageLink>{" "}
            / {title}, step {at} of {last}
          </p>
          <h2 ref={heading} tabIndex={-1}>
            {shown?.title}
          </h2>
          {shown && <StepText key={at} text={shown.text} />}
        </div>
      </div>
      <div class="lesson-live">{children}</div>
    </div>
  );
}

function StepText({ text }: { text: () => ComponentChildren }): JSX.Element {
  return <>{text()}</>;
}
