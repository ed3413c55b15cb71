"""The examples run."""

from __future__ import annotations

import subprocess
import sys

import pytest
from conftest import ROOT

EXAMPLES = ROOT / "examples"


def test_the_notebook_runs_from_top_to_bottom():
    pytest.importorskip("ipykernel", reason="ipykernel is not installed")
    pytest.importorskip("pandas", reason="pandas is not installed")
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    nbformat = pytest.importorskip("nbformat", reason="nbformat is not installed")
    nbclient = pytest.importorskip("nbclient", reason="nbclient is not installed")
    notebook = nbformat.read(EXAMPLES / "fit4cad.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in outputs)
    assert not any(output.output_type == "error" for output in outputs)


def test_the_local_cluster_measures_itself(tmp_path):
    pytest.importorskip("distributed", reason="dask is not installed")
    pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    script = EXAMPLES / "local_cluster.py"
    done = subprocess.run([sys.executable, script, "--models", "60", "--spacing", "0.05", "--out", tmp_path], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "60 models" in done.stdout and "models per second per core" in done.stdout
