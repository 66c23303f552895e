"""Ends of intervals are read as values are: by names, times and units, and refused as these."""

import math

import control
import numpy as np
import pandas as pd
import pytest
import xarray as xr

import clpt_control as clpt

TIMES = [0.0, 0.5, 1.0]
DATES = np.array(["2026-01-01", "2026-01-02", "2026-01-03"], "M8[s]")
DAY = 86400.0


def rows(values, *names):
    return xr.DataArray(values, dims="state", coords={"state": list(names)})


def over(times, values, **attrs):
    return xr.DataArray(values, dims="time", coords={"time": times}, attrs=attrs)


def box(tube, name, k=-1):
    return [float(tube[end].sel(name=name)[k]) for end in ("lower", "upper")]


def check_box(found, low, high, share=1e-9):
    """Check that a box holds an interval, to rounding of doubles, and is little wider."""
    size = max(abs(low), abs(high))
    assert low - share * size <= found[0] <= low + 1e-15 * size
    assert high - 1e-15 * size <= found[1] <= high + share * size


# --- initial states ------------------------------------------------------------------------------

LOW, HIGH = {"x[0]": 3.0, "x[1]": 1.0}, {"x[0]": 3.5, "x[1]": 2.0}
STEPS = np.array([1.0, 0.5])
low_rows = rows([1.0, 3.0], "x[1]", "x[0]")
low_series = pd.Series({"x[1]": 1.0, "x[0]": 3.0})
counted = xr.DataArray([1.0, 3.0], dims="k", coords={"k": [1, 0]})
STATES = {
    "labels in another order": {"x": (low_rows, low_rows + STEPS)},
    "each end in an order of its own": {
        "x": (low_rows, rows([3.5, 2], "x[0]", "x[1]"))
    },
    "Series": {"x": (low_series, pd.Series(HIGH))},
    "Series and DataArray": {"x": (low_series, rows([2, 3.5], "x[1]", "x[0]"))},
    "a list, and labels": {"x": ([3.0, 1.0], rows([2, 3.5], "x[1]", "x[0]"))},
    "labels, and an array": {"x": (low_rows, np.array([3.5, 2.0]))},
    "counted labels": {"x": (counted, counted + xr.DataArray([1.0, 0.5], dims="k"))},
    "elements": {"x[1]": (1, 2), "x[0]": (xr.DataArray(3.0), xr.DataArray(3.5))},
    "a number and a DataArray": {"x[0]": (3, xr.DataArray(3.5)), "x[1]": (1, 2)},
    "an array, and a dict in dicts": ({"x": [3.0, 1.0]}, HIGH),
    "dicts": (LOW, HIGH),
    "Datasets": (
        xr.Dataset({"x[1]": 1.0, "x[0]": 3.0}),
        xr.Dataset({"x[0]": 3.5, "x[1]": 2.0}),
    ),
    "a Dataset and a dict": (xr.Dataset({"x[1]": 1.0, "x[0]": 3.0}), HIGH),
    "Series as a whole": (low_series, pd.Series(HIGH)),
    "a Series of pairs": pd.Series({"x[1]": (1.0, 2.0), "x[0]": (3.0, 3.5)}),
    "a list of pairs": [(3.0, 3.5), (xr.DataArray(1.0), 2)],
    "32 bits": {"x": (np.float32([3.0, 1.0]), low_rows.astype("f4") + STEPS)},
}


@pytest.mark.parametrize("start", STATES.values(), ids=STATES)
def test_states_are_those_of_the_labels(start):
    model = clpt.Block(
        "m", update=lambda t, x, u, p: [-x[0], -2 * x[1]], states={"x": 2}
    )
    tube = clpt.enclose(model, [0, 1], None, start)
    for name, decay in (("x[0]", math.exp(-1)), ("x[1]", math.exp(-2))):
        check_box(box(tube, name), LOW[name] * decay, HIGH[name] * decay)


