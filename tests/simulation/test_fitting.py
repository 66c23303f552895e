"""Fits: what is recovered, how sure it is, and what the data do not tell."""

import control
import numpy as np
import pandas as pd
import pytest
from example_models import autonomous, decay
from scipy.optimize import curve_fit

import clpt_control as clpt

TIMES = np.linspace(0.0, 10.0, 101)
FORCE = np.sin(1.3 * TIMES)[None]
TRUTH = {"m": 2.0, "c": 0.7, "k": 5.0}
BEGIN = {"m": 1.5, "c": 0.5, "k": 4.0}
START = [0.3, 0.0]


def mass(**params):
    """A mass on a spring with a damper, pushed."""
    names = {
        "states": ["place", "speed"],
        "inputs": ["force"],
        "outputs": ["place", "speed"],
    }
    rate = lambda t, x, u, p: [x[1], (u[0] - p["c"] * x[1] - p["k"] * x[0]) / p["m"]]  # noqa: E731
    return control.nlsys(
        rate, name="mass", params={"m": 1.0, "c": 1.0, "k": 1.0} | params, **names
    )


def pushed(force=FORCE):
    """Its run."""
    return clpt.simulate(mass(**TRUTH), TIMES, force, START)


def measured(seed, force=FORCE, place=0.01, **noise):
    """Outputs of its run with noise of these deviations."""
    random, run, noise = (
        np.random.default_rng(seed),
        pushed(force),
        {"place": place, **noise},
    )
    return {
        name: run[name] + size * random.standard_normal(101)
        for name, size in noise.items()
    }


def fit(data, begin=BEGIN, inputs=FORCE, times=TIMES):
    return clpt.fit_parameters(mass(), data, begin, times, inputs, START)


def covered(seeds):
    found = [fitted(seed).intervals for seed in seeds]
    return np.mean([own[n][0] <= TRUTH[n] <= own[n][1] for own in found for n in TRUTH])


def fitted(seed):
    return fit(measured(seed), BEGIN | {"m": (1.5, 0.1, 10.0)})


def test_three_parameters_are_recovered_from_noisy_data():
    found = fitted(1)
    for name, value in TRUTH.items():
        assert abs(found.values[name] - value) < 4 * found.errors[name] < 0.1 * value
    again = clpt.simulate(mass(), TIMES, FORCE, found.initial_state, found.params)
    left = np.std(again.place.values - measured(1)["place"])
    assert [found.noise["place"], left] == pytest.approx([0.01, 0.01], rel=0.2)
    assert "m = " in repr(found)
    assert covered(range(10)) > 0.8


@pytest.mark.slow
def test_intervals_of_95_percent_hold_the_truth_as_often():
    assert 0.92 <= covered(range(100)) <= 0.98


def test_errors_are_those_of_curve_fit():
    """SciPy's own fit of the closed form, with differences."""
    times = np.linspace(0.0, 2.0, 41)
    noisy = 3.0 * np.exp(-1.7 * times) + 0.02 * np.random.default_rng(
        3
    ).standard_normal(41)
    own, covariance = curve_fit(
        lambda t, k, a: a * np.exp(-k * t), times, noisy, [1.0, 1.0]
    )
    found = clpt.fit_parameters(
        decay(1.0), {"x": noisy}, {"k": 1.0, "x0.x": 1.0}, times
    )
    assert [*found.values.values()] == pytest.approx(own, rel=1e-6)
    assert found.covariance == pytest.approx(covariance, rel=1e-4)


def test_outputs_of_unlike_noise_count_by_it():
    noise = {"place": 0.001, "speed": 0.1}
    data = measured(5, **noise)
    both = fit(data)
    assert both.noise == pytest.approx(noise, rel=0.2)
    assert both.errors["k"] <= 1.05 * fit({"place": data["place"]}).errors["k"]


@pytest.mark.parametrize("held", [{}, {"c": (0.1, 0.0, 1.0)}])
def test_noise_of_each_output_is_over_what_its_numbers_leave(held):
    """One output tells both numbers, the other none of them: ordinary regression beside a mean.

    A number that lies on its bound, as the data bend down, costs nothing.
    """
    times, random = np.linspace(0.0, 1.0, 6), np.random.default_rng(1)
    line = control.nlsys(
        lambda t, x, u, p: [p["b"]], lambda t, x, u, p: [x[0] + p["c"] * t**2, 0 * x[0]],
        inputs=0, outputs=["y", "still"], states=["s"], name="line",
        params={"b": 1.0, "c": 0.0},
    )  # fmt: skip
    data = {"y": 2 + 3 * times - times**2, "still": np.zeros(6)}
    data = {name: one + 0.1 * random.standard_normal(6) for name, one in data.items()}
    found = clpt.fit_parameters(line, data, {"b": 1.0, "x0.s": 1.0, **held}, times)
    (slope, level), covariance = np.polyfit(times, data["y"], 1, cov=True)
    left = data["y"] - level - slope * times
    noise = {
        "y": np.sqrt(left @ left / 4),
        "still": np.sqrt(np.mean(data["still"] ** 2)),
    }
    assert found.noise == pytest.approx(noise, rel=1e-6)
    errors = [found.errors["b"], found.errors["x0.s"]]
    assert errors == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-6)


