// A link to a page of this site that loads nothing anew.

import type { ComponentChildren, JSX } from "preact";
import { addressOf, goTo, page } from "../state/router";

interface Props {
  readonly id: string;
  /** Whether a page under this one is shown. */
  readonly leads?: boolean;
  readonly class?: string;
  readonly children: ComponentChildren;
}

export function PageLink({ id, leads = false, class: look, children }: Props): JSX.Element {
  return (
    <a
      href={addressOf(id)}
      class={look}
      aria-current={id === page.value ? "page" : leads ? "true" : undefined}
      onClick={(event) => {
        if (event.ctrlKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        goTo(id);
      }}
    >
      {children}
    </a>
  );
}