def heated():
    return clpt.Block(
        "tank",
        update=lambda t, x, u, p: u.q - p.k * x.h,
        states={"h": 1},
        inputs={"q": 1},
        parameters={"k": 1.0},
        units={"h": "m", "q": "m/s", "k": "1/s"},
    )


metre, centimetre = (xr.DataArray(1.0, attrs={"units": unit}) for unit in ("m", "cm"))
per_second, per_hour = (
    xr.DataArray(1.0, attrs={"units": unit}) for unit in ("1/s", "1/h")
)
WRONG_UNITS = [
    ({}, {"h": (metre, centimetre)}, {}),
    ({}, {"h": (centimetre, 2.0)}, {}),
    ({}, {"h": 0}, {"tank.k": (per_second, per_hour)}),
    ({}, {"h": 0}, {"tank.k": (per_hour, 2.0)}),
    ({"q": (over(TIMES, [0, 0, 0], units="cm/s"), 1.0)}, {"h": 0}, {}),
    ({"q": (0.0, over(TIMES, [1, 1, 1], units="cm/s"))}, {"h": 0}, {}),
]


@pytest.mark.parametrize("given", WRONG_UNITS)
def test_another_unit_of_an_end_is_refused(given):
    with pytest.raises(clpt.ClptError, match=r"is in '.*'; must be in"):
        clpt.enclose(heated(), TIMES, *given)


def test_ends_in_the_unit_of_the_model_are_taken():
    given = {"h": (metre, 2 * metre)}, {"tank.k": (per_second, 1.0)}
    given[0]["h"][1].attrs["units"] = "m"
    tube = clpt.enclose(heated(), [0, 1], {"q": 0}, *given)
    check_box(box(tube, "h[0]"), math.exp(-1), 2 * math.exp(-1))


kilometre = xr.DataArray(2.0, attrs={"units": "km"})
TWO_UNITS = {
    "an input": ({"u": (metre, kilometre)}, [0.0], {}),
    "a list": ([(metre, kilometre)], [0.0], {}),
    "Datasets": ((xr.Dataset({"u": metre}), xr.Dataset({"u": kilometre})), [0.0], {}),
    "a port and its signal": (({"u": metre}, {"u[0]": kilometre}), [0.0], {}),
    "a state": ({"u": 0}, {"x": (metre, kilometre)}, {}),
    "a parameter": ({"u": 0}, [0.0], {"m.k": (metre, kilometre)}),
}


@pytest.mark.parametrize("given", TWO_UNITS.values(), ids=TWO_UNITS)
def test_ends_in_two_units_are_refused_where_none_is_declared(given):
    with pytest.raises(clpt.ArgumentError, match="in 'm', its upper end in 'km'; must"):
        clpt.enclose(follows(), [0, 1], *given)


def test_each_end_is_read_alone_where_it_leaves_out_a_state():
    """The state z is from -2 to 0, as simulate takes 0 for what a mapping leaves out."""
    model = clpt.Block(
        "m", update=lambda t, x, u, p: {"x": -x.x, "z": -x.z}, states={"x": 1, "z": 1}
    )
    tube = clpt.enclose(model, [0, 1], None, ({"x": -1, "z": -2}, {"x": 1}))
    low, high = box(tube, "z[0]")
    assert -2 * math.exp(-1) - 1e-9 <= low <= -2 * math.exp(-1)
    assert 0 <= high < 1e-9
    with pytest.raises(clpt.ArgumentError, match=r"z\[0\]: .* lower <= upper"):
        clpt.enclose(model, [0, 1], None, ({"x": -1, "z": 5}, {"x": 1}))


# --- inputs --------------------------------------------------------------------------------------


def integral():
    """Return x0' = a, x1' = b."""
    return clpt.Block(
        "m",
        update=lambda t, x, u, p: [u.d[0], u.d[1]],
        states={"x": 2},
        inputs={"d": 2},
    )


def follows():
    return clpt.Block(
        "m",
        update=lambda t, x, u, p: p.k * u.u,
        states={"x": 1},
        inputs={"u": 1},
        parameters={"k": 1.0},
    )


