"""Values known by hand; controllers, learner and laws have reference numbers and proofs."""

import math
import re
from types import SimpleNamespace

import hypothesis
import numpy as np
import pytest
from error_sentences import says
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats
from source_checks import CHECKS

import clpt_control as clpt
from clpt_control.base import random_numbers
from clpt_control.engine.model.block import evaluate
from clpt_control.engine.model.declaration import Each, multiples
from clpt_control.paper.blocks import (
    disturbance,
    field,
    flow,
    localization,
    reference,
    vehicle,
)
from clpt_control.paper.currents.plane import GriddedField
from clpt_control.paper.scenario.file import paper_text


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
def test_sources_are_what_the_theorems_take_them_for(check):
    check()


# --- basis functions, Eq. (5) -----------------------------------------------------------------


FORMULAS = {
    "exponential": lambda d: np.exp(-d / 6.0),
    "gaussian": lambda d: np.exp(-(d**2) / 18.0),
    "gaussian-sigma": lambda d: np.exp(-(d**2) / 3.0),
}


@pytest.mark.parametrize("kernel", flow.KERNELS)
def test_a_block_is_asked_at_many_places_and_times(kernel):
    one = [[1.0, -2.0]], [3.0], [0.7], [-math.pi / 2]
    block = flow.flow_basis("basis_x", "x", kernel, *one)
    rng = np.random.default_rng(4)
    times, x = rng.uniform(0, 20, 50), rng.uniform(-5, 5, (50, 2))
    shape = FORMULAS[kernel](np.hypot(x[:, 0] - 1.0, x[:, 1] + 2.0))
    for t in (times, 5.0):
        found = evaluate(block, t, x)[:, 0]
        np.testing.assert_allclose(found, shape * np.sin(0.7 * np.array(t)), atol=1e-14)
    assert evaluate(block, 5.0, x[0]).shape == (1, 1)


@pytest.mark.parametrize("kernel", flow.KERNELS)
def test_the_largest_slope_of_a_kernel_is_known(kernel):
    d = np.linspace(0, 30, 1_000_001)
    steepest = -np.diff(FORMULAS[kernel](d)).min() / d[1]
    assert flow.largest_shear(kernel, [3.0], [[0.0], [0.0]], 1.0) == pytest.approx(
        steepest, rel=1e-4
    )
    # two functions of theta, at worst along one direction
    both = flow.largest_shear(kernel, [3.0, 3.0], [[3.0, 0.0], [4.0, 1.0]], 0.0)
    assert both == pytest.approx(6 * steepest, rel=1e-4)


@pytest.mark.parametrize("kernel", flow.KERNELS)
def test_the_text_of_a_kernel_is_its_formula(kernel):
    exp, d = np.exp, np.linspace(0, 30, 7)
    text = flow.KERNELS[kernel].formula.replace("^", "**")
    text = re.sub(r"\((\d) s\)", r"(\1*s)", text.replace("(2 s**2)", "(2*s**2)"))
    value = eval(text, {"exp": exp, "d": d, "s": 3.0})
    np.testing.assert_allclose(value, FORMULAS[kernel](d), rtol=1e-14)


def test_the_example_names_each_kernel_with_its_formula():
    (comment,) = re.findall(r"(?m)^kernel = .*# (.*)", paper_text())
    rows = [f"{name}: {row.formula}" for name, row in flow.KERNELS.items()]
    assert comment == f"of the distance d and the width s: {'; '.join(rows)}"


# --- flows, Eqs. (3), (4), (32) ---------------------------------------------------------------


def test_disturbance_is_added_to_the_flow():
    p, u = np.array([[1.0, 2], [3, 4]]), [9.0, 9.0, 0.25, 0.5]
    assert flow.true_flow(p).output(0, [], u).tolist() == [1.25, 2.75]
    windy = flow.true_flow(p, disturbed=True)
    assert windy.output(0, [], [*u, 0.5, -2.75]).tolist() == [1.75, 0.0]


# --- reference, section IV --------------------------------------------------------------------


def test_pinned_interval_stands():
    block, pinned = (
        reference.reference([[1, 1], [2, 2], [3, 3]], 2.0),
        {"reference.interval": 4.0},
    )
    for t in (0.0, 1.9, 2.0, 77.0):
        assert block.output(t, [], [], params=pinned)[0] == 2


def test_multiples_are_single_rounded_products():
    times = multiples(0.1, 0.0, 1000.0)
    np.testing.assert_array_equal(times, [0.1 * k for k in range(1, len(times) + 1)])
    assert times[-1] <= 1000.0 < 0.1 * (len(times) + 1)
    ends = ((4.0, 8.0), (4.5, 5.5), (-9.0, 1.0))
    assert [multiples(2.0, *between).tolist() for between in ends] == [
        [6.0, 8.0],
        [],
        [],
    ]


