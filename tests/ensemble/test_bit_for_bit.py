"""The same ensemble, to the last bit: on threads, after interruptions, on a cluster."""

import importlib.util
import json
import multiprocessing
import os
import random
import re
import signal
import socket
import subprocess
import sys
import time
import warnings
from pathlib import Path

import law_blocks
import numpy as np
import pytest
from adaptive_loop import mrac
from random_diagrams import random_diagram
from sampled_runs import TIMES, VARY, assert_identical, files, lag, system, unread
from subprocesses import (
    CLPT,
    GUARD,
    await_line,
    listening,
    ran,
    started,
    without_progress,
)

import clpt_control as clpt
from clpt_control import (
    ClptError,
    DataError,
    DiagramError,
    ScenarioError,
    SimulationError,
    run_ensemble,
)

DASK = pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="no Dask")
LINUX = pytest.mark.skipif(
    not Path("/proc/self/net/tcp").exists(), reason="no /proc/net"
)


@pytest.mark.parametrize(("threads", "chunk"), [(1, 7), (2, 3), (3, 40)])
def test_threads_chunks_and_batches_do_not_matter(
    scenario, whole, tmp_path, threads, chunk
):
    """Three threads run batches of 8 of 40 members, one thread batches of 16."""
    given = {"seed": 3, "trajectories": True, "threads": threads, "chunk": chunk}
    data = run_ensemble(scenario, VARY, 40, out=tmp_path / "e.zarr", **given)
    assert_identical(data, whole)


KILLED = """
import sys
import threading
import clpt_control
from clpt_control import run_ensemble
scenario = clpt_control.load_scenario(sys.argv[1])
def stop(done):
    if done >= 40:
        print("far", flush=True)
        threading.Event().wait()
run_ensemble(
    scenario, sys.argv[4:], int(sys.argv[3]), seed=1, out=sys.argv[2], chunk=20, progress=stop
)
"""


@pytest.mark.long
def test_killed_and_started_again(quick, tmp_path):
    members, file = 120, tmp_path / "scenario.toml"
    clpt.save_scenario(quick, file)
    out, wanted = tmp_path / "killed.zarr", tmp_path / "whole.zarr"
    words = [sys.executable, "-c", KILLED, file, out, members, *VARY]
    with started(words, stderr=None) as work:
        await_line(work, work.stdout, "far")
    counts = []
    again = clpt.load_scenario(file)
    run_ensemble(
        again, VARY, members, seed=1, out=out, chunk=20, progress=counts.append
    )
    assert counts[0] in range(20, members, 20)  # whole chunks
    assert counts[-1] == members
    run_ensemble(again, VARY, members, seed=1, out=wanted, chunk=20)
    assert files(out) == files(wanted)


# --- any diagram ---------------------------------------------------------------------------------


def drawn(seed, most):
    """Return a random diagram and a range of at most so many of its numbers."""
    draw = random.Random(seed)
    diagram = random_diagram(draw)
    with pytest.raises(ScenarioError) as refused:
        clpt.run_ensemble(diagram, "none=0:1", 2, timepts=TIMES[:5], inputs=0.1)
    names = str(refused.value).partition("ay vary: ")[2].split(", ")
    # "v" of all blocks and "system0.v" are one number
    names = [
        name for name in names if not any(one.endswith(f".{name}") for one in names)
    ]
    picked = draw.sample(sorted(names), min(most, len(names)))
    return diagram, dict.fromkeys(picked, "0.5:0.9")


@pytest.mark.parametrize(
    "first", [1, *(pytest.param(k, marks=pytest.mark.slow) for k in range(3, 23, 2))]
)
def test_threads_and_chunks_do_not_matter_to_any_diagram(first):
    compared = 0
    for seed in range(first, first + 2):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                diagram, vary = drawn(seed, 3)
                given = {
                    "members": 11,
                    "timepts": TIMES[:5],
                    "inputs": 0.1,
                    "trajectories": True,
                }
                whole = clpt.run_ensemble(diagram, vary, threads=1, **given)
                cut = clpt.run_ensemble(diagram, vary, threads=3, chunk=4, **given)
        except ClptError:  # a loop of functions, or nothing that is left to vary
            continue
        assert_identical(whole, cut)
        compared += 1
    assert compared