ramp = over([0, 0.5, 1.0, 1.5, 2.0], [0, 0.5, 1.0, 1.5, 2.0])  # integral t^2/2
falling = over([2.0, 1.0, 0.0], [2.1, 1.1, 0.1])  # the line above the ramp, backwards
series = pd.Series([0.0, 2.0], index=[0.0, 2.0])
response = control.TimeResponseData(
    [0.0, 2.0], [[0.1, 2.1]], output_labels=["u"], issiso=False
)
table = pd.DataFrame({"time": [0.0, 1.5, 3.0], "u": [0.1, 1.6, 3.1]})
INPUTS = {
    "times of its own": {"u": (ramp, ramp + 0.1)},
    "other times of each end": {"u": (ramp, falling)},
    "Series": {"u": (series, series + 0.1)},
    "Series and DataArray": {"u": (series, falling)},
    "samples of the run, and labels": {"u": ([0.0, 0.5, 1.0], falling)},
    "Datasets": (xr.Dataset({"u": ramp}), xr.Dataset({"u": falling})),
    "a Dataset and a response": (xr.Dataset({"u": ramp}), response),
    "a dict and a table": ({"u": ramp}, table),
    "responses": (
        control.TimeResponseData(
            [0.0, 2.0], [[0.0, 2.0]], output_labels=["u"], issiso=False
        ),
        response,
    ),
    "a list of a pair": [(ramp, falling)],
    "a table with names and a dict": (
        pd.DataFrame({"u": [0.0, 2.0]}, index=[0.0, 2.0]),
        {"u": falling},
    ),
    "tables with names": (
        pd.DataFrame({"u": [0.0, 2.0]}, index=[0.0, 2.0]),
        table.set_index("time"),
    ),
}


@pytest.mark.parametrize("inputs", INPUTS.values(), ids=INPUTS)
def test_inputs_are_those_of_their_times(inputs):
    tube = clpt.enclose(follows(), TIMES, inputs, [0.0])
    check_box(box(tube, "x[0]"), 0.5, 0.6)
    low, high = box(tube, "x[0]", 1)  # within a step, whose noise it has
    assert 0.07 < low <= 0.125
    assert 0.175 <= high < 0.23


def test_equal_ends_with_other_times_may_differ_by_rounding():
    low, high = (over(at, at) for at in ([0, 0.1, 0.3, 1.0], [0, 0.7, 1.0]))
    tube = clpt.enclose(follows(), TIMES, {"u": (low - 0.3, high - 0.3)}, [0.0])
    check_box(box(tube, "x[0]"), 0.2, 0.2, 1e-13)


def test_times_are_those_of_the_lower_end_if_none_are_given():
    tube = clpt.enclose(follows(), None, {"u": (ramp, falling)}, [0.0])
    assert tube.time.values.tolist() == [0, 0.5, 1.0, 1.5, 2.0]
    check_box(box(tube, "x[0]"), 2.0, 2.2)


def test_dates_count_from_those_of_the_lower_end():
    days = over(DATES, [1.0, 1.0, 1.0])
    tube = clpt.enclose(follows(), None, {"u": (days, days + 1)}, [0.0])
    check_box(box(tube, "x[0]"), 2 * DAY, 4 * DAY)
    later = days.assign_coords(time=DATES + np.timedelta64(1, "D"))
    with pytest.raises(clpt.ClptError, match="begins at 2026-01-02"):
        clpt.enclose(follows(), [0, DAY], {"u": (days, later)}, [0.0])
    tube = clpt.enclose(follows(), DATES[1:], {"u": (later - 1, days)}, [0.0])
    check_box(box(tube, "x[0]"), 0.0, DAY)


def test_an_input_jumps_at_a_time_of_its_own():
    """0 until 0.25, then 1; the upper end is 1 higher and has other times."""
    low = over([0, 0.25, 0.25, 2], [0.0, 0.0, 1.0, 1.0])
    high = over([0, 0.125, 0.25, 0.25, 2], [1.0, 1.0, 1.0, 2.0, 2.0])
    tube = clpt.enclose(follows(), [0, 0.25, 1.0], {"u": (low, high)}, [0.0])
    check_box(box(tube, "x[0]"), 0.75, 1.75)
    check_box(box(tube, "x[0]", 1), 0.0, 0.25)


