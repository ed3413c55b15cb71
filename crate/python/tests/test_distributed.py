"""Many models on a cluster of this machine: nothing lost, nothing done twice, the digits of a plain loop."""

from __future__ import annotations

import os
import signal
import time

import pytest

import fit4cad

pytest.importorskip("distributed", reason="dask is not installed: pip install 'fit4cad[distributed]'")
pytest.importorskip("pyarrow", reason="pyarrow is not installed")

from fit4cad import distributed as many  # noqa: E402

PARTS = [part["name"] for part in fit4cad.declared()["parts"]]


def generated(count: int):
    """So many different models that are made where they are needed; of the part that is quickest made."""
    return [many.Generated("spool", f"PC{at}", {"spacing": 0.1, "noise": 0.001, "seed": at + 1}) for at in range(count)]


@pytest.fixture(scope="module")
def client():
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True) as cluster, Client(cluster) as client:
        yield client


def rows_of(out):
    rows = many.read(out).to_pylist()
    return {(row["model"], row.get("method")): row for row in rows}, rows


def serial(tasks):
    for task in tasks:
        model, _ = task.load(False)
        yield (model.name, "Imperfect"), model.score("Imperfect").summary()


def test_two_thousand_models_survive_a_killed_worker_with_the_digits_of_a_loop(client, tmp_path):
    tasks = generated(2000)
    killed = []

    def kill(done, of):
        if done > 300 and not killed:
            pids = client.run(os.getpid)
            killed.append(next(iter(pids.values())))
            os.kill(killed[0], getattr(signal, "SIGKILL", signal.SIGTERM))

    summary = many.score(tasks, tmp_path / "run", client=client, progress=kill)
    assert killed and (summary.models, summary.failed) == (2000, 0)
    found, rows = rows_of(tmp_path / "run")
    assert len(rows) == len(found) == 2000
    for key, wanted in serial(tasks[::10]):
        row = found[key]
        assert {name: row[name] for name in wanted} == wanted


def test_a_cut_run_goes_on_where_it_stopped(client, tmp_path):
    class Cut(Exception):
        pass

    def cut(done, of):
        if done >= 40:
            raise Cut

    tasks, out = generated(120), tmp_path / "run"
    with pytest.raises(Cut):
        many.score(tasks, out, client=client, batch=4, progress=cut)
    before = len(many.read(out))
    assert 40 <= before < 120
    summary = many.score(tasks, out, client=client, batch=4)
    assert (summary.known, summary.models) == (before, 120 - before)
    found, rows = rows_of(out)
    assert len(rows) == len(found) == 120
    # Another protocol is other work.
    assert many.score(tasks[:5], out, client=client, protocol="published").models == 5


def test_files_are_told_by_their_content_and_broken_models_stop_nothing(client, tmp_path):
    folder = tmp_path / "set"
    for at in range(6):
        model = fit4cad.generate(PARTS[at], spacing=0.04, name=f"PC{at + 1}")
        fit4cad.write(model, folder)
        fit4cad.write(model, folder, model.imperfect())
    (folder / "PC3.txt").write_text("nothing of a cloud\n")
    (folder / "PC9.ply").write_bytes(b"ply\nformat nonsense\n")
    out = tmp_path / "run"
    summary = many.score(folder, out, client=client, batch=3)
    assert (summary.models, summary.failed) == (7, 2)
    found, _ = rows_of(out)
    assert "no ground truth" in found["PC9", None]["error"]
    own = fit4cad.read(folder, name="PC1").score("Imperfect").summary()
    assert {name: found["PC1", "Imperfect"][name] for name in own} == own
    # What has changed is done again, what has failed is tried again, all else is known.
    model = fit4cad.generate(PARTS[2], spacing=0.04, name="PC3")
    fit4cad.write(model, folder)
    again = many.score(folder, out, client=client)
    assert (again.known, again.models, again.failed) == (5, 2, 1)


def test_fits_are_those_of_a_loop_and_are_written(client, tmp_path):
    tasks = [many.Generated("shaft", f"PC{at}", {"spacing": 0.02, "seed": at + 1}) for at in range(5)]
    many.fit(tasks, tmp_path / "run", method="pg", files=tmp_path / "found", client=client)
    found, _ = rows_of(tmp_path / "run")
    for task in tasks:
        model, _ = task.load(True)
        wanted = fit4cad.fit(model, "pg")
        row = found[task.name, "PG"]
        assert [(each["type"], each["points"], each["mfe"]) for each in row["primitives"]] == [(each.type, len(each), each.mfe) for each in wanted]
        assert list(row["primitives"][0]["parametric"]) == wanted[0].parametric.tolist()
    assert len(list((tmp_path / "found").rglob("*.txt"))) == 3 * len(tasks)


class Endless:
    """A model that never comes."""

    name = "endless"

    def load(self, clouds_only):
        while True:
            time.sleep(0.05)


def test_a_straggler_is_bounded_and_its_worker_started_again(tmp_path):
    import sys

    # Pickled with this module, which the workers have not.
    import cloudpickle
    import dask
    from distributed import Client, LocalCluster

    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}):
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            start = time.monotonic()
            summary = many.score([*generated(6), Endless(), *generated(6)[3:]], tmp_path, client=client, batch=2, time_limit=4.0)
            assert time.monotonic() - start < 300
            assert summary.models == 10 and summary.failed == 1
            client.wait_for_workers(2, timeout=60)
    found, _ = rows_of(tmp_path)
    assert "took its worker down" in found["endless", None]["error"]


def test_a_fit_that_takes_too_long_is_ended(client, tmp_path):
    slow = many.Generated("towers", "slow", {"spacing": 0.004})
    summary = many.fit([slow], tmp_path, client=client, batch=1, time_limit=0.2)
    assert (summary.models, summary.failed) == (1, 1)
    # By itself where it hears of the limit in time; on a busy machine with its worker.
    error = rows_of(tmp_path)[0]["slow", None]["error"]
    assert "longer than 0.2 s" in error or "took its worker down" in error
    # What failed is tried again, and has all the time it wants.
    quick = many.Generated("spool", "slow", {"spacing": 0.1})
    assert many.fit([quick], tmp_path, client=client).failed == 0


def test_bags_are_inputs_too_and_what_is_wrong_is_said_at_once(client, tmp_path):
    bag = pytest.importorskip("dask.bag")
    assert many.score(bag.from_sequence(generated(5), npartitions=2), tmp_path, client=client).models == 5
    with pytest.raises(ValueError, match="there are definition"):
        many.score(generated(1), tmp_path, client=client, protocol="fair")
    with pytest.raises(ValueError, match="there are tolerance"):
        many.fit(generated(1), tmp_path, client=client, tolerence=1)
    with pytest.raises(fit4cad.InputError, match="there is no such file or folder"):
        many.score(tmp_path / "nowhere", tmp_path, client=client)
