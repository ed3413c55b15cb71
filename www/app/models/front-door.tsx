// What a first visitor reads: what this is, and the three ways on. It stands beside the sample that opens the page.

import type { JSX } from "preact";
import { adding } from "../intake/adding";
import { PageLink } from "../navigation/page-link";
import { showPanel } from "../state/panels";

export function FrontDoor({ sample }: { sample: boolean }): JSX.Element {
  return (
    <section class="front-door" aria-label="What this is">
      <p>
        Finds planes, cylinders, cones, spheres and tori in point clouds of CAD objects, and scores what methods find.
        Everything happens in this browser: nothing to install, nothing uploaded.
      </p>
      <ul>
        <li>
          <button type="button" onClick={() => (adding.value = true)}>
            Score my results
          </button>
          <small>Points, truth and what a method found: every measure, by every protocol.</small>
        </li>
        <li>
          <button
            type="button"
            onClick={() => {
              showPanel("fit");
              adding.value = true;
            }}
          >
            Fit my scan
          </button>
          <small>A bare cloud will do: see what is in it, and take it home.</small>
        </li>
        <li>
          <PageLink id="lessons" class="button">
            Learn how it works
          </PageLink>
          <small>Short lessons with live parts and exercises.</small>
        </li>
      </ul>
      <p>
        <PageLink id="results">Who is where: the standing results</PageLink>
      </p>
      {sample && <p class="hint">Until you drop something, a sample is shown.</p>}
    </section>
  );
}
