// A link to a page of this site that loads nothing anew.

import type { ComponentChildren, JSX } from "preact";
import { addressOf, goTo, page } from "./router";

export function PageLink({ id, children }: { id: string; children: ComponentChildren }): JSX.Element {
  return (
    <a
      href={addressOf(id)}
      aria-current={id === page.value ? "page" : undefined}
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
