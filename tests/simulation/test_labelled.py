"""Labels of xarray, pandas and responses decide, never positions; closed forms are right."""

import datetime

import control
import numpy as np
import pandas as pd
import pytest
import xarray

import clpt_control as clpt

TIMES, OWN = np.linspace(0.0, 2.0, 5), np.linspace(0.0, 4.0, 9)
DATA = xarray.Dataset({"b": ("time", 0 * OWN + 10), "a": ("time", OWN)}, {"time": OWN})
TABLE = pd.DataFrame({"b": DATA.b.values, "a": OWN}, index=OWN)
NAMED = xarray.DataArray(
    [DATA.b, DATA.a], {"signal": ["b", "a"], "time": OWN}, ("signal", "time")
)
RIGHT = np.array([TIMES**2 / 2, 10 * TIMES]).T  # integrals of t and 10
DATES = np.datetime64("2024-05-01T12:00:00", "ns") + (OWN * 1e9).astype("m8[ns]")
DATED, SPANS = DATA.assign_coords(time=DATES), DATA.assign_coords(time=DATES - DATES[0])
RESPONSE = control.TimeResponseData(
    OWN, NAMED.values, output_labels=["b", "a"], issiso=False
)


def integrators(inputs=("a", "b")):
    n = len(inputs)
    states = [f"q{name}" for name in inputs]
    return control.ss(
        *(np.zeros((n, n)), np.eye(n), np.eye(n), 0),
        inputs=[*inputs],
        states=states,
        outputs=states,
        name="m",
    )


@pytest.mark.parametrize(
    "inputs",
    [
        DATA,
        DATA.isel(time=slice(None, None, -1)),
        {"a": DATA.a, "b": 10.0},
        {"a": TIMES, "b": DATA.b},
        [DATA.a, 10.0],
        NAMED,
        NAMED.T[::-1],
        TABLE,
        TABLE.T,
        TABLE[::-1],
        TABLE.rename_axis("time").reset_index(),
        RESPONSE,
        DATED,
        DATED.to_dataframe(),
        DATED.to_dataframe().reset_index(),
        {"a": SPANS.a[::-1], "b": DATA.b},
        {"a": DATED.a, "b": TIMES * 0 + 10},
        {"a": xarray.DataArray(OWN, {"time": ("sample", OWN)}, "sample"), "b": 10},
        DATA.assign_coords(
            time=("time", OWN, {"units": "seconds"}), depth=("time", OWN)
        ),
    ],
)
def test_inputs_are_read_at_their_own_times_and_by_name(inputs):
    run = clpt.simulate(integrators(), TIMES, inputs)
    np.testing.assert_allclose(run.states, RIGHT, atol=1e-7)
    found = clpt.prepare(integrators(), TIMES)(inputs=inputs)
    np.testing.assert_allclose(found.states, RIGHT, atol=1e-7)


