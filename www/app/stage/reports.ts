// How the submissions in the views match the truth, by the protocol that is on.

import { computed } from "@preact/signals";
import { rivalReports, selectedReports } from "../state/selection";
import { protocol } from "../state/settings";
import type { Reports } from "./colouring";

export const reports = computed<Reports>(() => ({
  prediction: selectedReports.value?.[protocol.value],
  rival: rivalReports.value?.[protocol.value],
}));
