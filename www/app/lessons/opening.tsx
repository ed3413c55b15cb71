// What stands in the place of a workbench until its session has begun.

import type { ComponentChildren, JSX } from "preact";
import type { Session, Start } from "./session";

interface Props {
  readonly start: Start;
  readonly children: (session: Session) => ComponentChildren;
}

export function Opening({ start: { session, failure, again }, children }: Props): JSX.Element {
  if (session) return <>{children(session)}</>;
  if (failure === undefined) return <p class="empty">Preparing the lesson…</p>;
  return (
    <div class="empty">
      <p role="alert">The lesson could not be started: {failure}</p>
      <button type="button" onClick={again}>
        Try again
      </button>
    </div>
  );
}
