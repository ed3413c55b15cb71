// The list of lessons.

import type { JSX } from "preact";
import { PageLink } from "../navigation/page-link";
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
            <PageLink id={id}>{title}</PageLink>
            <p>{about}</p>
          </li>
        ))}
      </ol>
    </div>
  );
}
