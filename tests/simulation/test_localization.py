"""Learning at fixes: closed forms of least squares, causality, and what a fix does to the run."""

import law_blocks
import numpy as np
import pytest
from error_sentences import says
from scipy.integrate import simpson

import clpt_control as clpt

TABLE = "learning.fix_regression"
PAPER = clpt.paper_scenario().with_values(
    {
        "learning.law": "fix-regression",
        "localization": {"interval": 5.0},
        **dict.fromkeys(
            f"learning.{key}" for key in ("gain", "feedback", "feedforward")
        ),
    }
)
# one steady function so wide that it is 1 to rounding: a uniform current, and m = t
STEADY = {
    "kernel": "gaussian",
    "centers": [[0.0, 0.0]],
    "widths": [1e9],
    "periods": [np.inf],
}
ONE = {"flow.parameters": [[0.3], [-0.2]], f"{TABLE}.prior": 0.5, f"{TABLE}.noise": 0.1}
ONE |= {"basis": STEADY, "model.parameters": None, "learning.parameters": None}
UNIFORM = PAPER.with_values({**ONE, "run.duration": 60.0})
THETA = np.array([0.3, -0.2])


def estimates(run):
    return run.flow_parameters_estimate.values[..., 0]


@pytest.mark.long
@pytest.mark.parametrize("latency", [0.0, 2.0])
@pytest.mark.parametrize("engine", ["native", "python"])
def test_in_a_uniform_current_the_estimate_is_that_of_ridge_regression(latency, engine):
    """After k exact fixes, T apart: theta_hat = theta k T^2 / (k T^2 + (r/prior)^2)."""
    run = clpt.simulate(
        UNIFORM.with_values({"localization.latency": latency}), engine=engine
    )
    k = np.floor((run.time.values - latency) / 5.0 + 1e-9)
    share = np.where(k > 0, k * 25.0, 0.0) / (
        np.maximum(k, 0) * 25.0 + (0.1 / 0.5) ** 2
    )
    np.testing.assert_allclose(
        estimates(run), share[:, None] * THETA, rtol=0, atol=1e-10
    )
    since = run.time.values - 5.0 * np.maximum(k, 0)
    away = (1 - share) * since  # x - z = eta m
    np.testing.assert_allclose(run.clpe, away[:, None] * THETA, rtol=0, atol=1e-8)
    V = 0.1**2 * (1 - share) ** 2 * (0.5**-2 + np.maximum(k, 0) * 25.0 / 0.1**2) / 2
    np.testing.assert_allclose(run.lyapunov, V * np.sum(THETA**2), rtol=1e-9)
    assert np.all(run.feedback_gain == 1.0)


def fixes_of(scenario):
    """Return the block of the fixes of a scenario."""
    (block,) = (one for one in clpt.paper_blocks(scenario) if one.name == "fixes")
    return block


def test_where_fixes_are_missing_the_integral_goes_on():
    scenario = UNIFORM.with_values(
        {"localization.dropouts": 0.5, "localization.seed": 2}
    )
    block = fixes_of(scenario)
    taken = [k for k in range(1, 13) if block.output(5.0 * k, [], [0.0, 0.0])[2]]
    assert 2 < len(taken) < 10
    run = clpt.simulate(scenario)
    learned, squares, last = np.zeros(len(run.time)), 0.0, 0
    for k in taken:
        squares, last = squares + (5.0 * (k - last)) ** 2, k
        learned[run.time >= 5.0 * k - 1e-9] = squares / (squares + 0.04)
    np.testing.assert_allclose(
        estimates(run), learned[:, None] * THETA, rtol=0, atol=1e-10
    )


def test_dropouts_are_as_frequent_as_said_and_independent_of_noise():
    count, rate = 2000, 0.3
    given = {"noise": 1.0, "interval": 5.0, "dropouts": rate, "seed": 7}
    block = fixes_of(PAPER.with_values({"localization": given}))
    found = np.array(
        [block.output(5.0 * k, [], [0.0, 0.0]) for k in range(1, count + 1)]
    )
    assert set(found[:, 2]) == {0.0, 1.0}
    few = 4 * np.sqrt(rate * (1 - rate) / count)
    assert abs(1 - found[:, 2].mean() - rate) < few
    apart = found[:, 2] - found[:, 2].mean()
    pairs = (apart[1:], apart[:-1]), (apart, found[:, 0]), (apart, found[:, 1])
    assert all(abs(np.mean(a * b)) < few for a, b in pairs)


def test_steps_of_equal_length_average_the_noise_of_fixes():
    """y_k is theta T + n_k - n_{k-1}; with a wide prior the sum leaves the last n alone."""
    exact = {f"{TABLE}.noise": 1e-9, f"{TABLE}.prior": 1e3}
    noisy = {"localization.noise": 0.05, "localization.interval": 20.0}
    scenario = UNIFORM.with_values(exact | noisy)
    run, block = clpt.simulate(scenario), fixes_of(scenario)
    for k in (1, 2, 3):
        n = block.output(20.0 * k, [], [0.0, 0.0])[:2]
        learned = estimates(run.sel(time=20.0 * k))
        np.testing.assert_allclose(learned, THETA + n / (20.0 * k), rtol=0, atol=1e-9)


