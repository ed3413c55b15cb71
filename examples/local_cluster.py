"""Scores generated models on a cluster of this machine, and says what the cluster costs against a plain loop.

    python examples/local_cluster.py --models 2000 --out scores
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import fit4cad
from fit4cad import distributed as many


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", type=int, default=2000)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--spacing", type=float, default=0.02, help="of the diagonal: about 0.02 gives 3,000 points a part")
    parser.add_argument("--out", type=Path, default=None)
    given = parser.parse_args()
    parts = [part["name"] for part in fit4cad.declared()["parts"]]
    options = {"spacing": given.spacing}
    tasks = [
        many.Generated(parts[at % len(parts)], f"PC{at}", {**options, "seed": at + 1}) for at in range(given.models)
    ]

    with tempfile.TemporaryDirectory() as scratch:
        out = given.out or Path(scratch)
        with many.local(given.workers) as client:
            # Once beforehand, so that what is measured is no start of processes.
            many.score(tasks[: 2 * given.workers], Path(scratch) / "warm", client=client, batch=1)
            summary = many.score(tasks, out, client=client)
        print(summary)
        rows = many.read(out).select(["model", "DSC", "seconds"]).to_pylist()
        mean = sum(row["DSC"] for row in rows) / len(rows)
        inside = sum(row["seconds"] for row in rows)
    start = time.perf_counter()
    some = tasks[:: max(1, len(tasks) // 200)]
    for task in some:
        model, _ = task.load(False)
        model.score("Imperfect").summary()
    loop = (time.perf_counter() - start) / len(some)
    spent = given.workers * summary.seconds / max(summary.models, 1)
    print(f"mean DSC {mean:.4f}")
    print(f"{1 / spent:.1f} models per second per core; a plain loop alone on the machine {1 / loop:.1f}")
    print(f"overhead of the cluster over the work done in it: {100 * (given.workers * summary.seconds / inside - 1):.1f} %")


if __name__ == "__main__":
    main()
