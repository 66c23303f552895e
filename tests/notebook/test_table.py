"""`run.clpt.table()`: read back by csv and by scipy.io.loadmat, it is the run."""

import csv

import control
import numpy as np
import pytest
from scipy.io import loadmat

import clpt_control as clpt

TIMES = np.linspace(0.0, 2.0, 11)


def run_of_a_diagram(ports=("h", "q"), units=None):
    state, u = ports
    block = clpt.Block(
        "tank",
        update=lambda t, x, u_, p: [u_[0] - x[0], x[0] - x[1]],
        inputs={u: 1},
        states={state: 2},
        units=units,
    )
    return clpt.simulate(block, TIMES, np.sin(TIMES))


def test_a_csv_file_is_the_run_to_the_last_digit(tmp_path):
    run = run_of_a_diagram(units={"h": "m", "q": "m3/s"})
    table = run.clpt.table(tmp_path / "run.csv")
    with (tmp_path / "run.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    assert head == [*table.columns] == ["time", "h[0] (m)", "h[1] (m)", "q (m3/s)"]
    read = np.array(rows, dtype=float)
    np.testing.assert_array_equal(read, table)
    own = [run.time, run.h.sel(h_index=0), run.h.sel(h_index=1), run.q]
    np.testing.assert_array_equal(read.T, own)


def test_a_mat_file_has_a_matrix_for_each_port(tmp_path):
    run = run_of_a_diagram(units={"h": "m"})
    run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    assert {name for name in read if name[0] != "_"} == {
        *("time", "h", "q", "units", "signals", "title")
    }
    np.testing.assert_array_equal(read["time"], TIMES)
    np.testing.assert_array_equal(read["h"], run.h)
    np.testing.assert_array_equal(read["q"], run.q)
    assert read["title"] == "Response of tank"
    assert read["units"]["h"] == "m"
    assert not len(read["units"]["q"])
    assert read["signals"]["h"].tolist() == ["h[0]", "h[1]"]
    shapes = loadmat(tmp_path / "run.mat")
    assert shapes["time"].shape == (11, 1)
    assert shapes["h"].shape == (11, 2)
    assert shapes["q"].shape == (11, 1)


def test_a_run_of_a_scenario_and_of_a_team(made, tmp_path):
    run, both = made["run"], made["team"]
    table = run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    np.testing.assert_array_equal(read["alpha"], run.alpha.values.reshape(len(run.time), -1))
    assert read["signals"]["alpha"][4] == "alpha axis 2 basis 2"
    assert [*table.columns[:3]] == ["time (s)", "position axis 1 (m)", "position axis 2 (m)"]
    assert "flow_parameters" not in read  # which are no signals
    own = both.position.sel(vehicle="b", axis=1)
    np.testing.assert_array_equal(both.clpt.table()["position vehicle b axis 1 (m)"], own)


@pytest.mark.parametrize(
    ("h", "q", "names"),
    [
        ("_e", "q", {"x__e", "q"}),
        ("x" * 80, "q", {"x" * 60, "q"}),
        ("\u00fc", "q", {"x__", "q"}),
        ("a b", "a_b", {"a_b", "a_b_"}),
    ],
)
def test_names_are_those_that_matlab_allows(tmp_path, h, q, names):
    run = run_of_a_diagram().rename(h=h, q=q)
    run.clpt.table(tmp_path / "run.mat")
    read = {name for name in loadmat(tmp_path / "run.mat") if name[:2] != "__"}
    assert read - {"time", "units", "signals", "title"} == names


def test_it_refuses_in_a_sentence(tmp_path):
    run = run_of_a_diagram()
    for path in (tmp_path / "run.xls", tmp_path / "nowhere/run.csv", tmp_path / "nowhere/run.mat"):
        with pytest.raises(clpt.DataError) as caught:
            run.clpt.table(path)
        assert "\n" not in str(caught.value)
    for none in (run.isel(time=3), run.rename(h="time", time="t")):
        with pytest.raises(clpt.DataError, match="no signal along time"):
            none.clpt.table()
    assert list(tmp_path.iterdir()) == []


def test_columns_of_members_name_what_varied():
    lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y", name="lag")
    times = np.linspace(0.0, 1.0, 3)
    data = clpt.run_ensemble(lag, {"u": [1, 2]}, timepts=times, trajectories=True)
    table = data.clpt.table()
    assert [*table.columns] == ["time", "y u 1.0", "y u 2.0"]
    np.testing.assert_allclose(table.values[:, 2], 2.0 * (1.0 - np.exp(-times)), atol=1e-6)