def test_nothing_before_it_arrives_depends_on_a_fix():
    late = {"localization.latency": 2.0, "run.duration": 30.0, "run.output_step": 0.5}
    late[f"{TABLE}.noise"] = 0.3  # the same r for both
    calm, other = (
        clpt.simulate(PAPER.with_values(late | {"localization.noise": n}))
        for n in (0.0, 0.3)
    )
    before = calm.time.values < 7.0
    for name in ("position", "predicted_position", "alpha"):
        apart = np.abs(calm[name] - other[name]).max(dim=calm[name].dims[1:]).values
        assert np.all(apart[before] < 1e-12)
        assert np.all(apart[~before][1:] > 1e-6)


def test_ever_more_fixes_give_continuous_least_squares():
    """As T goes to 0 with r^2 = s^2 T, P^-1 is 1/prior^2 + int phi phi^T/s^2 along the track."""
    s, prior, times = 0.3, 0.9, np.linspace(0.0, 20.0, 4001)
    plain = clpt.paper_scenario().with_values({"run.duration": 20.0})
    basis, track = plain.basis_block(), clpt.simulate(plain, times).position.values
    phi = np.array([basis.output(t, [], x) for t, x in zip(times, track, strict=True)])
    seen = simpson(phi[:, :, None] * phi[:, None], x=times, axis=0) / s**2
    limit = plain.flow.parameters @ (
        np.eye(3) - np.linalg.inv(np.eye(3) + prior**2 * seen)
    )
    apart = []
    for between in (0.2, 0.1, 0.05):
        own = {f"{TABLE}.noise": s * np.sqrt(between), f"{TABLE}.prior": prior}
        often = PAPER.with_values({"localization.interval": between, **own})
        run = clpt.simulate(often, [0.0, 20.0])
        apart.append(np.abs(run.flow_parameters_estimate[-1] - limit).max().item())
    assert apart[2] < 3e-4, apart
    assert apart[0] > 1.8 * apart[1] > 3.2 * apart[2]


def test_the_vehicle_steers_on_its_prediction_alone():
    calm = PAPER.with_values({"flow.parameters": [[0.0] * 3] * 2})
    exact = {"rtol": 1e-11, "atol": 1e-12}
    run, still = (
        clpt.simulate(one, np.linspace(0.0, 5.0, 21), **exact) for one in (PAPER, calm)
    )
    before = run.predicted_position[:-1]  # the first fix no flow is known
    np.testing.assert_allclose(before, still.position[:-1], rtol=0, atol=1e-9)
    assert np.abs(run.clpe[:-1]).max() > 1
    np.testing.assert_allclose(run.clpe[-1], 0.0, atol=1e-12)  # right after the fix


LEARNED = [  # the largest error at a time
    ({}, {200: 0.02, 1000: 0.005}),
    ({"localization.interval": 20.0, "vehicle.max_speed": 1.5}, {1000: 0.05}),
    ({"localization.interval": 20.0}, {1000: 0.05}),
]


@pytest.mark.parametrize(("values", "bounds"), LEARNED)
def test_the_papers_flow_is_learned_at_fixes(values, bounds):
    run = clpt.simulate(PAPER.with_values({**values, "run.duration": 1000.0}))
    errors = abs(run.flow_parameters_estimate - run.flow_parameters)
    for time, bound in bounds.items():
        assert errors.sel(time=time).max() < bound


NOISY = clpt.paper_scenario().with_values({"localization": {"noise_period": 1.0}})
REFUSED = [  # the key that is named, the values, the sentence
    (
        "learning.law",
        {"localization": None},
        "learns at fixes, and needs localization.interval",
    ),
    ("learning.gain", {"learning.gain": 0.8}, "has no use for it"),
    ("learning.feedback", {"learning.feedback": [1.0, 1.0]}, "Remove the key"),
    ("localization.dropouts", {"localization.dropouts": 1.0}, "less than 1"),
    ("localization.latency", {"localization.latency": 5.0}, "below the interval"),
    (
        "localization.noise_period",
        {"localization.noise_period": 1.0},
        "only with interval = 0",
    ),
    (
        "localization.interval",
        {"learning.law": "learned-flow", "learning.gain": 0.8},
        "fix-reg",
    ),
]


@pytest.mark.parametrize(("key", "values", "said"), REFUSED)
def test_what_does_not_fit_is_said(key, values, said):
    says(clpt.ClptError, rf"\A(?=.*{key}).*{said}.*\Z", PAPER.with_values, values)


def test_what_is_of_fixes_alone_or_of_no_fixes_is_said():
    for key in ("latency", "dropouts"):
        with pytest.raises(
            clpt.ClptError, match=f"localization.{key} = 0.1: is of fixes"
        ):
            NOISY.with_values({f"localization.{key}": 0.1})
    with pytest.raises(clpt.DataError, match="z of a recorded run jumps at fixes"):
        clpt.gramian(clpt.simulate(UNIFORM), 20.0, 0.0)
    with pytest.raises(clpt.ClptError, match="reads the position at all times"):
        clpt.simulate(clpt.closed_loop(PAPER, law=law_blocks.papers_law()))


