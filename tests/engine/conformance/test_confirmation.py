"""No record is used that Python does not confirm, whoever asks for it."""

import math

import control
import numpy as np
import pytest
from engine_runs import heaps, tracing
from error_sentences import says
from scipy.integrate import solve_ivp

import clpt_control as clpt


def system_of(rate, name="r", **more):
    """Return x' = rate(x)."""
    sizes = {"inputs": 0, "outputs": 1, "states": 1}
    return control.nlsys(rate, None, **sizes, **more, name=name)


# --- records that are wrong: of each branch the first path is taken -------------------------------


def in_a_window(t, x, u, p):
    return [-x[0] if not 0.35 < x[0] < 0.351 else -3.0 * x[0]]


def far(t, x, u, p):
    if x[0] < 5000.0:
        return [-x[0]]
    return [-3.0 * x[0]]


def beyond_a_parameter(t, x, u, p):
    if x[0] < 40.0 * p["level"]:
        return [-x[0]]
    return [-3.0 * x[0]]


def in_a_corner(t, x, u, p):
    k = -1.0
    if x[0] > 0.5 and math.sin(x[0]) < 0.1 and x[0] < 3.2:
        k = -3.0
    return [k * x[0]]


def as_time_goes(t, x, u, p):
    if t < 9.5:
        return [-x[0]]
    return [-3.0 * x[0]]


WRONG = [in_a_window, far, beyond_a_parameter, in_a_corner, as_time_goes]
SENTENCE = (
    r"x\[0\] is -?[\d.e+-]+ as traced and -?[\d.e+-]+ in Python, at t = .*, x = \[.*\]"
)


@pytest.mark.parametrize("rate", WRONG, ids=lambda one: one.__name__)
@pytest.mark.parametrize("merges", ["functions", "statements"])
def test_a_wrong_record_is_used_by_nobody(rate, merges, monkeypatch):
    first = lambda tape, tree, values: values[0]  # noqa: E731
    monkeypatch.setattr(heaps, "joined", first)
    monkeypatch.setattr(tracing, "joined", first)
    if merges == "functions":  # and no statements
        monkeypatch.setattr(heaps, "KINDS", {})
    system = system_of(rate, params={"level": 2.0})
    says(clpt.DiagramError, SENTENCE, clpt.linearize, system, [1.0])
    says(clpt.DiagramError, SENTENCE, clpt.equations, system)
    says(clpt.DiagramError, SENTENCE, clpt.export, system)
    says(clpt.ClptError, SENTENCE, clpt.lyapunov, system, "x[0]**2")
    run = {"timepts": [0.0, 1.0], "initial_state": [1.0]}
    says(clpt.ClptError, SENTENCE, clpt.sensitivity, system, to="x[0]", **run)
    with pytest.warns(UserWarning, match=SENTENCE):
        found = clpt.simulate(system, **run)
    assert found.attrs["engine"] == "python"
    with pytest.warns(UserWarning, match=SENTENCE):
        clpt.run_ensemble(system, "x[0]=0.5:1", 2, timepts=[0.0, 1.0])


def test_records_are_compared_where_the_caller_is(monkeypatch):
    """A branch at x = 1e6 t, far from 0, which only this run reaches."""

    def rate(t, x, u, p):
        if x[0] < 1e6 * t + 2e7:
            return [-1e5 - x[0] / 1e3]
        return [-1.0]

    first = lambda tape, tree, values: values[0]  # noqa: E731
    monkeypatch.setattr(tracing, "joined", first)
    monkeypatch.setattr(heaps, "joined", first)
    with pytest.warns(UserWarning, match=SENTENCE):
        clpt.simulate(system_of(rate), [0.0, 40.0], None, [3e7])


# --- what is no difference ------------------------------------------------------------------------


def cancels(t, x, u, p):
    """cos^2 + sin^2 - 1 is rounding alone, and Python's another one than NumPy's arrays have."""
    return [math.cos(x[0]) ** 2 + math.sin(x[0]) ** 2 - 1.0]


def raises_beside(t, x, u, p):
    """Overflows far from 0, where the record has the limit."""
    return [1.0 / (1.0 + math.exp(-50.0 * x[0])) - x[0]]


def divides(t, x, u, p):
    return [math.atan(1.0 / float(x[0])) - x[0]]


@pytest.mark.parametrize("rate", [cancels, raises_beside, divides])
def test_rounding_and_errors_of_operations_are_no_difference(rate, recwarn):
    run = clpt.simulate(system_of(rate), [0.0, 1.0], None, [0.6])
    assert run.attrs["engine"] == "native"
    assert not recwarn.list


