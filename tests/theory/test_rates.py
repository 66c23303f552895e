"""Rates at which parameters converge, against rates by SciPy and closed forms."""

import sys
from pathlib import Path

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import clpt_control as clpt

sin, cos = np.sin, np.cos


def square(t):
    return np.where(np.mod(t, 4) < 2, 1.0, -1.0)


def pulse(t):
    return np.where(np.mod(t, 4) < 1, 1.0, 0.0)


# name -> a, gains, w of time, its period
LOOPS = {
    "constant": (2.0, [1.0], [lambda t: 1.0 + 0 * t], 1.0),
    "constant, slow": (1.0, [0.01], [lambda t: 1.0 + 0 * t], 3.0),
    "constant, oscillating": (1.0, [25.0], [lambda t: 1.0 + 0 * t], 1.0),
    "a circle": (1.0, [1.0, 1.0], [sin, cos], 2 * np.pi),
    "a circle, high gain": (1.0, [10.0, 10.0], [sin, cos], 2 * np.pi),
    "a step and a sine": (1.0, [0.1, 0.1], [lambda t: 1.0 + 0 * t, sin], 2 * np.pi),
    "a sine": (4.0, [2.0], [sin], 2 * np.pi),
    "a pulse": (1.0, [1.0], [pulse], 4.0),
    "a square wave and one": (1.0, [0.5, 0.5], [square, lambda t: 1.0 + 0 * t], 4.0),
    "fast": (50.0, [400.0], [lambda t: sin(40 * t)], np.pi / 20),
    "slow": (0.01, [1e-5, 2e-5], [lambda t: sin(t / 50), lambda t: cos(t / 50)], 100 * np.pi),
    "weak": (1.0, [1.0, 1.0], [lambda t: 1.0 + 0 * t, lambda t: 1 + 0.1 * sin(t)], 2 * np.pi),
    "other gains": (1.0, [0.5, 3.0], [sin, lambda t: cos(2 * t)], 2 * np.pi),
    "three": (2.0, [1.0] * 3, [lambda t: 1.0 + 0 * t, sin, cos], 2 * np.pi),
    "four": (2.0, [1.0] * 4, [sin, cos, lambda t: sin(2 * t), lambda t: cos(2 * t)], 2 * np.pi),
    "five": (
        2.0, [1.0] * 5,
        [lambda t: 1.0 + 0 * t, sin, cos, lambda t: sin(2 * t), lambda t: cos(2 * t)], 2 * np.pi,
    ),
    "six": (
        3.0, [2.0] * 6,
        [sin, cos, lambda t: sin(2 * t), lambda t: cos(2 * t), lambda t: sin(3 * t),
         lambda t: cos(3 * t)], 2 * np.pi,
    ),
    "two frequencies": (1.0, [1.0, 1.0], [lambda t: sin(t) + sin(2 * t), cos], 2 * np.pi),
    "large w": (1.0, [1.0, 1.0], [lambda t: 5 * sin(t), lambda t: 5 * cos(t)], 2 * np.pi),
    "small w": (1.0, [1.0, 1.0], [lambda t: 0.1 * sin(t), lambda t: 0.1 * cos(t)], 2 * np.pi),
}  # fmt: skip


def loop_of(a, gains, change=""):
    """The error system as a block with inputs w, and its verdict."""
    n = len(gains)

    def rates(t, x, u, p):
        leak = 0.1 * x.th[0] if change == "leak" else 0.0 * x.th[0]
        e = -p.a * x.e - (x.e**3 if change == "cubic" else 0.0) + u.w @ x.th
        return {"e": e, "th": -p.gains * u.w * x.e - leak}

    block = clpt.Block(
        "loop",
        update=rates,
        inputs={"w": n},
        states={"e": 1, "th": n},
        parameters={"a": a, "gains": np.array(gains)},
    )
    return block, clpt.lyapunov(
        block, lambda s: s.e**2 / 2 + sum(s.th**2 / s.gains) / 2
    )


def measured(a, gains, w, period, samples=2001):
    block, verdict = loop_of(a, gains)
    t = np.linspace(0, period, samples)
    inputs = np.array([f(t) for f in w])
    return clpt.gramian(block, of=verdict, timepts=t, inputs=inputs, initial_state=0.1)