def test_a_number_and_samples_take_the_largest_width():
    """From 0 to t: the box takes the width 1 at all times, so 1 in the integral."""
    tube = clpt.enclose(follows(), [0, 1], {"u": (0, over([0, 1], [0, 1]))}, [0.0])
    low, high = box(tube, "x[0]")
    assert -0.26 < low <= 0.0
    assert 0.5 <= high < 0.76


jump = over([0.0, 1.0, 1.0], [1.0, 1.0, -9.0])
AT_THE_END = {  # dt, the input and the output at 1, x(1) + u(1)
    "labels": (0, {"u": jump}, 1 - 9),
    "a repeated time": (0, {"u": [1.0, 1, 1, -9]}, 1 - 9),
    "a pair": (0, {"u": (jump, 2.0)}, 1 - 9),
    "a map": (0.5, {"u": jump}, 2 - 9),
    "a map of a pair": (0.5, {"u": (jump, 2.0)}, 2 - 9),
}


@pytest.mark.parametrize("given", AT_THE_END.values(), ids=AT_THE_END)
def test_the_last_box_is_after_a_jump_of_an_input(given):
    dt, inputs, value = given
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: x.x + u.u if dt else u.u,
        **{"states": {"x": 1}, "inputs": {"u": 1}, "outputs": {"a": 1}, "dt": dt},
        output=lambda t, x, u, p: {"a": x.x + u.u},
    )
    times = [0, 0.5, 1, 1] if isinstance(inputs["u"], list) else TIMES
    tube = clpt.enclose(model, times, inputs, [0.0])
    low, high = box(tube, "a[0]")
    assert low - 1e-9 <= value <= high + 1e-9
    if not isinstance(inputs["u"], tuple):
        assert high - low < 1e-9


LATER = {  # an input, and whether boxes may hold for ever
    "varies later": ({"u": over([0, 1, 2], [0, 0, 90])}, False),
    "varies later in one end": ({"u": (0, over([0, 1, 2], [0, 0, 90]))}, False),
    "is constant": ({"u": over([0, 1, 2], [0, 0, 0])}, True),
}


@pytest.mark.parametrize("dt", [0, 0.5])
@pytest.mark.parametrize(("inputs", "is_kept"), LATER.values(), ids=LATER)
def test_boxes_do_not_hold_for_ever_if_an_input_varies_after_the_run(
    dt, inputs, is_kept
):
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: u.u + (0.5 * x.x if dt else -x.x),
        **{"states": {"x": 1}, "inputs": {"u": 1}, "dt": dt},
    )
    tube = clpt.enclose(model, TIMES, inputs, [(-1.0, 1.0)])
    assert ("hold for ever" in tube.message) == is_kept


def test_ports_of_an_input_are_read_by_name():
    low = xr.DataArray(
        [[4.0], [2.0]], dims=("s", "time"), coords={"s": ["d[1]", "d[0]"], "time": [0]}
    )
    low = low.isel(time=0, drop=True)
    tube = clpt.enclose(integral(), [0, 1], {"d": (low, low[::-1] + 1)}, [0.0, 0.0])
    check_box(box(tube, "x[0]"), 2.0, 3.0)
    check_box(box(tube, "x[1]"), 4.0, 5.0)


@pytest.mark.parametrize("dt", [0.5, 0.25])
def test_a_map_reads_its_inputs_at_its_steps(dt):
    """x+ = x + u, u from t to t + 1: the sums of t, and the number of steps more."""
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: x.x + u.u,
        states={"x": 1},
        inputs={"u": 1},
        dt=dt,
    )
    high = over([0.0, 2.0], [1.0, 3.0])
    tube = clpt.enclose(model, [0, 1], {"u": (ramp, high)}, [0.0])
    total = sum(dt * k for k in range(round(1 / dt)))
    check_box(box(tube, "x[0]"), total, total + round(1 / dt))


