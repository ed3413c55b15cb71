"""Both command lines, called alike, say the same on stdout and on stderr, write the same files and end with one code."""

from __future__ import annotations

import gzip
import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import BIN, NODE, ROOT

import fit4cad

#: A part of each kind of trouble: edges, thin faces, all five types.
PARTS = ("bracket", "flange", "knob")


def run(command, *args, cwd):
    done = subprocess.run([*command, *map(str, args)], capture_output=True, cwd=cwd, check=False)
    assert b"Traceback" not in done.stderr, done.stderr.decode()
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def without_seconds(text):
    """JSON without what a clock says."""
    found = json.loads(text)
    for each in found if isinstance(found, list) else []:
        each.pop("seconds", None)
    return found


@pytest.fixture
def both(node, tmp_path):
    """Calls both command lines in folders of their own and holds everything against each other; gives what they said."""

    def call(*args, into=None, code=0):
        said = []
        for name, command in (("node", [NODE, str(BIN)]), ("python", [sys.executable, "-m", "fit4cad"])):
            home = tmp_path / name
            home.mkdir(exist_ok=True)
            said.append(run(command, *args, cwd=home))
        (node_code, node_out, node_err), (own_code, own_out, own_err) = said
        assert own_err == node_err
        if "--json" in args:
            assert without_seconds(own_out) == without_seconds(node_out)
        elif args[0] == "fit":
            assert re.sub(r" +\d+\.\d{3} ", " ", own_out) == re.sub(r" +\d+\.\d{3} ", " ", node_out)
        else:
            assert own_out == node_out
        assert own_code == node_code == code, node_err
        same_files(tmp_path / "node", tmp_path / "python")
        return own_out

    return call


def same_files(one: Path, other: Path):
    def below(folder):
        return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    left, right = below(one), below(other)
    assert left.keys() == right.keys()
    for path, content in left.items():
        assert right[path] == content, path


@pytest.fixture(scope="module")
def scored(tmp_path_factory):
    """Three parts, scanned badly, with the answers of three methods: one finds half of it, one everything, one has labels
    without surfaces."""
    out = tmp_path_factory.mktemp("scored")
    for at, part in enumerate(PARTS):
        model = fit4cad.generate(part, spacing=0.02, noise=0.001 * at, missing=0.1 * at)
        fit4cad.write(model, out)
        fit4cad.write(model, out, model.imperfect())
        model.submissions["WHOLE"] = model.truth
        fit4cad.write(model, out, "WHOLE")
        (out / "LABELS").mkdir(exist_ok=True)
        labels = "\n".join("1" if label == 2 else str(label) for label in model.truth.labels)
        (out / "LABELS" / f"{part}_labels.txt").write_text(labels)
    (out / "note.md").write_text("of no kind that is read")
    return out


@pytest.fixture(scope="module")
def steps(tmp_path_factory):
    """STEP files of two parts, and one that is none."""
    out = tmp_path_factory.mktemp("steps")
    for part in PARTS[:2]:
        fit4cad.write(fit4cad.generate(part, spacing=0.02), out / f"{part}.step")
    # Of one name twice, and packed.
    (out / "flange.stp.gz").write_bytes(gzip.compress((out / "flange.step").read_bytes(), mtime=0))
    (out / "broken.stp").write_text("ISO-10303-21;")
    return out


@pytest.mark.parametrize("form", ["table", "csv", "latex", "markdown", "json"])
def test_scores_in_every_format(both, scored, form):
    both("score", scored, *(["--json"] if form == "json" else ["--format", form]))
    both("score", scored, "--self", "--protocol", "published", "--format", form)


@pytest.mark.parametrize("form", ["table", "csv", "latex", "markdown"])
def test_tables_for_a_paper(both, scored, form):
    bold = ["--bold"] if form in ("latex", "markdown") else []
    both("score", scored, "--means", "--digits", "2", *bold, "--format", form)
    both("score", scored, "--measures", "DSC,MFE,d1", "--digits", "12", *bold, "--format", form)
    both("score", scored, "--digits", "1", "--published", *bold, "--protocol", "published", "--format", form)


