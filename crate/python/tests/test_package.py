"""What the package gives and refuses."""

from __future__ import annotations

import _thread
import dataclasses
import gzip
import pickle
import subprocess
import sys
import threading
import time
import zipfile

import numpy as np
import pytest

import fit4cad


def test_points_labels_types_and_surfaces_score_as_arrays():
    model = fit4cad.generate("flange", spacing=0.02)
    labels = model.truth.labels
    primitives = model.truth.primitives
    surfaces = {at: each.surface for at, each in enumerate(primitives)}
    types = [each.type for each in primitives]
    truth = fit4cad.Segmentation.from_labels(model.points, labels, types, surfaces)
    report = fit4cad.score(model.points, truth, labels, types, surfaces)
    assert (report["DSC"], report.type_errors, report.surfaces_fitted) == (1.0, 0, False)
    assert report.truth == report.predicted == len(primitives)
    assert report["MFE"] < 1e-9
    # A point on an edge has one label and several primitives.
    assert 0.8 < fit4cad.score(model.points, model.truth, labels)["DSC"] < 1


def test_float32_lists_and_strided_arrays_are_points_too():
    grid = [[float(x), float(y), 3.0] for x in range(12) for y in range(12)]
    for points in (grid, np.float32(grid), np.asfortranarray(grid), np.repeat(grid, 2, axis=0)[::2]):
        [plane] = fit4cad.fit(points, "pg")
        assert plane.type == "Plane" and len(plane) == 144 and plane.surface.offset == 3.0
        assert plane.points.dtype == np.uint32


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: fit4cad.fit(np.zeros((3, 2))), r"shape \(n, 3\)"),
        (lambda: fit4cad.fit(np.zeros((9, 3)), "hough"), "there are ht, pg"),
        (lambda: fit4cad.fit(np.zeros((9, 3)), tolerence=1), "there are tolerance"),
        (lambda: fit4cad.fit(np.zeros((9, 3)), smallest=5.5), "whole number from 4 to 1000"),
        (lambda: fit4cad.fit(np.zeros((9, 3)), sharp_quantile=0.5), "no parameter of ht"),
        (lambda: fit4cad.score(np.zeros((9, 3)), [0] * 8, [0] * 9), r"shape \(9,\)"),
        (lambda: fit4cad.score(np.zeros((9, 3)), [0.5] * 9, [0] * 9), "whole numbers"),
        (lambda: fit4cad.score(np.zeros((9, 3)), [0] * 9, [0] * 9, ["Plain"]), "there are Plane, Cylinder"),
        (lambda: fit4cad.score(np.zeros((9, 3)), [0] * 9, [0] * 9, {4: "Plane"}), "no point has the label 4"),
        (lambda: fit4cad.score(np.zeros((9, 3)), [0] * 9, [0] * 9, protocol="spfn"), "score_field"),
        (lambda: fit4cad.generate("flunge"), "choose one of bracket"),
        (lambda: fit4cad.generate("flange", noise=2), "`noise` must be a number from 0 to"),
        (lambda: fit4cad.generate("flange").score("HT"), "no submission of `HT`"),
        (lambda: fit4cad.surface_of("Plane", [1, 2]), "9"),
        (lambda: fit4cad.score_field(np.zeros((9, 3)), [0] * 9, [0] * 9, normalisation="metre"), "choose primitive"),
    ],
)
def test_what_is_wrong_is_said_with_what_there_is(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_a_broken_file_is_an_exception_with_file_line_and_what_to_do(tmp_path):
    model = fit4cad.generate("bracket", spacing=0.03)
    fit4cad.write(model, tmp_path)
    lists = tmp_path / "bracket_primitives.txt"
    lists.write_text(lists.read_text().replace("Primitive2:=[", "Primitive2:=[99999999,", 1))
    with pytest.raises(fit4cad.InputError) as raised:
        fit4cad.read(tmp_path)
    error = raised.value
    assert error.file == str(lists) and error.line >= 2 and error.hint
    assert f"{lists}:{error.line}:{error.column}: error:" in str(error)
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    lenient = fit4cad.read(tmp_path, strict=False)
    assert len(lenient.truth) == len(model.truth)
    assert any(each.severity == "error" for each in lenient.diagnostics)


def test_absent_and_ambiguous_paths_are_said(tmp_path):
    with pytest.raises(fit4cad.InputError, match="there is no such file or folder"):
        fit4cad.read(tmp_path / "nothing.ply")
    for name in ("a", "b"):
        fit4cad.write(fit4cad.generate("plate", spacing=0.05, name=name), tmp_path)
    with pytest.raises(fit4cad.InputError, match="2 models: a, b"):
        fit4cad.read(tmp_path)
    assert fit4cad.read(tmp_path, name="b").name == "b"


@pytest.mark.parametrize("name", ["p.ply", "p.npz", "p.vg", "p.xyzc"])
def test_points_and_labels_come_back_from_other_programs_files(tmp_path, name):
    model = fit4cad.generate("knob", spacing=0.03)
    fit4cad.write(model, tmp_path / name)
    again = fit4cad.read(tmp_path / name)
    assert np.allclose(again.points, model.points, atol=1e-5)
    assert len(again.truth) == len(model.truth) and None in again.fitted


def test_the_documentation_of_read_names_every_kind_of_file():
    for kind in fit4cad.declared()["fileKinds"]:
        assert kind["title"] in fit4cad.read.__doc__ and f".{kind['endings'][0]}" in fit4cad.read.__doc__


def test_long_texts_are_read_in_pieces(tmp_path, monkeypatch):
    from fit4cad._files import File

    path = tmp_path / "long.xyz"
    rows = [f"{at % 1000:.6f} {at // 1000:.6f} {at * 0.001:.6f}\n" for at in range(400_000)]
    rows[300_000] = "1.0 x 2.0\n"
    path.write_text("".join(rows))
    monkeypatch.setattr(File, "read", lambda self: pytest.fail("it is asked for whole"))
    model = fit4cad.read(path, strict=False)
    [error] = model.diagnostics
    assert (len(model), error.line, error.column) == (399_999, 300_001, 5)
    assert model.points[-1].tolist() == [999, 399, 399.999]


def test_clouds_of_single_primitives_are_segments_of_the_cloud_beside_them(tmp_path):
    model = fit4cad.generate("plate", spacing=0.03)
    rows = lambda points: "".join(f"{x} {y} {z}\n" for x, y, z in points.tolist())
    (tmp_path / "plate.xyz").write_text(rows(model.points))
    (tmp_path / "RANSAC").mkdir()
    for at, each in enumerate(model.truth.primitives, 1):
        name = f"{each.type}_{at:04}.txt"
        (tmp_path / "RANSAC" / name).write_text(rows(np.float32(model.points[each.points])))
    found = fit4cad.read(tmp_path).submissions["RANSAC"].primitives
    order = sorted(model.truth.primitives, key=lambda each: each.type)
    assert sorted(each.points.tolist() for each in found) == sorted(each.points.tolist() for each in order)


def test_step_goes_out_and_comes_back(tmp_path):
    model = fit4cad.generate("bracket", spacing=0.02)
    fit4cad.write(model, tmp_path / "part.step")
    again = fit4cad.read(tmp_path / "part.step", points=3000)
    assert again.imported["faces"] and len(again) > 1000
    assert set(each.type for each in again.truth) <= {"Plane", "Cylinder", "Cone", "Sphere", "Torus"}
    packed = tmp_path / "part.STP.gz"
    packed.write_bytes(gzip.compress((tmp_path / "part.step").read_bytes()))
    one = fit4cad.read(packed, points=3000, bodies=[1])
    assert one.name == "part" and np.array_equal(one.points, again.points)
    with pytest.raises(fit4cad.InputError, match="7"):
        fit4cad.read(packed, bodies=[7])
    scan = fit4cad.read(tmp_path / "part.step", points=3000, spread="scan", views=1)
    seen = [sum(face["points"] > 0 for face in model.imported["faces"]) for model in (scan, again)]
    assert 0 < seen[0] < seen[1]


def test_zips_are_read_and_what_is_damaged_is_said(tmp_path):
    fit4cad.write(fit4cad.generate("plate", spacing=0.05), tmp_path / "set")
    with zipfile.ZipFile(tmp_path / "set.zip", "w") as archive:
        for file in (tmp_path / "set").iterdir():
            archive.write(file, f"set/{file.name}")
    model = fit4cad.read(tmp_path / "set.zip")
    assert model.score()["DSC"] == 1.0
    content = bytearray((tmp_path / "set.zip").read_bytes())
    content[60:80] = bytes(20)
    (tmp_path / "broken.zip").write_bytes(content)
    with pytest.raises(fit4cad.InputError, match="damaged"):
        fit4cad.read(tmp_path / "broken.zip")


def test_the_noise_is_told_and_every_parameter_has_a_standard_error():
    model = fit4cad.generate("flange", spacing=0.03, noise=0.002)
    measured = fit4cad.fit(model)
    assert measured.noise.source == "measured" and measured.noise.kind == "scattered"
    given = fit4cad.fit(model, noise=2 * measured.noise.deviation)
    assert given.noise == fit4cad.Noise(2 * measured.noise.deviation, "given", None, 0.0)
    assert model.truth.noise is None
    for each in measured:
        errors = each.standard_errors
        assert errors.position is None or errors.position > 0
        assert (errors.radius is None) == (each.type in ("Plane", "Cone") or errors == fit4cad.StandardErrors())
    with pytest.raises(ValueError, match="from corner to corner"):
        fit4cad.fit(model, noise=1e6)


def test_progress_rises_and_what_it_raises_ends_the_fit():
    model = fit4cad.generate("towers", spacing=0.02)
    heard = []
    fit4cad.fit(model, progress=lambda stage, share: heard.append((stage, share)))
    stages = [each["name"] for each in fit4cad.declared()["stages"]]
    places = [stages.index(stage) for stage, _ in heard]
    assert places == sorted(places) and heard[-1][0] == "patches"

    def stop(stage, share):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        fit4cad.fit(model, progress=stop)


def test_the_lock_is_released_and_ctrl_c_ends_a_fit():
    model = fit4cad.generate("towers", spacing=0.002)
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    interrupt = threading.Timer(0.3, _thread.interrupt_main)
    thread.start()
    interrupt.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            fit4cad.fit(model, "ht")
    finally:
        done.set()
        thread.join()
    assert len(ticks) > 10


def test_many_give_what_one_by_one_gives():
    models = [fit4cad.generate(part["name"], spacing=0.03) for part in fit4cad.declared()["parts"][:5]]
    done = []
    for model, found in zip(models, fit4cad.fit_many(models, "pg", jobs=3, progress=lambda now, of: done.append((now, of)))):
        model.submissions["PG"] = found
        assert found.rows() == fit4cad.fit(model, "pg").rows()
    assert done[-1] == (5, 5)
    many = fit4cad.score_many(models, jobs=2)
    assert [each.to_dict() for each in many] == [model.score("PG").to_dict() for model in models]
    [summary] = fit4cad.summarise(many)
    assert summary["models"] == 5 and summary["over"]["DSC"]["count"] == 5


def test_results_are_tables():
    pytest.importorskip("pandas", reason="pandas is not installed")
    pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    model = fit4cad.generate("shaft", spacing=0.03)
    report = model.score()
    frame, table = report.to_pandas(), report.to_arrow()
    assert list(frame["truth"]) == table.column("truth").to_pylist() == [row.truth for row in report.primitives]
    assert {"DSC", "MFE"} <= set(frame.columns) == set(table.column_names)
    assert model.truth.to_arrow().num_rows == len(model.truth)
    assert dataclasses.is_dataclass(report) and isinstance(report.primitives[0].measures["DSC"], float)
    assert pickle.loads(pickle.dumps(report)) == report


def test_segments_get_their_surfaces():
    model = fit4cad.generate("ball-joint", spacing=0.03)
    found = fit4cad.fit_segments(model.points, model.truth.labels)
    wanted = {number: each.type for number, each in enumerate(model.truth)}
    large = [each for each in found if len(each) >= 60]
    assert len(large) > 3 and all(each.type == wanted[each.number] for each in large)
    told = fit4cad.fit_segments(model.points, model.truth.labels, list(wanted.values()))
    assert [each.type for each in told] == list(wanted.values())
    for each in found:
        assert np.median(each.surface.distance(model.points[each.points])) < 1e-3 * np.ptp(model.points)
    sphere = next(each for each in model.truth if each.type == "Sphere")
    single = fit4cad.fit_single(model.points[sphere.points])
    assert single.best.type == "Sphere" and single.margin > 1


def test_surfaces_and_their_vectors_are_each_others_inverse():
    for part in ("flange", "ball-joint", "nozzle", "elbow"):
        for each in fit4cad.generate(part, spacing=0.03).truth:
            for form, vector in (("parametric", each.parametric), ("implicit", each.implicit)):
                surface, misfit = fit4cad.surface_of(each.type, vector, form)
                assert misfit < 1e-6 and surface.type == each.type


def test_a_worse_scan_keeps_its_truth():
    model = fit4cad.generate("flange", spacing=0.03)
    worse = fit4cad.degrade(model, noise=0.001, missing=0.2, outliers=0.1, seed=3)
    assert len(worse) != len(model) and worse.truth is not None
    again = fit4cad.degrade(model.points, model.truth, noise=0.001, missing=0.2, outliers=0.1, seed=3)
    assert np.array_equal(worse.points, again.points)
    thinned = fit4cad.degrade(model, density=10, seed=3)
    assert 0.2 * len(model) < len(thinned) < 0.6 * len(model)
    with pytest.raises(ValueError, match="density"):
        fit4cad.degrade(model, density=0)


def test_a_truth_that_is_wrong_is_found_and_corrected(tmp_path):
    model = fit4cad.generate("bracket", spacing=0.03)
    assert fit4cad.check(model).ok
    fit4cad.write(model, tmp_path)
    surfaces = tmp_path / "bracket_implicit.txt"
    lines = surfaces.read_text()
    first = lines.index("]")
    surfaces.write_text(lines[:first].rsplit(" ", 1)[0] + " 12345.0" + lines[first:])
    audit = fit4cad.check(fit4cad.read(tmp_path))
    assert not audit.ok and audit.corrections[0]["form"] == "implicit" and "implicit" in audit.corrected
    assert all(row["message"] for row in audit.rows())


def test_the_command_line_says_what_is_wrong(tmp_path):
    def run(*args):
        return subprocess.run([sys.executable, "-m", "fit4cad", *args], capture_output=True, text=True, cwd=tmp_path, check=False)

    assert run("--version").stdout == f"fit4cad {fit4cad.__version__}\n"
    assert run("score").returncode == 2
    failed = run("fit", "x", "--method", "ht", "--tolerance", "9", "--json")
    assert failed.returncode == 2 and "from 0 to 0.05" in failed.stderr and '"error"' in failed.stdout
    absent = run("score", "nowhere")
    assert absent.returncode == 1 and "nowhere: error: there is no such file or folder" in absent.stderr


def test_hdf5_as_h5py_writes_it_is_read(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    at = np.arange(60)
    plane = np.stack([at % 10 * 0.1, at // 10 * 0.1, np.zeros(60)], 1)
    points = np.concatenate([plane, plane[:, [2, 0, 1]] + [0, 0, 1]])
    labels = np.repeat([0, 1], 60)
    with h5py.File(tmp_path / "train_data.h5", "w") as file:
        file.create_dataset("points", data=np.stack([points, 2 * points]), compression="gzip", shuffle=True)
        file.create_dataset("labels", data=np.stack([labels, labels]), compression="lzf")
        file["prim"] = np.ones((2, 120), dtype="u1")
    with h5py.File(tmp_path / "predictions.h5", "w") as file:
        file["seg_id"] = np.stack([labels, labels])
    first, second = fit4cad.read_all(tmp_path)
    assert [first.name, second.name] == ["00000", "00001"]
    assert np.array_equal(second.points, 2 * points)
    assert list(first.submissions) == ["predictions"]
    assert first.score("predictions")["DSC"] == 1
    # Files of another machine are read there: what names them can be sent.
    from fit4cad._files import collect

    files, problems = collect([tmp_path])
    assert problems == [] and pickle.loads(pickle.dumps(files[0])).read() == files[0].read()


def test_a_long_cloud_in_a_zip_is_read_in_pieces(tmp_path):
    rows = "".join(f"{at % 977}.25 {at % 101}.125 {at}.5\n" for at in range(500_000))
    with zipfile.ZipFile(tmp_path / "a.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("long.xyz", rows)
    with gzip.open(tmp_path / "other.xyz.gz", "wt", compresslevel=1) as stream:
        stream.write(rows)
    from fit4cad._files import collect

    (entry, _), _ = collect([tmp_path])
    part = entry.parts()
    text = rows.encode()
    for start in [0, 3, 4_000_000, 4_000_010, 9_000_000, 5]:
        assert part(start, start + 100) == text[start : start + 100]
    models = list(fit4cad.read_all(tmp_path))
    assert [len(model.points) for model in models] == [500_000, 500_000]
    assert np.array_equal(models[0].points, models[1].points)