def test_data_are_a_run_or_have_gaps():
    run = pushed()
    gaps = {"place": np.where(np.arange(101) % 3, run.place.values, np.nan)}
    for data, times in ((run[["place", "speed"]], None), (gaps, TIMES)):
        found = clpt.fit_parameters(mass(), data, BEGIN, times, FORCE, START)
        assert found.values == pytest.approx(TRUTH, rel=1e-5)


def test_what_the_data_do_not_tell_is_said():
    found = fit(measured(0, 0.0, place=0.001), inputs=0.0)
    (said,) = found.unidentified  # without a force all three grow alike
    assert said.startswith("the data do not tell m and c and k apart")
    assert said.count("1 %") == 3
    assert np.isinf([*found.errors.values()]).all()
    assert said in repr(found)
    assert found.values["k"] / found.values["m"] == pytest.approx(2.5, rel=1e-2)


def test_a_bound_that_is_met_has_no_error():
    found = fit(measured(0), BEGIN | {"m": (1.0, 0.1, 1.8)})
    assert found.values["m"] == pytest.approx(1.8)
    assert [np.isfinite(found.errors[n]) for n in "mk"] == [False, True]
    assert np.isnan(found.errors["m"])
    assert found.unidentified == ("m lies on a bound",)


def test_a_start_at_rest_is_told():
    """The speed at the start is zero to the last digit, which is no relative change."""
    begin, data = (
        {"x0.place": 0.1, "x0.speed": 0.1, "k": 4.0},
        {"place": pushed().place},
    )
    found = clpt.fit_parameters(mass(**TRUTH), data, begin, TIMES, FORCE)
    assert not found.unidentified
    free = clpt.sensitivity(mass(**TRUTH), TIMES, "place", [*begin], FORCE, START)
    J, own = free.place.values, np.array([*found.errors.values()])
    errors = np.sqrt(np.diag(np.linalg.inv(J.T @ J)))
    np.testing.assert_allclose(own / own[0], errors / errors[0], rtol=1e-4)


MISTAKES = [
    ({"data": {"q": TIMES}}, "q is not an output; .* It has place, speed"),
    ({"data": {"place": np.nan * TIMES}}, "no finite numbers of the outputs place"),
    ({"data": {"place": TIMES[:5]}}, "101 samples"),
    ({"data": {"place": ["a"] * 101}}, "place'\\] = .* must be an array of numbers"),
    (
        {"data": {"place": TIMES, "sped": TIMES}},
        "sped is not an output; .* Did you mean 'speed'",
    ),
    (
        {"data": pushed(), "inputs": None},
        "force is not an output; inputs= takes inputs",
    ),
    ({"data": {"place": TIMES}, "times": None}, "timepts: is required"),
    ({"begin": {"q": 1.0}}, "parameter 'q': is no number of the system"),
    ({"begin": {"m": (1.0, 2.0, 3.0)}}, "low <= start <= high"),
    ({"begin": {"m": (1.0, 2.0)}}, r"or \(start, low, high\)"),
    ({"begin": {"m": [1.0, 0.5, 3.0]}}, r"m = \[1.0, 0.5, 3.0\]: must be a number"),
]


@pytest.mark.parametrize(("given", "said"), MISTAKES)
def test_mistakes_are_told(given, said):
    with pytest.raises(clpt.ClptError, match=said):
        fit(**{"data": measured(0), "begin": {"m": 1.0}} | given)


def test_a_try_that_escapes_is_taken_back():
    """From a = 4, b = 0 the first step is to a = 0.6, b = 4, which is infinite at t = 0.3."""
    rate = lambda t, x, u, p: [-p["a"] * x[0] + p["b"] * x[0] ** 2]  # noqa: E731
    growth, times, (a, b) = (
        autonomous(rate, a=1.0, b=1.0),
        np.linspace(0, 5, 21),
        (1.0, 0.9),
    )
    data = {"x": a / (b + (a - b) * np.exp(a * times))}
    found = clpt.fit_parameters(
        growth, data, {"a": 4.0, "b": 0.0}, times, initial_state=[1.0]
    )
    assert found.values == pytest.approx({"a": a, "b": b}, abs=1e-8)
    with pytest.raises(
        clpt.SimulationError, match=r"at a = 0.3, b = 0.5: .*Begin closer,"
    ):
        clpt.fit_parameters(
            growth, data, {"a": 0.3, "b": 0.5}, times, initial_state=[1.0]
        )