# --- parameters ----------------------------------------------------------------------------------


def test_array_parameters_and_labelled_numbers():
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: -p.k * x.x,
        states={"x": 2},
        parameters={"k": np.ones(2)},
    )
    tube = clpt.enclose(model, [0, 1], None, [1, 1], {"m.k": ([1, 2], [1, 2.001])})
    check_box(box(tube, "x[0]"), math.exp(-1), math.exp(-1))
    check_box(box(tube, "x[1]"), math.exp(-2.001), math.exp(-2), 1e-5)
    labels = rows([2.0, 1.0], "x[1]", "x[0]")
    for pair in ((labels, labels), ([1, 2], labels), (labels, [1, 2])):
        with pytest.raises(clpt.BlockError, match=r"m\.k = .*without NaN or labels"):
            clpt.enclose(model, [0, 1], None, [1, 1], {"m.k": pair})


# --- what is refused -----------------------------------------------------------------------------

REFUSED = {  # inputs, initial states and params; words of the sentence
    "ends that cross by labels": (None, {"x": ([1.0, 3.5], low_rows)}, {}, r"x\[1\]: "),
    "an array that crosses": (None, {"x": ([1, 3], [2, 2])}, {}, "lower <= upper"),
    "labels of no state": (
        None,
        {"x": (low_rows, rows([1, 2], "x[0]", "y"))},
        {},
        "there is no y",
    ),
    "a label that is missing": (
        None,
        {"x": (low_rows, rows([3.0], "x[0]"))},
        {},
        r"no signal 'x\[1\]'",
    ),
    "a state that a Dataset leaves out": (
        None,
        (LOW, xr.Dataset({"x[0]": 4.0})),
        {},
        r"no signal 'x\[1\]'",
    ),
    "times of a state": (None, {"x": (low_rows, ramp)}, {}, "values over time"),
    "NaN": (None, {"x[0]": (0.0, math.nan)}, {}, "a finite width"),
    "NaN with a label": (None, {"x[0]": (xr.DataArray(math.nan), 1)}, {}, "finite"),
    "inf": (None, {"x[0]": (0, math.inf)}, {}, "a finite width"),
    "inf with labels": (None, {"x": ([0, 0], low_rows * math.inf)}, {}, "finite"),
    "complex": (None, {"x[0]": (0, 1j)}, {}, "must be an array of numbers"),
    "complex with labels": (None, {"x": (low_rows * 1j, low_rows)}, {}, "of numbers"),
    "a text": (None, {"x[0]": ("0", "1")}, {}, "must be an array of numbers"),
    "None": (None, {"x[0]": (0, None)}, {}, "one shape"),
    "a dict for an array": (
        None,
        {"x": (LOW, HIGH)},
        {},
        "must be an array of numbers",
    ),
    "pairs in ends": (None, ({"x": (0, 1)}, HIGH), {}, "may be two pairs"),
    "three ends": (None, {"x[0]": (0, 1, 2)}, {}, "finite number;"),
    "params that cross": (None, {"x": [0, 0]}, {"m.k": (per_second * 2, 1)}, "k: must"),
    "NaN of a param": (None, {"x": [0, 0]}, {"m.k": (1, math.nan)}, "a finite width"),
    "a dict of a param": (
        None,
        {"x": [0, 0]},
        {"m.k": (LOW, HIGH)},
        "must be a number",
    ),
    "pairs in a param": (None, {"x": [0, 0]}, {"m.k": [(1, 2)]}, "within an array"),
}


@pytest.mark.parametrize("given", REFUSED.values(), ids=REFUSED)
def test_an_end_is_refused_as_a_value_is(given):
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: -p.k * x.x,
        states={"x": 2},
        parameters={"k": 1.0},
    )
    *arguments, words = given
    with pytest.raises(clpt.ClptError, match=words):
        clpt.enclose(model, [0, 1], *arguments)