@pytest.mark.long
@pytest.mark.parametrize(
    "seed",
    [
        22,
        41,
        *(pytest.param(seed, marks=pytest.mark.slow) for seed in (16, 23, 32, 51)),
    ],
)
def test_members_are_what_python_runs_block_by_block(seed):
    diagram, vary = drawn(seed, 4)
    given = {"timepts": TIMES[:5], "inputs": 0.1, "initial_state": 0.2}
    data = clpt.run_ensemble(diagram, vary, 5, trajectories=True, **given)
    for m in range(5):
        states, inputs = np.full(diagram.nstates, 0.2), np.full(diagram.ninputs, 0.1)
        params = {}
        for key in vary:
            value = data[key].values[m]
            if key in diagram.input_labels:
                inputs[diagram.input_labels.index(key)] = value
            elif places := [
                k
                for k, label in enumerate(diagram.state_labels)
                if key in (label, label.partition("[")[0])
            ]:
                states[places] = value
            else:
                params[key] = value
        alone = clpt.simulate(
            diagram, TIMES[:5], inputs, states, params, engine="python", method="dop853"
        )
        for port in {label.partition("[")[0] for label in diagram.output_labels}:
            found = data[port if port in data else f"{port}_"].values[m]
            wanted = alone[port].values
            size = 1 + np.abs(wanted).max()
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-6 * size)


def test_a_folder_goes_on_and_refuses_another_diagram(tmp_path):
    def stop(done):
        if done >= 10:
            raise KeyboardInterrupt

    out = tmp_path / "e.zarr"
    given = {
        "vary": "tau=0.5:2",
        "members": 100,
        "timepts": TIMES,
        "inputs": 1.0,
        "chunk": 10,
    }
    with pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(lag(), out=out, progress=stop, threads=2, **given)
    counts = []
    data = clpt.run_ensemble(lag(), out=out, progress=counts.append, **given)
    assert 0 < counts[0] < 100
    assert_identical(data, clpt.run_ensemble(lag(), **given))
    before = files(out)
    other = system(
        lambda t, x, u, p: (u - 2 * x) / p["tau"], inputs=1, params={"tau": 1.0}
    )
    for of, more in ((other, {}), (lag(), {"inputs": 2.0}), (lag(), {"rtol": 1e-9})):
        with pytest.raises(
            DataError, match=r"an ensemble of another diagram. Give another"
        ):
            clpt.run_ensemble(of, out=out, **given | more)
    assert files(out) == before
    odd = system(unread, params={"a": 1.0}, name="odd")
    with pytest.raises(DiagramError, match=r"^out: odd\.update: "):
        # it cannot be told from others
        clpt.run_ensemble(odd, {"a": [1.0]}, timepts=TIMES, out=tmp_path / "odd.zarr")
    assert [*tmp_path.iterdir()] == [out]


# --- by other processes --------------------------------------------------------------------------


@pytest.mark.processes
@DASK
@pytest.mark.parametrize("of", ["a diagram", "a law"])
def test_a_cluster_gets_the_block(quick, tmp_path, of):
    loop, given = (
        mrac(),
        {"vary": {"gain": [0.5, 1.0], "plant.a": [-1.0, 0.0]}, "inputs": 1.0},
    )
    given |= {"timepts": TIMES}
    if of == "a law":
        loop = clpt.closed_loop(quick, law=law_blocks.papers_law(gain=1.1))
        given = {"vary": "flow.parameters~normal:0.1", "members": 8}
    here = run_ensemble(loop, chunk=2, **given)
    there = run_ensemble(
        loop, out=tmp_path / "e", threads=1, dask="local", chunk=2, **given
    )
    for name in here.data_vars:
        assert here[name].values.tobytes() == there[name].values.tobytes(), name