@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        (DATA.assign(c=DATA.a), "has no input 'c'"),
        (DATA.rename(a="aa"), "has no input 'aa'. Did you mean 'a'"),
        (DATA[["a"]], "has no signal 'b', but a"),
        (pd.Series({"b": 1.0}), "has no signal 'a', but b"),
        (DATA.isel(time=slice(3)), "from 0 to 1. Give timepts within"),
        (DATA.isel(time=[0]), "from 0 to 0. Give timepts within"),
        (DATA.isel(time=[]), "must be numbers, or dates"),
        (DATA.isel(time=[1, 0, *range(2, 9)]), "must be finite and in order"),
        (DATA.where(DATA.time != 1.0), "must be finite"),
        (DATA.assign_coords(time=("time", OWN, {"units": "ms"})), "are in 'ms', those"),
        ({"a": DATED.a, "b": DATA.b}, "dates and numbers"),
        ({"a": DATED.a, "b": DATED.b[1:]}, "begins at 2024-05-01T12:00:00.5"),
        (TABLE.set_axis(pd.DatetimeIndex(DATES, tz="UTC")), "without a time zone"),
        (TABLE.set_axis(range(1, 10)), "call them time"),
        (TABLE.rename_axis("depth"), "labels of depth are no names"),
        (TABLE.set_axis(pd.MultiIndex.from_product([range(3)] * 2)), "are no names"),
        (TABLE.set_axis(["a", "a"], axis=1), "given twice"),
        (TABLE.astype(str), "has texts. Give numbers"),
        ({"a": "4"}, "must be an array of numbers"),
        ([NAMED, 0.0], "Give a dict by name"),
        ({"a": NAMED}, "there is no b. Did you mean 'a'|It has a"),
        ({"a": DATA.a.expand_dims(i=2, k=2)}, "several dimensions of signals"),
        ({"a": 1.0, "m.a": 2.0}, "has no input 'm.a'"),
    ],
)
def test_labels_that_contradict_are_refused(inputs, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.simulate(integrators(), TIMES, inputs)


def test_units_that_differ_are_refused():
    block = clpt.Block(
        "v",
        update=lambda t, x, u, p: u,
        inputs={"a": 1},
        states={"s": 1},
        units={"a": "m/s"},
    )
    plain = control.nlsys(lambda t, x, u, p: u, inputs="a", states="s", name="n")
    plain.units = {"a": "m/s"}
    for system in (block, clpt.connect([block], "a"), plain):
        run = clpt.simulate(system, TIMES, {"a": DATA.a.assign_attrs(units="m s-1")})
        np.testing.assert_allclose(run.states[:, 0], RIGHT[:, 0], atol=1e-7)
        with pytest.raises(clpt.ArgumentError, match="is in 'km/h'; must be in 'm/s'"):
            clpt.simulate(system, TIMES, {"a": DATA.a.assign_attrs(units="km/h")})


def test_a_jump_among_other_times():
    jump = xarray.DataArray([0.0, 0, 1, 1], {"time": [0.0, 1, 1, 4]}, "time")
    run = clpt.simulate(integrators(), TIMES, {"b": jump, "a": DATA.a})
    right = np.array([RIGHT[:, 0], [0, 0, 0, 0.5, 1]]).T
    np.testing.assert_allclose(run.states, right, atol=1e-7)


def test_states_by_name_and_ports_by_number():
    start = pd.Series({"qb": 1.0, "qa": 2.0})
    state = xarray.DataArray(start.values, {"state": start.index}, "state")
    for given in (start, state, {**start}):
        run = clpt.simulate(integrators(), [0, 1], 0, given)
        assert run.states.values[0].tolist() == [2, 1]
        text = clpt.export(integrators(), initial_state=given)
        assert "= {2.0, 1.0}" in text
    swapped = integrators(["c[1]", "d", "c[0]"])
    c = xarray.DataArray([OWN, 0 * OWN + 10], {"time": OWN}, ("k", "time")).T
    run = clpt.simulate(swapped, TIMES, {"c": c})
    np.testing.assert_allclose(run.states[:, [2, 0]], RIGHT, atol=1e-7)


def test_a_fit_reads_measurements_at_their_own_times():
    decay = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0] + u[0]],
        inputs="u",
        outputs="y",
        states="y",
        params={"k": 1.0},
        name="decay",
    )
    fine = np.linspace(0, 4, 401)
    force = xarray.DataArray(np.sin(fine), {"time": fine}, "time")
    y = clpt.simulate(decay, OWN, {"u": force}, [1.0], params={"k": 0.7}).y
    for timepts, inputs in (
        (None, {"u": force}),
        (fine, np.sin(fine)),
        (2 * OWN, force),
    ):
        for data in ({"y": y}, {"y": y[::-1]}, y.to_dataset(name="y")):
            found = clpt.fit_parameters(
                *(decay, data, {"k": 1.0}, timepts, inputs), initial_state=[1.0]
            )
            assert abs(found.values["k"] - 0.7) < 1e-7
    for timepts in (fine[:9], fine + 100):
        with pytest.raises(clpt.SimulationError, match="data are from 0 to 4"):
            clpt.fit_parameters(decay, {"y": y}, {"k": 1.0}, timepts, force)
    for name in ("yy", "z"):
        data = xarray.Dataset({"y": y, name: y})
        with pytest.raises(clpt.ArgumentError, match=f"{name} is not an output"):
            clpt.fit_parameters(decay, data, {"k": 1.0}, None, {"u": force})
    column = xarray.Dataset({"y": y, "u": ("time", OWN)})  # and one of an input
    run = clpt.simulate(decay, OWN, {"u": force}, [1.0], params={"k": 0.7})
    for data in (column, run):
        found = clpt.fit_parameters(
            decay, data, {"k": 1.0}, None, {"u": force}, initial_state=[1.0]
        )
        assert abs(found.values["k"] - 0.7) < 1e-7