def transition(a, gains, w, period, times=None):
    """Phi in coordinates in which V is the sum of squares, by SciPy."""
    n, roots = len(gains), np.sqrt(gains)

    def rate(t, y):
        Y, at = y.reshape(n + 1, n + 1), roots * [float(f(t)) for f in w]
        return np.vstack([-a * Y[0] + at @ Y[1:], -np.outer(at, Y[0])]).ravel()

    options = {"rtol": 1e-9, "atol": 1e-12, "max_step": period / 100, "t_eval": times}
    found = solve_ivp(rate, (0, period), np.eye(n + 1).ravel(), **options)
    return found.y.T.reshape(-1, n + 1, n + 1)[slice(None) if times is not None else -1]


def true_rate(*loop):
    largest = np.abs(np.linalg.eigvals(transition(*loop))).max()
    return -2 * np.log(largest) / loop[-1]


@pytest.mark.long
def test_certified_rates_are_below_the_true_ones():
    shares = []
    for name, loop in LOOPS.items():
        half_life = measured(*loop).certificate().half_life
        shares.append(2 * np.log(2) / half_life / true_rate(*loop))
        assert 0.6 < shares[-1] <= 1 + 1e-6, name
    assert np.median(shares) > 0.9


def test_contraction_of_a_constant_regressor_in_closed_form():
    a, g, w = 1.0, 0.1, 0.5
    coupling = w * np.sqrt(g)
    Phi = expm(5.0 * np.array([[-a, coupling], [-coupling, 0.0]]))
    found = measured(a, [g], [lambda t: w + 0 * t], 5.0).certificate()
    norm = np.linalg.norm(Phi, 2) ** 2
    assert found.contraction == pytest.approx(norm, rel=1e-9)
    norms = [np.linalg.norm(np.linalg.matrix_power(Phi, m), 2) for m in range(200)]
    tenth = next(m for m in range(200) if norms[m] <= 0.1)
    assert found.time_to_tenth == 5.0 * tenth
    assert found.half_life == pytest.approx(-40 / np.log2(norms[8]), rel=1e-6)


@pytest.mark.long
@pytest.mark.parametrize("name", ["a circle", "a pulse", "other gains", "three"])
def test_V_is_below_its_tube_in_many_starts(name):
    a, gains, w, period = LOOPS[name]
    found, times = measured(*LOOPS[name]), np.linspace(0, period, 41)
    once = transition(a, gains, w, period, times)
    Phi = np.concatenate(
        [once[:-1] @ np.linalg.matrix_power(once[-1], k) for k in range(8)]
    )
    at = np.concatenate([times[:-1] + k * period for k in range(8)])
    starts = np.random.default_rng(1).normal(size=(len(gains) + 1, 50))
    V = np.sum((Phi @ starts) ** 2, axis=1) / np.sum(starts**2, axis=0)
    bound = found.certificate()
    tube = bound.overshoot**2 * 4 ** (-at / bound.half_life)
    assert np.all(tube[:, None] * (1 + 1e-4) >= V)


@pytest.mark.long
def test_what_is_not_excited_has_no_rate():
    found = measured(1.0, [1.0, 1.0], [sin, lambda t: 2 * sin(t)], 2 * np.pi)
    assert found.certificate().half_life is None
    said = "not excited, or not enough: errors have no half-life"
    assert said in found.result.sentences
    assert found.report["half_life"] is None
    assert repr(found).endswith("errors have no half-life>")


@pytest.mark.sampled
@pytest.mark.parametrize(
    ("change", "line"), [("leak", r"th\[0\]'"), ("cubic", r"\(e\)'")]
)
def test_another_form_is_refused_with_its_line(change, line):
    block, verdict = loop_of(1.0, [1.0, 1.0], change)
    run = clpt.simulate(block, [0, 1, 2], [[1, 1, 1], [0, 1, 2]])
    with pytest.raises(clpt.DiagramError, match=f"of: {line}.* = .*is not"):
        clpt.gramian(run, of=verdict, signals=["th[0]", "th[1]"])