@pytest.mark.processes
@DASK
def test_a_dask_worker_is_killed(scenario, tmp_path):
    from distributed import Client, LocalCluster

    given, killed = {"members": 240, "seed": 1, "chunk": 10}, []
    here = {
        "n_workers": 2,
        "threads_per_worker": 1,
        "processes": True,
        "dashboard_address": ":0",
    }
    with LocalCluster(**here) as cluster, Client(cluster) as client:
        pids = list(client.run(os.getpid).values())

        def kill_one(done):
            if done and not killed:
                killed.append(pids[0])
                os.kill(pids[0], signal.SIGKILL)

        to = {
            "out": tmp_path / "d.zarr",
            "dask": cluster.scheduler_address,
            "progress": kill_one,
        }
        data = run_ensemble(scenario, VARY, **given, **to)
    assert killed
    assert_identical(data, run_ensemble(scenario, VARY, **given))


@pytest.mark.long
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
    given = {"out": tmp_path / "e.zarr", "chunk": 4, "threads": 1, "dask": "local"}
    run_ensemble(quick, VARY, 8, progress=look, **given)
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
    with pytest.raises(
        SimulationError, match=r"a worker was lost .* finished members are stored$"
    ):
        run_ensemble(quick, VARY, 80, out=out, progress=kill_one, **given)
    counts = []
    data = run_ensemble(quick, VARY, 80, out=out, progress=counts.append, **given)
    assert 0 < counts[0] < 80
    assert_identical(data, run_ensemble(quick, VARY, 80, seed=1, chunk=4))


@pytest.mark.processes
@DASK
def test_a_lost_scheduler_is_one_sentence(scenario, tmp_path):
    clpt.save_scenario(scenario, tmp_path / "s.toml")
    known, out = tmp_path / "scheduler.json", tmp_path / "e.zarr"
    words = (
        "ensemble",
        tmp_path / "s.toml",
        "--vary",
        VARY[0],
        "--members",
        "400",
        "--out",
        out,
    )
    here = ("--scheduler-file", known, "--host", "127.0.0.1", "--no-dashboard")
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}

    def service(name, *more):
        return started(
            [sys.executable, "-m", f"distributed.cli.dask_{name}", *here, *more],
            **quiet,
        )

    def wait(for_what, process):
        while not for_what():
            assert process.poll() is None
            time.sleep(0.05)

    with (
        service("scheduler", "--port", "0") as scheduler,
        service("worker", "--nthreads", "1"),
    ):
        wait(lambda: known.exists() and known.read_text().endswith("}"), scheduler)
        address = json.loads(known.read_text())["address"]
        with started((*CLPT, *words, "--chunk", "4", "--dask", address)) as process:
            wait(lambda: len([*out.glob("done/c/*")]) >= 5, process)
            scheduler.kill()
            said, err = process.communicate(timeout=GUARD)
    lost = (
        f"clpt: dask: the scheduler {address} was lost; finished members are stored; "
        f"{out} holds "
    )
    assert (process.returncode, said) == (1, "")
    told = without_progress(err).removeprefix(lost)
    held = re.fullmatch(
        r"(\d+) of 400 members; the same command goes on from there\n", told
    )
    counts = []
    data = run_ensemble(
        scenario, VARY[0], 400, out=out, chunk=4, progress=counts.append
    )
    assert max(20, int(held[1])) <= counts[0] < 400
    assert_identical(data, run_ensemble(scenario, VARY[0], 400, chunk=4))


def test_dask_needs_its_package_and_a_folder(quick, tmp_path, monkeypatch):
    with pytest.raises(ScenarioError, match="needs out"):
        run_ensemble(quick, VARY, 4, dask="local")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ClptError, match=r"distributed is not installed. Install"):
        run_ensemble(quick, VARY, 4, out=tmp_path / "e.zarr", dask="local")
    assert not list(tmp_path.iterdir())


