"""Tables are one search by bisection: exact, and nearly independent of their length."""

import bisect

import control
import numpy as np
import pytest
from recorded_blocks import as_it_runs, static
from scipy.interpolate import Akima1DInterpolator, CubicSpline, interp1d

import clpt_control as clpt
from clpt_control import Block

TIGHT = {"rtol": 1e-10, "atol": 1e-12}
ROWS = [3, 65, 1000, 30_000]


def system(rate, **more):
    return control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="m", **more)


def lines(block, role="output"):
    return [line.kind for line in block.array_record(role).operations]


@pytest.mark.parametrize("rows", ROWS)
def test_a_table_is_one_search(rows):
    xs = np.sort(np.random.default_rng(rows).uniform(-2.0, 2.0, rows))
    xs[rows // 2] = xs[rows // 2 - 1]  # two rows at one place
    ys = np.cos(np.arange(rows))
    block = static(lambda t, x, u, p: [np.interp(u[0], xs, ys)], 1)
    assert lines(block).count("search") == 1
    assert len(lines(block)) < 20
    beside = np.nextafter(xs, -9.0), xs, np.nextafter(xs, 9.0)
    for v in np.concatenate(
        [*(one[:: max(1, rows // 20)] for one in beside), [-3, 3, xs[0], xs[-1]]]
    ):
        as_it_runs(block, "output", 0.0, [], [v], 1e-12)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("value", [-np.inf, -1.0, 0.0, 0.5, 1.0, 2.0, np.inf])
def test_searches_are_numpys_and_pythons(side, value):
    row = np.array([-1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0])
    find = {"left": bisect.bisect_left, "right": bisect.bisect_right}[side]
    block = static(
        lambda t, x, u, p: [np.searchsorted(row, u[0], side), find(row.tolist(), u[0])],
        1,
        2,
    )
    numbers = as_it_runs(block, "output", 0.0, [], [value])
    np.testing.assert_array_equal(numbers, np.searchsorted(row, value, side))
    found = clpt.simulate(block, [0.0, 1.0], value) if np.isfinite(value) else None
    if found is not None:
        assert found.attrs["engine"] == "native"
        np.testing.assert_array_equal(found.y[-1], numbers)


@pytest.mark.parametrize("rows", [3, 30, 1000])
def test_the_least_of_a_row_is_its_first(rows):
    numbers = np.random.default_rng(rows).integers(-3, 3, rows).astype(float)
    block = static(
        lambda t, x, u, p: [np.argmin(numbers * u[0]), np.max(numbers * u[0])], 1, 2
    )
    for u in (1.0, -1.0, 0.0, 2.5):
        found = as_it_runs(block, "output", 0.0, [], [u])
        run = clpt.simulate(block, [0.0, 1.0], u)
        np.testing.assert_array_equal(run.y[-1], found)
        np.testing.assert_array_equal(
            found, [np.argmin(numbers * u), np.max(numbers * u)]
        )


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("rows", [2, 40, 3000])
def test_a_straight_table_over_a_state_is_its_line(rows, engine):
    xs = np.linspace(0.0, 1.0, rows)
    decay = system(lambda t, x, u, p: [-np.interp(x[0], xs, 2.0 * xs)])
    run = clpt.simulate(decay, np.linspace(0, 3, 7), 0, [1.0], engine=engine, **TIGHT)
    np.testing.assert_allclose(run.states[:, 0], np.exp(-2.0 * run.time), rtol=1e-8)
    assert run.solver_steps < (200 if engine == "native" else 300)


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("slope", [1.0, -0.5])
def test_a_bent_table_over_a_state(slope, engine):
    """x' = 1 below x = 1, slope from there on."""
    xs, ys = np.array([-9.0, 1.0, 1.0, 9.0]), np.array([1.0, 1.0, slope, slope])
    climb = system(lambda t, x, u, p: [np.interp(x[0], xs, ys)])
    if slope < 0:  # both sides lead to the row, on which the run slides
        run = clpt.simulate(climb, [0.0, 2.0], 0, [0.0], **TIGHT)
        assert run.states[-1].item() == pytest.approx(1.0, abs=1e-6)
        return
    run = clpt.simulate(climb, [0.0, 0.5, 3.0], 0, [0.0], engine=engine, **TIGHT)
    np.testing.assert_allclose(run.states[:, 0], [0.0, 0.5, 3.0], rtol=1e-9)


@pytest.mark.parametrize("shift", [0.0, 0.75, -0.3])
@pytest.mark.parametrize("rows", [11, 2001])
def test_rows_over_time_are_breakpoints(rows, shift):
    """x(t) is the integral of straight lines, exactly."""
    ts = np.linspace(0.0, 10.0, rows)
    us = np.random.default_rng(rows).normal(size=rows)
    drive = system(lambda t, x, u, p: [np.interp(t - shift, ts, us)])
    times = np.array([0.0, 1.0, 4.44, 9.0, 12.0])
    run = clpt.simulate(drive, times, 0, [0.0], **TIGHT)
    fine = np.union1d(np.concatenate([[0.0, 12.0], ts + shift]), times)
    fine = fine[(fine >= 0.0) & (fine <= 12.0)]
    values = np.interp(fine - shift, ts, us)
    sums = np.concatenate(
        [[0.0], np.cumsum(np.diff(fine) * (values[1:] + values[:-1]) / 2)]
    )
    np.testing.assert_allclose(
        run.states[:, 0], sums[np.searchsorted(fine, times)], atol=1e-11
    )
    inside = np.count_nonzero((ts + shift > 0) & (ts + shift < 12))
    assert run.solver_steps <= inside + 10


def test_a_held_table_over_time_jumps_at_its_rows():
    """x' is u_k from t_k on: the hold of searchsorted, of interp1d and of two rows at one time."""
    ts, us = np.array([0.0, 1.0, 2.5, 4.0]), np.array([1.0, -2.0, 0.5, 3.0])
    twice = np.repeat(ts, 2)[1:], np.repeat(us, 2)[:-1]
    hold = interp1d(ts, us, "previous", bounds_error=False, fill_value=(1.0, 3.0))
    held = [
        lambda t, x, u, p: [us[np.searchsorted(ts, t, side="right") - 1]],
        lambda t, x, u, p: [hold(t)],
        lambda t, x, u, p: [np.interp(t, *twice)],
    ]
    exact = np.interp(
        [0.5, 1.0, 3.0, 5.0], [*ts, 5.0], np.cumsum([0.0, 1.0, -3.0, 0.75, 3.0])
    )
    for rate in held:
        run = clpt.simulate(system(rate), [0.0, 0.5, 1.0, 3.0, 5.0], 0, [0.0], **TIGHT)
        assert run.attrs["engine"] == "native"
        np.testing.assert_allclose(run.states[1:, 0], exact, atol=1e-10)


def test_an_akima_spline_is_its_polynomials():
    spline = Akima1DInterpolator([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 0.0, 2.0, 1.0])
    run = clpt.simulate(system(lambda t, x, u, p: [spline(t)]), [0.0, 3.7], 0, [0.1])
    assert run.attrs["engine"] == "native"
    exact = 0.1 + spline.integrate(0.0, 3.7)
    assert run.states[-1].item() == pytest.approx(exact, rel=1e-9)


def test_the_integral_of_a_derivative_of_a_spline_is_its_difference():
    spline = CubicSpline([0.0, 1.0, 2.5, 4.0], [[0.0, 2.0, 1.0, 3.0]] * 2, axis=1)
    drive = system(lambda t, x, u, p: [np.sum(spline(t, 1))])
    run = clpt.simulate(drive, [0.0, 3.3], 0, [0.5], **TIGHT)
    assert run.attrs["engine"] == "native"
    exact = 0.5 + np.sum(spline(3.3) - spline(0.0))
    assert run.states[-1].item() == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("kind", ["linear", "nearest", "next", "zero", "quadratic"])
def test_a_table_along_another_axis_has_scipys_values_and_ends(kind):
    ends = np.array([7.0, 8.0]), np.array([-7.0, -8.0])
    rows = [[0.0, 2.0, 1.0, 3.0], [1.0, 1.0, 4.0, 0.0]]
    table = interp1d(
        [0.0, 1.0, 2.5, 4.0], rows, kind, 1, bounds_error=False, fill_value=ends
    )
    block = static(lambda t, x, u, p: table(u).ravel(), 2, 4)
    for u in np.linspace(-0.5, 4.5, 21):
        run = clpt.simulate(block, [0.0, 1.0], [u, 2.0])
        assert run.attrs["engine"] == "native"
        np.testing.assert_allclose(run.y[-1], table([u, 2.0]).ravel(), 1e-12, 1e-12)


def test_a_dense_smooth_table_needs_no_more_steps_than_its_curve():
    """A smaller difference of a table and a curve than 3e-9 is none."""
    xs = np.linspace(-4.0, 4.0, 80_000)
    spline = CubicSpline(xs, np.sin(xs))
    steps = {}
    for name, rate in {
        "curve": lambda t, x, u, p: [np.sin(x[0]) + 0.2],
        "table": lambda t, x, u, p: [np.interp(x[0], xs, np.sin(xs)) + 0.2],
        "spline": lambda t, x, u, p: [spline(x[0]) + 0.2],
    }.items():
        run = clpt.simulate(system(rate), [0.0, 2.5], 0, [0.1], rtol=1e-8, atol=1e-10)
        steps[name] = int(run.solver_steps)
        assert run.states[-1].item() == pytest.approx(END, rel=3e-8)
    assert max(steps.values()) <= 1.2 * steps["curve"] + 2


# x' = sin x + 0.2 from 0.1: the integral of 1/(sin x + 0.2) is 2.5
def _end():
    from scipy.integrate import quad
    from scipy.optimize import brentq

    passed = lambda x: quad(lambda s: 1.0 / (np.sin(s) + 0.2), 0.1, x, epsabs=1e-13)[0]  # noqa: E731
    return brentq(lambda x: passed(x) - 2.5, 0.2, 3.0, xtol=1e-13)


END = _end()


def test_members_of_an_ensemble_read_tables_over_time():
    ts = np.linspace(0.0, 5.0, 101)
    drive = Block(
        "drive",
        update=lambda t, x, u, p: [p.gain * np.interp(t, ts, ts**2) - x.z],
        states={"z": 1},
        parameters={"gain": 1.0},
    )
    ensemble = clpt.run_ensemble(drive, "drive.gain=1:2", 5, timepts=[0.0, 5.0])
    for k in range(5):
        gain = ensemble["drive.gain"].values[k]
        alone = clpt.simulate(drive, [0.0, 5.0], params={"drive.gain": gain})
        assert ensemble["z_final"].values[k].item() == pytest.approx(
            alone.z.values[-1], rel=1e-9
        )


def test_two_rows_at_one_place_and_rows_in_no_order():
    ts, us = [0.0, 1.0, 1.0, 2.0], [0.0, 0.0, 1.0, 1.0]
    step = system(lambda t, x, u, p: [np.interp(t, ts, us)])
    run = clpt.simulate(step, [0.0, 2.0], **TIGHT)
    assert run.states[-1].item() == pytest.approx(1.0, abs=1e-10)
    wrong = system(
        lambda t, x, u, p: [np.interp(x[0], [0.0, 2.0, 1.0], [0.0, 1.0, 2.0])]
    )
    with pytest.warns(UserWarning, match="np.interp of points that do not increase"):
        clpt.simulate(wrong, [0.0, 1.0])


@pytest.mark.parametrize("period", [10.0, 7.0])
def test_a_periodic_table_is_numpys(period):
    ts, us = np.linspace(0.0, 9.5, 20), np.random.default_rng(2).normal(size=20)
    block = static(lambda t, x, u, p: [np.interp(u[0], ts, us, period=period)], 1)
    for v in np.linspace(-25.0, 25.0, 91):
        as_it_runs(block, "output", 0.0, [], [v], 1e-12)
