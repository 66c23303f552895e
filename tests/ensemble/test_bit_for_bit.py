"""The same ensemble, to the last bit: on threads, after interruptions, on a cluster."""

import importlib.util
import json
import multiprocessing
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import tracemalloc
from pathlib import Path

import pytest
from ensemble_stores import VARY, assert_identical, files
from processes import CLPT, GUARD, await_line, listening, started, without_progress

import clpt_control
from clpt_control.ensemble.members import Ensemble
from clpt_control.ensemble.run import run_ensemble
from clpt_control.ensemble.store import open_store
from clpt_control.errors import ClptError, DataError, ScenarioError, SimulationError


@pytest.mark.parametrize(("threads", "chunk"), [(1, 7), (2, 3), (3, 1000)])
def test_threads_and_chunks_do_not_matter(scenario, whole, tmp_path, threads, chunk):
    given = {"seed": 3, "trajectories": True, "threads": threads, "chunk": chunk}
    data = run_ensemble(scenario, VARY, 40, out=tmp_path / "e.zarr", **given)
    assert_identical(data, whole)


def test_the_batch_does_not_matter(scenario, whole, monkeypatch):
    monkeypatch.setattr(Ensemble, "batch", 8)
    data = run_ensemble(scenario, VARY, 40, seed=3, threads=2, trajectories=True)
    assert_identical(data, whole)


KILLED = """
import sys
import threading
import clpt_control
from clpt_control.ensemble.run import run_ensemble
scenario = clpt_control.load_scenario(sys.argv[1])
def stop(done):
    if done >= 40:
        print("far", flush=True)
        threading.Event().wait()
run_ensemble(
    scenario, sys.argv[4:], int(sys.argv[3]), seed=1, out=sys.argv[2], chunk=20, progress=stop
)
"""


def test_killed_and_started_again(quick, tmp_path):
    members, file = 120, tmp_path / "scenario.toml"
    clpt_control.save_scenario(quick, file)
    out, wanted = tmp_path / "killed.zarr", tmp_path / "whole.zarr"
    words = [sys.executable, "-c", KILLED, file, out, members, *VARY]
    with started(words, stderr=None) as work:
        await_line(work, work.stdout, "far")
    missing = open_store(out).missing()
    assert 0 < len(missing) < members // 20
    counts = []
    again = clpt_control.load_scenario(file)
    run_ensemble(again, VARY, members, seed=1, out=out, chunk=20, progress=counts.append)
    assert counts[0] == members - 20 * len(missing)
    assert counts[-1] == members
    run_ensemble(again, VARY, members, seed=1, out=wanted, chunk=20)
    assert files(out) == files(wanted)


def test_an_interrupt_leaves_whole_chunks(quick, tmp_path):
    def stop(done):
        if done >= 30:
            raise KeyboardInterrupt

    out = tmp_path / "e.zarr"
    with pytest.raises(KeyboardInterrupt):
        run_ensemble(quick, VARY, 100, out=out, chunk=10, threads=2, progress=stop)
    assert 0 < len(open_store(out).missing()) < 10
    data = run_ensemble(quick, VARY, 100, out=out, chunk=10)
    assert_identical(data, run_ensemble(quick, VARY, 100))


def test_a_whole_ensemble_is_not_run_again(quick, tmp_path, monkeypatch):
    first = run_ensemble(quick, VARY, 20, out=tmp_path / "e.zarr").load()
    monkeypatch.setattr(Ensemble, "summaries", None)
    assert_identical(run_ensemble(quick, VARY, 20, out=tmp_path / "e.zarr"), first)


def edited(key, value):
    def edit(path):
        metadata = json.loads(path.read_text())
        metadata[key] = value
        path.write_text(json.dumps(metadata))

    return edit