@pytest.mark.parametrize("form", ["table", "csv", "latex", "markdown"])
def test_published_rows(both, tmp_path, form):
    """Of a model with the counts of PC1, and of so many others that a LaTeX table takes more than a page."""
    for name in ("PC1", *(f"PC{number}" for number in range(100, 120))):
        count = 7500 if name == "PC1" else 800
        points = [(at % 31, at // 31 % 31, at % 8) for at in range(count)]
        for path, rows in (
            (f"{name}.xyz", [" ".join(map(str, point)) for point in points]),
            (f"{name}_labels.txt", [str(at % 8) for at in range(count)]),
            (f"MINE/{name}_labels.txt", [str(-1 if at % 5 == 0 else at % 8) for at in range(count)]),
            (f"HT (published)/{name}_labels.txt", [str(at % 8 // 2) for at in range(count)]),
        ):
            file = tmp_path / "set" / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text("\n".join(rows))
    bold = ["--bold"] if form in ("latex", "markdown") else []
    said = both("score", tmp_path / "set", "--published", *bold, "--format", form)
    assert "PG (published)" in said.replace("\\", "")
    both("score", tmp_path / "set", "--published", "--means", *bold, "--format", form)


@pytest.mark.parametrize("form", ["table", "csv", "latex", "markdown", "json"])
def test_the_protocols_of_the_field_in_every_format(both, scored, form):
    written = ["--json"] if form == "json" else ["--format", form]
    both("score", scored, "--protocol", "all", "--measures", "all", "--by", "type,size,noise,density,missing", *written)
    both("score", scored, "--protocol", "shrec2022,spfn,pq", "--by", "noise", "--normalisation", "unit-cube", *written)
    both("score", scored, "--measures", "all", "--epsilon", "0.02", *written)


def test_conditions_that_a_manifest_declares(both, scored):
    manifest = {"degradation": {"noise": 0.002, "missing": 0.5, "outliers": 1}, "models": [{"model": "flange"}, {"model": 3}, 7]}
    path = scored / "manifest.json"
    path.write_text(json.dumps(manifest))
    try:
        said = json.loads(both("score", scored, "--protocol", "spfn", "--by", "missing,noise", "--json"))
    finally:
        path.unlink()
    declared = [each for result in said["results"] if result["model"] == "flange" for each in result["conditions"] if each["declared"]]
    assert {each["value"] for each in declared} == {0.002, 0.5}


def test_threads_change_nothing(both, scored):
    alone = both("score", scored, "--json")
    assert both("score", scored, "--json", "--jobs", "3") == alone
    both("score", scored, "--protocol", "all", "--by", "noise", "--jobs", "2", "--json")
    one = without_seconds(both("fit", scored, "--method", "ht", "--out", "one", "--json"))
    many = without_seconds(both("fit", scored, "--method", "ht", "--out", "many", "--json", "--jobs", "0"))
    assert many == one


@pytest.mark.skipif(sys.platform == "win32", reason="there a signal ends a process at once")
def test_ctrl_c_ends_the_threads_too(tmp_path):
    model = fit4cad.generate("towers", spacing=0.004)
    for at in range(12):
        model.name = f"PC{at}"
        fit4cad.write(model, tmp_path / "set")
    command = [sys.executable, "-m", "fit4cad", "fit", "set", "--method", "ht", "--jobs", "2", "--out", "found"]
    running = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    # It is made before the first model is read.
    while not (tmp_path / "found").exists():
        time.sleep(0.02)
    time.sleep(1)
    running.send_signal(signal.SIGINT)
    out, told = running.communicate(timeout=60)
    assert (running.returncode, out, told) == (130, b"", b"")


@pytest.mark.parametrize("arguments", [["--method", "HT"], ["--method", "pg", "--seed", "7", "--sharp-quantile", "0.9"]])
def test_fits(both, scored, arguments):
    both("fit", scored, *arguments, "--out", "found", "--json")
    both("fit", scored / "flange.txt", *arguments)


def test_single_primitives(both, scored, tmp_path):
    both("fit", "--single", scored, "--out", "single", "--json")
    both("fit", "--single", scored / "knob.txt", "--out", "alone")


def test_statistics(both, scored):
    for form in (["--json"], [], ["--format", "csv"]):
        both("stats", scored, *form)
    both("stats", scored / "knob.txt")


def test_audits_and_corrections(both, scored, tmp_path):
    spoilt = tmp_path / "spoilt"
    spoilt.mkdir()
    for file in scored.glob("flange*.txt"):
        text = file.read_text()
        (spoilt / file.name).write_text(re.sub(r"\d\.\d", "9.9", text, count=1) if "parametric" in file.name else text)
    both("check", spoilt, "--json", "--write", "right", code=1)
    both("check", spoilt, scored, "--write", "right", code=1)


def test_exports(both, scored):
    forms = ",".join([*(each["name"] for each in fit4cad.declared()["exports"]), "step", "fit4cad"])
    both("export", scored, "--to", forms, "--out", "forms")
    both("export", scored / "knob.txt", "--to", "ply", code=1)


def test_parts(both):
    both("generate", "--list")
    both("generate", "flange", "--spacing", "0.03", "--imperfect", "--name", "Größe", "--out", "made")


def test_worse_scans(both, scored):
    both("degrade", scored, "--noise", "0.002", "--outliers", "0.02", "--missing", "0.1", "--seed", "7", "--out", "worse")
    both("degrade", scored, scored / "knob.txt", "--missing", "0.1")


def test_degraded_sets_of_the_standing_table(both, tmp_path):
    ten = tmp_path / "ten"
    for number in (1, 2, 5, 9, 11, 14, 16, 27, 31):
        fit4cad.write(fit4cad.generate("bracket", spacing=0.05, seed=number, name=f"PC{number}"), ten)
    both("degrade", ten, "--set", "test-10-missing", "--out", "worse", code=1)
    fit4cad.write(fit4cad.generate("bracket", spacing=0.05, name="PC33"), ten)
    for name in ("test-10-noise", "test-10-outliers"):
        both("degrade", ten, "--set", name, "--out", name)


def test_the_degraded_sets_are_those_of_the_standing_table(node):
    from fit4cad._sets import DEGRADED

    script = """
      const { setsOf } = await import(process.argv[1]);
      process.stdout.write(JSON.stringify(setsOf().sets.filter(({ degraded }) => degraded)));"""
    module = (ROOT / "bin" / "cli" / "standing" / "folder.mjs").as_uri()
    done = subprocess.run([NODE, "--input-type=module", "-e", script, module], capture_output=True, text=True, check=True)
    sets = {each["id"]: (each["title"], each["models"], each["degraded"]) for each in json.loads(done.stdout)}
    assert DEGRADED == sets


def test_models_of_step_files(both, steps):
    both("import", steps / "flange.step", "--points", "3000", "--bodies", "1", "--out", "one", "--json")
    both("import", steps, "--seed", "3", "--noise", "0.001", "--missing", "0.1", "--test", "0.5", "--out", "set", "--json", code=1)
    both("import", steps, "--spread", "random", "--spacing", "2", "--least", "9", "--separate", "--named", "--out", "plain", code=1)
    both("import", steps / "flange.step", "--bodies", "1,7", code=1)


@pytest.mark.parametrize(
    "arguments",
    [
        ["score"],
        ["score", "nowhere", "--json"],
        ["score", "nowhere"],
        ["score", "x", "--protocol", "spfm"],
        ["score", "x", "--epsilon", "1"],
        ["score", "x", "--measures", "all", "--epsilon", "-1"],
        ["score", "x", "--by", "colour"],
        ["score", "x", "--format", "yaml"],
        ["score", "x", "--bold"],
        ["score", "x", "--bold", "--format", "csv"],
        ["score", "x", "--means", "--measures", "DSC", "--json"],
        ["score", "x", "--digits", "2.5"],
        ["score", "x", "--measures", "DSC,residual"],
        ["score", "x", "--measures", "DSC", "--protocol", "spfn"],
        ["score", "x", "--protocol", "spfn", "--published", "--digits", "3"],
        ["score", "x", "--json", "--format", "csv"],
        ["score", "x", "--jobs", "-1"],
        ["score", "x", "--as", "role=clod:x"],
        ["score", "x", "--as", "flange"],
        ["fit", "x"],
        ["fit", "--method"],
        ["fit", "--method", "--json"],
        ["fit", "x", "--json=yes"],
        ["fit", "x", "-q"],
        ["fit", "x", "--tolerence", "1"],
        ["fit", "x", "--method", "ht", "--seed", "x"],
        ["fit", "x", "--method", "ht", "--sharp-quantile", "0.5"],
        ["fit", "x", "--method", "ht", "--smallest", "5.5"],
        ["fit", "x", "--method", "ht"],
        ["fit", "x", "--single", "--method", "ht"],
        ["fit", "x", "--single", "--jobs", "2"],
        ["fit", "--single"],
        ["export", "x"],
        ["export", "x", "--to", "ply,docx"],
        ["import"],
        ["import", "x", "--points", "5"],
        ["import", "x", "--points", "50", "--spacing", "1"],
        ["import", "x", "--spread", "odd"],
        ["import", "x", "--bodies", "0"],
        ["import", "x", "--test", "2"],
        ["import", "nowhere.step", "--json"],
        ["degrade", "x"],
        ["degrade", "x", "--set", "test-11"],
        ["degrade", "x", "--set", "test-10-noise", "--noise", "0.1"],
        ["degrade", "x", "--noise", "2"],
        ["generate"],
        ["generate", "flunge"],
        ["generate", "flange", "--name", "a/b"],
        ["generate", "--list", "flange"],
        ["stats", "nowhere"],
        ["check", "nowhere", "--json"],
    ],
)
def test_what_is_wrong_is_said_alike(both, arguments):
    both(*arguments, code=1 if "nowhere" in " ".join(arguments) or arguments == ["fit", "x", "--method", "ht"] else 2)


def test_help_names_every_option_of_the_other(node, tmp_path):
    for command in ("score", "fit", "export", "import", "check", "stats", "generate", "degrade"):
        _, theirs, _ = run([NODE, BIN], command, "--help", cwd=tmp_path)
        code, own, _ = run([sys.executable, "-m", "fit4cad"], command, "--help", cwd=tmp_path)
        assert code == 0
        # Of an option in an example of another command nothing is to be said.
        syntax = theirs.split("Examples:")[0].split("Example:")[0]
        assert set(re.findall(r"(?<![\w-])--[a-z-]+", syntax)) <= set(re.findall(r"--[a-z-]+", own)), command


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no disk that is always full")
def test_a_full_disk_and_a_reader_that_has_gone_are_borne(node):
    for command in ([NODE, BIN], [sys.executable, "-m", "fit4cad"]):
        with open("/dev/full", "w") as full:
            done = subprocess.run([*command, "generate", "--list"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert (done.returncode, done.stderr) == (1, "fit4cad: the result could not be printed: the disk is full\n")
        gone = subprocess.Popen([*command, "score", "--help"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        gone.stdout.close()
        assert (gone.stderr.read(), gone.wait()) == (b"", 0)


def test_commands_of_the_standing_table_are_said_to_be_elsewhere(tmp_path):
    code, _, told = run([sys.executable, "-m", "fit4cad"], "verify", "results/x", cwd=tmp_path)
    assert code == 2 and "npx fit4cad alone" in told
    code, _, told = run([sys.executable, "-m", "fit4cad"], "skore", cwd=tmp_path)
    assert code == 2 and "Commands: score, fit, export" in told
