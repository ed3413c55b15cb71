// A modal sheet on the browser's own <dialog>: focus stays inside, Escape closes.

import type { ComponentChildren, JSX } from "preact";
import type { Signal } from "@preact/signals";
import { useLayoutEffect, useId, useRef } from "preact/hooks";
import { Icon } from "./icon";

interface Props {
  readonly open: Signal<boolean>;
  readonly title: string;
  readonly className?: string;
  readonly children: ComponentChildren;
}

export function Dialog({ open, title, className = "", children }: Props): JSX.Element {
  const dialog = useRef<HTMLDialogElement>(null);
  // Told of a moment later, when it may have been opened anew.
  const closedHere = useRef(false);
  const id = useId();
  const shown = open.value;

  // Before the page is painted: keys pressed once it is seen are meant for the dialog.
  useLayoutEffect(() => {
    const element = dialog.current;
    if (shown && element && !element.open) element.showModal();
    if (!shown && element?.open) {
      closedHere.current = true;
      element.close();
    }
  }, [shown]);

  return (
    <dialog
      ref={dialog}
      class={`sheet ${className}`}
      aria-labelledby={id}
      onClose={() => {
        if (!closedHere.current) open.value = false;
        closedHere.current = false;
      }}
      onClick={(event) => {
        // A click on the backdrop reaches the dialog itself.
        if (event.target === dialog.current) open.value = false;
      }}
    >
      {shown && (
        <div class="sheet-body">
          <header>
            <h2 id={id}>{title}</h2>
            <button type="button" class="icon" aria-label="Close" onClick={() => (open.value = false)}>
              <Icon name="close" />
            </button>
          </header>
          {children}
        </div>
      )}
    </dialog>
  );
}
