// Where the places of primitives mean what they do: they mean something else in another model or submission.

import { computed } from "@preact/signals";
import { rivalMethod, selectedMethod, selectedModel } from "../state/selection";

export const where = computed(() => JSON.stringify([selectedModel.value, selectedMethod.value, rivalMethod.value]));
