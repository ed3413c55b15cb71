"""``fit4cad fit --single``: each cloud, or each segment of it that is given, is one primitive."""

from __future__ import annotations

import time
from typing import Any, Optional, Sequence

from .. import _engine
from .._errors import Diagnostic
from .._files import Group, texts_of
from .._segmentation import Segmentation
from .figures import align, json_text, precise, scientific
from .models import Hear, below, each_model, found, of_truth
from .terminal import clear, make_folder, print_text, tell, warn, write_file

Row = dict[str, Any]

#: What its submissions are called.
_METHOD = "SINGLE"


def recognise(paths: Sequence[str], *, out: Optional[str], as_json: bool) -> int:
    """Recognises what the paths name; gives the exit code."""
    if out is not None:
        make_folder(out)

    def visit(group: Group, _: Hear) -> tuple[Optional[Row], list[Diagnostic]]:
        model = group.read(of_truth)
        if len(model) == 0:
            return None, model.diagnostics
        start = time.perf_counter()
        truth = None if model.truth is None else model.truth._native
        segments, native = _engine.recognise(model._cloud, truth)
        seconds = time.perf_counter() - start
        row = {"engine": _engine.__version__, "model": model.name, "points": len(model), "seconds": seconds, "segments": segments}
        if out is not None:
            model.submissions[_METHOD] = Segmentation(native, model._cloud)
            for role, text in texts_of(model, _METHOD).items():
                write_file(below(out, _engine.path_of("test-set", model.name, role, _METHOD)), text)
            for each in segments:
                stem = model.name if len(segments) == 1 else f"{model.name}_{each['number']}"
                write_file(below(out, f"shrec2022/{_engine.file_name(stem)}.txt"), each["answer"])
        return row, model.diagnostics

    files, problems = found(paths)
    visited, unplaced, stops = each_model(files, visit, "recognising")
    clear()
    failed = tell([*problems, *(problem for _, told in visited for problem in told), *unplaced, *stops])
    models = [row for row, _ in visited if row is not None]
    if not models:
        warn("fit4cad fit: there was no cloud to fit; see fit4cad fit --help.")
    print_text(json_text(models) if as_json else _table(models))
    return 1 if failed or not models else 0


def _table(models: Sequence[Row]) -> str:
    if not models:
        return ""
    rows = [["model", "segment", "points", "type", "rms", "largest", "runner-up", "its rms", "margin"]]
    for model in models:
        for each in model["segments"]:
            best, second = each["best"], each["runnerUp"]
            rows.append(
                [
                    *(model["model"], str(each["number"]), str(each["points"])),
                    *(best["type"], scientific(best["rms"], 2), scientific(best["largest"], 2)),
                    *(second["type"], scientific(second["rms"], 2), precise(each["margin"], 3)),
                ]
            )
    return f"{align(rows, 1)}\n"
