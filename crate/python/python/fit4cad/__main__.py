"""``python -m fit4cad``: the commands and words of ``npx fit4cad``, on the same engine, without Node."""

from __future__ import annotations

import sys

from ._cli import main


def run() -> None:
    """Runs the command line and ends with its exit code."""
    sys.exit(main(sys.argv[1:]))


if __name__ == "__main__":
    run()