def test_multiples_are_counted_as_they_are_listed():
    for period in (0.1, 1 / 3, 7.0, 0.013):
        each, rng = Each(period), np.random.default_rng(1)
        at = multiples(period, 0.0, 900.0)
        for t in (
            *rng.uniform(0, 900, 200),
            *at[::7],
            *np.nextafter(at[::7], 0.0),
            0.0,
        ):
            assert each.count(None, t) == np.searchsorted(at, t, side="right")


# --- disturbances, Eq. (32) -------------------------------------------------------------------


def noise_at(block, **numbers):
    """What the block's function gives for columns of parameters, intervals and both axes."""
    p = SimpleNamespace(**{**block.parameters._asdict(), **numbers})
    return block.output_function(0.0, [], SimpleNamespace(x_true=0.0), p)


COUNT = 20000
NEIGHBOURS = (0, 1, 2, 12345, random_numbers.MODULUS - 2, random_numbers.MODULUS - 1)
# by numbers of the hash
APART = (3, 3 + 7919, 3 + 104729, 3 + 40503, 3 + 7919 + 104729)


@pytest.fixture(scope="module")
def noises():
    """Rows of noise: both axes of some seeds, of a position, and of many seeds at one interval."""
    rows, k = [], np.arange(float(COUNT))[:, None]
    for seed in (*NEIGHBOURS, *APART):
        block = disturbance.disturbance(
            "noise", [1.0, 1.0], period=1.0, seed=float(seed)
        )
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
    largest = int(random_numbers.MODULUS) - 1
    table = {"kind": "noise", "amplitude": [1.0, 1.0], "period": 1.0, "seed": largest}
    paper = clpt.paper_scenario().with_values({"flow.disturbance": table})
    says(
        clpt.ScenarioError,
        "seed",
        paper.with_values,
        {"flow.disturbance.seed": largest + 1},
    )


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


# --- limits of a vehicle -------------------------------------------------------------------------

PAPER = clpt.paper_scenario()
LIMITED = PAPER.with_values({"vehicle.max_speed": 1.5})
velocity = st.floats(-1e6, 1e6).filter(lambda v: v == 0 or abs(v) > 1e-100)


@hypothesis.seed(1)
@settings(max_examples=200, deadline=None)
@given(v=st.tuples(velocity, velocity), limit=st.floats(1e-3, 1e3))
def test_at_most_the_limit_in_the_same_direction_and_as_commanded_below(v, limit):
    found, speed = (
        np.array(vehicle.speed_limit(limit).output(0.0, [], v)),
        math.hypot(*v),
    )
    assert math.hypot(*found) <= limit * (1 + 1e-14)
    if speed < limit * (1 - 1e-15):
        assert found.tolist() == list(v)
    if speed > limit * (1 + 1e-15):
        assert math.hypot(*found) == pytest.approx(limit, rel=1e-14)
        assert math.atan2(found[1], found[0]) == pytest.approx(
            math.atan2(v[1], v[0]), abs=1e-14
        )
    missing = vehicle.hedging().output(0.0, [], [*v, *found])
    np.testing.assert_allclose(found + missing, v, rtol=1e-15)


CALM = {"flow.parameters": [[0.0] * 3] * 2}
AGAINST = [  # speed of the flow, distance at first, and at t
    # 2.5 against 1.5: the distance grows by 1.0 a second
    (2.5, 3.0, lambda t: 3.0 + t),
    # r' = 1 - 1.5 down to r = 1.5 at t = 17, then r' = 1 - r
    (
        1.0,
        10.0,
        lambda t: np.where(t <= 17, 10.0 - 0.5 * t, 1.0 + 0.5 * np.exp(17 - t)),
    ),
]


@pytest.mark.parametrize(("speed", "start", "r"), AGAINST, ids=["drifts", "comes home"])
def test_a_vehicle_drifts_or_comes_home_at_what_one_is_faster(speed, start, r):
    """KD = 1: it steers to the origin in a constant flow, along (0.6, 0.8), it does not know."""
    along = np.array([0.6, 0.8])
    values = {
        "flow.disturbance": {"kind": "constant", "amplitude": (speed * along).tolist()},
        "vehicle.position": (start * along).tolist(),
        "reference": {"kind": "waypoints", "points": [[0.0, 0.0]], "dwell": 100.0},
        "run.duration": 40.0,
    }
    run = clpt.simulate(LIMITED.with_values({**CALM, **values}))
    tolerance = 1e-12 if speed > 1.5 else 1e-7
    np.testing.assert_allclose(
        run.position, np.outer(r(run.time), along), rtol=tolerance
    )


