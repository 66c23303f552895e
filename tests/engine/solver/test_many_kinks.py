"""Many kinks and jumps of large models are located, each."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from slope_limiter import limited

import clpt_control as clpt

CELLS = 100
TIMES = np.linspace(0.0, 0.4, 21)
PLACES = (np.arange(CELLS) + 0.5) / CELLS
WAVE = 1.2 + np.sin(2 * np.pi * PLACES)


def cells(t, x, u, p):
    return limited(x)


def cells_and_climber(t, x, u, p):
    """Beside the cells, what rises by 3 a second up to 0.5, then by 1."""
    return np.concatenate([limited(x[:CELLS]), [np.where(x[CELLS] < 0.5, 3.0, 1.0)]])


def cells_and_slider(t, x, u, p):
    """Beside 20 cells, what rises to 0.5 and stays there, held by a relay."""
    return np.concatenate([limited(x[:20]), [1.0 - 2.0 * np.sign(x[20] - 0.5)]])


def system(function, n):
    return control.nlsys(function, None, states=n, inputs=0, outputs=n, name="cells")


@pytest.mark.long
def test_a_limiter_is_as_exact_as_a_tight_run_of_scipy():
    run = clpt.simulate(system(cells, CELLS), TIMES, None, WAVE)
    exact = solve_ivp(
        lambda t, x: limited(x), (0, 0.4), WAVE, "DOP853", TIMES, rtol=1e-12, atol=1e-13
    )
    assert np.abs(run.states.values - exact.y.T).max() < 1e-6


@pytest.mark.long
def test_it_runs_again_to_the_last_bit():
    runs = [clpt.simulate(system(cells, CELLS), TIMES, None, WAVE) for _ in range(3)]
    assert len({run.states.values.tobytes() for run in runs}) == 1


def test_jumps_among_many_kinks_are_located():
    run = clpt.simulate(system(cells_and_climber, CELLS + 1), TIMES, None, [*WAVE, 0.0])
    closed_form = np.minimum(3.0 * TIMES, 0.5 + (TIMES - 0.5 / 3.0))
    assert np.abs(run.states.values[:, CELLS] - closed_form).max() < 1e-10


@pytest.mark.long
def test_a_run_that_slides_among_many_kinks_is_right():
    run = clpt.simulate(system(cells_and_slider, 21), TIMES, None, [*WAVE[::5], 0.0])
    assert "sliding on a switch" in run.attrs["method"]
    closed_form = np.minimum(3.0 * TIMES, 0.5)
    assert np.abs(run.states.values[:, 20] - closed_form).max() < 1e-8


def test_few_kinks_of_a_large_model_are_located():
    def springs(t, x, u, p):
        """Masses that turn at their own pace, each with a spring that is harder on one side."""
        place, speed = x[:40], x[40:]
        return np.concatenate([speed, -place - 0.5 * np.maximum(place, 0.0)])

    start = np.concatenate([np.ones(40), np.zeros(40)])
    run = clpt.simulate(system(springs, 80), np.linspace(0, 1.0, 5), None, start)
    assert run.attrs["method"] == "DOP853"
    assert run.states.values[-1, 0] == pytest.approx(np.cos(np.sqrt(1.5)), abs=1e-8)


def test_what_was_a_kink_and_jumps_later_is_located():
    """One `where` chooses slopes of the cells, and a speed that falls from 3 to 1 at 0.5."""

    def rates(t, x, u, p):
        ahead = np.roll(x[:CELLS], -1) - x[:CELLS]
        behind = np.roll(ahead, 1)
        smaller = np.where(np.abs(ahead) < np.abs(behind), ahead, behind)
        product = np.concatenate([ahead * behind, [0.5 - x[CELLS]]])
        chosen = np.where(
            product > 0,
            np.concatenate([smaller, [3.0]]),
            np.concatenate([0.0 * smaller, [1.0]]),
        )
        slope = chosen[:CELLS]
        flux = 0.5 * (x[:CELLS] + 0.5 * slope) ** 2
        rate = -(flux - np.roll(flux, 1)) * CELLS
        return np.concatenate([rate, [chosen[CELLS]]])

    run = clpt.simulate(system(rates, CELLS + 1), TIMES, None, [*WAVE, 0.0])
    closed_form = np.minimum(3.0 * TIMES, 0.5 + (TIMES - 0.5 / 3.0))
    assert np.abs(run.states.values[:, CELLS] - closed_form).max() < 1e-7


def random_network(random):
    """Return rates of 40 states: a stable matrix, and kinks of random sums of them."""
    A = random.standard_normal((40, 40)) / 8.0 - 5.0 * np.eye(40)
    B, C = random.standard_normal((2, 40, 40)) / 3.0
    bias = random.standard_normal(40)
    kinds = random.permutation(5)[:3]
    drive = 3.0 + 4.0 * random.random(40)

    def rates(t, x, u, p):
        a, b = B @ x + bias, C @ x
        bends = (
            np.maximum(a, b),
            np.abs(a),
            np.clip(a, -0.5, 0.5),
            np.where(a * b > 0, np.where(np.abs(a) < np.abs(b), a, b), 0.0),
            np.minimum(np.abs(a), 0.3),
        )
        return A @ x + sum(bends[k] for k in kinds) + 4.0 * np.sin(drive * t)

    return rates


@pytest.mark.parametrize(
    "seed",
    [
        pytest.param(0, marks=pytest.mark.long),
        *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 20)),
    ],
)
def test_random_networks_with_kinks_are_as_exact_as_tight_runs_of_scipy(seed):
    random = np.random.default_rng(seed)
    rates = random_network(random)
    start, times = random.standard_normal(40), np.linspace(0.0, 4.0, 9)
    run = clpt.simulate(system(rates, 40), times, None, start)
    exact = solve_ivp(
        lambda t, x: rates(t, x, None, None),
        (0, 4),
        start,
        "DOP853",
        times,
        rtol=1e-12,
        atol=1e-13,
        max_step=2e-3,
    )
    assert run.attrs["method"].startswith("DOP853")
    size = np.abs(exact.y).max()
    assert 0.1 < size < 100.0
    assert np.abs(run.states.values - exact.y.T).max() < 1e-7 * size


@pytest.mark.long
def test_a_sort_of_many_signals_is_compiled():
    """Signals that fall as exp(-t) stay in their order."""
    start = np.random.default_rng(3).permutation(np.linspace(0.1, 2.0, 64))
    rank = np.argsort(np.argsort(start))
    sorting = control.nlsys(
        lambda t, x, u, p: -np.sort(x)[rank],
        inputs=0, outputs=64, states=64, name="sorting",
    )  # fmt: skip
    run = clpt.simulate(sorting, [0.0, 1.0], initial_state=start)
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.states.values[-1], start * np.exp(-1.0), rtol=1e-7)
