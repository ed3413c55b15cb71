"""What the engine does natively, of the Python package: the training set fitted on one thread and on all, and models
scored by Dask and by a plain loop. Prints JSON. Arguments: how many models Dask gets, then paths of clouds, if any."""

from __future__ import annotations

import json
import os
import sys
import time
from typing import Any, Callable

import fit4cad
from fit4cad import distributed as many

#: Workers of the cluster, one thread each.
WORKERS = 2
#: Seconds for which a cluster without work is watched.
IDLE = 10.0


def timed(body: Callable[[], Any]) -> tuple[Any, dict[str, float]]:
    """What the body gives, with the seconds and the seconds of processor it took, those of all threads together."""
    start, before = time.perf_counter(), time.process_time()
    value = body()
    return value, {"seconds": time.perf_counter() - start, "processor": time.process_time() - before}


def fits(paths: list[str]) -> list[dict[str, Any]]:
    """Every cloud fitted by both methods, on one thread and on all."""
    if paths:
        models = list(fit4cad.read_all(*paths))
    else:
        models = [fit4cad.generate(part["name"]) for part in fit4cad.declared()["parts"]]
    rows = []
    for method in (each["name"] for each in fit4cad.declared()["fitters"]):
        first = None
        for jobs in sorted({1, os.cpu_count() or 1}):
            found, spent = timed(lambda: fit4cad.fit_many(models, method, jobs=jobs))
            labels = [each.labels.tobytes() for each in found]
            first = first or labels
            rows.append({"method": method, "jobs": jobs, "models": len(models), "same": labels == first, **spent})
    return rows


def overhead(count: int) -> dict[str, Any]:
    """The same models scored on a cluster of this machine and by a plain loop, in seconds of processor."""
    import tempfile

    parts = [part["name"] for part in fit4cad.declared()["parts"]]
    tasks = [many.Generated(parts[at % len(parts)], f"PC{at}", {"spacing": 0.02, "seed": at + 1}) for at in range(count)]

    def loop() -> None:
        for task in tasks:
            model, _ = task.load(False)
            model.score("Imperfect").summary()

    _, alone = timed(loop)
    with tempfile.TemporaryDirectory() as scratch:
        with many.local(WORKERS) as client:
            # Once beforehand: what is measured is no start of processes.
            many.score(tasks[: 2 * WORKERS], f"{scratch}/warm", client=client, batch=1)

            def everywhere(body: Callable[[], Any]) -> tuple[Any, dict[str, float]]:
                before = sum(client.run(time.process_time).values())
                value, own = timed(body)
                workers = sum(client.run(time.process_time).values()) - before
                return value, {"seconds": own["seconds"], "processor": own["processor"] + workers}

            _, idle = everywhere(lambda: time.sleep(IDLE))
            summary, cluster = everywhere(lambda: many.score(tasks, f"{scratch}/run", client=client))
    assert (summary.models, summary.failed) == (count, 0), summary
    return {"models": count, "workers": WORKERS, "loop": alone, "idle": idle, "cluster": cluster}


def main() -> None:
    count, *paths = sys.argv[1:]
    print(json.dumps({"fits": fits(paths), "overhead": overhead(int(count))}))


if __name__ == "__main__":
    main()