def test_dates_count_from_the_first_of_timepts():
    later = {"a": DATED.a, "b": DATED.b[1:]}
    right = np.array([OWN[2:7] ** 2 / 2 - 0.5, 10 * (OWN[2:7] - 1)]).T
    run = clpt.simulate(integrators(), DATES[2:7], later)
    np.testing.assert_allclose(run.states, right, atol=1e-7)
    assert run.time.values.tolist() == TIMES.tolist()
    again = clpt.prepare(integrators(), DATED.time[2:7])(inputs=later)
    np.testing.assert_allclose(again.states, right, atol=1e-7)


def test_a_timedelta_is_in_the_unit_of_the_scenario():
    hours = clpt.paper_scenario().with_values({"units.time": "h", "run.duration": 5})
    learner, track = (
        clpt.closed_loop(hours, external="x"),
        clpt.simulate(hours).position,
    )
    right = clpt.simulate(learner, track.time, {"x": track}).states
    spans = track.assign_coords(time=pd.to_timedelta(track.time.values, unit="h"))
    found = clpt.simulate(learner, track.time, {"x": spans.T[::-1]}).states
    np.testing.assert_allclose(found, right, atol=1e-9)
    seconds = track.assign_coords(time=("time", track.time.values, {"units": "s"}))
    with pytest.raises(clpt.ArgumentError, match="are in 's', those of the run in 'h'"):
        clpt.simulate(learner, track.time, {"x": seconds})


def test_signals_are_counted_from_0_and_those_of_the_paper_from_1():
    swapped = integrators(["c[1]", "c[0]"])
    for dim, labels in (("axis", [2, 1]), ("basis", [2, 1]), ("k", [1, 0])):
        c = xarray.DataArray(
            [0 * OWN + 10, OWN], {dim: labels, "time": OWN}, (dim, "time")
        )
        run = clpt.simulate(swapped, TIMES, {"c": c})
        np.testing.assert_allclose(run.states[:, ::-1], RIGHT, atol=1e-7)
    three = clpt.simulate(integrators(["c[0]", "c[1]", "c[2]"]), TIMES)
    others = three.qc.rename(qc_index="c_index").isel(c_index=[2, 1])
    counts = [c.assign_coords(k=labels) for labels in ([3, 7], [2, 1])]
    for named in (*counts, c.rename(k="member"), c.rename(k="axis"), others):
        with pytest.raises(clpt.ArgumentError, match="need not count signals"):
            clpt.simulate(swapped, TIMES, {"c": named})
    with pytest.raises(clpt.ArgumentError, match=r"c\[0\]'\]: is given twice"):
        clpt.simulate(swapped, TIMES, {"c": 1.0, "c[0]": 2.0})


@pytest.mark.parametrize("start", [RESPONSE, DATA, TABLE, TABLE.a])
def test_a_start_is_of_one_time(start):
    with pytest.raises(clpt.SimulationError, match="of one time"):
        clpt.simulate(integrators(), TIMES, 0, start)
    assert clpt.simulate(integrators(), TIMES, 0, {"qa": DATA.a[2]}).qa[0] == 1.0


def test_one_trace_of_a_response():
    r = control.step_response(
        control.ss(-np.eye(2), np.eye(2), np.eye(2), 0, outputs=["a", "b"]),
        np.linspace(0, 2, 2001),
    )
    with pytest.raises(clpt.SimulationError, match="has 2 traces") as error:
        clpt.simulate(integrators(), TIMES, r)
    one = eval(str(error.value).partition("Give one: ")[2])
    run = clpt.simulate(integrators(), TIMES, one)
    np.testing.assert_allclose(run.qa, TIMES - 1 + np.exp(-TIMES), atol=1e-6)
    assert not run.qb.any()


