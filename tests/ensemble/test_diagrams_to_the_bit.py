"""Ensembles of diagrams to the last bit: threads, chunks, folders, processes, random diagrams."""

import importlib.util
import random
import warnings

import numpy as np
import pytest
from adaptive_loop import mrac
from ensemble_stores import assert_identical, files
from random_diagrams import random_diagram
from swept import TIMES, lag, system, unread

import clpt_control as clpt
from clpt_control.diagrams.varied import place_of
from clpt_control.ensemble.drawn_values import read_varies
from clpt_control.ensemble.members import Ensemble
from clpt_control.ensemble.of_diagrams import VariedDiagram
from clpt_control.equations.ports import ports_of
from clpt_control.errors import ClptError, DataError, DiagramError


def drawn(seed):
    """Return a random diagram, its inputs, and some of its names, all in a small range."""
    draw = random.Random(seed)
    diagram = random_diagram(draw)
    varied = VariedDiagram(diagram, (), TIMES[:5], 0.1)
    names = sorted(name for name in varied.names if varied.why_not(name))
    places = {n: place_of(n, varied.names, varied.given) for n in names}
    free = [n for n, at in places.items() if at and np.ndim(varied._value(at)) == 0]
    picked = draw.sample(free, min(3, len(free)))
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
                diagram, vary = drawn(seed)
                given = {"members": 11, "timepts": TIMES[:5], "inputs": 0.1, "trajectories": True}
                whole = clpt.run_ensemble(diagram, vary, threads=1, **given)
                cut = clpt.run_ensemble(diagram, vary, threads=3, chunk=4, **given)
        except ClptError:  # a loop of functions, or nothing that is left to vary
            continue
        assert_identical(whole, cut)
        compared += 1
    assert compared


@pytest.mark.parametrize(
    "seed", [13, 34, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (15, 42, 44))]
)
def test_members_are_what_python_runs_block_by_block(seed):
    draw = random.Random(seed)
    diagram = random_diagram(draw)
    first = VariedDiagram(diagram, (), TIMES[:5], 0.1, 0.2)
    names = [name for name in sorted(first.names) if place_of(name, first.names, first.given)]
    vary = dict.fromkeys(draw.sample(names, min(4, len(names))), "0.4:0.9")
    varied = VariedDiagram(diagram, read_varies(vary), TIMES[:5], 0.1, 0.2)
    given = {"timepts": TIMES[:5], "inputs": 0.1, "initial_state": 0.2, "trajectories": True}
    data = clpt.run_ensemble(diagram, vary, 5, **given)
    python = Ensemble(varied, vary, "python")
    for m in range(5):
        own = {key: data[key].values[m] for key in vary}
        parameters, start, inputs = varied.member(own)
        alone = python.native.with_parameters(parameters)
        solution = alone.run(start, TIMES[:5], inputs=inputs, method="dop853")
        signals = alone.signals(solution, inputs)
        every = np.vstack([signals.T, inputs.along(solution.t)])
        wanted = (varied.wiring.output_map @ every).T
        for port, places in ports_of(varied.outputs).items():
            found = data[port if port in data else f"{port}_"].values[m].reshape(5, -1)
            size = 1 + np.abs(wanted[:, places]).max()
            np.testing.assert_allclose(found, wanted[:, places], rtol=0, atol=1e-6 * size)


def test_a_folder_goes_on_and_refuses_another_diagram(tmp_path):
    out = tmp_path / "e.zarr"
    given = {"vary": "tau=0.5:2", "members": 30, "timepts": TIMES, "inputs": 1.0, "chunk": 10}

    def stop(done):
        if done >= 10:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(lag(), out=out, progress=stop, threads=1, **given)
    counts = []
    data = clpt.run_ensemble(lag(), out=out, progress=counts.append, **given)
    assert 0 < counts[0] < 30
    assert_identical(data, clpt.run_ensemble(lag(), **given))
    before = files(out)
    other = system(lambda t, x, u, p: (u - 2 * x) / p["tau"], inputs=1, params={"tau": 1.0})
    for of, more in ((other, {}), (lag(), {"inputs": 2.0}), (lag(), {"rtol": 1e-9})):
        with pytest.raises(DataError, match="holds an ensemble of another diagram; give another"):
            clpt.run_ensemble(of, out=out, **given | more)
    assert files(out) == before
    with pytest.raises(DataError, match="is an ensemble of a diagram, not of a scenario"):
        clpt.report(out, tmp_path / "page.html")


def test_a_folder_cannot_tell_what_cannot_be_read(tmp_path):
    odd, out = system(unread, params={"a": 1.0}, name="odd"), tmp_path / "e.zarr"
    with pytest.raises(DiagramError, match=r"^out: odd\.update: "):
        clpt.run_ensemble(odd, {"a": [1.0]}, timepts=TIMES, out=out)
    assert not list(tmp_path.iterdir())


@pytest.mark.processes
@pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="Dask is not installed")
def test_processes_get_a_diagram(tmp_path):
    given = {"vary": {"gain": [0.5, 1.0], "plant.a": [-1.0, 0.0]}, "timepts": TIMES, "inputs": 1.0}
    here = clpt.run_ensemble(mrac(), chunk=2, **given)
    there = clpt.run_ensemble(
        mrac(), out=tmp_path / "e.zarr", dask="local", threads=1, chunk=2, **given
    )
    for name in here.data_vars:
        assert here[name].values.tobytes() == there[name].values.tobytes(), name