def test_a_param_that_is_no_place_of_the_record_has_no_interval():
    model = control.nlsys(
        lambda t, x, u, p: [-p["w"][0] * x[0]],
        **{"states": ["a"], "inputs": 0, "outputs": ["a"], "name": "n"},
        params={"w": np.array([1.0, 2.0])},
    )
    one = control.step_response(control.ss(-1, 1, 1, 0), [0, 1]).outputs
    with pytest.raises(clpt.SimulationError, match="takes no interval of w"):
        clpt.enclose(model, [0, 1], None, [1], {"w": (0 * one + 2, 0 * one + 1)})


REFUSED_INPUTS = {
    "times that end early": ((ramp, over([0, 0.5], [1, 1])), "are from 0 to 0.5"),
    "ends that cross by times": ((ramp, over([0, 1], [1, 0])), "u.* lower <= upper"),
    "gaps": ((ramp, over([0, 1, 2], [1, math.nan, 3])), "must be finite"),
    "texts as times": ((ramp, over(["a", "b"], [1, 1])), "."),
    "samples without times": ((ramp, xr.DataArray([1, 2], dims="time")), "2 samples"),
    "other numbers of samples": (([0.0, 0.0, 0.0], [1.0, 1.0]), "one shape"),
}


@pytest.mark.parametrize("given", REFUSED_INPUTS.values(), ids=REFUSED_INPUTS)
def test_an_end_of_an_input_is_refused_as_a_value_is(given):
    pair, words = given
    with pytest.raises(clpt.ClptError, match=words):
        clpt.enclose(follows(), TIMES, {"u": pair}, [0.0])


# --- outputs without bounds ----------------------------------------------------------------------


def test_an_output_without_a_bound_is_named_and_takes_no_other():
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: -x,
        states={"x": 1},
        outputs={"line": 1, "ratio": 1, "log": 1, "both": 1},
        output=lambda t, x, u, p: {
            "line": 2 * x.x + 1,
            "ratio": 1 / x.x,
            "log": np.log(x.x),
            "both": np.where(x.x > 2, 1 / x.x, np.log(x.x + 2)),
        },
    )
    tube = clpt.enclose(model, [0, 1], None, [(-0.5, 1.0)])
    decay = math.exp(-1)
    check_box(box(tube, "line[0]"), 1 - decay, 1 + 2 * decay)
    check_box(box(tube, "x[0]"), -0.5 * decay, decay)
    for name, why in (("ratio[0]", "a divisor may be 0"), ("log[0]", "logarithm")):
        assert np.isnan(box(tube, name)).all()
        sentence = tube.message.partition(f"; {name} has no box at some times, as ")[2]
        assert why in sentence.partition(";")[0]
    whose = "of all states and outputs but ratio[0], log[0], both[0] "
    assert f"lies within the boxes {whose}to t = 1" in tube.message
    assert f"the `over_` boxes {whose}up to then hold for ever" in tube.message


def test_an_output_that_is_lost_later_has_its_first_boxes():
    """1/(x - 1) of x from 3 + 3.1 to 0: the divisor is 0 at log 3."""
    model = clpt.Block(
        "m",
        update=lambda t, x, u, p: -x,
        states={"x": 1},
        outputs={"y": 1, "s": 1},
        output=lambda t, x, u, p: {"y": 1 / (x.x - 1), "s": np.sign(x.x - 1)},
    )
    tube = clpt.enclose(model, [0, 0.5, 1.1, 2], None, [(3.0, 3.1)])
    values = [3 * math.exp(-0.5), 3.1 * math.exp(-0.5)]
    check_box(box(tube, "y[0]", 1), *sorted(1 / (x - 1) for x in values), 0.05)
    assert np.isnan(box(tube, "y[0]", 2)).all()
    low, high = (1 / (x * math.exp(-2) - 1) for x in (3.1, 3.0))
    check_box(box(tube, "y[0]", 3), low, high, 0.1)
    check_box(box(tube, "s[0]", 2), -1, 1)
    assert "but y[0] to t" in tube.message