# --- fixes from outside --------------------------------------------------------------------------


def fed_by_fixes(times, interval=3.0, latency=0.0):
    """A learner in a uniform current of (0.4, -0.2), fed with fixes at given times."""
    scenario = clpt.Scenario(
        basis={
            "kernel": "gaussian",
            "centers": [[0, 0]],
            "widths": [1e3],
            "constituents": ["steady"],
        },
        flow={"parameters": [[0.0], [0.0]]},
        vehicle={"feedback": [1.0, 1.0], "feedforward": [1.0, 1.0]},
        reference={"kind": "waypoints", "points": [[1, 0], [0, 1]], "dwell": 3.0},
        learning={"law": "fix-regression"},
        localization={"interval": interval, "latency": latency},
        run={"duration": 30.0, "output_step": 0.1},
    )
    samples = np.arange(0, 30.001, 0.05)
    velocity, current = np.array([1.0, 0.5]), np.array([0.4, -0.2])
    taken = np.zeros(len(samples))
    taken[np.round(np.array(times) / 0.05).astype(int)] = 1
    inputs = [*np.outer(velocity + current, samples), taken]
    inputs += [np.full(len(samples), part) for part in velocity]
    loop = clpt.closed_loop(scenario, external=("fix", "taken", "v_x"))
    return clpt.simulate(loop, samples, np.array(inputs))


OFF = [2.9, 6.1, 8.9, 12.1, 14.9, 18.1, 20.9, 24.1, 26.9]


@pytest.mark.parametrize("latency", [0.0, 0.5])
def test_each_rise_of_taken_is_a_fix(latency):
    """The interval does not count, if fixes come from outside."""
    run = fed_by_fixes(OFF, latency=latency)
    learned = run.flow_parameters_estimate.values[-1, :, 0]
    np.testing.assert_allclose(learned, [0.4, -0.2], atol=2e-3)
    early = run.flow_parameters_estimate.sel(
        time=2.8 + latency, method="nearest"
    ).values
    assert not early.any()  # -0.0 is 0
    jumped = run.flow_parameters_estimate.sel(time=2.9 + latency, method="nearest")
    assert jumped.values.any()


@pytest.mark.parametrize("held", [1.0, 0.4])
def test_taken_that_never_rises_is_refused(held):
    values = {"learning": {"law": "fix-regression"}, "localization": {"interval": 5.0}}
    scenario = clpt.paper_scenario().with_values(values)
    loop = clpt.closed_loop(scenario, external=("fix", "taken", "v_x"))
    times = np.linspace(0, 50, 101)
    still = {"fix": np.outer([0.5, -0.2], times), "v_x": [0.0, 0.0]}
    with pytest.raises(
        clpt.ClptError, match=r"taken: never rises above 1/2.* Give a pulse"
    ):
        clpt.simulate(loop, times, {**still, "taken": held})
    run = clpt.simulate(loop, times, {**still, "taken": 0.0})
    assert not run.alpha.any()
    with pytest.raises(
        clpt.DiagramError, match=r"external='taken' .* each rise above 1/2"
    ):
        clpt.closed_loop(scenario, external=("fix", "v_x"))


def test_fixes_closer_than_their_latency_are_refused():
    """The second one would be sent before the first one has arrived."""
    with pytest.raises(clpt.ScenarioError, match="before the last one has arrived"):
        fed_by_fixes([2.9, 3.2], latency=0.5)


@pytest.mark.parametrize(("interval", "is_told"), [(0.2, False), (4.0, True)])
def test_an_interval_that_is_long_for_an_eddy_is_told(interval, is_told):
    """An eddy of 1 rad/s: started 5 % off, fixes each 4 s drive the law away."""
    a, width = 3.0, 4.0
    k = 1.0 / (2 * a / width**2 * np.exp(-(a**2) / (2 * width**2)))
    theta = np.array([[0, 0, -k, k, 0.1], [k, -k, 0, 0, 0.0]])
    gains = dict.fromkeys(
        f"learning.{key}" for key in ("gain", "feedback", "feedforward")
    )
    values = {
        "learning.law": "fix-regression",
        "localization": {"interval": interval},
        **gains,
        "basis": {
            "kernel": "gaussian",
            "centers": [[a, 0], [-a, 0], [0, a], [0, -a], [0, 0]],
            "widths": [width] * 4 + [1e6],
            "periods": [np.inf] * 5,
        },
        "flow.parameters": theta.tolist(),
        "model.parameters": None,
        "learning.parameters": (-0.95 * theta).tolist(),
        "run.duration": 200.0,
        "run.output_step": interval / 4,
    }
    run = clpt.simulate(clpt.paper_scenario().with_values(values))
    assert ("the interval is long for this flow" in run.attrs["message"]) == is_told