def test_a_level_at_which_a_rate_jumps_is_refused():
    """x' = 1 below the edge, k above: x = edge + k (t - edge)."""
    rate = lambda t, x, u, p: [1.0 if x[0] < p["edge"] else p["k"]]  # noqa: E731
    data = {"x": np.where(TIMES < 4.03, TIMES, 4.03 + 3.0 * (TIMES - 4.03))}
    with pytest.raises(
        clpt.SimulationError, match="do not confirm its derivative by edge"
    ):
        clpt.fit_parameters(
            autonomous(rate, edge=1.0, k=2.0), data, {"edge": 3.0, "k": 2.5}, TIMES
        )


# --- how well a model fits -----------------------------------------------------------------------


def wave(amplitude, seed=2):
    """Decay with a slow wave that the model does not have, and a little noise."""
    times = np.linspace(0.0, 3.0, 61)
    noise = 0.01 * np.random.default_rng(seed).standard_normal(61)
    data = 2.0 * np.exp(-times) + amplitude * np.sin(4.0 * times) + noise
    begin = {"k": 0.8, "x0.x": 1.5}
    return times, data, clpt.fit_parameters(decay(1.0), {"x": data}, begin, times)


def test_what_a_wrong_model_leaves_is_told():
    times, data, found = wave(0.3)
    left = data - found.values["x0.x"] * np.exp(-found.values["k"] * times)
    share = 100.0 * (1.0 - np.mean(left**2) / np.var(data))
    output = found.outputs["x"]
    assert output.correlation == pytest.approx(
        np.corrcoef(left[1:], left[:-1])[0, 1], abs=0.02
    )
    assert 100.0 * output.explained == pytest.approx(share, rel=1e-6)
    assert f"x: {share:.2f} % of the variance explained" in repr(found)
    assert "residuals are not noise: the errors are too small" in repr(found)


@pytest.mark.parametrize("seed", range(5))
def test_noise_is_noise(seed):
    _, _, found = wave(0.0, seed)
    assert abs(found.outputs["x"].correlation) < 3.0 / np.sqrt(61)
    assert "not noise" not in repr(found)


def test_an_input_that_was_held_goes_through_a_hold():
    """y' = b u - a y with u held for h = 0.2: y(k + 1) = e^-ah y(k) + (1 - e^-ah) b/a u(k)."""
    a, b, h, times = 1.0, 2.0, 0.2, 0.2 * np.arange(101)
    u = np.where(times % 8 < 4, 1.0, 0.0)
    y = np.zeros(101)
    for k in range(100):
        y[k + 1] = np.exp(-a * h) * y[k] + (1 - np.exp(-a * h)) * b / a * u[k]
    data = {"y": y + 0.003 * np.random.default_rng(0).standard_normal(101)}
    plant = control.nlsys(
        lambda t, x, u, p: [p["b"] * u[0] - p["a"] * x[0]],
        name="plant",
        states=["y"],
        inputs=["u"],
        outputs=["y"],
        params={"a": 1.0, "b": 1.0},
    )
    found = clpt.fit_parameters(plant, data, {"a": 0.8, "b": 1.5}, times, u)
    assert "residuals are not noise" in repr(found)
    held = clpt.connect([clpt.parts.hold(h, u="r", y="u"), plant], external="r")
    begin = {"plant.a": 0.8, "plant.b": 1.5}
    found = clpt.fit_parameters(held, data, begin, times, u)
    assert "not noise" not in repr(found)
    for name, true in (("plant.a", a), ("plant.b", b)):
        assert abs(found.values[name] - true) < 4 * found.errors[name]


def test_exact_data_have_no_residuals_to_speak_of():
    run = pushed()
    found = fit({"place": run.place.values})
    assert "place: 100.00 % of the variance explained" in repr(found)
    assert "not noise" not in repr(found)


def test_a_dead_channel_is_told():
    data = measured(4, speed=0.01)
    found = fit({"place": data["place"], "speed": np.zeros(101)})
    place, speed = repr(found).splitlines()[-2:]
    assert place.startswith("place: 9")
    assert "not noise" not in place
    assert speed.startswith("speed: no variance to explain")
    assert speed.endswith("residuals are not noise: the errors are too small")


