// A part of the page that is fetched when it is first shown.

import type { FunctionComponent, JSX } from "preact";
import { useEffect, useState } from "preact/hooks";

export type Load = () => Promise<{ default: FunctionComponent }>;

const loaded = new WeakMap<Load, FunctionComponent>();

/** Begins to fetch a part that will be shown soon; one that fails is asked for again when it is shown. */
export function fetchAhead(load: Load): void {
  load().then(
    (module) => loaded.set(load, module.default),
    () => undefined,
  );
}

export function Lazy({ load, title }: { load: Load; title: string }): JSX.Element {
  const [, settled] = useState(0);
  const [failure, setFailure] = useState<string>();
  const Part = loaded.get(load);

  useEffect(() => {
    // Not asked of `loaded`: a part fetched ahead may have come since this was drawn.
    if (Part) return;
    let wanted = true;
    load().then(
      (module) => {
        loaded.set(load, module.default);
        if (wanted) settled((n) => n + 1);
      },
      (error: unknown) => {
        if (wanted) setFailure(error instanceof Error ? error.message : String(error));
      },
    );
    return () => {
      wanted = false;
    };
  }, [load]);

  if (Part) return <Part />;
  if (failure !== undefined) {
    return (
      <p class="empty" role="alert">
        {title} could not be loaded ({failure}). Check the connection and reload the page.
      </p>
    );
  }
  return <p class="empty">Loading {title}…</p>;
}
