// How many findings ask for attention, beside the panel's title.

import type { JSX } from "preact";
import { findings } from "./findings";

export function diagnosticsBadge(): JSX.Element | null {
  const errors = findings.value.filter(({ severity }) => severity === "error").length;
  const warnings = findings.value.filter(({ severity }) => severity === "warning").length;
  if (errors + warnings === 0) return null;
  return (
    <span class={`badge ${errors > 0 ? "error" : "warning"}`}>
      {errors + warnings}
      <span class="visually-hidden"> findings</span>
    </span>
  );
}
