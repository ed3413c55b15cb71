"""The command line of ``npx fit4cad``, with its words, its options, its JSON and its exit codes, on the same engine
and without Node. ``submit`` and ``verify``, which keep a checkout's standing table, are of that one alone."""

from .main import main

__all__ = ["main"]