def flipped(path):
    raw = bytearray(path.read_bytes())
    raw[len(raw) // 2] ^= 0xFF
    path.write_bytes(raw)


LOST = {  # file -> what happens to it
    "gain_error/zarr.json": Path.unlink,
    "learning.gain/zarr.json": edited("shape", [7]),
    "end/zarr.json": edited("data_type", "float32"),
    "mark/zarr.json": edited("dimension_names", ["time"]),
    "alpha/zarr.json": edited("attributes", {}),
    "done/zarr.json": edited("shape", [9]),
    "clpe_rms/zarr.json": edited("fill_value", 0.0),
    "zarr.json": flipped,
    "time/c/0": flipped,
    "learning.gain/c/1": flipped,
    "member/c/0": Path.unlink,
}


@pytest.fixture(scope="module")
def stored(scenario, tmp_path_factory):
    """A whole store of a short ensemble, with how to run it."""
    quick = scenario.with_values({"run.duration": 10})
    out = tmp_path_factory.mktemp("stored") / "e.zarr"

    def run(path):
        return run_ensemble(quick, VARY[0], 6, out=path, chunk=3, threads=1, trajectories=True)

    run(out)
    return out, run


@pytest.mark.parametrize("name", LOST)
def test_a_store_without_what_it_must_hold_is_named_and_left(stored, tmp_path, name):
    whole, run = stored
    out = tmp_path / "e.zarr"
    shutil.copytree(whole, out)
    LOST[name](out / name)
    before = files(out)
    array = re.escape(name.partition("/")[0])
    with pytest.raises(DataError, match=rf"e\.zarr: is (no ensemble|damaged, .*its {array} is)"):
        run(out)
    assert files(out) == before


@pytest.mark.parametrize("size", [10**6, 3 * 10**7])
def test_an_array_that_says_it_holds_much_is_refused_unread(stored, tmp_path, size):
    out = shutil.copytree(stored[0], tmp_path / "e.zarr")
    form = out / "learning.gain" / "zarr.json"
    form.write_text(json.dumps(json.loads(form.read_text()) | {"shape": [size]}))
    tracemalloc.start()
    with pytest.raises(DataError, match=r"its learning\.gain is not as it was made"):
        open_store(out)
    assert tracemalloc.get_traced_memory()[1] < 10**7
    tracemalloc.stop()


def shortened(path):
    path.write_bytes(path.read_bytes()[:-6])


@pytest.mark.parametrize(
    ("name", "damage"),
    [
        ("gain_error/c/0/0", flipped),
        ("alpha/c/1/0/0/0", flipped),
        ("gain_error/c/1/0", shortened),
        ("done/c/0", shortened),  # a checksum
        ("clpe_rms_whole/c/1", Path.unlink),
        ("alpha/c/1/0/0/0", Path.unlink),
    ],
)
def test_a_damaged_chunk_is_run_again(stored, tmp_path, name, damage):
    whole, run = stored
    out = tmp_path / "e.zarr"
    shutil.copytree(whole, out)
    damage(out / name)
    run(out)
    assert files(out) == files(whole)


def test_a_store_that_memory_does_not_suffice_for_is_removed(quick, tmp_path, monkeypatch):
    def too_much(work, values):
        raise MemoryError

    monkeypatch.setattr(Ensemble, "summaries", too_much)
    with pytest.raises(MemoryError):
        run_ensemble(quick, VARY[0], 4, out=tmp_path / "e.zarr", threads=1)
    assert not list(tmp_path.iterdir())


DASK = pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="no Dask")


@pytest.mark.processes
@DASK
def test_a_dask_worker_is_killed(scenario, tmp_path):
    from distributed import Client, LocalCluster

    given, killed = {"members": 240, "seed": 1, "chunk": 10}, []
    here = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
    with LocalCluster(**here) as cluster, Client(cluster) as client:
        pids = list(client.run(os.getpid).values())

        def kill_one(done):
            if done and not killed:
                killed.append(pids[0])
                os.kill(pids[0], signal.SIGKILL)

        to = {"out": tmp_path / "d.zarr", "dask": cluster.scheduler_address, "progress": kill_one}
        data = run_ensemble(scenario, VARY, **given, **to)
    assert killed
    assert_identical(data, run_ensemble(scenario, VARY, **given))


