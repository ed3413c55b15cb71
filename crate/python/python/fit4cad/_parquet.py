"""Rows of a run on their way into Parquet files, and back."""

from __future__ import annotations

import itertools
import os
import time
import uuid
from pathlib import Path
from typing import Any

from ._files import StrPath
from ._tables import Row, wanted

#: A result is on disk after so many rows, or so many seconds, whichever comes first: what a cut run loses at most.
ROWS, SECONDS = 2000, 10.0


class Rows:
    """Rows on their way into Parquet files, each of them whole or not there."""

    def __init__(self, out: Path) -> None:
        self.out, self.rows, self.run = out, [], uuid.uuid4().hex[:12]  # type: ignore[var-annotated]
        self.parts, self.since = itertools.count(), time.monotonic()
        out.mkdir(parents=True, exist_ok=True)

    def add(self, rows: list[Row]) -> None:
        """Takes rows in, and writes when there are enough or it is time."""
        self.rows += rows
        if len(self.rows) >= ROWS or (self.rows and time.monotonic() - self.since >= SECONDS):
            self.flush()

    def flush(self) -> None:
        """Writes what there is."""
        self.since = time.monotonic()
        if not self.rows:
            return
        arrow, parquet = wanted("pyarrow"), wanted("pyarrow.parquet")
        path = self.out / f"part-{self.run}-{next(self.parts):06}.parquet"
        partial = path.with_name(f".{path.name}.partial")
        columns = list(dict.fromkeys(name for row in self.rows for name in row))
        table = arrow.Table.from_pylist([{name: row.get(name) for name in columns} for row in self.rows])
        parquet.write_table(table, partial)
        os.replace(partial, path)
        self.rows = []

    def known(self) -> frozenset[bytes]:
        """The keys of the rows there are."""
        parquet = wanted("pyarrow.parquet")
        keys: set[bytes] = set()
        for path in self.out.glob("part-*.parquet"):
            keys.update(parquet.read_table(path, columns=["key"]).column("key").to_pylist())
        return frozenset(keys - {b""})


def read(out: StrPath) -> Any:
    """The rows of a run so far, as a ``pyarrow.Table``: all of its files, of this run and those before it."""
    dataset = wanted("pyarrow.dataset")
    parts = sorted(str(path) for path in Path(out).glob("part-*.parquet"))
    arrow = wanted("pyarrow")
    if not parts:
        return arrow.table({})
    schema = arrow.unify_schemas(
        [dataset.dataset(part).schema for part in parts], promote_options="permissive"
    )
    return dataset.dataset(parts, schema=schema).to_table()
