// A view that stands by itself: points by label, in the page's theme.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { isDark } from "../state/settings";
import { effect } from "@preact/signals";
import type { PointView } from "./point-view";
import type { Layout } from "./types";
import { ViewCanvas } from "./view-canvas";

interface Props {
  /** What the view shows, for those who cannot see it. */
  readonly label: string;
  readonly layout: Layout;
  /** Whether points are seen apart; else neighbours overlap, and as discs in their surface close it. */
  readonly apart?: boolean;
  readonly onView: (view: PointView) => void;
  readonly children?: JSX.Element | readonly (JSX.Element | false | undefined)[] | false | undefined;
}

const LIGHT = { background: "#ffffff", ink: "#000000" };
const DARK = { background: "#14181c", ink: "#ffffff" };

export function LiveView({ label, layout, apart = false, onView, children }: Props): JSX.Element {
  const [failure, setFailure] = useState<string>();
  return (
    <div class="live-view">
      {failure === undefined ? (
        <ViewCanvas
          label={`${label}. Arrow keys turn it, plus and minus enlarge it.`}
          layout={layout}
          onLayout={() => undefined}
          onReady={(view) => {
            onView(view);
            view.setPointSize({ unit: "spacing", value: apart ? 0.9 : 1.3 });
            return effect(() => view.setTheme(isDark() ? DARK : LIGHT));
          }}
          onUnavailable={({ message }) => setFailure(message)}
        />
      ) : (
        <p class="empty">{failure} What stands beside it works all the same.</p>
      )}
      {children}
    </div>
  );
}
