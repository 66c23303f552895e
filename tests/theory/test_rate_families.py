"""Certified rates of families of loops e' = A e + W th, th' = -G W^T P e, against SciPy.

The transition matrix of a window is integrated by DOP853 at 1e-11 from jump to jump: its largest
eigenvalue has the true rate, its norm in the coordinates of V the exact contraction.
"""

from itertools import pairwise

import control
import numpy as np
import pytest
import sympy
import xarray
from scipy.integrate import solve_ivp

import clpt_control as clpt

sin, cos, where, mod, pi = np.sin, np.cos, np.where, np.mod, np.pi
ONE = ((1.0,),)
TURN = ((-1.0, 2.0), (-2.0, -3.0))
THREE = ((-1.0, 1.0, 0.0), (-1.0, -2.0, 0.5), (0.0, -0.5, -0.5))
NO_JUMPS = ()


def row(*functions):
    return lambda t: [[f(t) for f in functions]]


def one(t):
    return 1 + 0 * t


def square(period):
    return lambda t: where(mod(t, period) < period / 2, 1.0, -1.0)


def burst(frequency):
    return lambda t: where(mod(t, 10.0) < 1.5, sin(frequency * t), 0.0)


def pulses(width, every=2.0, height=3.0):
    return lambda t: where(mod(t - 0.3, every) < width, height, 0.0)


def collinear(d):
    return row(sin, lambda t: sin(t) + d * cos(t))


def eye(n, gain=1.0):
    return gain * np.eye(n)


