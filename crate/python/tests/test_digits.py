"""The digits are those of the wasm under Node, to the last one."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import pytest

import fit4cad


def python(*args: object):
    done = subprocess.run([sys.executable, "-m", "fit4cad", *map(str, args)], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1) and "Traceback" not in done.stderr, done.stderr
    return done.stdout


def test_generated_parts_are_the_same_files(node, tmp_path):
    for name in [part["name"] for part in fit4cad.declared()["parts"]][:4]:
        options = ["--spacing", "0.02", "--noise", "0.001", "--outliers", "0.05", "--missing", "0.1", "--seed", "7", "--imperfect"]
        node("generate", name, *options, "--out", tmp_path / "node", as_json=False)
        python("generate", name, *options, "--out", tmp_path / "python")
    files = sorted(path.relative_to(tmp_path / "node") for path in (tmp_path / "node").rglob("*.txt"))
    assert len(files) == 4 * 7
    for file in files:
        assert (tmp_path / "node" / file).read_bytes() == (tmp_path / "python" / file).read_bytes(), file


@pytest.mark.parametrize("protocol", ["definition", "published"])
def test_scores_are_the_same(node, folder, protocol):
    theirs = node("score", folder, "--protocol", protocol, "--json")
    own = json.loads(python("score", folder, "--protocol", protocol, "--json"))
    assert len(own) == len(fit4cad.declared()["parts"])
    assert own == theirs


def test_the_table_is_the_same(node, folder):
    assert python("score", folder, "--self") == node("score", folder, "--self", as_json=False)


def test_figures_of_the_field_are_the_same(node, folder):
    theirs = {each["model"]: each for each in node("score", folder, "--protocol", "all", "--measures", "all", "--json")["results"]}
    models = list(fit4cad.read_all(folder))
    assert len(models) == len(theirs)
    for model in models:
        own = model.score_field("Imperfect").to_dict()
        figures = {each["figure"]: each["value"] for each in theirs[model.name]["figures"]}
        assert figures == own["figures"], model.name
        assert theirs[model.name]["primitives"] == own["primitives"] and theirs[model.name]["types"] == own["types"]


@pytest.mark.parametrize("method", ["ht", "pg"])
def test_fits_are_the_same_files(node, folder, tmp_path, method):
    theirs = node("fit", folder, "--method", method, "--out", tmp_path / "node", "--json")
    own = json.loads(python("fit", folder, "--method", method, "--out", tmp_path / "python", "--json"))
    for one, other in zip(own, theirs):
        del one["seconds"], other["seconds"]
    assert own == theirs
    files = [path for path in (tmp_path / "node").rglob("*") if path.is_file()]
    assert len(files) == 3 * len(own)
    for file in files:
        assert file.read_bytes() == (tmp_path / "python" / file.relative_to(tmp_path / "node")).read_bytes(), file


def test_audits_are_the_same(node, folder):
    assert json.loads(python("check", folder, "--json")) == node("check", folder, "--json")


def test_exports_are_the_same_bytes(node, folder, tmp_path):
    forms = ",".join([each["name"] for each in fit4cad.declared()["exports"]] + ["fit4cad", "step"])
    cloud = sorted(folder.glob("bracket*.txt"))
    node("export", *cloud, "--to", forms, "--out", tmp_path / "node", as_json=False)
    python("export", *cloud, "--to", forms, "--out", tmp_path / "python")
    files = [path for path in (tmp_path / "node").rglob("*") if path.is_file()]
    assert len(files) > 10
    for file in files:
        assert file.read_bytes() == (tmp_path / "python" / file.relative_to(tmp_path / "node")).read_bytes(), file


def test_what_is_declared_is_the_same(node):
    from conftest import NODE, ROOT

    script = """
      const { readFileSync } = await import("node:fs");
      const [engine, cad] = await Promise.all(process.argv.slice(1).map(async (name) => {
        const module = await import(`${name}.js`);
        module.initSync({ module: readFileSync(new URL(`${name}_bg.wasm`)) });
        return module;
      }));
      process.stdout.write(JSON.stringify({ ...engine.declarations(), importOptions: cad.importOptions() }));"""
    modules = [(ROOT / "bin" / name / name).as_uri() for name in ("engine", "cad")]
    done = subprocess.run([NODE, "--input-type=module", "-e", script, *modules], capture_output=True, text=True, check=True)
    theirs, own = json.loads(done.stdout), fit4cad.declared()
    for key, value in own.items():
        if key == "limits":
            continue
        # What is not there is null here, and null or absent there.
        assert without_nulls(json.loads(json.dumps(value))) == without_nulls(theirs[key]), key


def without_nulls(declared):
    """The entries of a list without those of their values that are null; anything else as it is."""
    if not isinstance(declared, list):
        return declared
    return [{name: it for name, it in one.items() if it is not None} for one in declared]


def test_the_colours_are_those_of_the_page(node):
    from conftest import NODE, ROOT

    from fit4cad import _colours

    script = "const p=await import(process.argv[1]);process.stdout.write(JSON.stringify([p.UNSEGMENTED,...p.SEGMENT_COLOURS]))"
    palette = (ROOT / "www" / "shared" / "palette.mjs").as_uri()
    done = subprocess.run([NODE, "--input-type=module", "-e", script, palette], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == [_colours.UNSEGMENTED, *_colours.SEGMENT_COLOURS]


def test_labels_that_come_without_surfaces_score_as_their_files_do(node, folder, tmp_path):
    model = fit4cad.read(folder, name="flange")
    labels = model.truth.labels
    np.savetxt(tmp_path / "flange.txt", model.points, fmt="%.17g")
    (tmp_path / "MINE").mkdir()
    np.savetxt(tmp_path / "flange_labels.txt", labels, fmt="%d")
    np.savetxt(tmp_path / "MINE" / "flange_labels.txt", np.where(labels == 2, 1, labels), fmt="%d")
    [theirs] = node("score", tmp_path, "--json")
    own = fit4cad.score(model.points, labels, np.where(labels == 2, 1, labels), model="flange", method="MINE")
    assert own.surfaces_fitted and theirs["surfacesFitted"]
    assert own.mean == theirs["mean"]
    assert own.rows() == theirs["primitives"]
