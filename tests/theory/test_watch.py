"""Transition matrix of the errors, carried beside a loop: |x(t)| <= |Phi(t)| |x(0)| + int |g|.

x has the errors in coordinates in which V is |x|^2 / 2.  Norms are by SciPy, bounds by runs.
"""

from functools import reduce

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import clpt_control as clpt

PAPER = clpt.paper_scenario()


def errors_of(run, scenario):
    """|x| of each axis, (times, 2), by hand: e, then eta over the root of gamma."""
    theta, vehicle = np.array(scenario.flow.parameters), scenario.vehicle
    squares = (
        np.sum((run.alpha.values.reshape(-1, 2, 3) + theta) ** 2, axis=2)
        + (run.K.values - vehicle.feedback) ** 2
        + (run.Gamma.values - vehicle.feedforward) ** 2
    )
    return np.sqrt(run.e.values**2 + squares / scenario.learning.gain)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(20))
def test_errors_of_each_run_are_below_the_carried_matrix(seed):
    """Twenty starts and disturbances, the blocks of one gramian."""
    rng = np.random.default_rng(seed)
    watch = clpt.gramian(PAPER, 50.0, 0.0).watch
    push = rng.uniform(0, 0.3, 2)
    sine = {"kind": "sine", "amplitude": push.tolist(), "period": rng.uniform(1, 60)}
    scenario = PAPER.with_values({"flow.disturbance": sine})
    wired = clpt.connect([*clpt.closed_loop(scenario).syslist, *watch])
    start = [
        rng.uniform(-2, 2) * label.startswith("adaptation")
        for label in wired.state_labels
    ]
    run = clpt.simulate(wired, np.linspace(0, 200, 401), initial_state=start, rtol=1e-8)
    errors = errors_of(run, scenario)
    for k, axis in enumerate(("x1", "x2")):
        factor = run[f"factor_{axis}"].values.ravel()
        assert factor[0] == pytest.approx(1.0)
        assert 0.3 < factor[-1] < 0.97
        bound = factor * errors[0, k] + push[k] * run.time.values
        assert np.all(errors[:, k] <= bound * (1 + 1e-6))
        assert np.any(errors[:, k] > push[k] * run.time.values)


def test_the_norms_of_the_papers_run():
    """By SciPy's expm at the middles of steps of 0.025 s, k = 1."""
    found = clpt.gramian(PAPER, 200.0).transition
    run = clpt.simulate(clpt.closed_loop(PAPER), np.linspace(0, 200, 16001))
    for k in (0, 1):
        own = run.predicted_position, run.reference
        w = np.hstack([run.phi_x.values, *(signal.values[:, [k]] for signal in own)])
        M = np.zeros((8000, 6, 6))
        M[:, 0, 1:] = np.sqrt(PAPER.learning.gain) * w[1::2]
        M[:, 1:, 0] = -M[:, 0, 1:]
        M[:, 0, 0] = -1.0
        Phi = reduce(lambda Y, step: step @ Y, expm(0.025 * M))
        first = found.isel(time=0, axis=k)
        norm = np.linalg.norm(Phi, 2)
        assert float(first.factor) == pytest.approx(norm, rel=2e-5)
        assert float(first.window_factor) == float(first.factor)
    # as measured before with another program
    assert found.factor[-1].values == pytest.approx([0.0798252, 0.0091532], rel=1e-5)
    assert found.time.values == pytest.approx(np.arange(200, 2001, 200))


def test_a_recorded_run_has_the_norms_of_its_scenario():
    run = clpt.simulate(PAPER.with_values({"run.duration": 130.0}))
    found = clpt.gramian(run, 50.0, 0.0).transition
    scenario = clpt.gramian(PAPER, 50.0, 0.0).transition
    assert found.time.values == pytest.approx([50, 100, 130])
    assert found.factor[:2].values == pytest.approx(
        scenario.factor[:2].values, rel=1e-7
    )
    assert np.isnan(found.window_factor[2]).all()  # shorter


