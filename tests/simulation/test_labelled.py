"""Labels of xarray, pandas and responses decide, never positions; closed forms are right."""

import control
import numpy as np
import pandas as pd
import pytest
import xarray

import clpt_control as clpt

TIMES, OWN = np.linspace(0.0, 2.0, 5), np.linspace(0.0, 4.0, 9)
DATA = xarray.Dataset({"b": ("time", 0 * OWN + 10), "a": ("time", OWN)}, {"time": OWN})
TABLE = pd.DataFrame({"b": DATA.b.values, "a": OWN}, index=OWN)
NAMED = xarray.DataArray(
    [DATA.b, DATA.a], {"signal": ["b", "a"], "time": OWN}, ("signal", "time")
)
RIGHT = np.array([TIMES**2 / 2, 10 * TIMES]).T  # integrals of t and 10
RESPONSE = control.TimeResponseData(
    OWN, NAMED.values, output_labels=["b", "a"], issiso=False
)


def integrators(inputs=("a", "b")):
    n = len(inputs)
    states = [f"q{name}" for name in inputs]
    return control.ss(
        *(np.zeros((n, n)), np.eye(n), np.eye(n), 0),
        inputs=[*inputs],
        states=states,
        outputs=states,
        name="m",
    )


@pytest.mark.parametrize(
    "inputs",
    [
        DATA,
        DATA.isel(time=slice(None, None, -1)),
        {"a": DATA.a, "b": 10.0},
        {"a": TIMES, "b": DATA.b},
        [DATA.a, 10.0],
        NAMED,
        NAMED.T[::-1],
        TABLE,
        TABLE.T,
        TABLE[::-1],
        TABLE.rename_axis("time").reset_index(),
        RESPONSE,
    ],
)
def test_inputs_are_read_at_their_own_times_and_by_name(inputs):
    run = clpt.simulate(integrators(), TIMES, inputs)
    np.testing.assert_allclose(run.states, RIGHT, atol=1e-7)
    found = clpt.prepare(integrators(), TIMES)(inputs=inputs)
    np.testing.assert_allclose(found.states, RIGHT, atol=1e-7)


@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        (DATA.assign(c=DATA.a), "has no input 'c'"),
        (DATA.isel(time=slice(3)), "from 0 to 1. Give timepts within"),
        (DATA.isel(time=[1, 0, *range(2, 9)]), "must be finite and in order"),
        (DATA.where(DATA.time != 1.0), "must be finite"),
        (DATA.assign_coords(time=pd.date_range("2020", periods=9)), "are dates"),
        (TABLE.set_axis(range(1, 10)), "whole numbers. Name it time"),
        (TABLE.set_axis(pd.MultiIndex.from_product([range(3)] * 2)), "of one level"),
        (TABLE.set_axis(["a", "a"], axis=1), "given twice"),
        ([NAMED, 0.0], "Give a dict by name"),
        ({"a": NAMED}, "has the names b, a; must be a"),
    ],
)
def test_labels_that_contradict_are_refused(inputs, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.simulate(integrators(), TIMES, inputs)


def test_units_that_differ_are_refused():
    block = clpt.Block(
        "v",
        update=lambda t, x, u, p: u,
        inputs={"a": 1},
        states={"s": 1},
        units={"a": "m/s"},
    )
    plain = control.nlsys(lambda t, x, u, p: u, inputs="a", states="s", name="n")
    plain.units = {"a": "m/s"}
    for system in (block, clpt.connect([block], "a"), plain):
        run = clpt.simulate(system, TIMES, {"a": DATA.a.assign_attrs(units="m s-1")})
        np.testing.assert_allclose(run.states[:, 0], RIGHT[:, 0], atol=1e-7)
        with pytest.raises(clpt.ArgumentError, match="is in 'km/h'"):
            clpt.simulate(system, TIMES, {"a": DATA.a.assign_attrs(units="km/h")})


def test_a_jump_among_other_times():
    jump = xarray.DataArray([0.0, 0, 1, 1], {"time": [0.0, 1, 1, 4]}, "time")
    run = clpt.simulate(integrators(), TIMES, {"b": jump, "a": DATA.a})
    right = np.array([RIGHT[:, 0], [0, 0, 0, 0.5, 1]]).T
    np.testing.assert_allclose(run.states, right, atol=1e-7)


def test_states_by_name_and_ports_by_number():
    start = pd.Series({"qb": 1.0, "qa": 2.0})
    state = xarray.DataArray(start.values, {"state": start.index}, "state")
    for given in (start, state, {**start}):
        run = clpt.simulate(integrators(), [0, 1], 0, given)
        assert run.states.values[0].tolist() == [2, 1]
        text = clpt.export(integrators(), initial_state=given)
        assert "= {2.0, 1.0}" in text
    swapped = integrators(["c[1]", "d", "c[0]"])
    c = xarray.DataArray([OWN, 0 * OWN + 10], {"time": OWN}, ("k", "time")).T
    run = clpt.simulate(swapped, TIMES, {"c": c})
    np.testing.assert_allclose(run.states[:, [2, 0]], RIGHT, atol=1e-7)


def test_a_fit_reads_measurements_at_their_own_times():
    decay = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0] + u[0]],
        inputs="u",
        outputs="y",
        states="y",
        params={"k": 1.0},
        name="decay",
    )
    fine = np.linspace(0, 4, 401)
    force = xarray.DataArray(np.sin(fine), {"time": fine}, "time")
    y = clpt.simulate(decay, OWN, {"u": force}, [1.0], params={"k": 0.7}).y
    for timepts, inputs in (
        (None, {"u": force}),
        (fine, np.sin(fine)),
        (2 * OWN, force),
    ):
        for data in ({"y": y}, {"y": y[::-1]}, y.to_dataset(name="y")):
            found = clpt.fit_parameters(
                *(decay, data, {"k": 1.0}, timepts, inputs), initial_state=[1.0]
            )
            assert abs(found.values["k"] - 0.7) < 1e-7
    with pytest.raises(clpt.SimulationError, match="Give timepts within"):
        clpt.fit_parameters(decay, {"y": y}, {"k": 1.0}, fine[:9], fine[:9])
