"""Ensembles: designs, independence of how they are run, interruptions, mistakes."""

import importlib.util
import json
import os
import re
import shutil
import signal
import sys
from pathlib import Path

import numpy as np
import pytest
from pictures import inked
from processes import await_line, started

import clpt_control
from clpt_control.ensemble.drawn_values import draw_members
from clpt_control.ensemble.plan import make_plan
from clpt_control.ensemble.run import run_ensemble
from clpt_control.ensemble.spread import ensemble_plot, ensemble_summary
from clpt_control.ensemble.store import open_store
from clpt_control.ensemble.varied_keys import read_varies, read_vary, variable_values
from clpt_control.ensemble.worker import Worker
from clpt_control.errors import ClptError, DataError, ScenarioError
from clpt_control.simulation.report import run_and_report

HERE = Path(__file__).parents[1]
VARY = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1", "learning.position=-1:1"]


@pytest.fixture(scope="module")
def scenario():
    """Two and a half rounds of the paper's waypoints, four times faster."""
    return clpt_control.paper_scenario().with_values({"run.duration": 125, "reference.dwell": 5})


@pytest.fixture
def quick(scenario):
    return scenario.with_values({"run.duration": 10})


@pytest.fixture(scope="module")
def whole(scenario):
    """One thread, one chunk, trajectories: what all other ways must give."""
    return run_ensemble(scenario, VARY, 40, seed=3, threads=1, samples=100, trajectories=True)