STEPS = np.arange(0.0, 40.0, 0.25)
FULL = ((2.0, 0.5), (0.5, 1.0))
FULL3 = ((1.0, 0.25, 0.125), (0.25, 2.0, 0.5), (0.125, 0.5, 0.75))
OSCILLATOR, ITS_P = ((0.0, 1.0), (-2.0, -3.0)), ((1.25, 0.25), (0.25, 0.25))
# name -> A, W, G, P, window, times of jumps, samples, number of windows in the run
LOOPS = {
    "quasi-periodic": (
        ((-1.0,),), row(sin, lambda t: sin(1.375 * t)), eye(2), ONE, 40.0, NO_JUMPS, 401, 2),
    "quasi-periodic, three": (
        ((-2.0,),), row(lambda t: sin(t) + cos(1.4142 * t), lambda t: cos(0.618 * t), one),
        eye(3, 0.5), ONE, 30.0, NO_JUMPS, 201, 2),
    "floor": (
        ((-1.0,),), row(lambda t: mod(np.floor(t / 2), 3.0) - 1, one), eye(2), ONE, 6.0, STEPS,
        101, 2),
    "stairs": (
        ((-3.0,),), row(lambda t: np.floor(4 * mod(t, 1.0)) / 4, cos), eye(2, 2.0), ONE, 2 * pi,
        STEPS, 101, 2),
    "squares": (
        ((-1.0,),), row(square(4.0), square(8.0)), eye(2, 0.5), ONE, 8.0, STEPS, 101, 2),
    "a square beside the samples": (
        ((-1.0,),), row(square(3.7), one), eye(2), ONE, 3.7, np.arange(0, 40, 1.85), 101, 2),
    "a burst": (
        ((-1.0,),), row(burst(6.0)), eye(1), ONE, 10.0, (1.5,), 401, 2),
    "bursts": (
        ((-2.0,),), row(burst(6.0), burst(5.0)), eye(2, 4.0), ONE, 10.0, (1.5,), 401, 2),
    "collinear to 1e-2": (((-1.0,),), collinear(1e-2), eye(2), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "collinear to 1e-4": (((-1.0,),), collinear(1e-4), eye(2), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "chirp": (
        ((-1.0,),), row(lambda t: sin(t**2 / 5), lambda t: cos(t**2 / 5)), eye(2), ONE, 20.0,
        NO_JUMPS, 41, 1),
    "chirp, fast": (
        ((-4.0,),), row(lambda t: cos(t**2 / 2)), eye(1, 10.0), ONE, 12.0, NO_JUMPS, 13, 1),
    "pulses": (((-1.0,),), row(pulses(0.2)), eye(1), ONE, 2.0, (0.3, 0.5), 5, 2),
    "pulses between the samples": (
        ((-1.0,),), row(pulses(0.005, 1.0, 10.0)), eye(1), ONE, 2.0, (0.3, 0.305, 1.3, 1.305),
        5, 2),
    "full gain": (
        ((-1.0,),), row(sin, lambda t: cos(2 * t)), FULL, ONE, 2 * pi, NO_JUMPS, 101, 2),
    "full gain, three": (
        ((-2.0,),), row(sin, cos, one), FULL3, ONE, 2 * pi, NO_JUMPS, 101, 2),
    "microseconds": (
        ((-1e6,),), row(lambda t: 1e6 * sin(1e6 * t), lambda t: 1e6 * cos(1e6 * t)), eye(2), ONE,
        2e-6 * pi, NO_JUMPS, 101, 2),
    "weeks": (
        ((-1e-6,),), row(lambda t: 1e-6 * sin(1e-6 * t), lambda t: 1e-6 * cos(1e-6 * t)), eye(2),
        ONE, 2e6 * pi, NO_JUMPS, 101, 2),
    "units of parameters": (
        ((-1.0,),), row(lambda t: 1024 * sin(t), lambda t: cos(t) / 512),
        ((2.0**-20, 0.0), (0.0, 2.0**18)), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "low gain": (((-1.0,),), row(sin, cos), eye(2, 2.0**-10), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "high gain": (((-1.0,),), row(sin, cos), eye(2, 1024.0), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "e of two": (
        TURN, lambda t: [[sin(t), cos(t)], [cos(2 * t), 0.7 + 0 * t]], eye(2, 0.25), eye(2),
        2 * pi, NO_JUMPS, 101, 2),
    "e of two with a P": (
        OSCILLATOR, lambda t: [[0 * t, 0 * t], [sin(t), cos(t)]], FULL, ITS_P, 2 * pi, NO_JUMPS,
        101, 2),
    "e of three": (
        THREE, lambda t: [[sin(t), 0 * t], [cos(t), sin(3 * t)], [0.5 + 0 * t, cos(2 * t)]],
        eye(2, 0.5), eye(3), 2 * pi, NO_JUMPS, 101, 2),
    "e of two, square": (
        TURN, lambda t: [[square(4.0)(t)], [sin(pi * t / 2)]], eye(1), eye(2), 4.0, (2.0,), 101, 2),
    "fractions": (
        ((-1.0,),), row(lambda t: sin(t) / (1 + sin(t) ** 2), lambda t: cos(t) / (2 + cos(t))),
        eye(2), ONE, 2 * pi, NO_JUMPS, 101, 2),
    "fractions, e of two": (
        TURN,
        lambda t: [[1 / (1 + sin(t) ** 2), 0 * t], [sin(t) / (3 - cos(2 * t)), cos(t)]],
        eye(2), eye(2), 2 * pi, NO_JUMPS, 101, 2),
    "a decay": (((-1.0,),), row(lambda t: np.exp(-t / 5)), eye(1), ONE, 10.0, NO_JUMPS, 101, 1),
}  # fmt: skip


def truth(A, W, G, P, start, window, jumps=()):
    """Half-life of the root of V, and V at the end of the window over V, at worst."""
    A, G, P = (np.array(x, dtype=float) for x in (A, G, P))
    m = len(A)
    both = np.block(
        [[P, np.zeros((m, len(G)))], [np.zeros((len(G), m)), np.linalg.inv(G)]]
    )

    def rates(t, y, first, last):
        Y = y.reshape(len(both), -1)
        w = np.array(W(np.clip(t, first, last)), dtype=float)
        return np.vstack([A @ Y[:m] + w @ Y[m:], -G @ w.T @ P @ Y[:m]]).ravel()

    end, y = start + window, np.eye(len(both)).ravel()
    inner = [t for t in jumps if start < t < end]
    edges = np.array([start, *inner, end])
    for a, b in pairwise(edges):
        within = a + 1e-12 * window, b - 1e-12 * window
        options = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-13}
        y = solve_ivp(rates, (a, b), y, args=within, **options).y[:, -1]
    S = np.linalg.cholesky(both).T
    Phi = S @ y.reshape(both.shape) @ np.linalg.inv(S)
    largest = np.abs(np.linalg.eigvals(Phi)).max()
    return window * np.log(2) / -np.log(largest), np.linalg.norm(Phi, 2) ** 2


def loop_and_V(A, W, G, P):
    """The loop as python-control has it, its states e0, ..., h0, ..., and V."""
    m, n = len(A), len(G)
    names = [f"e{k}" for k in range(m)] + [f"h{k}" for k in range(n)]

    def rates(t, x, u, p):
        e, h, w = x[:m], x[m:], W(t)
        Pe = [sum(P[i][j] * e[j] for j in range(m)) for i in range(m)]
        sums = [sum(w[i][k] * Pe[i] for i in range(m)) for k in range(n)]
        return [
            sum(A[i][j] * e[j] for j in range(m))
            + sum(w[i][k] * h[k] for k in range(n))
            for i in range(m)
        ] + [-sum(G[k][j] * sums[j] for j in range(n)) for k in range(n)]

    loop = control.nlsys(rates, inputs=0, outputs=0, states=names, name="loop")
    weights, gains = (
        sympy.Matrix(np.array(x)).applyfunc(sympy.Rational) for x in (P, G)
    )
    e, h = (sympy.Matrix(sympy.symbols(x, real=True)) for x in (names[:m], names[m:]))
    return loop, (e.T * weights * e + h.T * gains.inv() * h)[0] / 2


def check(found, true, contraction):
    certificate = found.certificate()
    assert 0.6 < true / certificate.half_life < 1 + 1e-7
    assert certificate.contraction == pytest.approx(contraction, rel=1e-4, abs=1e-9)
    assert certificate.contraction > contraction * (1 - 1e-8) - 1e-12


@pytest.mark.parametrize("name", LOOPS)
def test_a_certified_rate_is_at_most_the_true_one(name):
    A, W, G, P, window, jumps, samples, windows = LOOPS[name]
    loop, V = loop_and_V(A, W, G, P)
    t = np.linspace(0, windows * window, samples)
    run = clpt.simulate(loop, t, initial_state=[0.0] * len(A) + [1.0] * len(G))
    found = clpt.gramian(run, window, 0.0, of=clpt.lyapunov(loop, V))
    check(found, *truth(A, W, G, P, 0.0, window, jumps))


# --- evidence in the window ------------------------------------------------------------------


def scalar(w, **params):
    """The loop of one parameter with w(t, x, u, p), whose further states have `rates`."""
    loop = control.nlsys(
        lambda t, x, u, p: [
            -x[0] + w(t, x, u, p) * x[1], -w(t, x, u, p) * x[0], *params["rates"](t, x)
        ] if "rates" in params else [-x[0] + w(t, x, u, p) * x[1], -w(t, x, u, p) * x[0]],
        states=["e", "h", *params.get("states", ())], inputs=params.get("inputs", 0), outputs=0,
        params=params.get("params", {}), name="loop",
    )  # fmt: skip
    return loop, clpt.lyapunov(loop, lambda s: (s.e**2 + s.h**2) / 2)


def of_time(w, start, window, jumps=()):
    return truth(((-1.0,),), row(w), ((1.0,),), ONE, start, window, jumps)


def test_a_window_inside_one_sample():
    def w(t):
        return cos(20 * pi * t)

    loop, verdict = scalar(lambda t, x, u, p: w(t))
    run = clpt.simulate(loop, np.linspace(0, 20, 5), initial_state=[0, 1])
    check(clpt.gramian(run, 1.0, 6.2, of=verdict), *of_time(w, 6.2, 1.0))


def test_inputs_are_those_of_the_run_not_of_its_samples():
    loop, verdict = scalar(lambda t, x, u, p: u[0], inputs=["w"])
    jump = clpt.simulate(loop, [0, 5, 5, 10, 20], [1, 1, 0.1, 0.1, 0.1], [0, 1])
    true = of_time(lambda t: where(t < 5, 1.0, 0.1), 1.0, 8.0, (5.0,))
    check(clpt.gramian(jump, 8.0, 1.0, of=verdict), *true)
    t = np.linspace(0, 20, 401)
    w = xarray.DataArray(sin(7 * t), {"time": t}, ("time",))
    fine = clpt.simulate(loop, np.linspace(0, 20, 11), {"w": w}, [0, 1])
    true = of_time(lambda s: np.interp(s, t, w.values), 4.0, 6.0, t)
    check(clpt.gramian(fine, 6.0, 4.0, of=verdict), *true)


@pytest.mark.parametrize("size", [1e-10, 1e10])
def test_w_of_a_plant_in_other_units(size):
    loop, verdict = scalar(
        lambda t, x, u, p: x[2] / size,
        states=["y"], rates=lambda t, x: [size * sin(3 * t) - x[2]],
    )  # fmt: skip
    run = clpt.simulate(loop, np.linspace(0, 20, 41), initial_state=[0, 1, 0])

    def w(t):
        return (sin(3 * t) - 3 * cos(3 * t) + 3 * np.exp(-t)) / 10

    check(clpt.gramian(run, 2 * pi, 5.0, of=verdict), *of_time(w, 5.0, 2 * pi))


def test_w_of_a_state_whose_rate_jumps_at_samples():
    loop, verdict = scalar(
        lambda t, x, u, p: x[2], states=["y"], rates=lambda t, x: [square(4.0)(t)]
    )
    run = clpt.simulate(loop, np.linspace(0, 20, 11), initial_state=[0, 1, 0])

    def w(t):
        return 2 - np.abs(mod(t, 4.0) - 2)

    check(clpt.gramian(run, 4.0, 8.0, of=verdict), *of_time(w, 8.0, 4.0, (10.0,)))


def test_a_push_that_is_zero_along_the_run():
    loop = control.nlsys(
        lambda t, x, u, p: [-x[0] + sin(t) * x[1] + u[0], -sin(t) * x[0]],
        states=["e", "h"], inputs=["d"], outputs=0, name="loop",
    )  # fmt: skip
    verdict = clpt.lyapunov(loop, lambda s: s.e**2 + s.h**2)
    t = np.linspace(0, 40, 41)
    run = clpt.simulate(loop, t, 0 * t, [0, 1])
    check(clpt.gramian(run, 2 * pi, 20.0, of=verdict), *of_time(sin, 20.0, 2 * pi))
    run = clpt.simulate(loop, t, where(t < 5, 1.0, 0.0), [0, 1])
    with pytest.raises(clpt.DiagramError, match=r"d\(t\): is not A e \+ W th"):
        clpt.gramian(run, of=verdict)


def edited(run):
    run = run.copy(deep=True)
    run.states[20:, 1] *= 1.01
    return run


@pytest.mark.parametrize(
    "change", [lambda run: run.assign_coords(time=run.time + 1), edited]
)
def test_another_axis_of_time_and_edited_states_are_refused(change):
    loop, verdict = scalar(lambda t, x, u, p: sin(t) * np.exp(-t / 20))
    run = clpt.simulate(loop, np.linspace(0, 40, 81), initial_state=[0, 1])
    with pytest.raises(clpt.DataError, match="does not follow the equations"):
        clpt.gramian(change(run), 2 * pi, 20.0, of=verdict)


def test_parameters_that_were_set_after_the_run_are_refused():
    """The run has learned, so that its states do not show the amplitude of w."""
    loop, verdict = scalar(lambda t, x, u, p: p["b"] * sin(t), params={"b": 0.1})
    run = clpt.simulate(loop, np.linspace(0, 20, 41), initial_state=[0, 0])
    loop.params["b"] = 1.0
    with pytest.raises(clpt.DataError, match="have changed since the run"):
        clpt.gramian(run, 2 * pi, 5.0, of=verdict)


def test_a_loop_that_counts_intervals_is_refused():
    signal = clpt.Block(
        "signal",
        output=lambda t, x, u, p: {"w": 1.0 - 1.5 * np.mod(p.interval, 2.0)},
        outputs={"w": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: np.arange(np.floor(t0) + 1, t1 + 1e-9),
    )
    errors = clpt.Block(
        "errors",
        update=lambda t, x, u, p: {"e": -x.e + u.w * x.h, "h": -u.w * x.e},
        inputs={"w": 1},
        states={"e": 1, "h": 1},
    )
    loop = clpt.connect([signal, errors])
    verdict = clpt.lyapunov(loop, lambda s: s.e**2 + s.h**2)
    run = clpt.simulate(loop, np.linspace(0, 8, 9), initial_state=[0, 1])
    with pytest.raises(clpt.DiagramError, match="interval has no value along the run"):
        clpt.gramian(run, 2.0, 1.0, of=verdict)


def test_a_recorded_scenario_in_a_window_inside_one_sample():
    paper = clpt.paper_scenario()
    run = clpt.simulate(paper, np.linspace(0, 400, 9))
    recorded, of_paper = (
        clpt.gramian(source, 30.0, 205.0).certificate() for source in (run, paper)
    )
    assert recorded.half_life == of_paper.half_life
    assert recorded.contraction == of_paper.contraction


def test_a_regressor_that_jumps_with_a_state_is_refused():
    """Times of such jumps are not among the times at which W is divided."""

    def rates(t, x, u, p):
        w = np.where(np.abs(x[0]) > 0.3, 1.0, 0.0)
        return [-x[0] + w * x[1], -2 * w * x[0]]

    loop = control.nlsys(rates, inputs=0, states=["e", "h"], outputs=["e", "h"])
    found = clpt.lyapunov(loop, lambda s: s.e**2 / 2 + s.h**2 / 4)
    run = clpt.simulate(loop, np.linspace(0, 20, 21), initial_state=[4.0, -3.0])
    with pytest.raises(clpt.DiagramError, match="may jump where a state passes"):
        clpt.gramian(run, 10.0, 5.0, of=found)
