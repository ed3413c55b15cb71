// What the two protocols say, and how they differ.

import type { JSX } from "preact";
import { PROTOCOL_DIFFERENCES } from "../../generated/declared/protocol-differences.js";
import { capitalised } from "../ui/format";
import { compareAll } from "./protocol-dialog";
import { PROTOCOLS } from "./protocols";

export default function ProtocolSheet(): JSX.Element {
  return (
    <>
      {PROTOCOLS.map(({ name, meaning }) => (
        <p key={name}>
          <strong>{capitalised(name)}.</strong> {meaning}
        </p>
      ))}
      <table>
        <caption class="visually-hidden">How the protocols differ</caption>
        <thead>
          <tr>
            <th scope="col">What</th>
            <th scope="col">Definition</th>
            <th scope="col">Published</th>
          </tr>
        </thead>
        <tbody>
          {PROTOCOL_DIFFERENCES.map(({ what, definition, published }) => (
            <tr key={what}>
              <th scope="row">{what}</th>
              <td>{definition}</td>
              <td>{published}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        In both, each true primitive is matched with the predicted one it shares most points with; of equals, the first.
        A true primitive that shares no point with any prediction scores DSC, PPV and TPR 0 in the mean, so predicting nothing never pays.
      </p>
      <p>
        Others score by rules of their own.{" "}
        <button type="button" onClick={compareAll}>
          The protocols of the field, side by side
        </button>
      </p>
    </>
  );
}
