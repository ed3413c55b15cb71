"""What the tests share: the command line under Node, whose digits are the measure."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
NODE = os.environ.get("FIT4CAD_NODE") or shutil.which("node")
BIN = ROOT / "bin" / "fit4cad.mjs"


@pytest.fixture(scope="session")
def node():
    """Runs the command line under Node and gives what its JSON says; skips where it is not built."""
    if NODE is None or not (ROOT / "bin" / "engine" / "engine_bg.wasm").exists():
        pytest.skip("there is no Node, or the wasm is not built: nothing to compare with")

    def run(*args: object, as_json: bool = True):
        done = subprocess.run([NODE, str(BIN), *map(str, args)], capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), done.stderr
        return json.loads(done.stdout) if as_json else done.stdout

    return run


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """Every part of the catalogue as files, with a submission that is wrong on purpose."""
    import fit4cad

    out = tmp_path_factory.mktemp("parts")
    for part in fit4cad.declared()["parts"]:
        model = fit4cad.generate(part["name"], spacing=0.015)
        method = model.imperfect()
        fit4cad.write(model, out)
        fit4cad.write(model, out, method)
    return out
