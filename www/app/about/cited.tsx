// A work, to read and to cite.

import type { ComponentChildren, JSX } from "preact";
import type { Work } from "../../../CITATION.cff";
import { copy } from "../export/download";
import { Icon } from "../ui/icon";
import { bibtexOf, lineOf } from "./bibtex";

/** The work in a line, and its entry to take along. */
export function Cited({ work, what }: { work: Work; what: string }): JSX.Element {
  const entry = bibtexOf(work);
  return (
    <>
      <p class="work-cited">
        {lineOf(work)} {work.doi !== undefined && <Away to={`https://doi.org/${work.doi}`}>doi:{work.doi}</Away>}
      </p>
      <details>
        <summary>BibTeX of {what}</summary>
        <pre tabIndex={0} role="region" aria-label={`BibTeX of ${what}`}>
          {entry}
        </pre>
      </details>
      <button type="button" onClick={() => void copy(entry, `BibTeX of ${what}`)}>
        <Icon name="copy" />
        Copy BibTeX of {what}
      </button>
    </>
  );
}

/** A link that leaves the page where it is. */
export function Away({ to, children }: { to: string; children: ComponentChildren }): JSX.Element {
  return (
    <a href={to} target="_blank" rel="noopener noreferrer">
      {children}
    </a>
  );
}
