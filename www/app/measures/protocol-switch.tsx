// Definition | Published.

import type { JSX } from "preact";
import type { Protocol } from "../engine/contract";
import { protocol } from "../state/settings";
import { protocolShown } from "./protocol-dialog";
import { Icon } from "../ui/icon";

const PROTOCOLS: readonly { id: Protocol; title: string }[] = [
  { id: "definition", title: "Definition" },
  { id: "published", title: "Published" },
];

export function ProtocolSwitch(): JSX.Element {
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">Protocol</legend>
      {PROTOCOLS.map(({ id, title }) => (
        <label key={id}>
          <input
            type="radio"
            name="protocol"
            value={id}
            checked={protocol.value === id}
            onChange={() => (protocol.value = id)}
          />
          <span>{title}</span>
        </label>
      ))}
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

export function toggleProtocol(): void {
  protocol.value = protocol.value === "definition" ? "published" : "definition";
}