def test_what_is_not_allowed_is_said():
    for key, value, said in (
        ("vehicle.max_speed", 0.0, " = 0.0: must be greater than 0"),
        ("vehicle.max_speed", math.inf, ".*finite"),
        ("learning.hedging", True, " = true: .* only with vehicle.max_speed"),
    ):
        says(clpt.ScenarioError, key + said, PAPER.with_values, {key: value})


def test_the_limit_has_a_name_at_call_time_and_may_vary():
    short = LIMITED.with_values(
        {"run.duration": 10, "run.rtol": 1e-12, "run.atol": 1e-13}
    )
    run = clpt.simulate(short, params={"speed_limit.max_speed": 1.1})
    many = clpt.run_ensemble(
        short, "vehicle.max_speed=[1.1, 1.5]", 2, trajectories=True
    )
    speeds = many["vehicle.max_speed"].values
    assert sorted(speeds) == [1.1, 1.5]
    for m, speed in enumerate(speeds):
        alone = clpt.simulate(short.with_values({"vehicle.max_speed": float(speed)}))
        np.testing.assert_allclose(
            many.position[m], alone.position, rtol=1e-9, atol=1e-9
        )
        if speed == 1.1:
            np.testing.assert_allclose(run.position, alone.position, atol=1e-7)


# --- the measured position x_m = x + s n, n standard normal, held ------------------------------

NOISE = {"noise": 0.05, "noise_period": 0.5, "seed": 3}
NOISY = PAPER.with_values({"localization": NOISE, "run.duration": 20})


def test_the_vehicle_steers_on_what_it_reads():
    """In calm water x' = -k (x + n) + k zc: exact from one period of the noise to the next."""
    run = clpt.simulate(NOISY.with_values({**CALM, "run.output_step": 0.5}))
    x, n = run.position.values, (run.measured_position - run.position).values
    left = np.exp(-0.5)
    wanted = left * x[:-1] + (1 - left) * (run.reference.values[:-1] - n[:-1])
    np.testing.assert_allclose(x[1:], wanted, rtol=0, atol=1e-8)
    assert np.std(n) == pytest.approx(0.05, rel=0.3)


def test_the_truth_is_without_noise():
    run = clpt.simulate(NOISY)
    phi = evaluate(NOISY.basis_block(), run.time.values, run.position.values)
    flow = np.einsum("ik,tk->ti", run.flow_parameters.values, phi)
    np.testing.assert_allclose(run.true_flow, flow, rtol=0, atol=1e-12)
    seen = run.measured_position - run.predicted_position
    np.testing.assert_allclose(run.clpe, seen, rtol=0, atol=1e-12)
    off = ((run.feedback_gain - 1) ** 2 + (run.feedforward_gain - 1) ** 2).sum("axis")
    theta = run.flow_parameters_estimate - run.flow_parameters
    off = off + (theta**2).sum(("axis", "basis"))
    V = ((run.position - run.predicted_position) ** 2).sum(
        "axis"
    ) + off / NOISY.learning.gain
    np.testing.assert_allclose(run.lyapunov, V / 2, rtol=1e-12)


def test_no_noise_is_no_localization():
    quiet = clpt.simulate(NOISY.with_values({"localization.noise": 0.0}))
    plain = clpt.simulate(NOISY.with_values({"localization": None}))
    for name in plain.data_vars:
        np.testing.assert_allclose(
            quiet[name], plain[name], rtol=0, atol=1e-7, err_msg=name
        )
    assert set(quiet.data_vars) - set(plain.data_vars) == {"measured_position"}


def test_a_measured_track_feeds_the_learner_alone():
    loop = clpt.closed_loop(NOISY, external="x")
    assert loop.input_labels == ["x[0]", "x[1]"]
    assert {"measurement", "basis_x_true"} <= {
        one.name for one in clpt.paper_blocks(NOISY)
    }
    assert clpt.closed_loop(NOISY, external="x_true").nstates == loop.nstates


def test_a_seed_varies_by_a_list_and_every_member_has_its_own_noise():
    seeds, how = (
        "localization.seed=[0, 1, 2, 3]",
        {"design": "grid", "trajectories": True},
    )
    for k, position in enumerate(
        clpt.run_ensemble(NOISY, seeds, 4, **how).position.values
    ):
        own = clpt.simulate(NOISY.with_values({"localization.seed": k}))
        np.testing.assert_allclose(position, own.position, rtol=0, atol=1e-10)
    for vary, said in (
        ("=0:3", "List the values"),
        ("=[1, 2.5]", "must be a whole number"),
    ):
        says(
            clpt.ClptError,
            said,
            clpt.run_ensemble,
            NOISY,
            f"localization.seed{vary}",
            2,
        )