def files(folder):
    """Every file of a store with its bytes."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def assert_identical(one, other):
    assert set(one.variables) == set(other.variables)
    for name in one.variables:
        assert one[name].dims == other[name].dims
        assert one[name].values.tobytes() == other[name].values.tobytes(), name


# ---- designs


def draw(scenario, vary, members, design="lhs", seed=0):
    return draw_members(scenario, read_varies(scenario, vary), members, design, seed)


def test_a_latin_hypercube_draws_once_from_each_part(scenario):
    values = draw(scenario, ["learning.gain=0.2:2.0", "learning.position=-1:1"], 64, seed=5)
    for column in (
        (values["learning.gain"] - 0.2) / 1.8,
        *((values["learning.position"].T + 1) / 2),
    ):
        assert sorted(np.floor(column * 64).astype(int)) == list(range(64))
    assert np.abs(np.corrcoef(values["learning.position"].T)[0, 1]) < 0.5


@pytest.mark.parametrize("design", ["lhs", "random"])
def test_normal_has_an_absolute_deviation_about_the_scenario(scenario, design):
    values = draw(scenario, "flow.parameters~normal:0.1", 4000, design)["flow.parameters"]
    assert values.shape == (4000, 2, 3)
    centred = values - np.array(scenario.flow.parameters)
    np.testing.assert_allclose(centred.mean(axis=0), 0, atol=0.01)
    np.testing.assert_allclose(centred.std(axis=0), 0.1, rtol=0.05)
    assert np.abs(np.mean(np.abs(centred) < 0.1) - 0.6827) < 0.01


def test_uniform_fills_its_range(scenario):
    values = draw(scenario, "learning.gain=0.2:2.0", 4000, "random")["learning.gain"]
    assert values.min() > 0.2
    assert values.max() < 2.0
    np.testing.assert_allclose(np.percentile(values, [25, 50, 75]), [0.65, 1.1, 1.55], atol=0.06)


def test_a_grid_has_every_combination(scenario):
    vary = ["learning.gain=[0.5, 1, 2]", "reference.radius=2:4", "vehicle.feedforward=0.5:1.5"]
    values = draw(scenario, vary, 3 * 27, "grid")
    found = np.column_stack(
        [values["learning.gain"], values["reference.radius"], values["vehicle.feedforward"]]
    )
    assert len(np.unique(found, axis=0)) == 81
    assert set(values["learning.gain"]) == {0.5, 1.0, 2.0}
    assert set(values["reference.radius"]) == {2.0, 3.0, 4.0}
    quantiles = draw(scenario, "learning.gain~normal:0.1", 2, "grid")["learning.gain"]
    np.testing.assert_allclose(quantiles - 0.8, [-0.067449, 0.067449], atol=1e-6)


def test_levels_of_arrays_and_balance(scenario):
    rows = [[0.5, 0.5], [1.0, 2.0]]
    values = draw(scenario, f"vehicle.feedback={json.dumps(rows)}", 10)["vehicle.feedback"]
    assert sorted(map(tuple, values)) == [(0.5, 0.5)] * 5 + [(1.0, 2.0)] * 5


def test_values_depend_on_seed_design_members_and_number_alone(scenario):
    alone = draw(scenario, "learning.gain=0.2:2.0", 50, seed=2)["learning.gain"]
    among = draw(scenario, VARY[::-1], 50, seed=2)["learning.gain"]
    assert alone.tobytes() == among.tobytes()
    others = [draw(scenario, VARY, 50, seed=3), draw(scenario, VARY, 50, "random", seed=2)]
    assert all(alone.tobytes() != other["learning.gain"].tobytes() for other in others)


def test_every_key_that_may_vary_can(quick):
    square = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    disturbed = quick.with_values({"flow.disturbance": square})
    for key, base in variable_values(disturbed).items():
        level = (base * 1.01 + 0.001).tolist()
        data = run_ensemble(disturbed, f"{key}={json.dumps([level])}", 1, samples=20)
        assert data["status"].values.tolist() == [1], key
        one = clpt_control.simulate(disturbed.with_values({key: level}))
        end = float(np.abs(one.flow_parameters_estimate - one.flow_parameters)[-1].max())
        assert abs(float(data["flow_parameter_error"][0, -1]) - end) < 1e-7, key


# ---- the members


@pytest.mark.parametrize("number", [0, 17, 39])
def test_a_member_is_a_run_of_its_own(scenario, whole, number):
    own = {vary.split("=")[0].split("~")[0]: None for vary in VARY}
    values = {key: whole[key].values[number] for key in own}
    report = run_and_report(scenario.with_values(values))
    run, summary = report.run, report.summary
    for name in ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain"):
        np.testing.assert_allclose(whole[name][number], run[name], rtol=0, atol=1e-6)
    np.testing.assert_array_equal(whole["time"], run["time"])
    last = summary["max_flow_parameter_error"]["100"]
    error = whole["flow_parameter_error"].sel(mark=100)[number]
    assert abs(float(error) - last) < 1e-6
    gain = whole["gain_error"].sel(mark=100)[number]
    assert abs(float(gain) - summary["max_gain_error"]["100"]) < 1e-6


def test_mean_squares_are_those_of_clpt_run(scenario):
    data = run_ensemble(scenario, "learning.gain=[0.8]", 1)
    wanted = run_and_report(scenario).summary
    np.testing.assert_allclose(data["clpe_rms"][0], wanted["clpe_rms_per_cycle"], atol=1e-7)
    assert abs(float(data["clpe_rms_whole"][0]) - wanted["clpe_rms"]) < 1e-7
    assert data.sizes["cycle"] == 2


@pytest.mark.parametrize("name", ["paper", "known_flow_biased"])
def test_reference_numbers(reference, name):
    found = [path for path in (HERE / "reference").glob("*.toml") if path.stem == name]
    if not found:
        pytest.skip(f"no reference scenario {name}")
    scenario = clpt_control.load_scenario(found[0])
    gain = scenario.learning.gain
    data = run_ensemble(scenario, f"learning.gain=[{gain}]", 1)
    numbers = reference[found[0].stem]
    np.testing.assert_allclose(data["clpe_rms"][0], numbers["clpe_rms_per_cycle"], atol=1e-6)
    wanted = numbers.get("max_flow_parameter_error") or {}
    for t in ("100", "200", "2000"):
        if t in wanted:
            got = float(data["flow_parameter_error"].sel(mark=float(t))[0])
            assert abs(got - wanted[t]) < 1e-6


def test_a_member_that_fails_costs_itself_alone(quick):
    vary = "vehicle.position=[[0, 0], [1e200, 0], [0, 0]]"
    data = run_ensemble(quick, vary, 3, "grid", samples=50)
    status = data["status"].values
    assert status[0] == status[2] == 1
    assert status[1] in (2, 3)
    assert np.isnan(data["clpe_rms_whole"][1])
    assert float(data["end"][1]) < 10 == float(data["end"][0])
    summary = ensemble_summary(data)
    assert summary["ended"]["finished"] == 2
    assert summary["first_failed"] == 1
    assert data["gain_error"][0].values.tobytes() == data["gain_error"][2].values.tobytes()


# ---- bit for bit


@pytest.mark.parametrize(("threads", "chunk"), [(1, 7), (2, 1), (2, 16), (3, 1000)])
def test_threads_and_chunks_do_not_matter(scenario, whole, tmp_path, threads, chunk):
    data = run_ensemble(
        scenario,
        VARY,
        40,
        seed=3,
        out=tmp_path / "e.zarr",
        threads=threads,
        chunk=chunk,
        samples=100,
        trajectories=True,
    )
    assert_identical(data, whole)


def test_order_and_company_do_not_matter(scenario, whole):
    plan = make_plan(scenario, VARY, 40, seed=3, samples=100, trajectories=True)
    values = plan.store.values(0)
    order = np.random.default_rng(0).permutation(40)
    mixed = plan.worker.summaries({key: array[order] for key, array in values.items()})
    alone = plan.worker.summaries({key: array[9:10] for key, array in values.items()})
    for name, array in mixed.items():
        assert array.tobytes() == whole[name].values[order].tobytes(), name
        assert alone[name].tobytes() == whole[name].values[9:10].tobytes(), name


def test_the_batch_does_not_matter(scenario, whole, monkeypatch):
    monkeypatch.setattr(Worker, "batch", 8)
    data = run_ensemble(scenario, VARY, 40, seed=3, threads=2, samples=100, trajectories=True)
    assert_identical(data, whole)


# ---- interruptions

KILLED = """
import sys
import threading
import clpt_control
from clpt_control.ensemble.run import run_ensemble
scenario = clpt_control.load_scenario(sys.argv[1])
def stop(done):
    if done >= 100:
        print("far", flush=True)
        threading.Event().wait()