def test_dates_of_a_fit():
    y = np.exp(-0.7 * OWN) * 3
    decay = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0] + u[0] - t],
        inputs="u",
        outputs="y",
        states="y",
        params={"k": 1.0},
        name="decay",
    )
    data = pd.DataFrame({"y": y, "when": DATES}).set_index("when")
    ramp = xarray.DataArray(
        [-1.0, 5.0], {"time": DATES[0] + np.array([-1, 5], "m8[s]")}, "time"
    )
    begin, start = {"k": 1.0}, {"y": 3.0}
    found = clpt.fit_parameters(decay, data, begin, DATES, {"u": ramp}, start)
    assert abs(found.values["k"] - 0.7) < 1e-7
    with pytest.raises(clpt.SimulationError, match="Give timepts as dates"):
        clpt.fit_parameters(decay, data, begin, None, {"u": ramp}, start)
    ramp = ramp.assign_coords(time=[-1.0, 5.0])
    with pytest.raises(clpt.SimulationError, match="dates and numbers"):
        clpt.fit_parameters(decay, data, begin, None, {"u": ramp}, start)
    found = clpt.fit_parameters(
        decay, {"y": pd.Series(y, OWN)}, begin, None, ramp, start
    )
    assert abs(found.values["k"] - 0.7) < 1e-7


@pytest.mark.parametrize("value", ["4", None, pd.Series([4.0])])
def test_a_parameter_is_a_number_without_labels(value):
    lag = clpt.Block(
        "lag",
        update=lambda t, x, u, p: -p.k * x.y,
        states={"y": 1},
        parameters={"k": 1.0},
    )
    plain = control.nlsys(
        lambda t, x, u, p: -p["k"] * x,
        inputs=0,
        states="y",
        params={"k": 1.0},
        name="p",
    )
    for system, key in ((lag, "lag.k"), (plain, "k"), (clpt.connect([plain]), "p.k")):
        for verb in (clpt.simulate, clpt.prepare):
            with pytest.raises(clpt.ClptError, match="must be a number"):
                verb(system, TIMES, params={key: value})
        run = clpt.simulate(system, TIMES, 0, 1.0, {key: xarray.DataArray(0.5)})
        np.testing.assert_allclose(run.states[:, 0], np.exp(-TIMES / 2), atol=1e-7)


def test_labelled_operating_points_and_members():
    plant = control.nlsys(
        lambda t, x, u, p: [x[0] * x[1], x[1] ** 2 + u[0]],
        inputs="u",
        states=["states", "b"],
        name="plant",
    )
    A = clpt.linearize(plant, pd.Series({"b": 1.0, "states": 2.0})).A
    assert A.tolist() == [[1, 2], [0, 2]]
    for table in (pd.DataFrame({"u": [1.0, 2.0]}), DATA[["a"]]):
        with pytest.raises(clpt.ScenarioError, match="table of members is no grid"):
            clpt.run_ensemble(plant, table, timepts=TIMES)


def test_inputs_and_states_in_any_order():
    """Equations, linearization, check and proof of signals that are numbered backwards."""
    plant = control.nlsys(
        lambda t, x, u, p: [-x[0] + u[0] * u[2], -2 * x[1] - x[1] ** 3 + 3 * u[1]],
        lambda t, x, u, p: [x[0], x[1]],
        inputs=["c[1]", "d", "c[0]"],
        outputs=["y[1]", "y[0]"],
        states=["q[1]", "q[0]"],
        name="plant",
    )
    assert str(clpt.equations(plant)).split("\n")[:2] == [
        "q[1]' = -q[1] + c[0](t)*c[1](t)",
        "q[0]' = -q[0]**3 - 2*q[0] + 3*d(t)",
    ]
    B = clpt.linearize(plant, u={"c": [2.0, 5.0]}).B
    assert B.tolist() == [[2, 0, 5], [0, 3, 0]]
    assert clpt.check(plant).ok
    assert repr(clpt.lyapunov(plant)).startswith("<Verdict proved")


def test_two_times_get_a_note():
    note = "two samples"
    assert note in clpt.simulate(integrators(), (0, 10)).attrs["message"]
    assert note not in clpt.simulate(integrators(), (0, 5, 10)).attrs["message"]