@pytest.mark.long
def test_an_e_of_two_numbers_and_a_matrix_of_gains():
    A = np.array([[0.0, 1.0], [-2.0, -3.0]])
    B, G = np.array([0.0, 1.0]), np.array([[2.0, 0.5], [0.5, 1.0]])
    P = np.array([[1.25, 0.25], [0.25, 0.25]])  # P A + A^T P = -I
    assert pytest.approx(-np.eye(2), abs=1e-12) == P @ A + A.T @ P

    def rates(t, x, u, p):
        c = 0.25 * x.e[0] + 0.25 * x.e[1]
        push = u.w[0] * x.th[0] + u.w[1] * x.th[1]
        e = [x.e[1], -2 * x.e[0] - 3 * x.e[1] + push]
        th = [-(2 * u.w[0] + 0.5 * u.w[1]) * c, -(0.5 * u.w[0] + u.w[1]) * c]
        return {"e": e, "th": th}

    block = clpt.Block("two", update=rates, inputs={"w": 2}, states={"e": 2, "th": 2})
    inverse = np.linalg.inv(G)
    verdict = clpt.lyapunov(block, lambda s: s.e @ P @ s.e + s.th @ inverse @ s.th)
    T, t = 2 * np.pi, np.linspace(0, 2 * np.pi, 2001)
    given = {"timepts": t, "inputs": [sin(t), cos(t)], "initial_state": 0.1}
    found = clpt.gramian(block, of=verdict, **given)

    def rate(t, y):
        Y, w = y.reshape(4, 4), np.array([sin(t), cos(t)])
        return np.ravel(
            [*(A @ Y[:2] + np.outer(B, w @ Y[2:])), *(-np.outer(G @ w, B @ P @ Y[:2]))]
        )

    Phi = solve_ivp(rate, (0, T), np.eye(4).ravel(), rtol=1e-10, atol=1e-12).y[:, -1]
    S = np.linalg.cholesky(np.block([[P, 0 * P], [0 * P, inverse]])).T
    contraction = np.linalg.norm(S @ Phi.reshape(4, 4) @ np.linalg.inv(S), 2) ** 2
    assert found.certificate().contraction == pytest.approx(contraction, abs=1e-5)
    rate = -2 * np.log(np.abs(np.linalg.eigvals(Phi.reshape(4, 4))).max()) / T
    assert 0.7 < 2 * np.log(2) / found.certificate().half_life / rate <= 1


def tutorial():
    """The tutorial's MRAC, its verdict, and a run."""
    examples = Path(__file__).parents[2] / "examples"
    sys.path.insert(0, str(examples))
    import mrac

    t = np.linspace(0, 320, 6401)
    run = clpt.simulate(mrac.loop(), t, np.sign(np.sin(2 * np.pi * t / 40) + 1e-9))
    return clpt.lyapunov(mrac.loop(), mrac.V), run


def test_adaptive_control_by_a_model_is_read_from_its_verdict():
    verdict, run = tutorial()
    found = clpt.gramian(run, 40.0, 280.0, of=verdict)
    assert found.names == {"w": ["adaptation.k_r", "adaptation.k_y"]}
    # by SciPy, with r on straight lines: e' = -2 e + (r, -y)/2 th, th' = -(r, -y) e
    t, r = run.time.values, run.r.values.ravel()
    k = np.searchsorted(t, 280.0)
    start = [*run.states.values[k], *np.eye(3).ravel()]

    def rate(s, x):
        (y, ym, k_r, k_y), Phi, push = x[:4], x[4:].reshape(3, 3), np.interp(s, t, r)
        e, w = y - ym, np.array([push, -y])
        own = [-y + (k_r * push - k_y * y) / 2, 2 * (push - ym), -e * push, e * y]
        return [*own, *(-2 * Phi[0] + w / 2 @ Phi[1:]), *np.ravel(-np.outer(w, Phi[0]))]

    options = {"rtol": 1e-9, "atol": 1e-12, "max_step": 0.05}
    Phi = solve_ivp(rate, (280, 320), start, **options).y[4:, -1].reshape(3, 3)
    S = np.diag([1, np.sqrt(0.5), np.sqrt(0.5)])
    norm = np.linalg.norm(S @ Phi @ np.linalg.inv(S), 2) ** 2
    assert found.certificate().contraction == pytest.approx(norm, rel=1e-7)
    named = clpt.gramian(run, 40.0, 280.0, of=verdict, signals=[*found.names["w"]])
    assert named.certificate() == found.certificate()
    with pytest.raises(clpt.DiagramError, match="must be states in V"):
        clpt.gramian(run, of=verdict, signals=["r"])