LINUX = pytest.mark.skipif(not Path("/proc/self/net/tcp").exists(), reason="no /proc/net")


@LINUX
@DASK
def test_processes_of_this_machine_take_no_connections(quick, tmp_path):
    found = []

    def look(done):
        others = [one.pid for one in multiprocessing.active_children()]
        found.append((len(others), listening([os.getpid(), *others])))

    with socket.create_server(("127.0.0.1", 0)) as known:
        [address] = listening([os.getpid()])  # the test sees what is there
        assert int(address.split(":")[1], 16) == known.getsockname()[1]
    run_ensemble(
        quick, VARY, 8, out=tmp_path / "e.zarr", chunk=4, threads=1, dask="local", progress=look
    )
    assert found == [(0, []), (1, []), (1, [])]
    for one in multiprocessing.active_children():
        one.join(GUARD)
    assert multiprocessing.active_children() == []


@pytest.mark.processes
@DASK
def test_a_process_of_this_machine_is_killed(quick, tmp_path):
    out, killed = tmp_path / "e.zarr", []

    def kill_one(done):
        if done and not killed:
            killed.append(done)
            os.kill(multiprocessing.active_children()[0].pid, signal.SIGKILL)

    given = {"seed": 1, "chunk": 4, "threads": 2, "dask": "local"}
    with pytest.raises(SimulationError, match=r"a worker was lost .* what is done is kept$"):
        run_ensemble(quick, VARY, 80, out=out, progress=kill_one, **given)
    assert 0 < len(open_store(out).missing()) < 20
    data = run_ensemble(quick, VARY, 80, out=out, **given)
    assert_identical(data, run_ensemble(quick, VARY, 80, seed=1, chunk=4))


@pytest.mark.processes
@DASK
def test_a_lost_scheduler_is_one_sentence(scenario, tmp_path):
    clpt_control.save_scenario(scenario, tmp_path / "s.toml")
    known, out = tmp_path / "scheduler.json", tmp_path / "e.zarr"
    words = ("ensemble", tmp_path / "s.toml", "--vary", VARY[0], "--members", "400", "--out", out)
    words = (*CLPT, *words, "--chunk", "4")
    dask = (sys.executable, "-m", "distributed.cli.dask_{}", "--scheduler-file", known)
    here = ("--host", "127.0.0.1", "--no-dashboard")
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}

    def service(name, *more):
        return started((*dask[:2], dask[2].format(name), *dask[3:], *here, *more), **quiet)

    with service("scheduler", "--port", "0") as scheduler, service("worker", "--nthreads", "1"):
        while not known.exists() or not known.read_text().endswith("}"):
            assert scheduler.poll() is None
            time.sleep(0.05)
        address = json.loads(known.read_text())["address"]
        with started((*words, "--dask", address)) as process:
            while not (out / "done").exists() or len(open_store(out, "r").missing()) > 95:
                assert process.poll() is None
                time.sleep(0.05)
            scheduler.kill()
            said, err = process.communicate(timeout=GUARD)
    lost = f"clpt: dask: the scheduler {address} was lost; what is done is kept; {out} holds "
    assert (process.returncode, said) == (1, "")
    told = without_progress(err).removeprefix(lost)
    assert re.fullmatch(r"\d+ of 400 members; the same command goes on from there\n", told)
    left = len(open_store(out, "r").missing())
    assert 0 < left <= 95
    data = run_ensemble(scenario, VARY[0], 400, out=out, chunk=4)
    assert_identical(data, run_ensemble(scenario, VARY[0], 400, chunk=4))


def test_dask_that_is_not_installed(quick, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ClptError, match="distributed: is not installed; pip install"):
        run_ensemble(quick, VARY, 4, out=tmp_path / "e.zarr", dask="local")
    assert not (tmp_path / "e.zarr").exists()


def test_dask_needs_a_folder(quick):
    with pytest.raises(ScenarioError, match="needs out"):
        run_ensemble(quick, VARY, 4, dask="local")
