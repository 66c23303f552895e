"""Values known by hand; controllers, learner and laws have reference numbers and proofs."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy import stats
from source_checks import CHECKS

import clpt_control as clpt
from clpt_control.blocks import disturbance, field, flow, localization, reference
from clpt_control.currents.plane import GriddedField
from clpt_control.equations.declaration import Each, multiples


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
def test_sources_are_what_the_theorems_take_them_for(check):
    check()


# --- basis functions, Eq. (5) -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("kernel", "formula"),
    [
        ("exponential", lambda d: np.exp(-d / 6.0)),
        ("gaussian", lambda d: np.exp(-(d**2) / 18.0)),
        ("gaussian-sigma", lambda d: np.exp(-(d**2) / 3.0)),
    ],
)
def test_a_block_is_asked_at_many_places_and_times(kernel, formula):
    one = [[1.0, -2.0]], [3.0], [0.7], [-math.pi / 2]
    block = flow.flow_basis("basis_x", "x", kernel, *one)
    rng = np.random.default_rng(4)
    times, x = rng.uniform(0, 20, 50), rng.uniform(-5, 5, (50, 2))
    shape = formula(np.hypot(x[:, 0] - 1.0, x[:, 1] + 2.0))
    for t in (times, 5.0):
        found = clpt.equations.evaluate(block, t, x)[:, 0]
        np.testing.assert_allclose(found, shape * np.sin(0.7 * np.array(t)), atol=1e-14)
    assert clpt.equations.evaluate(block, 5.0, x[0]).shape == (1, 1)


# --- flows, Eqs. (3), (4), (32) ---------------------------------------------------------------


def test_disturbance_is_added_to_the_flow():
    p, u = np.array([[1.0, 2], [3, 4]]), [9.0, 9.0, 0.25, 0.5]
    assert flow.true_flow(p).output(0, [], u).tolist() == [1.25, 2.75]
    windy = flow.true_flow(p, disturbed=True)
    assert windy.output(0, [], [*u, 0.5, -2.75]).tolist() == [1.75, 0.0]


# --- reference, section IV --------------------------------------------------------------------


def test_pinned_interval_stands():
    block, pinned = reference.reference([[1, 1], [2, 2], [3, 3]], 2.0), {"reference.interval": 4.0}
    for t in (0.0, 1.9, 2.0, 77.0):
        assert block.output(t, [], [], params=pinned)[0] == 2


def test_multiples_are_single_rounded_products():
    times = multiples(0.1, 0.0, 1000.0)
    np.testing.assert_array_equal(times, [0.1 * k for k in range(1, len(times) + 1)])
    assert times[-1] <= 1000.0 < 0.1 * (len(times) + 1)
    ends = ((4.0, 8.0), (4.5, 5.5), (-9.0, 1.0))
    assert [multiples(2.0, *between).tolist() for between in ends] == [[6.0, 8.0], [], []]


def test_multiples_are_counted_as_they_are_listed():
    for period in (0.1, 1 / 3, 7.0, 0.013):
        each, rng = Each(period), np.random.default_rng(1)
        at = multiples(period, 0.0, 900.0)
        for t in (*rng.uniform(0, 900, 200), *at[::7], *np.nextafter(at[::7], 0.0), 0.0):
            assert each.count(None, t) == np.searchsorted(at, t, side="right")


# --- disturbances, Eq. (32) -------------------------------------------------------------------


def noise_at(block, **numbers):
    """What the block's function gives for columns of parameters, intervals and both axes."""
    p = SimpleNamespace(**{**block.parameters._asdict(), **numbers})
    return block.output_function(0.0, [], SimpleNamespace(x_true=0.0), p)


COUNT = 20000
NEIGHBOURS = (0, 1, 2, 12345, disturbance.MODULUS - 2, disturbance.MODULUS - 1)
APART = (3, 3 + 7919, 3 + 104729, 3 + 40503, 3 + 7919 + 104729)  # by numbers of the hash