run_ensemble(
    scenario, sys.argv[4:], int(sys.argv[3]), seed=1, out=sys.argv[2], chunk=20, progress=stop
)
"""


def test_killed_and_started_again(scenario, tmp_path):
    members, file = 300, tmp_path / "scenario.toml"
    clpt_control.save_scenario(scenario, file)
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
    monkeypatch.setattr(Worker, "summaries", None)
    assert_identical(run_ensemble(quick, VARY, 20, out=tmp_path / "e.zarr"), first)


@pytest.mark.parametrize("damage", ["cut", "removed", "trajectory removed", "checksum cut"])
def test_damaged_chunks_are_run_again(quick, tmp_path, damage):
    out = tmp_path / "e.zarr"
    run_ensemble(quick, VARY, 30, out=out, chunk=10, trajectories=True)
    before = files(out)
    victim = {
        "cut": out / "gain_error" / "c" / "1" / "0",
        "removed": out / "clpe_rms_whole" / "c" / "2",
        "trajectory removed": out / "alpha" / "c" / "1" / "0" / "0" / "0",
        "checksum cut": out / "done" / "c" / "0",
    }[damage]
    if "cut" in damage:
        victim.write_bytes(victim.read_bytes()[:-6])
    else:
        victim.unlink()
    run_ensemble(quick, VARY, 30, out=out, chunk=10, trajectories=True)
    assert files(out) == before


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


LOST = {  # file -> (what happens to it, what is said)
    "gain_error/zarr.json": (Path.unlink, "gain_error has lost its files"),
    "learning.gain/zarr.json": (edited("shape", [7]), "learning.gain has lost its shape"),
    "end/zarr.json": (edited("data_type", "float32"), "end has lost its dtype"),
    "mark/zarr.json": (edited("dimension_names", ["time"]), "mark has lost its dimension names"),
    "alpha/zarr.json": (edited("attributes", {}), "alpha has lost its attributes"),
    "done/zarr.json": (edited("shape", [9]), "done has lost its shape"),
    "zarr.json": (flipped, "is no ensemble or is damaged"),
    "time/c/0": (flipped, "time has lost its files"),
    "learning.gain/c/1": (flipped, "learning.gain has lost its files"),
    "member/c/0": (Path.unlink, "member has lost its values"),
}


@pytest.fixture(scope="module")
def stored(scenario, tmp_path_factory):
    """A whole store of a short ensemble, with how to run it."""
    quick = scenario.with_values({"run.duration": 10})
    out = tmp_path_factory.mktemp("stored") / "e.zarr"

    def run(path):
        return run_ensemble(
            quick, VARY[0], 6, out=path, chunk=3, threads=1, trajectories=True, samples=100
        )

    run(out)
    return out, run


@pytest.mark.parametrize("name", LOST)
def test_a_store_without_what_it_must_hold_is_named_and_left(stored, tmp_path, name):
    whole, run = stored
    out = tmp_path / "e.zarr"
    shutil.copytree(whole, out)
    damage, sentence = LOST[name]
    damage(out / name)
    before = files(out)
    with pytest.raises(DataError, match=rf"e\.zarr: .*{re.escape(sentence)}"):
        run(out)
    assert files(out) == before


@pytest.mark.parametrize("name", ["alpha/c/1/0/0/0", "gain_error/c/0/0"])
def test_a_flipped_byte_of_a_chunk_is_run_again(stored, tmp_path, name):
    whole, run = stored
    out = tmp_path / "e.zarr"
    shutil.copytree(whole, out)
    flipped(out / name)
    run(out)
    assert files(out) == files(whole)


def test_a_store_that_memory_does_not_suffice_for_is_removed(quick, tmp_path, monkeypatch):
    def too_much(work, values):
        raise MemoryError

    monkeypatch.setattr(Worker, "summaries", too_much)
    with pytest.raises(MemoryError):
        run_ensemble(quick, VARY[0], 4, out=tmp_path / "e.zarr", threads=1)
    assert not list(tmp_path.iterdir())


# ---- a cluster


@pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="Dask is not installed")
def test_a_dask_worker_is_killed(scenario, tmp_path):
    from distributed import Client, LocalCluster

    members, killed = 240, []
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        ) as cluster,
        Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())

        def kill_one(done):
            if done and not killed:
                killed.append(pids[0])
                os.kill(pids[0], signal.SIGKILL)

        data = run_ensemble(
            scenario,
            VARY,
            members,
            seed=1,
            out=tmp_path / "d.zarr",
            chunk=10,
            dask=cluster.scheduler_address,
            progress=kill_one,
        )
    assert killed
    assert_identical(data, run_ensemble(scenario, VARY, members, seed=1, chunk=10))


def test_dask_that_is_not_installed(quick, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ClptError, match="not installed; install it with"):
        run_ensemble(quick, VARY, 4, out=tmp_path / "e.zarr", dask="local")
    assert not (tmp_path / "e.zarr").exists()


def test_dask_needs_a_folder(quick):
    with pytest.raises(ScenarioError, match="needs out"):
        run_ensemble(quick, VARY, 4, dask="local")


# ---- mistakes

MISTAKES = [
    ({"vary": "learning.gain"}, "must be KEY=LOW:HIGH"),
    ({"vary": "learning.gain=3"}, "such as learning.gain=0.2:2.0"),
    ({"vary": "learning.gain=2:1"}, "the first number must be below the second"),
    ({"vary": "learning.gain=a:1"}, "'a' must be a finite number"),
    ({"vary": "learning.gain=0:inf"}, "'inf' must be a finite number"),
    ({"vary": "learning.gain~normal:0"}, "standard deviation must be positive"),
    ({"vary": "learning.gain~gamma:1"}, "must stand normal:DEVIATION"),
    ({"vary": "learning.gain=[0.5, 1"}, "the list cannot be read"),
    ({"vary": "learning.gain=[]"}, "at least one value"),
    ({"vary": "learning.gain=[[1, 2]]"}, "each value must be a number"),
    ({"vary": "learning.gain=[true]"}, "each value must be a number"),
    ({"vary": 'learning.gain=["a"]'}, "each value must be a number"),
    ({"vary": "learning.position=[[1, 2, 3]]"}, "must be an array of shape (2,)"),
    ({"vary": []}, "name at least one key"),
    ({"vary": ["learning.gain=1:2", "learning.gain=1:2"]}, "named 2 times"),
    ({"vary": "learning.gian=1:2"}, "did you mean learning.gain? May vary: basis.centers"),
    ({"vary": "nothing=1:2"}, "unknown key nothing; may vary: basis.centers"),
    ({"vary": "adaptation.gain=1:2"}, "the scenario's key is learning.gain"),
    ({"vary": "learning=1:2"}, "is a table; name one of its keys, such as learning.law"),
    ({"vary": "reference.count=5:10"}, "counts and seeds are whole numbers"),
    ({"vary": "basis.kernel=1:2"}, "it is not a number"),
    ({"vary": "run.duration=1:2"}, "members share duration"),
    ({"vary": "flow.disturbance.period=1:2"}, "is not set in the scenario"),
    ({"vary": "learning.theta_estimate=1:2"}, "is not set in the scenario"),
    ({"vary": "learning.gain=-1:2"}, "must be greater than 0; or should be positive"),
    ({"vary": "vehicle.feedback~normal:9"}, "vehicle.feedback"),
    ({"vary": VARY[0], "members": 0}, "members = 0: must be a whole number, at least 1"),
    ({"vary": VARY[0], "members": 2.5}, "members = 2.5: must be a whole number"),
    ({"vary": VARY[0], "members": 10**20}, "would draw 1e+20 numbers; at most 2e+08"),
    ({"vary": VARY[0], "members": 10**20, "design": "grid"}, "would draw 1e+20 numbers"),
    ({"vary": VARY[0], "members": 2, "samples": 10**20}, "more than 1e+08 in a run"),
    ({"vary": "learning.gain=٢:٣", "members": 2}, "'٢' must be a finite number"),
    ({"vary": "learning.gain=" + "[" * 5000, "members": 2}, "the list cannot be read"),
    ({"vary": f"learning.gain=[{'1' * 5000}]", "members": 2}, "the list cannot be read"),
    ({"vary": f"learning.gain=[{'1' * 400}]", "members": 2}, "each value must be a number"),
    ({"vary": VARY[0], "seed": -1}, "seed = -1: must be a whole number"),
    ({"vary": VARY[0], "design": "sobol"}, "must be one of lhs, grid, random"),
    ({"vary": VARY[0], "chunk": 0}, "chunk = 0: must be a whole number"),
    ({"vary": VARY[0], "threads": 0}, "threads = 0: must be a whole number"),
    ({"vary": VARY[0], "samples": 3}, "samples = 3: must be a whole number, at least 20"),
    ({"vary": VARY[0], "times": [11.0]}, "11.0 must lie between 0 and run.duration = 10"),
    ({"vary": "learning.gain=[1, 2]", "design": "grid", "members": 5}, "must have 2 members"),
    (
        {"vary": ["learning.gain=[1, 2]", "learning.position=0:1"], "design": "grid"},
        "must have 2 n^2 members, such as 2 or 8 or 18",
    ),
]


@pytest.mark.parametrize(("given", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(quick, tmp_path, given, sentence):
    given = {"members": 10, **given}
    with pytest.raises(ClptError) as error:
        run_ensemble(quick, out=tmp_path / "e.zarr", **given)
    text = str(error.value)
    assert "\n" not in text
    if "greater" not in sentence:
        assert sentence in text
    else:
        assert "member " in text
        assert "narrow learning.gain=-1.0:2.0" in text
    assert list(tmp_path.iterdir()) == []


def test_the_first_member_that_is_not_allowed_is_named(quick):
    values = [0.5, 1.0, -0.1, 2.0, -3.0]
    with pytest.raises(ScenarioError, match=r"^member 2: learning.gain = -0.1: must be"):
        run_ensemble(quick, f"learning.gain={values}", 5, "grid")


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"seed": 1}, "holds an ensemble of seed = 0, not 1"),
        ({"members": 21}, "holds an ensemble of members = 20, not 21"),
        ({"design": "random"}, "holds an ensemble of design = lhs, not random"),
        ({"vary": "learning.gain=1:2"}, "holds an ensemble of vary = learning.gain=0.2:2.0"),
        ({"trajectories": True}, "holds an ensemble of trajectories = False, not True"),
        ({"chunk": 7}, "holds an ensemble of chunk = 20, not 7"),
        ({"samples": 50}, "holds an ensemble of samples = 2000, not 50"),
        ({"scenario": 1}, "holds an ensemble of another scenario"),
    ],
)
def test_another_ensemble_is_refused(quick, tmp_path, given, sentence):
    out = tmp_path / "e.zarr"
    run_ensemble(quick, VARY, 20, out=out)
    before = files(out)
    arguments = {"scenario": quick, "vary": VARY, "members": 20, **given}
    if given == {"scenario": 1}:
        arguments["scenario"] = quick.with_values({"learning.gain": 0.9})
    with pytest.raises(DataError) as error:
        run_ensemble(out=out, **arguments)
    assert sentence in str(error.value)
    assert files(out) == before


def test_folders_that_are_no_ensemble(quick, tmp_path):
    out = tmp_path / "e.zarr"
    cases = []
    file = tmp_path / "file"
    file.write_text("text")
    cases.append((file, "is a file"))
    filled = tmp_path / "filled"
    filled.mkdir()
    (filled / "notes.txt").write_text("mine")
    cases.append((filled, "is a folder without an ensemble"))
    cases.append((tmp_path / "no" / "e.zarr", "does not exist"))
    run_ensemble(quick, VARY, 4, out=out)
    for name, text in (("text", "{"), ("empty", "{}")):
        damaged = tmp_path / f"{name}.zarr"
        shutil.copytree(out, damaged)
        (damaged / "zarr.json").write_text(text)
        cases.append((damaged, "is no ensemble or is damaged"))
    lost = tmp_path / "lost.zarr"
    shutil.copytree(out, lost)
    shutil.rmtree(lost / "status")
    cases.append((lost, "is no ensemble or is damaged"))
    for path, sentence in cases:
        with pytest.raises(DataError, match=sentence):
            run_ensemble(quick, VARY, 4, out=path)
    assert (filled / "notes.txt").read_text() == "mine"
    empty = tmp_path / "new"
    empty.mkdir()
    assert run_ensemble(quick, VARY, 4, out=empty).sizes["member"] == 4


def test_numbers_of_other_versions_are_not_mixed(quick, tmp_path):
    out = tmp_path / "e.zarr"
    run_ensemble(quick, VARY, 20, out=out, chunk=10)
    store = open_store(out)
    store.group.attrs["code"] = "another"
    run_ensemble(quick, VARY, 20, out=out, chunk=10)
    store.group["done"][1] = 0
    with pytest.raises(DataError, match="begun by other versions"):
        run_ensemble(quick, VARY, 20, out=out, chunk=10)


def test_vary_reads_back():
    for text in ("a.b=0.2:2.0", "a.b~normal:0.1", "a.b=[0.5, 1, [2, 3]]"):
        assert read_vary(read_vary(text).text) == read_vary(text) or "[" in text


# ---- the figure and the command


@pytest.mark.parametrize("duration", [10, 125])
def test_the_figure(scenario, duration):
    data = run_ensemble(scenario.with_values({"run.duration": duration}), VARY, 8, samples=50)
    figure = ensemble_plot(data)
    assert [len(ax.get_title(loc="left")) > 0 for ax in figure.axes] == [True, True]
    assert figure.axes[1].get_yscale() == "log"


@pytest.fixture
def ensemble(clpt):
    """`clpt ensemble`."""
    return lambda *arguments: clpt("ensemble", *arguments)


def test_the_command(ensemble, quick, tmp_path):
    file, out, figure = tmp_path / "s.toml", tmp_path / "e.zarr", tmp_path / "e.png"
    clpt_control.save_scenario(quick, file)
    many = ("--members", 12, "--vary", VARY[0], "--vary", VARY[1], "--seed", 4, "--out", out)
    outcome = ensemble(file, *many, "--json", "--figure", figure)
    assert outcome.status == 0, outcome.err
    printed = json.loads(outcome.out)
    assert printed["ended"] == {"finished": 12}
    assert inked(figure) > 0.01
    table = ensemble(file, *many)
    assert table.status == 0
    assert "12 finished" in table.out
    wrong = ensemble(file, "--members", 3, "--vary", "x=1:2", "--out", tmp_path / "f.zarr")
    assert wrong.status == 2
    assert wrong.err.count("\n") == 1
    assert not (tmp_path / "f.zarr").exists()
    named = ensemble(file, *many, "--figure", tmp_path / "e.gif")
    assert named.status == 2
    assert ".png, .pdf or .svg" in named.err