@pytest.mark.long
def test_a_run_of_another_loop_has_the_rate_of_that_loop():
    _, verdict = loop_of(1.0, [1.0, 1.0])
    other, _ = loop_of(1.1, [1.0, 1.0])
    t = np.linspace(0, 2 * np.pi, 1001)
    given = {"timepts": t, "inputs": [sin(t), cos(t)], "initial_state": 1.0}
    found = clpt.gramian(other, of=verdict, **given).certificate()
    true = true_rate(1.1, [1.0, 1.0], [sin, cos], 2 * np.pi)
    assert 0.9 < 2 * np.log(2) / found.half_life / true < 1 + 1e-6
    _, larger = loop_of(1.0, [1.0, 1.0, 1.0])
    with pytest.raises(clpt.DataError, match="on the loop of this run"):
        clpt.gramian(other, of=larger, **given)
    # of few samples, between which inputs are straight lines, the states follow the equations
    given |= {"timepts": t[::100], "inputs": [sin(t)[::100], cos(t)[::100]]}
    few = clpt.gramian(other, of=verdict, **given).certificate()
    lines = [lambda s, f=f: np.interp(s, t[::100], f(t)[::100]) for f in (sin, cos)]
    true = true_rate(1.1, [1.0, 1.0], lines, 2 * np.pi)
    assert 0.9 < 2 * np.log(2) / few.half_life / true < 1 + 1e-6


def of_time(w, samples, start=1.0, **params):
    """The excitation over 4 pi of a loop whose w is a function of time in its equations."""
    block = control.nlsys(
        lambda t, x, u, p: [-p["a"] * x[0] + w(t) * x[1], -w(t) * x[0]],
        states=["e", "th"], inputs=0, outputs=0, params={"a": 1.0}, name="loop",
    )  # fmt: skip
    verdict = clpt.lyapunov(block, lambda s: s.e**2 + s.th**2)
    t = np.linspace(0, 4 * np.pi, samples)
    run = clpt.simulate(block, t, initial_state=start, params=params)
    return clpt.gramian(run, of=verdict)


@pytest.mark.parametrize(
    "w",
    [
        lambda t: np.cos(t) ** 2,
        lambda t: np.sin(t) + np.sin(2 * t),
        lambda t: np.sin(t) * np.sin(2 * t),
        lambda t: np.where(np.sin(t) > 0.3, 1.0, 0.0),
        lambda t: np.heaviside(np.sin(t), 1.0),
    ],
)
@pytest.mark.parametrize("samples", [401, 1601])
def test_w_of_powers_products_and_comparisons(w, samples):
    certified = 2 * np.log(2) / of_time(w, samples).certificate().half_life
    true = true_rate(1.0, [1.0], [w], 4 * np.pi)
    assert 0.6 < certified / true < 1 + 1e-6


@pytest.mark.parametrize("start", [0.0, [0.0, 0.0]])
def test_a_run_that_starts_true_has_the_rate_of_its_own_parameters(start):
    found = of_time(np.sin, 401, start, a=0.1).certificate()
    true = true_rate(0.1, [1.0], [np.sin], 4 * np.pi)
    assert 0.9 < 2 * np.log(2) / found.half_life / true < 1 + 1e-6


def two_axes(g, change=None):
    """A run of two axes, of which one has e = th = 0 but for a given change, and their verdict."""
    block = control.nlsys(
        lambda t, x, u, p: [
            u[0] * x[2] - x[0], u[1] * x[3] - x[1], -u[0] * x[0], -p["g"] * u[1] * x[1],
        ],
        states=["e0", "e1", "h0", "h1"], inputs=["w0", "w1"], params={"g": 4.0}, name="loop",
    )  # fmt: skip
    verdict = clpt.lyapunov(
        block, lambda s: s.e0**2 + s.e1**2 + s.h0**2 + s.h1**2 / s.g
    )
    t = np.linspace(0, 4 * np.pi, 801)
    start = [0.3, 0.0, 1.0, change or 0.0]
    run = clpt.simulate(block, t, [sin(t), cos(t)], start, params={"g": g})
    return run, verdict


@pytest.mark.parametrize("g", [0.05, 4.0])
def test_an_axis_at_rest_has_the_gain_of_its_run(g):
    run, verdict = two_axes(g)
    found = clpt.gramian(run, of=verdict).certificate()
    axes = [
        true_rate(1.0, [1.0], [sin], 4 * np.pi),
        true_rate(1.0, [g], [cos], 4 * np.pi),
    ]
    assert 0.9 < 2 * np.log(2) / found.half_life / min(axes) < 1 + 1e-6


def test_a_run_without_its_diagram_is_refused_with_the_remedy(tmp_path):
    run, verdict = two_axes(4.0, change=1.0)
    clpt.save_run(run, tmp_path / "run.nc")
    with pytest.raises(clpt.DataError, match="Give the diagram in place of the run"):
        clpt.gramian(clpt.load_run(tmp_path / "run.nc"), of=verdict)