@pytest.mark.parametrize(
    "value",
    [
        pd.Series([5.0, 7.0], index=[1, 0]),
        pd.Series({"qb": 5.0, "qa": 7.0}),
        xarray.DataArray([5.0, 7.0], {"k": [1, 0]}, "k"),
    ],
)
def test_members_of_ensembles_have_no_labels(value):
    plant = integrators(["c[1]", "c[0]"])
    with pytest.raises(clpt.ScenarioError, match="a list of values without labels"):
        clpt.run_ensemble(plant, {"c": [value]}, timepts=TIMES)
    run = clpt.run_ensemble(plant, {"c": [value.to_numpy()]}, timepts=TIMES)
    assert run.qc_final.values.ravel() == pytest.approx([10, 14])
    with pytest.raises(clpt.ArgumentError, match="without labels"):
        clpt.simulate(plant, TIMES, {"c": [value, value]})


def test_names_beside_a_dimension():
    """Texts in a coordinate along a dimension are names, as those of its own index."""
    kinds = {"signal": ("i", ["b", "a"]), "i": [0, 1]}
    for names in ({"signal": kinds["signal"]}, kinds):
        given = xarray.DataArray([10.0, 3.0], names, "i")
        run = clpt.simulate(integrators(), TIMES, given)
        right = np.array([3 * TIMES, 10 * TIMES]).T
        np.testing.assert_allclose(run.states, right, atol=1e-7)
        start = given.assign_coords(signal=("i", ["qb", "qa"]))
        assert clpt.simulate(integrators(), TIMES, 0, start).qa[0] == 3.0
    marked = DATA.assign_coords(quality=("time", ["good"] * 9))
    run = clpt.simulate(integrators(), TIMES, marked)
    np.testing.assert_allclose(run.states, RIGHT, atol=1e-7)


def test_named_values_in_a_list_stand_at_their_places():
    run = clpt.simulate(integrators(), TIMES, 0, [1.0, 2.0]).isel(time=0, drop=True)
    for start in ([run.qb, run.qa], [run.qb, 0.0], run.qb, run.qa):
        with pytest.raises(clpt.ArgumentError, match="in place of another signal"):
            clpt.simulate(integrators(), TIMES, 0, start)
    again = clpt.simulate(integrators(), TIMES, 0, [run.qa, run.qb])
    assert again.states.values[0].tolist() == [1, 2]
    for inputs in ([TABLE.b, TABLE.a], [DATA.b, 0.0]):
        with pytest.raises(clpt.ArgumentError, match="has 'b' in place of another"):
            clpt.simulate(integrators(), TIMES, inputs)
    renamed = clpt.simulate(integrators(), TIMES, [DATA.a.rename("x"), TABLE.b])
    np.testing.assert_allclose(renamed.states, RIGHT, atol=1e-7)


def test_units_of_params_and_of_timepts():
    plain = control.nlsys(
        lambda t, x, u, p: [-p["k"]], inputs=0, states="y", params={"k": 2.0}, name="n"
    )
    plain.units = {"k": "m/s"}
    block = clpt.Block(
        "n",
        update=lambda t, x, u, p: -p.k,
        states={"y": 1},
        parameters={"k": 2.0},
        units={"k": "m/s"},
    )
    k = xarray.DataArray(3.0, attrs={"units": "m/s"})
    for system, key in ((plain, "k"), (block, "n.k")):
        run = clpt.simulate(system, TIMES, params={key: k})
        np.testing.assert_allclose(run.states[:, 0], -3 * TIMES, atol=1e-9)
        with pytest.raises(clpt.ArgumentError, match="is in 'km/h'; must be in 'm/s'"):
            clpt.simulate(system, TIMES, params={key: k.assign_attrs(units="km/h")})
    minutes = xarray.DataArray(TIMES, dims="time", attrs={"units": "min"})
    inputs = DATA.assign_coords(time=("time", OWN, {"units": "minutes"}))
    run = clpt.simulate(integrators(), minutes, inputs)
    np.testing.assert_allclose(run.states, RIGHT, atol=1e-7)
    inputs.time.attrs["units"] = "s"
    with pytest.raises(
        clpt.ArgumentError, match="are in 's', those of the run in 'min'"
    ):
        clpt.simulate(integrators(), minutes, inputs)
    with pytest.raises(clpt.ArgumentError, match="timepts: its times are in"):
        clpt.simulate(clpt.closed_loop(clpt.paper_scenario()), minutes)


