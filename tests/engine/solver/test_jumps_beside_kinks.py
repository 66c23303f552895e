"""Beside many kinks, jumps, narrow peaks and bumps of kinks are located."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from slope_limiter import limited

import clpt_control as clpt

CELLS = 60
TIMES = np.linspace(0.0, 0.4, 21)
WAVE = 1.2 + np.sin(2 * np.pi * (np.arange(CELLS) + 0.5) / CELLS)
AT = 0.2  # where what rises by 1 a second meets a peak


def system(rates, n):
    return control.nlsys(
        lambda t, x, u, p: rates(t, x), None, states=n, inputs=0, outputs=n, name="many"
    )


def beside_cells(rates, start, **options):
    """Return the run of further states, whose rates are `rates(t, x)`, beside the cells."""
    start = np.array(start)

    def together(t, x):
        return np.concatenate([limited(x[:CELLS]), np.stack(rates(t, x[CELLS:]))])

    block = system(together, CELLS + len(start))
    run = clpt.simulate(block, TIMES, None, np.append(WAVE, start), **options)
    assert run.attrs["engine"] == "native"
    return run.states.values[:, CELLS:]


def exact(rates, start, times, longest):
    run = solve_ivp(
        rates, times[[0, -1]], start, "DOP853", times, rtol=1e-12, atol=1e-13,
        max_step=longest,
    )  # fmt: skip
    return run.y.T


# --- jumps ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("width", [1e-2, 1e-4])
def test_a_pulse_between_two_thresholds_is_located(width):
    def rates(t, x):
        return 1.0, np.where(np.abs(x[0] - AT) < width, 1.0 / width, 0.0)

    x = beside_cells(rates, [0.0, 0.0])
    risen = np.clip((TIMES - AT + width) / width, 0.0, 2.0)
    np.testing.assert_allclose(x[:, 1], risen, atol=1e-8)


def test_a_jump_of_a_quotient_of_kinks_is_located():
    def rates(t, x):
        s = np.maximum(x[0] - 0.1, 0.05) / np.abs(x[0] - 2.0)
        return 1.0, np.where(np.abs(s - 0.1) < 0.01, 100.0, 0.0)

    x = beside_cells(rates, [0.0, 0.0])
    begin, end = 0.28 / 1.09, 0.32 / 1.11  # s is 0.09 and 0.11
    risen = 100.0 * np.clip(TIMES - begin, 0.0, end - begin)
    np.testing.assert_allclose(x[:, 1], risen, atol=1e-8)


def test_jumps_behind_two_levels_of_kinks_are_located():
    def rates(t, x):
        r = np.maximum(np.minimum(np.abs(x[0] - AT), 0.1), 0.02)
        return 1.0, np.where(r <= 0.02, 5.0, np.where(r >= 0.1, -1.0, 0.0))

    x = beside_cells(rates, [0.0, 0.0])
    near = 5.0 * np.clip(TIMES - 0.18, 0.0, 0.04)
    far = np.minimum(TIMES, 0.1) + np.maximum(0.0, TIMES - 0.3)
    np.testing.assert_allclose(x[:, 1], near - far, atol=1e-8)


def test_a_branch_without_effect_at_first_jumps_later():
    """The sign of sin 50 t chooses 0 or 0, and from t = 0.2 on 0 or 1."""

    def rates(t, x):
        chosen = np.where(x[0] > 0, np.where(x[1] > 0.4, 1.0, 0.0), 0.0)
        return 50.0 * np.cos(50.0 * t), 2.0, chosen

    x = beside_cells(rates, [0.0, 0.0, 0.0])
    half = np.pi / 50.0
    begins = half * np.array([4.0, 6.0])  # of positive half waves behind t = 0.2
    risen = np.clip(TIMES[:, None] - begins, 0.0, half).sum(axis=1)
    np.testing.assert_allclose(x[:, 2], risen, atol=1e-7)


def test_whole_numbers_are_located():
    x = beside_cells(lambda t, x: (1.0, np.floor(20.0 * x[0] + 0.5)), [0.0, 0.0])
    steps = (np.arange(8) + 0.5) / 20.0
    risen = np.maximum(TIMES[:, None] - steps, 0.0).sum(axis=1)
    np.testing.assert_allclose(x[:, 1], risen, atol=1e-8)


def test_a_relay_on_a_kink_is_slid_along():
    x = beside_cells(lambda t, x: (1.0 - 2.0 * np.sign(np.abs(x[0]) - 0.5),), [0.01])
    np.testing.assert_allclose(x[:, 0], np.minimum(0.01 + 3.0 * TIMES, 0.5), atol=1e-8)


def test_a_weak_relay_is_slid_along():
    def rates(t, x):
        return (1e-4 * (1.0 - 2.0 * np.sign(x[0] - 2e-5)),)

    x = beside_cells(rates, [0.0])
    np.testing.assert_allclose(x[:, 0], np.minimum(3e-4 * TIMES, 2e-5), atol=1e-11)


def test_weak_jumps_are_located():
    """Each changes the state by less than the estimate of the error sees."""
    places = np.linspace(0.0055, 0.3955, 40)
    x = beside_cells(lambda t, x: (1.0, 1e-5 * np.sum(x[0] > places)), [0.0, 0.0])
    risen = 1e-5 * np.maximum(TIMES[:, None] - places, 0.0).sum(axis=1)
    np.testing.assert_allclose(x[:, 1], risen, rtol=0, atol=1e-12)


def test_a_comparison_without_answer_is_refused():
    def rates(t, x):
        return 1.0, np.where(np.sqrt(AT - x[0]) > 1.0, 1.0, 0.5)

    with pytest.raises(clpt.SimulationError, match="compares a value that is not a nu"):
        beside_cells(rates, [0.0, 0.0])


def test_a_comparison_without_answer_is_refused_where_a_kink_reads_it():
    """Behind 0.2 the root has no value; it has an effect from 0.3 on, without a jump."""

    def rates(t, x):
        factor = np.where(np.sqrt(AT - x[0]) > 1.0, 1.0, 0.5)
        return 1.0, np.where(x[0] > 0.3, (x[0] - 0.3) * factor, 0.0)

    with pytest.raises(clpt.SimulationError, match="compares a value that is not a nu"):
        beside_cells(rates, [0.0, 0.0])


# --- narrow peaks ---------------------------------------------------------------------------------


def hat(distance, width):
    return np.maximum(0.0, 1.0 - np.abs(distance) / width) / width


def below_hat(distance, width):
    """Return the integral of the hat, up to a distance from its middle."""
    z = np.clip(distance / width, -1.0, 1.0)
    return np.where(z < 0.0, 0.5 * (1.0 + z) ** 2, 1.0 - 0.5 * (1.0 - z) ** 2)


@pytest.mark.parametrize("width", [1e-2, 1e-4, 1e-6])
def test_a_narrow_hat_is_met(width):
    x = beside_cells(lambda t, x: (1.0, hat(x[0] - AT, width)), [0.0, 0.0])
    np.testing.assert_allclose(x[:, 1], below_hat(TIMES - AT, width), atol=1e-8)


@pytest.mark.parametrize("width", [1e-2, 1e-4, 1e-6])
def test_a_narrow_hat_of_time_is_met(width):
    x = beside_cells(lambda t, x: (hat(t - 0.21, width),), [0.0])
    np.testing.assert_allclose(x[:, 0], below_hat(TIMES - 0.21, width), atol=1e-8)


def test_a_narrow_hat_of_a_table_is_met():
    places, heights = [0.0, 0.1999, AT, 0.2001, 1.0], [0.0, 0.0, 1e4, 0.0, 0.0]
    x = beside_cells(lambda t, x: (1.0, np.interp(x[0], places, heights)), [0.0, 0.0])
    np.testing.assert_allclose(x[:, 1], below_hat(TIMES - AT, 1e-4), atol=1e-8)


@pytest.mark.parametrize("width", [1e-4, 1e-5, 1e-6])
def test_narrow_hats_of_three_kinks_in_a_row_are_met(width):
    """Each of the three is passed once, and bends the rates."""
    places = np.linspace(0.0055, 0.3955, 40)

    def rates(t, x):
        begin, middle, end = (
            np.maximum(0.0, x[0] - places - shift) for shift in (-width, 0.0, width)
        )
        return 1.0, np.sum(begin - 2.0 * middle + end) / width**2

    x = beside_cells(rates, [0.0, 0.0])
    passed = (TIMES[:, None] > places).sum(axis=1)
    np.testing.assert_allclose(x[:, 1], passed, atol=1e-6)


def test_narrow_humps_of_a_fast_wave_are_met():
    """Where sin(500 x) is above cos b, it encloses 2 sin b - 2 b cos b with that line."""
    b = 0.05
    level = np.cos(b)

    def rates(t, x):
        return 1.0, np.maximum(0.0, np.sin(500.0 * x[0]) - level) * 1e4

    x = beside_cells(rates, [0.0, 0.0])
    one = 1e4 * (2.0 * np.sin(b) - 2.0 * b * np.cos(b)) / 500.0
    tops = (0.5 * np.pi + 2.0 * np.pi * np.arange(32)) / 500.0
    passed = (TIMES[:, None] > tops + 1e-3).sum(axis=1)
    between = np.abs(TIMES[:, None] - tops).min(axis=1) > 1e-3
    np.testing.assert_allclose(x[between, 1], one * passed[between], atol=1e-8)


# --- kinks that meet ------------------------------------------------------------------------------


def test_diodes_that_all_begin_at_their_kink_conduct():
    """A source charges a ladder of diodes, all of which are at their kink when it begins."""

    def rates(t, x):
        before = np.concatenate([np.reshape(2.0 * np.sin(5.0 * t), 1), x[:-1]])
        current = 20.0 * np.maximum(before - x, 0.0) + 30.0 * (before - x)
        return current - np.concatenate([current[1:], np.zeros(1)]) - 0.5 * x

    times, start = np.linspace(0.0, 2.0, 11), np.zeros(40)
    run = clpt.simulate(system(rates, 40), times, None, start)
    right = solve_ivp(rates, (0, 2), start, "LSODA", times, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(run.states, right.y.T, atol=1e-6)


def test_springs_at_rest_at_their_kinks_stay_so():
    """Every second of 100 masses swings, each against a spring that is harder on one side."""
    place = np.where(np.arange(100) % 2, 0.0, 0.5)

    def rates(t, x):
        y, v = x[:100], x[100:]
        return np.concatenate([v, -y - 3.0 * np.maximum(y, 0.0)])

    # half a period of 2 rad/s, then one of 1 rad/s
    times = np.array([0.0, np.pi / 4, np.pi / 4 + np.pi, 1.5 * np.pi])
    run = clpt.simulate(system(rates, 200), times, None, [*place, *np.zeros(100)])
    swinging = np.outer([1.0, 0.0, 0.0, 1.0], place)
    np.testing.assert_allclose(run.states[:, :100], swinging, atol=1e-8)


@pytest.mark.parametrize("count", [40, pytest.param(100, marks=pytest.mark.long)])
def test_springs_with_clearance_are_as_exact_as_scipy(count):
    """Masses that turn at their own pace, free within 0.2 of their rest.

    It is long for a tight run of SciPy.
    """
    pace = 1.0 + 0.05 * np.arange(count)

    def rates(t, x):
        y, v = x[:count], x[count:]
        beyond = np.where(y > 0.2, y - 0.2, np.where(y < -0.2, y + 0.2, 0.0))
        return np.concatenate([v, -(pace**2) * y - 5.0 * beyond])

    start = np.concatenate([np.full(count, 0.5), np.zeros(count)])
    times = np.linspace(0.0, 6.0, 7)
    run = clpt.simulate(system(rates, 2 * count), times, None, start)
    right = exact(rates, start, times, 2e-3)
    np.testing.assert_allclose(run.states, right, atol=1e-6)


def test_members_pass_kinks_as_single_runs_do():
    def rates(t, x, u, p):
        return p["pace"] * limited(x)

    block = control.nlsys(
        rates, None, states=CELLS, inputs=0, outputs=CELLS, params={"pace": 1.0},
        name="cells",
    )  # fmt: skip
    paces = np.array([0.5, 1.0, 1.5])
    many = clpt.run_ensemble(block, {"pace": paces}, timepts=TIMES, initial_state=WAVE)
    for member, pace in enumerate(paces):
        run = clpt.simulate(block, TIMES, None, WAVE, params={"pace": pace})
        np.testing.assert_array_equal(many.y_final[member], run.states[-1])


# --- bumps made of kinks --------------------------------------------------------------------------


@pytest.mark.parametrize("width", [1e-3, 1e-5])
@pytest.mark.parametrize("count", [1, 40])
def test_a_jump_that_reads_a_bump_of_kinks_is_located(count, width):
    """Its comparison holds for the time `width`, in which z grows by 1."""

    def rates(t, x):
        ahead = x[0] - 0.43217
        bump = np.minimum(np.maximum(ahead, 0.0), np.maximum(2 * width - ahead, 0.0))
        grows = np.where(bump > width / 2, 1.0 / width, 0.0)
        idle = 3e-4 * np.abs(x[2:] + 5.0)
        return np.concatenate([np.stack([1.0, grows]), idle])

    run = clpt.simulate(system(rates, 2 + count), [0.0, 0.5, 1.0])
    assert float(run.states[-1, 1]) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("rtol", [1e-4, 1e-8])
@pytest.mark.parametrize("width", [1e-3, 1e-5])
def test_narrow_tables_of_many_states_are_met(width, rtol):
    """Each of 40 states integrates a trapezoid of area 1 of three widths."""
    begins = 0.2 + 0.0173 * np.arange(40)
    knots, values = width * np.arange(4.0), [0.0, 0.5 / width, 0.5 / width, 0.0]

    def rates(t, x):
        moving = np.ones(1)
        return np.concatenate([moving, np.interp(x[0] - begins, knots, values)])

    run = clpt.simulate(system(rates, 41), [0.0, 0.5, 1.0], rtol=rtol, atol=rtol * 1e-2)
    np.testing.assert_allclose(run.states[-1, 1:], 1.0, atol=1e-5)