@pytest.mark.long
@pytest.mark.parametrize("start", [0.0, 1e6])
def test_e_of_two_numbers_a_matrix_of_gains_and_a_disturbance(start):
    """V = e'P e/2 + th'th/2 with G = L L', th = L h; Phi by DOP853, 10 other starts."""
    A, P = np.array([[-1.0, 2.0], [-1.0, -0.5]]), np.diag([1.0, 2.0])
    L = np.array([[2.0, 0.0], [1.0, 0.5]])
    G, inverse = L @ L.T, np.linalg.inv(L @ L.T)

    def W(t):
        return np.array([[np.sin(t), 1.0], [np.cos(7 * t), 0.5]])

    def rates(t, x, u, p):
        return {"e": A @ x.e + W(t) @ x.h, "h": -G @ W(t).T @ P @ x.e}

    def pushed(t, x, u, p):
        own = rates(t, x, u, p)
        return own | {"e": own["e"] + u.d}

    def signals(t, x, u, p):
        return {"e": x.e, "h": x.h, "w": W(t).ravel()}

    states = {"e": 2, "h": 2}
    loop = clpt.Block("loop", update=rates, states=states)
    verdict = clpt.lyapunov(loop, lambda s: s.e @ P @ s.e / 2 + s.h @ inverse @ s.h / 2)
    t = np.linspace(start, start + 10, 401)
    given = {"timepts": t, "initial_state": 0.5}
    found = clpt.gramian(loop, 4.0, start, of=verdict, **given)

    S = np.diag([1, np.sqrt(2), 1, 1])
    S[2:, 2:] = np.linalg.inv(L)

    def moved(t, y):
        Y = y.reshape(4, 4)
        rows = A @ Y[:2] + W(t) @ Y[2:], -G @ W(t).T @ P @ Y[:2]
        return np.vstack(rows).ravel()

    def norm_of(begin, end):
        options = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}
        Phi = solve_ivp(moved, (begin, end), np.eye(4).ravel(), **options).y[:, -1]
        return np.linalg.norm(S @ Phi.reshape(4, 4) @ np.linalg.inv(S), 2)

    ends = start + np.array([4, 8, 10])
    true = np.array([norm_of(start, end) for end in ends])
    window = np.array([norm_of(start, ends[0]), norm_of(*ends[:2])])
    assert found.transition.time.values == pytest.approx(ends, rel=1e-15)
    assert found.transition.factor.values.ravel() == pytest.approx(true, abs=1e-6)
    worst = float(found.transition.window_factor.max())
    assert worst == pytest.approx(window.max(), abs=1e-6)
    # on board
    shown = clpt.Block(
        "loop", update=pushed, output=signals, states=states, inputs={"d": 2},
        outputs={"e": 2, "h": 2, "w": 4},
    )  # fmt: skip
    wired = clpt.connect([shown, *found.watch], ["d"])
    rng = np.random.default_rng(3)
    d = 0.3 * np.array([np.sin(3 * t), np.cos(t)])
    for _ in range(10):
        first = [rng.normal() * (label[:4] == "loop") for label in wired.state_labels]
        run = clpt.simulate(wired, t, d, first, rtol=1e-9, atol=1e-11)
        factor = run.factor.values.ravel()
        x = np.linalg.norm(np.hstack([run.e.values, run.h.values]) @ S.T, axis=1)
        assert np.all(x <= factor * x[0] + 0.3 * np.sqrt(3) * (t - start) + 1e-9)
        at = factor[[160, 320, 400]]
        assert np.all(at >= true * (1 - 1e-6))
        assert np.all(at <= true * 4 ** (1 / 8))
        assert run.worst.values[100] == 0.0
        assert worst * (1 - 1e-6) <= run.worst.values[390] <= worst * 4 ** (1 / 8)


def test_a_window_in_which_errors_fall_to_nothing_is_told_as_1e_5():
    """a = 4, w = 2: |Phi(t)| = about 2 t exp(-2 t), by expm."""
    block = clpt.Block(
        "loop", update=lambda t, x, u, p: {"e": -4 * x.e + 2 * x.h, "h": -2 * x.e},
        states={"e": 1, "h": 1},
    )  # fmt: skip
    verdict = clpt.lyapunov(block, lambda s: s.e[0] ** 2 + s.h[0] ** 2)
    given = {"timepts": np.linspace(0, 50, 501), "initial_state": 1.0}
    found = clpt.gramian(block, 25.0, 0.0, of=verdict, **given)
    source = clpt.Block("one", output=lambda t, x, u, p: {"w": 2.0}, outputs={"w": 1})
    run = clpt.simulate(clpt.connect([source, *found.watch]), [0, 2, 25, 26, 50])
    true = np.linalg.norm(expm(2 * np.array([[-4.0, 2.0], [-2.0, 0.0]])), 2)
    assert run.factor.values[1] == pytest.approx(true, rel=2 ** (1 / 8) - 1)
    assert run.factor.values[1] >= true * (1 - 1e-5)
    assert run.factor.values[2:].ravel() == pytest.approx(1e-5, rel=1e-3)
    assert run.worst.values[3:].ravel() == pytest.approx(1e-5)


def test_the_command_prints_norms_along_the_run(printed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    clpt.save_scenario(PAPER.with_values({"run.duration": 400.0}), "s.toml")
    words = "excitation", "s.toml", "--window", "200"
    found = printed(*words)
    along = found["along_run"]
    assert (along["time"], along["axis"]) == ([200.0, 400.0], ["x1", "x2"])
    assert np.array(along["factor"])[:, 0] == pytest.approx(
        [0.75964, 0.60495], rel=1e-4
    )
    window = np.array(along["window_factor"])[:, 1]
    assert window == pytest.approx([0.55174, 0.56564], rel=1e-4)


@pytest.mark.sampled
@pytest.mark.parametrize(
    ("source", "window", "said"),
    [
        (PAPER.with_values({"learning.gain": 0.0}), 50.0, "learning.gain = 0"),
        (PAPER.with_values({"learning.sample": 1.0}), 50.0, "learning.sample"),
    ],
)
def test_errors_without_a_theorem_are_not_watched(source, window, said):
    found = clpt.gramian(source, window)
    for name in ("watch", "transition"):
        with pytest.raises(clpt.ClptError, match=said):
            getattr(found, name)


def test_signals_and_windows_without_end_are_refused():
    lag = clpt.simulate(clpt.parts.lag(1.0), [0, 1, 2], 1.0)
    found = clpt.gramian(lag, signals=["y"])
    for name in ("watch", "transition"):
        with pytest.raises(clpt.DataError, match="A team and signals"):
            getattr(found, name)
    with pytest.raises(clpt.DataError, match="more than 1000 windows"):
        clpt.gramian(PAPER, 1.0).transition  # noqa: B018
