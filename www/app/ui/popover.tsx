// A button that opens a small sheet beside itself. Escape and a click elsewhere close it.

import type { ComponentChildren, JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useId, useRef } from "preact/hooks";
import { placeBeside } from "./place";

export function Popover({ label, children }: { label: ComponentChildren; children: ComponentChildren }): JSX.Element {
  const id = useId();
  const open = useSignal(false);
  const button = useRef<HTMLButtonElement>(null);
  return (
    <>
      <button ref={button} type="button" aria-expanded={open.value} {...{ popovertarget: id }}>
        {label}
      </button>
      <div
        id={id}
        popover="auto"
        class="popover"
        onToggle={(event) => {
          open.value = event.currentTarget.matches(":popover-open");
          if (open.value && button.current) placeBeside(event.currentTarget, button.current);
        }}
      >
        {children}
      </div>
    </>
  );
}
