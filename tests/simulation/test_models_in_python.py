"""Models that run in Python: jumps of rates, random models, functions with hidden state."""

import ctypes
import warnings

import control
import numpy as np
import pytest

import clpt_control as clpt
from benchmarks import python_models

TIMES = np.linspace(0, 9.5, 39)
FLOOR = ctypes.PyDLL(None).floor  # C, which cannot be traced
FLOOR.restype, FLOOR.argtypes = ctypes.c_double, [ctypes.c_double]


def area(t):
    """Return the integral of a staircase: by n per time from t = n on."""
    whole = np.floor(t)
    return whole * (whole - 1) / 2 + whole * (t - whole)


def run(function):
    system = control.nlsys(function, None, inputs=0, outputs=2, states=2, name="stairs")
    with pytest.warns(UserWarning, match="runs in Python"):
        return clpt.simulate(system, TIMES, None, [0.0, 0.0])


def test_jumps_of_rates_leave_the_error_of_the_tolerance():
    response = run(lambda t, x, u, p: [1.0, FLOOR(x[0])])
    np.testing.assert_allclose(response.states.values[:, 1], area(TIMES), atol=2e-5)
    assert response.attrs["status"] == "finished"
    assert response.attrs["solver_evaluations"] < 10_000


def test_jumps_of_two_functions():
    two = lambda t, x, u, p: [1.0, FLOOR(x[0]) + 0.5 * FLOOR(2 * x[0])]  # noqa: E731
    expected = area(TIMES) + 0.25 * area(2 * TIMES)
    np.testing.assert_allclose(run(two).states.values[:, 1], expected, atol=6e-5)


@pytest.mark.parametrize("seed", range(len(python_models.TERMS)))
def test_random_models_are_as_exact_as_python_controls(seed):
    """Against SciPy at 1e-10; evaluations are counted in the function itself."""
    kind, errors, evaluations, _ = python_models.measured(seed)
    assert errors[0] < max(2.0 * errors[1], 1e-8)
    # a jump is met by steps of 12 stages, those of python-control have 6
    assert (
        evaluations[0]
        < (1.5 if kind in ("smooth", "kink", "stiff") else 2.5) * evaluations[1]
    )


@pytest.mark.parametrize(("k", "method"), [(1.0, "DOP853"), (1e5, "Rodas5P")])
def test_a_lag_behind_a_saw(k, method):
    """x' = k (u - x): behind a line of slope s, x is u - s/k and a part that fades."""
    times = np.linspace(0.0, 10.0, 51)
    saw = np.where(np.arange(51) % 2, 1.0, -1.0)
    exact = [0.0]
    for begin, end, span in zip(saw, saw[1:], np.diff(times), strict=False):
        lag = (end - begin) / span / k
        exact.append(end - lag + (exact[-1] - begin + lag) * np.exp(-k * span))
    rate = lambda t, x, u, p: [k * (u[0] - x[0]) + FLOOR(0.5)]  # noqa: E731
    system = control.nlsys(rate, None, inputs=1, outputs=1, states=1, name="lag")
    with pytest.warns(UserWarning, match="runs in Python"):
        found = clpt.simulate(system, times, saw, [0.0])
    assert found.attrs["method"].endswith(method)
    np.testing.assert_allclose(found.states[:, 0], exact, atol=1e-7)
    assert found.attrs["solver_evaluations"] < 220 * len(times)


def test_a_model_that_calls_lsoda_itself():
    """x' = -x/e, which is itself the end of an integration."""
    from scipy.integrate import odeint

    def rate(t, x, u, p):
        return -odeint(lambda y, s: -y, x[0], [0, 1], rtol=1e-10, atol=1e-12)[1]

    system = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="nested")
    with pytest.warns(UserWarning, match="runs in Python"):
        found = clpt.simulate(system, [0, 1], None, [1.0])
    assert found.attrs["method"] == "DOP853"
    np.testing.assert_allclose(found.states[-1], np.exp(-np.exp(-1.0)), atol=1e-8)


# --- hidden state -----------------------------------------------------------------------------


def loop_with_memory():
    """Return a low pass behind python-control's own backlash."""
    play = control.friction_backlash_nonlinearity(0.5)
    part = lambda t, x, u, p: play(u[0])  # noqa: E731
    source = lambda t, x, u, p: p["A"] * np.sin(2 * t)  # noqa: E731
    return control.interconnect(
        [
            control.nlsys(None, source, inputs=0, outputs="s", params={"A": 1.0}),
            control.nlsys(None, part, inputs="s", outputs="b"),
            control.tf(1, [1, 1], inputs="b", outputs="y"),
        ],
        inputs=[],
        outputs=["y"],
        name="loop",
    )


def test_a_function_with_hidden_state_runs_twice():
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        clpt.simulate(loop_with_memory(), np.linspace(0, 5, 51))
    sentences = [str(one.message) for one in seen]
    assert any(
        "order of calls" in text and "parts.backlash, parts.relay" in text
        for text in sentences
    )


def test_an_ensemble_refuses_a_function_with_hidden_state():
    with (
        pytest.warns(UserWarning, match="runs in Python"),
        pytest.raises(clpt.DiagramError, match="would share hidden state"),
    ):
        clpt.run_ensemble(
            loop_with_memory(), {"A": [1.0, 2.0]}, timepts=np.linspace(0, 5, 51)
        )
