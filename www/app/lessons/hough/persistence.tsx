// The persistence diagram: each maximum by the level at which it appears and the one at which it
// meets a higher one. Above the dashed line it lives long enough to count.

import type { JSX } from "preact";
import type { MaximumInfo } from "../../../generated/engine/engine.js";

interface Props {
  readonly maxima: readonly MaximumInfo[];
  readonly share: number;
  readonly chosen: number | undefined;
  readonly onCell: (cell: number) => void;
}

const SIZE = 300;
const MARGIN = 36;

export function Persistence({ maxima, share, chosen, onCell }: Props): JSX.Element {
  const top = Math.max(1, ...maxima.map(({ birth }) => birth));
  const at = (votes: number) => MARGIN + (votes / top) * (SIZE - MARGIN - 10);
  const up = (votes: number) => SIZE - at(votes);
  const kept = maxima.filter((each) => each.kept).length;
  return (
    <svg
      class="persistence"
      viewBox={`0 0 ${SIZE} ${SIZE}`}
      role="img"
      aria-label={`Persistence diagram of ${maxima.length} maxima, ${kept} of them above the threshold of ${Math.round(share * 100)} %`}
    >
      <line x1={at(0)} y1={up(0)} x2={at(top)} y2={up(0)} />
      <line x1={at(0)} y1={up(0)} x2={at(0)} y2={up(top)} />
      <line x1={at(0)} y1={up(0)} x2={at(top)} y2={up(top)} />
      <line class="threshold" x1={at(0)} y1={up(share * top)} x2={at(top * (1 - share))} y2={up(top)} />
      <text x={at(top / 2)} y={SIZE - 8} text-anchor="middle">
        death, in votes
      </text>
      <text transform={`translate(12 ${up(top / 2)}) rotate(-90)`} text-anchor="middle">
        birth, in votes
      </text>
      <text x={at(top)} y={SIZE - 22} text-anchor="end">
        {top}
      </text>
      <text x={at(0) - 4} y={up(top) + 4} text-anchor="end">
        {top}
      </text>
      {maxima.map(({ cell, birth, death, kept: alive }) => (
        <circle
          key={cell}
          cx={at(death)}
          cy={up(birth)}
          r={cell === chosen ? 7 : alive ? 5 : 2.5}
          fill={alive ? "#ff5a36" : "#9aa1a8"}
          onClick={() => onCell(cell)}
        />
      ))}
    </svg>
  );
}