def test_samples_along_a_dimension_without_times_are_those_of_timepts():
    """xarray would number them 0, 1, 2."""
    bare = xarray.Dataset({"a": ("time", 10 * TIMES), "b": ("time", 0 * TIMES + 10)})
    run = clpt.simulate(integrators(), 10 * TIMES, bare)
    np.testing.assert_allclose(run.states, RIGHT * [100, 10], atol=1e-5)
    growth = control.nlsys(
        *(lambda t, x, u, p: p["k"], None),
        inputs=0,
        outputs="a",
        states="a",
        params={"k": 1.0},
        name="growth",
    )
    fit = clpt.fit_parameters(growth, bare[["a"]], {"k": 0.5}, 7 * TIMES)
    assert fit.values["k"] == pytest.approx(10 / 7)
    for times in ([0, 1.5], np.linspace(0, 1, 6)):
        said = (
            f"inputs.*has 5 samples along time without times; timepts has {len(times)}"
        )
        with pytest.raises(clpt.SimulationError, match=said):
            clpt.simulate(integrators(), times, bare)
    for verb in (
        lambda: clpt.simulate(integrators(), None, bare),
        lambda: clpt.fit_parameters(growth, bare[["a"]], {"k": 0.5}),
    ):
        with pytest.raises(clpt.SimulationError, match="without times; timepts has 0"):
            verb()


@pytest.mark.parametrize(
    ("begin", "step"), [(0, 1e-13), (0, 1), (1e6, 0.002), (1.7e9, 1)]
)
def test_outside_is_measured_by_the_run(begin, step):
    """Samples that miss a tenth of a run are refused at any scale; rounding is not."""
    whole = begin + step * np.array([0.0, 10.0])
    for own in (
        begin + step * np.array([0.0, 9.0]),
        begin + step * np.array([1.0, 10.0]),
    ):
        with pytest.raises(clpt.SimulationError, match="Give timepts within"):
            clpt.simulate(integrators("a"), whole, {"a": pd.Series([0.0, 9.0], own)})
    inside = whole - np.array([0.0, 2.0]) * np.spacing(whole[1])
    run = clpt.simulate(integrators("a"), whole, {"a": pd.Series([0.0, 9.0], inside)})
    np.testing.assert_allclose(run.qa[-1], 4.5 * np.ptp(whole), rtol=1e-6)


def test_bounds_are_printed_to_their_last_digits():
    late = pd.Series([0.0, 9.0], [1700000003.25, 1700000010.0])
    with pytest.raises(
        clpt.SimulationError, match=r"1700000003.25 to 1700000010\. Give"
    ):
        clpt.simulate(integrators("a"), [1.7e9, 1.7e9 + 10], {"a": late})


def test_rows_of_responses_stand_at_their_places():
    """python-control keeps the order of labels when rows are selected: by name is not known."""
    source = control.ss(
        *(np.diag([-1.0, -2.0]), np.eye(2), np.eye(2), 0),
        outputs=["b", "a"],
        states=["qb", "qa"],
    )
    r = control.forced_response(source, OWN, np.ones((2, 9)), [2.0, 1.0])
    plant = integrators()
    right = clpt.simulate(plant, OWN, r).states
    picked = {"a": r.outputs["a"], "b": r.outputs["b"]}
    for inputs in (picked, [*picked.values()], np.asarray(r.outputs)[::-1]):
        found = clpt.simulate(plant, OWN, inputs).states
        np.testing.assert_allclose(found, right, atol=1e-6)
    ports = integrators(["c[0]", "c[1]"])
    swapped = control.TimeResponseData(
        OWN, r.outputs, output_labels=["c[1]", "c[0]"], issiso=False
    )
    prepared = clpt.prepare(plant, OWN)
    for verb in (
        lambda: clpt.simulate(plant, OWN, r.outputs),
        lambda: clpt.run_ensemble(plant, {"qa": [0.0]}, timepts=OWN, inputs=r.outputs),
        lambda: clpt.simulate(plant, OWN, 0, r.states[:, 0]),
        lambda: clpt.simulate(ports, OWN, {"c": swapped.outputs}),
        lambda: prepared(inputs=r.outputs),
        lambda: prepared(r.states[:, 0]),
        lambda: clpt.linearize(plant, r.states[:, 0]),
        lambda: clpt.export(plant, initial_state=r.states[:, 0]),
    ):
        with pytest.raises(clpt.ArgumentError, match="in place of another signal"):
            verb()
    same = integrators(["b", "a"])
    given = same, OWN, r.outputs, r.states[:, 0]
    right = clpt.simulate(same, OWN, r, {"qb": 2.0, "qa": 1.0}).states
    np.testing.assert_allclose(clpt.simulate(*given).states, right, atol=1e-6)


