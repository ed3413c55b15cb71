"""Fits a folder of clouds on a cluster that SLURM gives out, through dask-jobqueue.

    pip install 'fit4cad[distributed]' dask-jobqueue
    python examples/slurm.py /shared/abc --out /shared/abc-ht --jobs 50

Run it on a login node, in screen or tmux: it holds the scheduler, and each job is one node's workers. Folders must
be reached by the same paths from everywhere. When it is cut, or the jobs' time is up, run it again: it goes on where
it stopped.
"""

from __future__ import annotations

import argparse

from fit4cad import distributed as many


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--out", required=True)
    parser.add_argument("--method", default="ht")
    parser.add_argument("--jobs", type=int, default=10)
    parser.add_argument("--cores", type=int, default=32, help="of a node")
    parser.add_argument("--memory", default="64GB", help="of a node; a fit takes at most 200 bytes a point")
    parser.add_argument("--walltime", default="04:00:00")
    given = parser.parse_args()

    from dask.distributed import Client
    from dask_jobqueue import SLURMCluster

    # One thread a process: a model that has to be ended takes no other along.
    with SLURMCluster(cores=given.cores, processes=given.cores, memory=given.memory, walltime=given.walltime) as cluster:
        cluster.scale(jobs=given.jobs)
        with Client(cluster) as client:
            print(many.fit(given.paths, given.out, method=given.method, client=client, time_limit=120.0))


if __name__ == "__main__":
    main()
