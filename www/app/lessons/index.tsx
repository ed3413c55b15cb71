// The list of lessons.

import type { JSX } from "preact";
import { addressOf, goTo } from "../shell/router";
import { LESSONS } from "./catalogue";
import "./lessons.css";

export default function Lessons(): JSX.Element {
  return (
    <div class="lesson-index">
      <h2>Lessons</h2>
      <p>
        The methods and measures of the benchmark, step by step, on live data: every figure and picture is what the
        engine computes for it. Each step has its own link.
      </p>
      <ol>
        {LESSONS.map(({ id, title, about }) => (
          <li key={id}>
            <a
              href={addressOf(id)}
              onClick={(event) => {
                if (event.ctrlKey || event.metaKey || event.shiftKey) return;
                event.preventDefault();
                goTo(id);
              }}
            >
              {title}
            </a>
            <p>{about}</p>
          </li>
        ))}
      </ol>
    </div>
  );
}