@pytest.mark.long
def test_a_term_that_a_small_error_hides_is_not_taken_for_none():
    """e0' of the run has k w e1 beside the verdict's, with e1 of 1e-6."""
    loops = [
        control.nlsys(
            lambda t, x, u, p: [
                u[0] * x[2] - x[0] + p["k"] * u[0] * x[3], u[1] * x[3] - x[1],
                -u[0] * x[0] - p["k"] * u[1] * x[1], -4 * u[1] * x[1],
            ],
            states=["e0", "e1", "h0", "h1"], inputs=["w0", "w1"], name="loop",
            params={"k": float(k)},
        )
        for k in (0, 50)
    ]  # fmt: skip
    verdict = clpt.lyapunov(
        loops[0], lambda s: s.e0**2 + s.e1**2 + s.h0**2 + s.h1**2 / 4
    )
    t = np.linspace(0, 4 * np.pi, 801)
    start, given = [0.3, 1e-6, 1, 1e-6], {"rtol": 1e-9, "atol": 1e-14}
    run = clpt.simulate(loops[1], t, [sin(t), cos(t)], start, **given)
    with pytest.raises(clpt.DiagramError, match="is not a form of errors"):
        clpt.gramian(run, of=verdict)
    with pytest.raises(clpt.DiagramError, match=r"h0' = .* is not -G W"):
        clpt.gramian(run, of=verdict, signals=["h0", "h1"])


