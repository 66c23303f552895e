"""python-control's own systems beside blocks, and runs that repeat."""

import netCDF4
import numpy as np
import pytest
from calm_water import CALM, PAPER
from responses import response

import clpt_control as clpt
from clpt_control.errors import DataError
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.starts import initial_state


def test_run_from_its_file_repeats_itself(tmp_path):
    scenario = PAPER.with_values(
        {
            "run.duration": 45.0,
            "run.output_step": 2.5,
            "flow.disturbance": {
                "kind": "noise",
                "amplitude": [0.1, 0.2],
                "period": 3.0,
                "seed": 4,
            },
        }
    )
    run = clpt.simulate(scenario)
    clpt.save_run(run, tmp_path / "run.nc")
    loaded = clpt.load_run(tmp_path / "run.nc")
    assert set(loaded.variables) == set(run.variables)
    for name in run.variables:
        np.testing.assert_array_equal(loaded[name], run[name])
        assert loaded[name].attrs == run[name].attrs
    again = clpt.simulate(clpt.load_scenario(tmp_path / "run.nc"))
    for name in run.variables:
        np.testing.assert_array_equal(again[name], run[name])
    assert loaded.attrs["status"] == "finished"


def test_what_is_no_run_is_an_error(tmp_path):
    (tmp_path / "text.nc").write_text("no netcdf")
    for path in ("text.nc", "none.nc"):
        with pytest.raises(DataError, match=path):
            clpt.load_run(tmp_path / path)


@pytest.mark.parametrize("form", [2, "two", 0])
def test_a_run_of_a_later_version_is_refused(form, tmp_path):
    clpt.save_run(clpt.simulate(CALM), tmp_path / "run.nc")
    with netCDF4.Dataset(tmp_path / "run.nc", "a") as file:
        assert file.run_format == 1
        file.run_format = form
        file.source = "clpt-control 9.0"
    for read in (clpt.load_run, clpt.load_scenario):
        with pytest.raises(DataError, match=f"{form}, written by clpt-control 9.0.*reads 1 to 1"):
            read(tmp_path / "run.nc")


def test_runs_are_the_same_in_any_order():
    plain = PythonDiagram(clpt.closed_loop(CALM))
    x0 = initial_state(CALM)
    first = plain.run(x0, [0.0, 3.0]).x
    plain.run(x0 + 1.0, [1.0, 2.0])
    np.testing.assert_array_equal(plain.run(x0, [0.0, 3.0]).x, first)


def test_a_run_in_two_parts_is_the_run():
    loop, x0 = clpt.closed_loop(CALM), initial_state(CALM)
    whole = response(loop, [0.0, 1.0, 3.0], initial_state=x0, rtol=1e-11, atol=1e-13)
    part = response(loop, [0.0, 1.0], initial_state=x0, rtol=1e-11, atol=1e-13)
    rest = response(loop, [1.0, 3.0], initial_state=part.states[:, -1], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(rest.states[:, -1], whole.states[:, -1], atol=1e-9)