def rocket():
    """A rocket that vibrates while it burns for 15 s, then coasts for a day."""

    def rates(t, x, u, p):
        on = 1.0 if t < 15.0 else 0.0
        return [x[1], 300.0 * on, on * p["w"] * x[3], -on * p["w"] * x[2]]

    ports = {"states": 4, "outputs": ["x", "v", "a", "b"], "params": {"w": 1e3}}
    return system(rates, **ports)


@pytest.mark.long
def test_members_with_a_burst_finish_with_the_bits_of_simulate(tmp_path):
    """The vibration needs most of the tries; x = 300 (15^2 / 2 + 15 (t - 15)) m."""
    given = {"timepts": [0.0, 15.0, 1e5], "initial_state": [0.0, 0.0, 0.01, 0.0]}
    vary = {"w": np.linspace(600.0, 2200.0, 17)}
    runs = [
        run_ensemble(rocket(), vary, threads=threads, chunk=chunk, **given)
        for threads, chunk in ((1, None), (2, None), (2, 5))
    ]
    stored = run_ensemble(rocket(), vary, out=tmp_path / "e.zarr", chunk=4, **given)
    for data in (*runs, stored):
        assert_identical(data.reset_index("member"), runs[0].reset_index("member"))
    assert (runs[0].status == 1).all()
    height = 300.0 * (15.0**2 / 2 + 15.0 * (1e5 - 15.0))
    np.testing.assert_allclose(runs[0].x_final, height, rtol=1e-7)
    for m in (0, 8, 16):
        alone = clpt.simulate(rocket(), params={"w": vary["w"][m]}, **given)
        for port in "xvab":
            assert float(alone[port][-1]) == float(runs[0][f"{port}_final"][m])


def runaway():
    """An amplitude that grows, and turns the other states ever faster."""

    def rates(t, x, u, p):
        return [p["growth"] * x[0], x[0] * x[2], -x[0] * x[1]]

    ports = {"states": 3, "outputs": ["a", "b", "c"], "params": {"growth": 1.0}}
    return system(rates, **ports)


@pytest.mark.long
def test_runaway_members_end_at_the_same_time_in_any_company():
    """Each ends by its own tries: threads, chunks and members beside it do not matter."""
    given = {"timepts": np.linspace(0.0, 20.0, 5), "initial_state": [1.0, 0.0, 1.0]}
    growths = [-1.0, 1.5, -0.5, 2.0, 3.0, 0.0]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        runs = [
            run_ensemble(
                runaway(), {"growth": growths}, threads=threads, chunk=chunk, **given
            )
            for threads, chunk in ((1, None), (2, 1), (2, 4))
        ]
        alone = run_ensemble(runaway(), {"growth": [2.0]}, **given)
    for data in runs[1:]:
        assert_identical(data.reset_index("member"), runs[0].reset_index("member"))
    assert runs[0].status.values.tolist() == [1, 8, 1, 8, 8, 1]
    assert alone.end[0] == runs[0].end[3]


IN_MEMORY = """
import sys
import control
import clpt_control as clpt
lag = control.nlsys(
    lambda t, x, u, p: -p["rate"] * x, inputs=0, outputs=1, states=1, params={"rate": 1.0}
)
clpt.run_ensemble(
    lag,
    {"rate": [1.0, 2.0]},
    timepts=[0.0, 1.0],
    initial_state=1.0,
    summary={"last": lambda run: run.y.values[-1]},
)
burst = control.nlsys(
    lambda t, x, u, p: p["rate"] * x**2, inputs=0, outputs=1, states=1, params={"rate": 1.0}
)
clpt.run_ensemble(burst, {"rate": [0.1, 2.0]}, timepts=[0.0, 1.0], initial_state=1.0)
scenario = clpt.paper_scenario().with_values({"run.duration": 4.0})
clpt.run_ensemble(scenario, "learning.gain=0.5:1", 2, trajectories=True)
print([name for name in ("zarr", "dask", "distributed") if name in sys.modules])
"""


@pytest.mark.long
def test_results_in_memory_import_no_store():
    assert ran(sys.executable, "-c", IN_MEMORY).stdout == "[]\n"