@pytest.mark.parametrize("name", ["w0", "states"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_values_that_are_not_finite_are_refused(name, value):
    run, verdict = two_axes(4.0, change=1.0)
    run[name][700] = value
    with pytest.raises(clpt.DataError, match="must be finite, and its times increase"):
        clpt.gramian(run, of=verdict)


def test_a_slow_direction_falls_to_a_tenth_by_its_half_life():
    w = [sin, lambda t: sin(t) + 1e-3 * cos(t)]
    found = measured(1.0, [1.0, 1.0], w, 2 * np.pi).certificate()
    by_half_life = np.log2(10 * found.overshoot) * found.half_life
    true = 2 * np.log(10) / true_rate(1.0, [1.0, 1.0], w, 2 * np.pi)
    assert 0.99 * true < found.time_to_tenth <= by_half_life


@pytest.mark.sampled
@pytest.mark.parametrize("samples", [9, 41])
def test_w_between_samples_is_seen(samples):
    def aliased(t):
        return np.cos(2 * np.pi * t * (samples - 1) / (4 * np.pi))

    certified = 2 * np.log(2) / of_time(aliased, samples).certificate().half_life
    assert 0.99 < certified / true_rate(1.0, [1.0], [aliased], 4 * np.pi) < 1 + 1e-6


def late(change, samples, **params):
    """A window after 100 s, where w has changed and the errors have died out."""
    block = control.nlsys(
        lambda t, x, u, p: [
            -x[0] + p["b"] * np.where(t < 100, sin(t / 2), change(t)) * x[1],
            -p["b"] * np.where(t < 100, sin(t / 2), change(t)) * x[0],
        ],
        states=["e", "th"], inputs=0, params={"b": 1.0}, name="loop",
    )  # fmt: skip
    verdict = clpt.lyapunov(block, lambda s: (s.e**2 + s.th**2) / 2)
    t = np.append(np.arange(0, 100, 0.05), np.linspace(100, 130, samples))
    run = clpt.simulate(block, t, initial_state=[0.0, 1.0], params=params)
    return run, verdict


@pytest.mark.parametrize("b", [1.0, 0.02])
def test_the_loop_is_that_of_the_run_in_the_window(b):
    """21 Hz at a sample a second, and a parameter that the run has, the verdict not."""

    def fast(t):
        return np.cos(42 * np.pi * t)

    run, verdict = late(fast, 31, b=b)
    found = clpt.gramian(run, 4.0, 110.0, of=verdict).certificate()
    true = true_rate(1.0, [b**2], [fast], 1 / 21)
    assert 0.99 < 2 * np.log(2) / found.half_life / true < 1 + 1e-5


@pytest.mark.long
def test_the_rate_has_no_units():
    for u, s in ((1.0, 1.0), (2.0**-20, 1.0), (2.0**20, 2.0**10)):
        scales = np.array([s, 1 / s])
        block = control.nlsys(
            lambda t, x, _, p, u=u, s=scales: [
                -x[0] / u + s[0] * sin(t / u) / u * x[1] + s[1] * cos(t / u) / u * x[2],
                -sin(t / u) / u * x[0] / s[0], -cos(t / u) / u * x[0] / s[1],
            ],
            states=["e", "h1", "h2"], inputs=0, name="loop",
        )  # fmt: skip
        verdict = clpt.lyapunov(
            block, lambda q, s=s: (q.e**2 + s**2 * q.h1**2 + q.h2**2 / s**2) / 2
        )
        t = np.linspace(0, 2 * np.pi * u, 201)
        run = clpt.simulate(block, t, initial_state=[0, *(1 / scales)])
        found = clpt.gramian(run, of=verdict)
        assert found.dimension == {"w": 2}
        assert found.certificate().half_life == pytest.approx(3.2827 * u, rel=1e-4)


def test_the_sentence_of_parameters_has_their_weights():
    """|h| may rise by the root of the largest gain over the least."""
    found = measured(1.0, [1.0, 10000.0], [sin, lambda t: cos(2 * t)], 2 * np.pi)
    factor = 100 * found.certificate().overshoot
    assert f"of parameters, from e = 0: a factor {factor:.3g}" in repr(found)


@pytest.mark.filterwarnings("error")
def test_w_that_is_zero_is_not_excited():
    found = of_time(lambda t: 0 * t, 401)
    assert found.certificate().half_life is None
    assert found.report["half_life"] is None


@pytest.mark.long
@pytest.mark.parametrize(
    ("V", "said"),
    [
        (lambda s: s.e**4 + s.th @ s.th, "is not quadratic"),
        (lambda s: s.e**2 + s.th @ s.th / 2, "is not a form of errors"),
        (lambda s: s.e**2, "is not a form of errors"),
        (lambda s: s.e**2 + (s.th[0] + s.th[1]) ** 2, "a positive one of parameters"),
    ],
)
def test_another_V_is_refused(V, said):
    block, _ = loop_of(1.0, [1.0, 1.0])
    with pytest.raises(clpt.DiagramError, match=said):
        clpt.gramian(block, of=clpt.lyapunov(block, V), timepts=[0, 1], inputs=1)


def test_e_that_grows_is_refused():
    block, verdict = loop_of(-1.0, [1.0, 1.0])
    with pytest.raises(clpt.DiagramError, match="must be V > 0 that does not rise"):
        clpt.gramian(block, of=verdict, timepts=[0, 1], inputs=1)


@pytest.mark.long
def test_the_paper_halves_within_the_time_of_several_windows():
    found = clpt.gramian(clpt.paper_scenario(), 200.0, 200.0)
    certificate = found.certificate()
    assert certificate.contraction == pytest.approx(0.679, abs=5e-4)
    assert certificate.time_to_tenth == 2200.0
    assert 646.8 < certificate.half_life < 670  # 646.8: Floquet
    assert "halves at least every 663.5 s" in "".join(found.result.sentences)


@pytest.mark.parametrize("kind", ["scenario", "run", "verdict"])
def test_the_drawn_tubes_are_above_the_run(kind):
    paper, unit = clpt.paper_scenario(), " (m)"
    if kind == "verdict":
        verdict, run = tutorial()
        found, unit = clpt.gramian(run, 40.0, 80.0, of=verdict), ""
        k_r, k_y = run.k_r.values, run.k_y.values
        V = (run.e.values**2 + ((k_r - 4) ** 2 + (k_y - 2) ** 2) / 2) / 2
    else:
        run = clpt.simulate(paper)
        found = clpt.gramian(paper if kind == "scenario" else run, 200.0, 200.0)
        V = run.lyapunov.values
    ax = found.plot_tube()
    assert (ax.get_ylabel(), ax.get_yscale()) == (f"root of V{unit}", "log")
    norm, *tubes = (line.get_xydata() for line in ax.lines)
    assert len(tubes) == 1
    assert norm[:, 1] ** 2 == pytest.approx(np.ravel(V), rel=1e-9)
    for tube in tubes:
        assert np.all(tube[:, 1] >= np.interp(tube[:, 0], *norm.T))


def test_an_unknown_V_has_no_tube():
    run = clpt.simulate(clpt.paper_scenario()).drop_vars("lyapunov")
    with pytest.raises(clpt.DataError, match="plot_tube: V of the run is not known"):
        clpt.gramian(run, 200, 200).plot_tube()