@pytest.fixture(scope="module")
def noises():
    """Rows of noise: both axes of some seeds, of a position, and of many seeds at one interval."""
    rows, k = [], np.arange(float(COUNT))[:, None]
    for seed in (*NEIGHBOURS, *APART):
        block = disturbance.disturbance("noise", [1.0, 1.0], period=1.0, seed=float(seed))
        rows += [*noise_at(block, interval=k).T]
    for seed in (3.0, 4.0):
        rows += [*noise_at(localization.measurement(1.0, 1.0, seed), interval=k).T]
    for interval in (0.0, 7.0):
        rows += [*noise_at(block, seed=k, interval=interval).T]
    return np.array(rows)


def test_noise_is_standard_normal_and_does_not_repeat(noises):
    for n in noises:
        # five standard errors: 1/sqrt(20000) = 0.00707 of the mean, 1/sqrt(40000) of the sd
        assert abs(n.mean()) < 5 * 0.00708
        assert abs(n.std() - 1) < 5 * 0.005
        assert abs(stats.skew(n)) < 5 * math.sqrt(6 / COUNT)
        assert abs(stats.kurtosis(n)) < 5 * math.sqrt(24 / COUNT)
        assert stats.kstest(n, "norm").pvalue > 1e-4
        assert len(np.unique(n)) == COUNT


def test_noise_of_seeds_axes_and_lags_is_not_correlated(noises):
    """Nor are its sizes."""
    late = [row[lag : COUNT - 10 + lag] for row in noises for lag in (0, 1, 2, 3, 10)]
    for values in (np.array(late), np.square(late)):
        off = np.abs(np.corrcoef(values) - np.eye(len(values)))
        assert off.max() < 6 * 0.00708  # the largest of 11,000


def test_the_largest_seed_of_a_scenario_is_no_smaller_one_again():
    """The hash counts modulo a prime."""
    largest = int(disturbance.MODULUS) - 1
    table = {"kind": "noise", "amplitude": [1.0, 1.0], "period": 1.0, "seed": largest}
    paper = clpt.paper_scenario().with_values({"flow.disturbance": table})
    with pytest.raises(clpt.ScenarioError, match="seed"):
        paper.with_values({"flow.disturbance.seed": largest + 1})


# --- gridded flow, in place of Eq. (3) --------------------------------------------------------


def gridded(u, v, **options):
    axes = [np.linspace(0, 10, 6), np.linspace(-2, 2, 9), np.linspace(-3, 3, 7)]
    mesh = np.meshgrid(*axes, indexing="ij")
    return field.gridded_flow(GriddedField(*axes, u(*mesh), v(*mesh)), **options)


def test_spline_goes_through_the_grid():
    values = np.random.default_rng(6).normal(size=(2, 6, 9, 7))
    block = gridded(lambda *_: values[0], lambda *_: values[1])
    for m, j, i in np.ndindex(6, 9, 7):
        at = block.output(2.0 * m, [], [-3.0 + i, -2.0 + 0.5 * j])
        np.testing.assert_allclose(at, values[:, m, j, i], atol=1e-12)


def test_spline_gives_cubics_back_up_to_the_edges():
    """Of a current that turns at its first step and at its coast, nothing is flattened."""

    def u(t, y, x):
        return (1 - t + 0.02 * t**3) * (2 + y - y**3) * (x**2 - 0.3 * x**3)

    block = gridded(u, lambda t, y, x: t * y * x)
    edges = (0.0, -2.0, -3.0), (10.0, 2.0, 3.0)
    for t, y, x in (*edges, (0.3, -1.9, -2.8), (9.6, 1.8, 2.7), (4.7, 0.3, -1.1)):
        wanted = pytest.approx([u(t, y, x), t * y * x], abs=1e-10, rel=1e-7)
        assert block.output(t, [], [x, y]) == wanted