def test_times_in_each_form():
    """Lists of dates and responses are times for every verb; texts are not."""
    days = [datetime.datetime(2024, 5, 1, 12), datetime.datetime(2024, 5, 1, 12, 0, 4)]
    plant, right = integrators(), np.array([8.0, 40.0])
    for times in (days, tuple(map(np.datetime64, days)), [*map(pd.Timestamp, days)]):
        run = clpt.simulate(plant, times, DATED)
        np.testing.assert_allclose(run.states[-1], right, atol=1e-7)
    run = clpt.run_ensemble(plant, {"qa": [1.0]}, timepts=RESPONSE, inputs=DATA)
    np.testing.assert_allclose(run.qa_final, 9.0, atol=1e-7)
    run = clpt.prepare(plant, RESPONSE, DATA)()
    np.testing.assert_allclose(run.states[-1], right, atol=1e-7)
    slopes = clpt.sensitivity(plant, RESPONSE, to="qa", inputs=DATA)
    np.testing.assert_allclose(slopes.qa[-1], 1.0, atol=1e-7)
    for empty in ([], (), pd.DatetimeIndex([])):
        with pytest.raises(clpt.ClptError, match="timepts"):
            clpt.simulate(plant, empty, DATA)


def test_reasons_are_the_true_ones():
    texts = [str(day) for day in DATES]
    for table in (TABLE.set_axis(texts), TABLE.set_axis(texts)["a"].to_frame().T):
        with pytest.raises(clpt.ClptError, match=r"not texts\. .* pandas.to_datetime"):
            clpt.simulate(integrators(), TIMES, table)
    clock = integrators(["time"])
    with pytest.raises(clpt.ClptError, match="has no signal 'time', but none"):
        clpt.simulate(clock, TIMES, pd.DataFrame({"time": OWN}, OWN))
    matrix = clpt.Block(
        "mm",
        update=lambda t, x, u, p: {"s": p.K},
        states={"s": 2},
        parameters={"K": np.array([1.0, 2.0])},
    )
    with pytest.raises(
        clpt.ClptError, match=r"an array of shape \(2,\), without NaN or lab"
    ):
        clpt.simulate(matrix, TIMES, params={"mm.K": pd.Series([3.0, 5.0])})


def test_a_response_of_decreasing_times_keeps_its_values_with_its_times():
    """y' = u: the same samples, latest first, as integrated backwards."""
    u = np.linspace(0.0, 3.0, len(TIMES)) ** 2
    back = control.TimeResponseData(
        TIMES[::-1], u[::-1], output_labels=["a"], issiso=True
    )
    plant = integrators(["a"])
    right = clpt.simulate(plant, TIMES, {"a": u}).states.values
    np.testing.assert_allclose(clpt.simulate(plant, TIMES, back).states, right)
    np.testing.assert_allclose(clpt.prepare(plant, TIMES, back)().states, right)


def test_a_series_of_rows_is_a_dict():
    rows = {"a": np.sin(TIMES), "b": np.cos(TIMES)}
    plant = integrators(["a", "b"])
    run = clpt.simulate(plant, TIMES, pd.Series(rows))
    np.testing.assert_allclose(run.states, clpt.simulate(plant, TIMES, rows).states)
