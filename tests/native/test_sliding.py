"""Switches on which a run slides or comes to rest."""

import control
import numpy as np
import pytest
from test_kinks import T, run, system

import clpt_control as clpt
from clpt_control.errors import SimulationError
from clpt_control.native import python_diagram


def sliding(t, x, u, p):
    return [-np.sign(x[0]) + 0.3 * np.sin(t)]


def test_a_switch_that_chatters_slides_at_loose_tolerances_and_is_said_at_tight_ones():
    """x' = -sign x + 0.3 sin t stays at 0 once it is there."""
    found = clpt.simulate(system(sliding, 1), T, None, [0.5], rtol=1e-2, atol=1e-2)
    assert np.all(np.abs(found.states.values[T > 1, 0]) < 1e-3)
    with pytest.raises(
        SimulationError, match=r"t = 0\.54.* `sign` in s.update switches to and fro"
    ):
        run(sliding, [0.5])


@pytest.mark.parametrize("rtol", [1e-1, 3e-3, 1e-6, 1e-12])
@pytest.mark.parametrize(
    ("f", "x0"),
    [(sliding, [0.5]), (lambda t, x, u, p: [x[1], -2.0 if x[0] + x[1] > 0 else 2.0], [1.0, 0.0])],
)
def test_a_sliding_mode_is_told_or_run_soon(f, x0, rtol, monkeypatch):
    batches, said, ended = [], "", python_diagram.ended
    monkeypatch.setattr(
        python_diagram, "ended", lambda s, batch, u: batches.append(batch) or ended(s, batch, u)
    )
    made = system(f, len(x0))
    try:
        found = clpt.simulate(made, T, None, x0, rtol=rtol, atol=1e-2 * rtol)
    except SimulationError as error:
        said = str(error)
    _, evaluations, *_ = batches[0].counts[0]
    assert evaluations < 20_000_000
    if said:
        assert "switches to and fro without going on; give the switch a hysteresis" in said
    else:
        assert np.all(np.abs(found.states.values[-1]) < rtol)


def test_a_switch_that_no_tolerance_ends_is_an_error():
    with pytest.raises(SimulationError, match="switches to and fro"):
        run(lambda t, x, u, p: [-1e6 * np.sign(x[0]) + np.sin(1e3 * t)], [0.5])


def test_with_a_boundary_layer_it_runs():
    found = run(lambda t, x, u, p: [-np.clip(x[0] / 0.01, -1.0, 1.0)], [0.5]).states.values[:, 0]
    np.testing.assert_allclose(found[T <= 0.4], 0.5 - T[T <= 0.4], atol=1e-9)
    assert abs(found[-1]) < 1e-9


EMPTYING = {  # Torricelli: beyond the switch the rate has no value, or no slope
    "if": lambda t, x, u, p: [-p["k"] * np.sqrt(x[0])] if x[0] >= 0 else [0.0],
    "max": lambda t, x, u, p: [-p["k"] * np.sqrt(max(x[0], 0.0))],
    "sign": lambda t, x, u, p: [-p["k"] * np.sqrt(abs(x[0])) * np.sign(x[0])],
}


@pytest.mark.parametrize("name", EMPTYING)
def test_a_tank_that_runs_empty_stays_so(name):
    """x = (1 - k t/2)^2 until it is empty, one by one and in lanes."""
    tank = control.nlsys(
        EMPTYING[name], states=["x"], inputs=0, outputs=["x"], params={"k": 1.0}, name="tank"
    )
    times = np.linspace(0.0, 3.0, 31)
    right = np.maximum(1.0 - times / 2, 0.0) ** 2
    run = clpt.simulate(tank, times, initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.x.values.ravel(), right, atol=1e-8)
    k = np.array([0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(tank, {"k": k}, timepts=times, initial_state=[1.0])
    assert np.all(many.status == 1)
    np.testing.assert_allclose(many.x_final, np.maximum(1.0 - 1.5 * k, 0.0) ** 2, atol=1e-8)


def test_what_has_no_value_on_either_side_is_still_told():
    f = control.nlsys(
        lambda t, x, u, p: [np.log(x[0]) if x[0] > -1 else 0.0],
        states=["x"], inputs=0, outputs=0, name="falling",
    )  # fmt: skip
    with pytest.raises(SimulationError, match="derivative of x of block falling is not finite"):
        clpt.simulate(f, [0.0, 3.0], initial_state=[0.5])


def test_a_root_of_a_magnitude_that_begins_at_zero_goes_on():
    """Bouc and Wen's hysteresis at rest: |z|^0.5 has no value where the sign of z is held."""

    def rate(t, x, u, p):
        q, v, z = x
        slip = 0.6 * np.abs(v) * np.abs(z) ** 0.5 * z + 0.3 * v * np.abs(z) ** 1.5
        return [v, np.sin(t) - 0.2 * v - q - 0.5 * z, v - slip]

    system = control.nlsys(rate, None, inputs=0, outputs=3, states=["q", "v", "z"], name="bouc")
    times = np.linspace(0.0, 5.0, 51)
    run = clpt.simulate(system, times, None, [0.01, 0.0, 0.0])
    assert "switches not located" in run.attrs["method"]
    close = {"rtol": 1e-10, "atol": 1e-12}
    theirs = control.input_output_response(
        system, times, 0, [0.01, 0.0, 0.0], solve_ivp_kwargs=close
    )
    np.testing.assert_allclose(run.states.values, theirs.states.T, atol=1e-6)
    many = clpt.run_ensemble(system, {"q": [0.01]}, timepts=times, initial_state=[0.0, 0.0, 0.0])
    np.testing.assert_allclose(many.y_final.values[0], run.states.values[-1], atol=1e-7)
