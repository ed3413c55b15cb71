// What this is, whose work it builds on and how to cite that, what it is licensed under, and what becomes of the
// reader's data. The words on works come from CITATION.cff.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import citation from "../../../CITATION.cff";
import { engineVersion } from "../export/results";
import { Away, Cited } from "./cited";

const BENCHMARK = "https://github.com/chiararomanengo/Fit4CAD";

export default function AboutSheet(): JSX.Element {
  const { title, abstract, "preferred-citation": paper, "repository-code": repository, license } = citation;
  const licences = typeof license === "string" ? [license] : license;
  return (
    <>
      <p>
        {title}: {lowered(abstract)}
      </p>
      <Version />
      <section>
        <h3>The benchmark and its paper</h3>
        <p>
          Point clouds, ground truth, measures and the published results are those of <Away to={BENCHMARK}>Fit4CAD</Away>.
        </p>
        <Cited work={paper} what="the paper" />
      </section>
      <section>
        <h3>The playground</h3>
        <p>
          {citation.message}
          {repository !== undefined && (
            <>
              {" "}
              Its source is at <Away to={repository}>{repository.replace(/^https:\/\//, "")}</Away>.
            </>
          )}{" "}
          Licensed under {licences.join(" or ")}, at your option.
          {import.meta.env.PROD && (
            <>
              {" "}
              What the engine offers to other programs is <Away to="./doc/fit4cad/index.html">documented beside this page</Away>.
            </>
          )}
        </p>
        <Cited work={citation} what="the playground" />
      </section>
      <section>
        <h3>Your data</h3>
        <p>
          What you open stays in this browser: nothing is uploaded, nothing is counted, and there are no cookies. The page
          uses the network for its own parts, and for public models or the zip of a link only when you ask for them or open
          that link. A link that you share holds figures, names and settings after the “#”, which browsers send to no server.
          The browser keeps your choices (theme, protocol, layout), what you brought and made here until you remove it
          (under Files, “Remove everything”), and the page itself, so that it works offline.
        </p>
      </section>
    </>
  );
}

/** Of the engine that runs here, which decides what figures come out. */
function Version(): JSX.Element {
  const version = useSignal<string | undefined>(undefined);
  useEffect(() => {
    engineVersion().then(
      (found) => (version.value = found),
      () => undefined,
    );
  }, []);
  return <p role="status">Version {version.value ?? citation.version}</p>;
}

function lowered(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}
