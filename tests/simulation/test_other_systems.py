"""python-control's own systems beside blocks, and runs that repeat."""

import math
import pickle

import control
import netCDF4
import numpy as np
import pytest
from calm_water import CALM, PAPER
from responses import response

import clpt_control as clpt
from clpt_control.equations import Block
from clpt_control.errors import DataError
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.starts import initial_state


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_plain_systems_in_a_loop_with_blocks():
    """An oscillator: a Block's integrator, closed by two of python-control's own parts."""
    integrator = Block("speed", update=passes, inputs={"u": 1}, states={"s": 1})
    position = control.ss([[0.0]], [[1.0]], [[1.0]], [[0.0]], name="place")
    spring = control.nlsys(None, lambda t, x, u, params: -u, inputs=1, outputs=1, name="spring")
    loop = control.interconnect(
        [integrator, position, spring],
        connections=[
            ["place.u[0]", "speed.s[0]"],
            ["spring.u[0]", "place.y[0]"],
            ["speed.u[0]", "spring.y[0]"],
        ],
        outlist=["place.y[0]"],
        outputs=["x"],
        inputs=0,
        name="loop",
        check_unused=False,
    )
    times = np.linspace(0, 10, 21)
    run = response(loop, times, initial_state=[0.0, 1.0], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.outputs.ravel(), np.cos(times), atol=1e-9)


def passes(t, x, u, p):
    """s' = u, section 2: u[1], s[1]."""
    return u[0]


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_parameters_of_a_plain_system():
    lag = control.nlsys(
        lambda t, x, u, params: -params["k"] * x,
        None,
        inputs=1,
        outputs=1,
        states=1,
        name="lag",
        params={"k": 1.0},
    )
    block = Block("speed", update=passes, inputs={"u": 1}, states={"s": 1})
    loop = control.interconnect(
        [lag, block],
        connections=[["speed.u[0]", "lag.y[0]"]],
        outlist=["speed.s[0]"],
        outputs=["s"],
        inputs=0,
        name="loop",
        check_unused=False,
    )
    for k in (1.0, 3.0):
        run = response(
            loop, [0.0, 2.0], initial_state=[1.0, 0.0], params={"k": k}, rtol=1e-11, atol=1e-13
        )
        assert np.ravel(run.outputs)[-1] == pytest.approx((1 - math.exp(-2 * k)) / k, abs=1e-9)


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_a_plain_system_alone():
    run = response(control.ss(-2, 1, 1, 0), [0.0, 1.0], 4.0, rtol=1e-11, atol=1e-13)
    assert np.ravel(run.outputs)[-1] == pytest.approx(2 - 2 * math.exp(-2), abs=1e-9)


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


def test_pickled_blocks_run_the_same():
    loop = clpt.closed_loop(CALM)
    for block in loop.syslist:
        twin = pickle.loads(pickle.dumps(block))
        assert twin.name == block.name
        assert twin.update_function is block.update_function
        assert twin.output_function is block.output_function