def test_a_dead_channel_whose_residuals_are_white_is_told():
    """Noise for a channel that the model swings, sampled four times a period."""
    random = np.random.default_rng(3)
    times = np.arange(40) * 0.5 * np.pi
    swing = control.nlsys(
        lambda t, x, u, p: [x[1], -p["k"] * x[0]],
        lambda t, x, u, p: [x[0], x[1]],
        name="swing",
        states=["x", "v"],
        inputs=0,
        outputs=["place", "speed"],
        params={"k": 1.0},
    )
    noise = 0.01 * random.standard_normal((2, 40))
    data = {"place": np.cos(times) + noise[0], "speed": noise[1]}
    found = clpt.fit_parameters(
        swing, data, {"k": 1.0}, times, initial_state=[1.0, 0.0]
    )
    place, speed = repr(found).splitlines()[-2:]
    assert "too small" not in place
    assert speed.endswith(
        "the model is farther from the data than their mean: the errors are too small, "
        "begin elsewhere"
    )


def test_a_frozen_channel_has_no_variance():
    data = measured(4, speed=0.01)
    found = fit({"place": data["place"], "speed": np.full(101, 3.7)})
    assert "speed: no variance to explain" in repr(found)


def test_data_model_and_residuals_are_drawn():
    times, data, found = wave(0.3)
    (points, line), (residuals, *_) = [ax.get_lines() for ax in found.plot()]
    model = found.values["x0.x"] * np.exp(-found.values["k"] * times)
    np.testing.assert_array_equal(points.get_xdata(), times)
    np.testing.assert_array_equal(points.get_ydata(), data)
    np.testing.assert_allclose(line.get_ydata(), model, rtol=1e-6)
    np.testing.assert_allclose(residuals.get_ydata(), data - model, atol=1e-6)
    both = fit(measured(5, speed=0.1))
    assert both.plot().shape == (2, 2)


def test_an_output_is_drawn_with_its_unit():
    room = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0]],
        states=["T"],
        outputs=["T"],
        inputs=0,
        params={"k": 1.0},
        name="room",
    )
    room.units = {"T": "degC"}
    times = np.linspace(0.0, 2.0, 9)
    data = {"T": 20.0 * np.exp(-0.5 * times)}
    found = clpt.fit_parameters(room, data, {"k": 1.0}, times, initial_state=[20.0])
    assert found.plot()[0].get_title("left") == "T (degC)"


def test_a_run_begins_at_the_first_of_timepts():
    """The start is at timepts[0], also where measurements begin later: y = 2.5 t."""
    late = pd.DataFrame({"y": 2.5 * TIMES[60:]}, index=TIMES[60:])
    days = np.datetime64("2024-05-01", "ns") + (1e9 * TIMES).astype("m8[ns]")
    growth = control.nlsys(
        lambda t, x, u, p: p["k"] * u,
        inputs="u",
        outputs="y",
        states="y",
        params={"k": 1.0},
        name="growth",
    )
    u = {"u": pd.Series([1.0, 1.0], days[[0, -1]])}
    for data, times, inputs in (
        (late, TIMES, 1.0),
        (late, [0, 20], 1.0),
        (late.set_index(days[60:]), days, u),
        (late.set_index(days[60:]), days[[0, -1]], u),
    ):
        fit = clpt.fit_parameters(growth, data, {"k": 1.0}, times, inputs, [0.0])
        assert fit.values["k"] == pytest.approx(2.5)
    early = pd.DataFrame({"y": 2.5 * np.arange(3.0)}, index=np.arange(3.0))
    fit = clpt.fit_parameters(growth, early, {"k": 1.0}, [-1, 3], 1.0)
    assert fit.values["k"] == pytest.approx(20 / 14)  # k (t + 1), by least squares
    for times in ([1, 2.0], [0, 2 - 1e-6]):
        with pytest.raises(clpt.SimulationError, match="data are from 0 to 2"):
            clpt.fit_parameters(growth, early, {"k": 1.0}, times, 1.0)
    count = control.nlsys(
        lambda t, x, u, p: x + p["k"],
        inputs=0,
        outputs="y",
        states="y",
        params={"k": 1.0},
        dt=1,
        name="count",
    )
    fit = clpt.fit_parameters(count, early.iloc[1:], {"k": 1.0}, [-1, 0, 1, 2])
    assert fit.values["k"] == pytest.approx((2.5 * 2 + 5 * 3) / (2**2 + 3**2))


def test_times_in_falling_order_are_refused():
    decay = clpt.Block(
        "decay",
        update=lambda t, x, u, p: -p.k * x,
        states={"x": 1},
        parameters={"k": 1.0},
    )
    t = np.linspace(0, 2, 41)
    data = {"x": np.exp(-0.7 * t)}
    found = clpt.fit_parameters(decay, data, {"decay.k": 0.3}, t, 0.0, [1.0])
    assert found.values["decay.k"] == pytest.approx(0.7, rel=1e-6)
    with pytest.raises(clpt.SimulationError, match="timepts"):
        clpt.fit_parameters(decay, data, {"decay.k": 0.3}, t[::-1], 0.0, [1.0])
