"""`dataset.clpt`, and a run as a table, read back by csv and by scipy.io.loadmat."""

import csv
import pickle
import sys

import control
import numpy as np
import pytest
import xarray
from error_sentences import says
from gridded_currents import uniform_field
from scipy.io import loadmat
from subprocesses import ran

import clpt_control as clpt

ORDERS = (
    "clpt_control, xarray",
    "xarray, clpt_control",
    "clpt_control.currents, xarray.core",
)


@pytest.mark.processes  # test_release asks one of them
@pytest.mark.parametrize("order", ORDERS)
def test_it_is_there_whichever_was_imported_first(order):
    code = f"import {order}; import xarray; xarray.Dataset().clpt"
    ran(sys.executable, "-W", "error", "-c", code)


@pytest.mark.long
def test_a_run_and_its_file_as_xarray_opens_it(made, scenario, tmp_path):
    run = made["run"]
    clpt.save_run(run, tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        for one in (opened, run.isel(time=slice(3, 20))):
            assert (one.clpt.kind, one.clpt.scenario) == ("run", scenario)
            assert len(one.clpt.plot()) == 7
        report = clpt.report(opened.isel(time=[-1]), tmp_path / "page.html")
    assert report["kind"] == "Run of a scenario"


@pytest.mark.long
def test_a_field_is_found_from_the_file_alone(scenario, tmp_path):
    """The scenario's field is relative to its file, also for xarray's own opening."""
    uniform_field(tmp_path / "field.nc")
    flow = {"flow": {"field": str(tmp_path / "field.nc")}}
    clpt.save_scenario(scenario.with_values(flow), tmp_path / "s.toml")
    loaded, vary = clpt.load_scenario(tmp_path / "s.toml"), "learning.gain=0.2:2.0"
    clpt.save_run(clpt.simulate(loaded), tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        assert opened.clpt.plot("track").has_data()
    for out in (None, tmp_path / "e.zarr"):
        data = clpt.run_ensemble(loaded, vary, 2, out=out)
        assert data.clpt.scenario.field_path.is_file()
    assert xarray.open_zarr(out, consolidated=False).clpt.scenario.field_path.is_file()


@pytest.mark.long
def test_teams_ensembles_and_replays(made, scenario, tmp_path):
    data = made["replay"].dataset()
    for kind, one, count in (
        *(
            ("team", made["team"], 3),
            ("ensemble", made["ensemble"], 2),
            ("replay", data, 5),
        ),
    ):
        assert (one.clpt.kind, len(one.clpt.plot())) == (kind, count)
        assert f"clpt of a dataset: {kind}" in repr(one.clpt)
    assert [*made["team"].clpt.scenario.members.values()] == [scenario, scenario]
    assert made["ensemble"].clpt.scenario == scenario
    data.to_netcdf(tmp_path / "replay.nc")
    with xarray.open_dataset(tmp_path / "replay.nc") as opened:  # times decoded
        for name in ("current", "map", "clpe"):
            decoded, whole = opened.clpt.plot(name), data.clpt.plot(name)
            for of_data, own in zip(np.ravel(decoded), np.ravel(whole), strict=True):
                assert of_data.get_title(loc="left") == own.get_title(loc="left")
                for a, b in zip(of_data.lines, own.lines, strict=True):
                    np.testing.assert_allclose(a.get_ydata(), b.get_ydata(), atol=1e-3)


def test_what_is_not_ours_is_one_sentence(made):
    foreign = xarray.Dataset({"a": 1})
    assert repr(foreign.clpt) == "<clpt of a dataset: none of clpt's>"
    says(clpt.ClptError, "", lambda: foreign.clpt.scenario)
    says(clpt.ClptError, "", foreign.clpt.plot)
    says(clpt.ClptError, "", clpt.report, foreign, "page.html")
    says(clpt.ClptError, "", clpt.animate, foreign)


def test_a_run_is_linearized_at_one_of_its_times(scenario):
    scenario = scenario.started_true()
    run = clpt.simulate(scenario)
    made = run.clpt.linearize(10.0, input="zc", output="x", minimal=True)
    steered = clpt.closed_loop(scenario, external="zc")
    state, desired = run.clpt.state(10.0), run.reference.sel(time=10.0).values
    whole = clpt.linearize(steered, state, desired, 10.0)
    x = whole.output_labels.index("x[0]")
    assert (made.nstates, made.input_labels) == (2, ["zc[0]", "zc[1]"])
    np.testing.assert_allclose(made(1j), whole(1j)[x : x + 2], atol=1e-12)
    assert run.clpt.linearize(10.0).ninputs == 0
    cut = run.clpt.linearize(10.0, input="x", output="alpha")
    assert cut.state_labels[0] == "learning_model_z[0]"
    says(
        clpt.ArgumentError,
        "has no output 'nothing'",
        run.clpt.linearize,
        10.0,
        output="nothing",
    )
    changed = clpt.simulate(scenario, params={"basis_x.widths": [1.0, 2.0, 3.0]})
    lost = pickle.loads(pickle.dumps(changed))
    says(clpt.DataError, "does not contain its diagram.", lost.clpt.linearize, 10.0)
    other = clpt.simulate(scenario.with_values({"basis.widths": [1.0, 2.0, 3.0]}))
    np.testing.assert_allclose(
        changed.clpt.linearize(10.0).A, other.clpt.linearize(10.0).A, atol=1e-12
    )


def test_a_diagram_in_memory_is_linearized_at_its_inputs_of_that_time():
    """A pendulum whose torque u is scaled by its angle: the slopes are by hand."""
    rates = {"update": lambda t, x, u, p: [x[1], -p.g * np.sin(x[0]) + x[0] * u[0]]}
    ports = {"inputs": {"torque": 1}, "states": {"angle": 1, "rate": 1}}
    pendulum = clpt.Block("pendulum", **rates, **ports, parameters={"g": 2.0})
    loop = clpt.connect([pendulum], external="torque")
    given = {"initial_state": {"pendulum.angle": 0.3}, "params": {"pendulum.g": 5.0}}
    run = clpt.simulate(loop, TIMES, {"torque": TIMES}, **given)
    angle = run.clpt.state(1.0)[0]
    for one in (run, run.copy(deep=True).isel(time=slice(0, 6))):
        made = one.clpt.linearize(1.0, "torque", "angle")
        slopes = [[0, 1], [1.0 - 5.0 * np.cos(angle), 0]]
        np.testing.assert_allclose(made.A, slopes, atol=1e-12)
        np.testing.assert_allclose(made.B, [[0], [angle]], atol=1e-12)
        assert made.output_labels == ["angle"]
    named = clpt.linearize(loop, {"pendulum_angle": 0.5}, {"torque": 1.0})
    vectors = clpt.linearize(loop, [0.5, 0.0], [1.0])
    np.testing.assert_array_equal(named.A, vectors.A)
    says(
        clpt.ArgumentError, "Did you mean", clpt.linearize, loop, {"pendulum_angel": 1}
    )


# --- a run as a table, read back by csv and by scipy.io.loadmat ----------------------------------

TIMES = np.linspace(0.0, 2.0, 11)


def run_of_a_diagram(**units):
    ports = {"inputs": {"q": 1}, "states": {"h": 2}, "units": units}
    block = clpt.Block(
        "tank", update=lambda t, x, u, p: [u[0] - x[0], x[0] - x[1]], **ports
    )
    return clpt.simulate(block, TIMES, np.sin(TIMES))


def test_a_csv_file_is_the_run_to_the_last_digit(tmp_path):
    run = run_of_a_diagram(h="m", q="m3/s")
    table = run.clpt.table(tmp_path / "run.csv")
    with (tmp_path / "run.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    assert head == [*table.columns] == ["time", "h[0] (m)", "h[1] (m)", "q (m3/s)"]
    read = np.array(rows, dtype=float)
    np.testing.assert_array_equal(read, table)
    np.testing.assert_array_equal(read.T, [run.time, *run.h.values.T, run.q])


def test_the_table_of_an_ensemble_has_a_row_for_each_member(tmp_path):
    decay = clpt.Block(
        "decay",
        update=lambda t, x, u, p: {"w": -p.b * x.w},
        states={"w": 2},
        parameters={"b": 1.0},
        units={"w": "m", "b": "1/s"},
    )
    vary = {"decay.b": [1.0, 2.0], "w[0]": [3.0, 4.0, 5.0]}
    data = clpt.run_ensemble(decay, vary, timepts=TIMES, out=tmp_path / "d.zarr")
    table = data.clpt.table(tmp_path / "members.csv")
    assert [*table.columns[:4]] == ["member", "status", "decay.b (1/s)", "w[0] (m)"]
    assert table.status.tolist() == ["finished"] * 6
    exact = table["w[0] (m)"] * np.exp(-table["decay.b (1/s)"] * TIMES[-1])
    np.testing.assert_allclose(table["w_final[0] (m)"], exact, rtol=1e-6)


def test_a_mat_file_has_a_matrix_for_each_port(tmp_path):
    run = run_of_a_diagram(h="m")
    run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    own = {name for name in read if name[0] != "_"}
    assert own == {"time", "h", "q", "units", "signals", "title"}
    shapes = loadmat(tmp_path / "run.mat")
    for name, columns in (("time", 1), ("h", 2), ("q", 1)):
        np.testing.assert_array_equal(read[name], run[name])
        assert shapes[name].shape == (11, columns)
    assert (read["title"], read["units"]["h"]) == ("Response of tank", "m")
    assert not len(read["units"]["q"])
    assert read["signals"]["h"].tolist() == ["h[0]", "h[1]"]


def test_a_run_of_a_scenario_and_of_a_team(made, tmp_path):
    run, both = made["run"], made["team"]
    said = "label: is for a run, not for a team"
    says(clpt.ScenarioError, said, both.clpt.plot, label="mine")
    table = run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    np.testing.assert_array_equal(
        read["alpha"], run.alpha.values.reshape(len(run.time), -1)
    )
    assert read["signals"]["alpha"][4] == "alpha axis 2 basis 2"
    assert [*table.columns[:3]] == [
        "time (s)",
        "position axis 1 (m)",
        "position axis 2 (m)",
    ]
    assert "flow_parameters" not in read  # which are no signals
    own = both.position.sel(vehicle="b", axis=1)
    np.testing.assert_array_equal(
        both.clpt.table()["position vehicle b axis 1 (m)"], own
    )


ALLOWED = [("_e", "q", "x__e q"), ("x" * 80, "q", "x" * 60 + " q")]
ALLOWED += [("\u00fc", "q", "x__ q"), ("a b", "a_b", "a_b a_b_")]


@pytest.mark.parametrize(("h", "q", "names"), ALLOWED)
def test_names_are_those_that_matlab_allows(tmp_path, h, q, names):
    run_of_a_diagram().rename(h=h, q=q).clpt.table(tmp_path / "run.mat")
    read = {name for name in loadmat(tmp_path / "run.mat") if name[:2] != "__"}
    assert read - {"time", "units", "signals", "title"} == set(names.split())


def test_it_refuses_in_a_sentence(tmp_path):
    run = run_of_a_diagram()
    for name in ("run.xls", "nowhere/run.csv", "nowhere/run.mat"):
        says(clpt.DataError, "", run.clpt.table, tmp_path / name)
    for none in (run.isel(time=3), run.rename(h="time", time="t")):
        says(clpt.DataError, "no signal along time", none.clpt.table)
    assert list(tmp_path.iterdir()) == []


def test_columns_of_members_name_what_varied():
    lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y", name="lag")
    times = np.linspace(0.0, 1.0, 3)
    table = clpt.run_ensemble(
        lag, {"u": [1, 2]}, timepts=times, trajectories=True
    ).clpt.table()
    assert [*table.columns] == ["time", "y u 1", "y u 2"]
    np.testing.assert_allclose(
        table.values[:, 2], 2.0 * (1.0 - np.exp(-times)), atol=1e-6
    )
