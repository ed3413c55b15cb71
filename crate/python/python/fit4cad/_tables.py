"""Rows as tables of pandas and Arrow, which are loaded when first asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

if TYPE_CHECKING:
    import pandas
    import pyarrow

Row = dict[str, Any]


def wanted(module: str) -> Any:
    """A package that this one does without until it is needed."""
    import importlib

    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        name = module.split(".")[0]
        raise ModuleNotFoundError(f"{name} is not installed: pip install {name}", name=name) from error


class Table:
    """What has rows: ``to_pandas`` and ``to_arrow`` of anything that gives them."""

    def rows(self) -> Sequence[Row]:
        """The rows, each by the names of the columns."""
        raise NotImplementedError

    def to_pandas(self) -> pandas.DataFrame:
        """The rows as a ``pandas.DataFrame``. A value that cannot be had is missing."""
        return wanted("pandas").DataFrame.from_records(list(self.rows()))

    def to_arrow(self) -> pyarrow.Table:
        """The rows as a ``pyarrow.Table``. A value that cannot be had is null."""
        return wanted("pyarrow").Table.from_pylist(list(self.rows()))
