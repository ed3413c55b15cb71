// Definition | Published, and the way to all the others.

import type { JSX } from "preact";
import { protocol } from "../state/settings";
import { capitalised } from "../ui/format";
import { compareAll, protocolShown } from "./protocol-shown";
import { PROTOCOLS } from "./protocols";
import { Icon } from "../ui/icon";

export function ProtocolSwitch(): JSX.Element {
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">Protocol</legend>
      {PROTOCOLS.map(({ name }) => (
        <label key={name}>
          <input
            type="radio"
            name="protocol"
            value={name}
            checked={protocol.value === name}
            onChange={() => (protocol.value = name)}
          />
          <span>{capitalised(name)}</span>
        </label>
      ))}
      <button type="button" class="roomy" title="The submissions by every protocol of the field, side by side" onClick={compareAll}>
        All…
      </button>
      <button
        type="button"
        class="explain"
        aria-label="What the protocols are"
        onClick={() => (protocolShown.value = true)}
      >
        <Icon name="help" />
      </button>
    </fieldset>
  );
}

/** Goes on to the next protocol. */
export function toggleProtocol(): void {
  const at = PROTOCOLS.findIndex(({ name }) => name === protocol.value);
  protocol.value = (PROTOCOLS[at + 1] ?? PROTOCOLS[0])?.name ?? protocol.value;
}
