// Formulas in MathML.

import type { JSX } from "preact";
import type { Term } from "../engine/contract";

/** A measure's symbol and what it is equal to. */
export function Formula({ symbol, formula }: { symbol: Term; formula: Term }): JSX.Element {
  return (
    <math display="block">
      <mrow>
        <TermView term={symbol} />
        <mo>=</mo>
        <TermView term={formula} />
      </mrow>
    </math>
  );
}

function TermView({ term }: { term: Term }): JSX.Element {
  switch (term.kind) {
    case "word":
      return <mtext>{term.text}</mtext>;
    case "variable":
      return <mi>{term.text}</mi>;
    case "number":
      return <mn>{term.text}</mn>;
    case "operator":
      // Brackets stay as tall as a line: they enclose letters alone.
      return <mo stretchy={false}>{term.text}</mo>;
    case "row":
      return (
        <mrow>
          {term.terms.map((part, place) => (
            <TermView key={place} term={part} />
          ))}
        </mrow>
      );
    case "fraction":
      return (
        <mfrac>
          <TermView term={term.over} />
          <TermView term={term.under} />
        </mfrac>
      );
    case "sub":
      return (
        <msub>
          <TermView term={term.base} />
          <TermView term={term.index} />
        </msub>
      );
    case "under":
      return (
        <munder>
          <TermView term={term.operator} />
          <TermView term={term.range} />
        </munder>
      );
  }
}
