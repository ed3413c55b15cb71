// Text pasted as if it were a file.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { takeText } from "./intake";

const NAMES = ["PC1.txt", "PC1_primitives.txt", "PC1_parametric.txt", "PC1_implicit.txt"];

export function PasteForm({ onTaken }: { onTaken: () => void }): JSX.Element {
  const name = useSignal("PC1_primitives.txt");
  const text = useSignal("");
  return (
    <form
      class="paste"
      onSubmit={(event) => {
        event.preventDefault();
        void takeText(name.value.trim(), text.value);
        onTaken();
      }}
    >
      <p>
        The name says what the text is; a folder names the method, as in <code>pointCloud_primitives_MINE/PC1_primitives.txt</code>.
      </p>
      <label>
        File name
        <input
          type="text"
          required
          value={name.value}
          list="file-names"
          spellcheck={false}
          onInput={(event) => (name.value = event.currentTarget.value)}
        />
      </label>
      <datalist id="file-names">
        {NAMES.map((known) => (
          <option key={known} value={known} />
        ))}
      </datalist>
      <label>
        Text
        <textarea
          rows={4}
          required
          spellcheck={false}
          placeholder="Primitive1:=[1 2 3];"
          value={text.value}
          onInput={(event) => (text.value = event.currentTarget.value)}
        />
      </label>
      <button type="submit">Add text</button>
    </form>
  );
}