def test_nothing_is_printed_where_records_are_compared(capsys):
    def rate(t, x, u, p):
        print("called")
        return [-x[0]]

    clpt.equations(system_of(rate))
    assert capsys.readouterr().out == ""


# --- programs that once were misread --------------------------------------------------------------


class Thermostat:
    """Remembers whether it heats."""

    def __init__(self):
        self.heating = 1.0

    def __call__(self, temperature):
        if temperature > 21.0:
            self.heating = 0.0
        elif temperature < 19.0:
            self.heating = 1.0
        return self.heating


@pytest.mark.filterwarnings("ignore:.*hidden state")
def test_a_thermostat_that_remembers_runs_in_python():
    thermostat = Thermostat()
    room = system_of(
        lambda t, x, u, p: [0.2 * (10.0 - x[0]) + 4.0 * thermostat(x[0])], name="room"
    )
    said = "writes to 'heating' of Thermostat, which outlives the call.*parts.relay"
    says(clpt.DiagramError, said, clpt.equations, room)
    with pytest.warns(UserWarning, match=rf"^room runs in Python.*{said}"):
        run = clpt.simulate(room, [0.0, 0.1], None, [18.0])
    assert run.attrs["engine"] == "python"


def saturated(v, most=1.0):
    """Return v, or in its place v shortened."""
    size = np.sqrt(v @ v)
    if size > most:
        v *= most / size
        return v
    return 1.0 * v


def test_a_branch_between_samples_is_right():
    """A pulse that is saturated in place, between the samples that are compared."""

    def driven(t, x, u, p):
        v = np.array([2.2 * math.exp(-(((t - 0.7) / 0.2) ** 2)), 0.3])
        return saturated(v) - 0.2 * x

    system = control.nlsys(driven, None, inputs=0, outputs=2, states=2, name="r")
    times = np.linspace(0, 4, 41)
    run = clpt.simulate(system, times, None, [0.0, 0.0])
    assert run.attrs["engine"] == "native"
    tight = {"max_step": 0.01, "rtol": 1e-9, "atol": 1e-11}
    expected = solve_ivp(
        lambda t, x: driven(t, x, [], {}), (0, 4), [0, 0], t_eval=times, **tight
    )
    np.testing.assert_allclose(run.states.values, expected.y.T, atol=1e-6)


def contact(t, x, u, p):
    """x' = -x, and -101 x where x < 0: a nested function writes the force."""
    force = np.zeros(1)

    def push(k, v):
        force[k] = v

    if x[0] < 0:
        push(0, -100.0 * x[0])
    return [-x[0] + force[0]]


def two_names(t, x, u, p):
    """x' = -x where x > 5, else -4 x: two names of a list, of which one is set in a branch."""
    gain = [1.0, 2.0]
    out = gain
    if x[0] > 5:
        out = [0.0, 0.0]
    out[0] = 4.0
    return [-gain[0] * x[0]]


def row_at_a_signal(t, x, u, p):
    """x' = -3 x where x > 0, else -x."""
    rows = [[1.0, 1.0], [2.0, 1.0]]
    rows[int(x[0] > 0)][1] = 3.0
    return [-rows[1][1] * x[0]]


def set_by_a_helper(t, x, u, p):
    """x' = 1/2 - 2 x where x < 0, else -x."""
    v = x[0]

    def reset():
        nonlocal v
        v = 0.5

    if x[0] < 0:
        reset()
    return [v - 2.0 * x[0]]


FAST = 5.0


def by_identity(t, x, u, p):
    """x' = -5 x where x > 0, else 0."""
    gain = FAST if x[0] > 0 else 1.0
    return [-gain * x[0] if gain is FAST else 0.0 * x[0]]


SLOPES = {  # at x = -1, 1 and 6
    contact: (-101.0, -1.0, -1.0),
    two_names: (-4.0, -4.0, -1.0),
    row_at_a_signal: (-1.0, -3.0, -3.0),
    set_by_a_helper: (-2.0, -1.0, -1.0),
    by_identity: (0.0, -5.0, -5.0),
}


@pytest.mark.parametrize("rate", SLOPES, ids=lambda one: one.__name__)
def test_slopes_are_those_of_the_docstring(rate):
    system = system_of(rate)
    for x, slope in zip((-1.0, 1.0, 6.0), SLOPES[rate], strict=True):
        assert clpt.linearize(system, [x]).A.item() == pytest.approx(slope, abs=1e-12)
