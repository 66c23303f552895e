"""python-control's systems run as they stand: with its params, sizes and starts."""

import warnings

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.errors import BlockError, DiagramError, SimulationError

T = np.linspace(0.0, 2.0, 21)
TIGHT = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}


def against_control(system, inputs=0.0, start=0.0, params=None, close=1e-7, engine="native"):
    """Run a system here and by python-control, and compare all that both return."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        found = clpt.simulate(system, T, inputs, start, params)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its own, of a short start
        asked = control.input_output_response(
            system, T, inputs, start, params=params, solve_ivp_kwargs=TIGHT
        )
    made = np.reshape(np.asarray(asked.outputs), (-1, len(T)))
    ours = np.vstack([np.reshape(one.values.T, (-1, len(T))) for one in found.data_vars.values()])
    np.testing.assert_allclose(ours[: len(made)], made, atol=close * (1.0 + np.abs(made).max()))
    assert found.attrs["engine"] == engine
    return [str(one.message) for one in said]


def autonomous(update, **more):
    """A system of one state and no input."""
    return control.nlsys(update, None, inputs=0, outputs=1, states=1, **more)


def rate(t, x, u, params):
    m = params.get("m", 1.0)
    return np.array([x[1], (u[0] - params["c"] * x[1] - np.sin(x[0])) / m])


def pendulum(**more):
    own = {"inputs": 1, "outputs": 1, "params": {"c": 0.2, "m": 2, "why": "a word"}}
    return control.nlsys(rate, lambda t, x, u, p: x[0], states=2, **own | more)


def test_params_are_python_controls():
    for params in (None, {"m": 1000}, {"m": 3, "why": "another word"}):
        against_control(pendulum(name="a"), np.sin(T), [0.3, 0.0], params)


class Spring:
    """Reads `slack` in one of its ways alone, through a method."""

    def force(self, x, params):
        return params["slack"] * x[0]

    def rate(self, t, x, u, params):
        if params.get("mode", "firm") == "soft":
            return [x[1], -self.force(x, params)]
        return [x[1], -params["c"] * x[0]]


def by_number(t, x, u, params):
    return [x[1], -sum(params.get(f"k{i}", 1.0) * x[0] ** i for i in range(1, 3))]


def all_at_once(t, x, u, params):
    own = {"k": 1.0, **params}
    return [x[1], -own["k"] * x[0]]


def is_text(t, x, u, params):
    return [x[1], -float(f"{x[0]}") * params.get("k", 1.0)]


NAMES = {  # what may be given, and what no function reads
    rate: ([{"m": 2.0}, {"c": 0.1}], ["M", "mm", "typo", "rood.m"]),
    Spring().rate: ([{"slack": 1.0}, {"mode": "soft", "slack": 2.0}], ["slak", "x"]),
    by_number: ([{"k2": 2.0}], ["k3", "l2"]),
    all_at_once: ([{"k": 2.0}, {"any": 1.0}], []),
    is_text: ([{"k": 2.0}, {"any": 1.0}], []),
}


def as_it_is(update):
    return control.nlsys(update, None, inputs=1, outputs=2, states=2, params={"c": 1.0}, name="rod")


def in_a_loop(update):
    back = control.ss([], [], [], [[-1.0, 0.0]], inputs=2, outputs="u[0]", name="back")
    back.set_inputs(["x[0]", "x[1]"])
    rod = as_it_is(update)
    rod.set_outputs(["x[0]", "x[1]"])
    rod.set_inputs(["u[0]"])
    return clpt.connect([rod, back], name="loop")


@pytest.mark.parametrize("made", [as_it_is, in_a_loop])
@pytest.mark.parametrize("update", NAMES, ids=lambda f: f.__name__)
@pytest.mark.filterwarnings("ignore:.*runs in Python")
def test_names_that_functions_read_are_known_and_no_others(update, made):
    known, unknown = NAMES[update]
    system = made(update)
    calls = [
        lambda p: clpt.simulate(system, [0.0, 0.2], 0.0, [0.3, 0.1], params=p),
        lambda p: clpt.linearize(system, [0.3, 0.1], params=p),
    ]
    if made is in_a_loop:
        calls.append(
            lambda p: control.input_output_response(system, [0.0, 0.2], 0.0, [0.3, 0.1], params=p)
        )
    for call in calls:
        for params in known if update is not is_text else ():
            call(params)
        for name in unknown:
            with pytest.raises(BlockError, match=rf"unknown parameter '{name}'.* knows .*c"):
                call({"c": 2.0, name: 1.0})
    for params in known:
        calls[0](params)


def test_an_unknown_name_is_told_from_its_like():
    for name in ("mm", "rood.m"):
        with pytest.raises(BlockError, match=r"did you mean m\? This diagram knows c, m"):
            clpt.simulate(as_it_is(rate), [0.0, 1.0], 0.0, 0.0, params={name: 1.0})
    with pytest.raises(BlockError, match=r"did you mean back\.D\?"):
        clpt.simulate(in_a_loop(rate), [0.0, 1.0], 0.0, 0.0, params={"bak.D": [[1.0, 0.0]]})


def test_names_of_nested_diagrams():
    parts = [in_a_loop(rate).copy(name=name) for name in "ab"]
    outer = control.interconnect(parts, outlist=["a.x[0]"], check_unused=False)
    for name in ("m", "a.m", "b.c", "a.rod.m", "rod.m"):
        clpt.simulate(outer, [0.0, 0.2], 0.0, [0.3, 0.1, 0.2, 0.0], params={name: 2.0})
    for name in ("typo", "a.typo", "c.m", "back"):
        with pytest.raises(BlockError, match=f"unknown parameter '{name}'"):
            clpt.simulate(outer, [0.0, 0.2], 0.0, [0.3, 0.1, 0.2, 0.0], params={name: 2.0})


def test_a_param_under_the_name_of_its_system_is_for_that_one_alone():
    parts = [pendulum(name=name, inputs=["u"], outputs=[f"y{name}"]) for name in "ab"]
    two = control.interconnect(parts, inputs="u", outputs=["ya", "yb"], name="two")
    wired = clpt.connect(parts, external="u")
    around = control.interconnect([two], inputs="u", outputs=["ya", "yb"], name="around")
    a, b = (
        clpt.simulate(pendulum(name="a"), T, 0.3, [0.3, 0.0], params={"m": m}).states.values
        for m in (3.0, 5.0)
    )

    def run(system, params):
        return clpt.simulate(system, T, 0.3, [0.3, 0.0, 0.3, 0.0], params=params).states.values

    named = {"m": 3.0, "b.m": 5.0}
    for system in (two, wired, around):
        for params in (named, dict(reversed(named.items())), {"a.m": 3.0, "b.m": 5.0}):
            np.testing.assert_allclose(run(system, params), np.hstack([a, b]), rtol=1e-6, atol=1e-8)
    for params in ({"two.m": 3.0, "b.m": 5.0}, {"a.m": 3.0, "b.m": 9.0, "two.b.m": 5.0}):
        np.testing.assert_allclose(run(around, params), np.hstack([a, b]), rtol=1e-6, atol=1e-8)
    theirs = control.input_output_response(
        wired, T, 0.3, [0.3, 0.0, 0.3, 0.0], params=named, solve_ivp_kwargs={"rtol": 1e-9}
    )
    np.testing.assert_allclose(theirs.states.T, np.hstack([a, b]), atol=1e-5)
    alone = clpt.run_ensemble(
        parts[0], {"a.m": [3.0]}, timepts=T, inputs=0.3, initial_state=[0.3, 0.0]
    )
    np.testing.assert_allclose(alone.ya_final.values[0], a[-1, 0], rtol=1e-6)


def test_params_reach_nested_diagrams_as_python_control_hands_them_down():
    gain = control.nlsys(
        None, lambda t, x, u, p: p["k"] * (u[0] - u[1]),
        inputs=["r", "y"], outputs=["u"], name="gain", params={"k": 2.0},
    )  # fmt: skip
    plant = pendulum(name="plant", inputs=["u"], outputs=["y"])
    inner = control.interconnect([plant, gain], inputs="r", outputs="y", params={"m": 5.0})
    lag = control.tf([1.0], [0.3, 1.0], inputs="v", outputs="r")
    outer = control.interconnect([inner, lag], inputs="v", outputs="y", params={"k": 3.0})
    for params in (None, {"k": 1.0, "m": 7, "c": 0.0}):
        against_control(outer, np.cos(T), 0.1, params, close=1e-6)


@pytest.mark.parametrize("inputs", [np.vstack([np.sin(T), T]), [np.sin(T), 0.5], [0.5, 2.0]])
def test_sizes_that_a_system_leaves_open(inputs):
    open_ = control.nlsys(lambda t, x, u, p: -x + u[0] * np.array([1.0, 2.0]) + u[-1], None)
    against_control(open_, inputs, [1.0, 0.5])


def test_a_short_start_is_filled_with_zeros():
    against_control(pendulum(), 0.0, [0.4, 0])
    said = against_control(pendulum(), 0.0, np.array([0.4]))
    assert any("filled with zeros" in one for one in said)


def test_a_name_that_is_bound_where_the_run_goes_alone():
    def falls(t, x, u, p):
        if (mass := 1.0 + x[0] ** 2) > 0.0:
            pull = -x[0] / mass
        return [pull]

    def stops(t, x, u, p):
        if x[0] > 0.5:
            pull = -x[0]
        return [pull]

    def planned(t, x, u, p):
        for until, rate in ((0.7, 1.0), (1.3, -0.5), (1e9, 0.2)):
            if t < until:
                return [rate]

    plan = [(0.7, 1.0), (1.3, -0.5), (1e9, 0.2)]

    def next_of(t, x, u, p):
        return [next(rate for until, rate in plan if t < until)]

    against_control(autonomous(falls), 0.0, 1.0)
    for of_time in (planned, next_of):
        found = clpt.simulate(autonomous(of_time), T)
        assert found.engine == "native"
        np.testing.assert_allclose(found.states[-1, 0], 0.7 - 0.3 + 0.14, rtol=1e-11)
    for engine in ("native", "python"):
        with pytest.raises(SimulationError, match=r"0\.693147.*stops, line \d+: UnboundLocalError"):
            clpt.simulate(autonomous(stops), T, 0.0, 1.0, engine=engine)


def test_feedback_that_python_control_makes():
    plant = control.ss([[0.0, 1.0], [-1.0, -0.2]], [[0.0], [1.0]], np.eye(2), 0, name="plant")
    gains = [np.array([[1.0, 1.5]]), np.array([[3.0, 2.5]])]
    for method, points, inputs, start in (
        ("linear", [-1.0, 1.0], 0.5 * np.sin(T), 0.1),
        ("nearest", [[-1.0, 0.0], [1.0, 0.0]], 0.2 * np.sin(T) - 1.0, -1.0),
    ):
        by = {"gainsched_indices": [*range(np.ndim(points))], "gainsched_method": method}
        _, loop = control.create_statefbk_iosystem(plant, (gains, points), **by)
        against_control(loop, [inputs, 0.0, 0.0], [start, 0.0], close=1e-6)


class Counter:
    calls = 0

    def rate(self, t, x, u, p):
        self.calls += 1
        return -x * (1.0 if self.calls % 2 else 1.0 + 1e-12)


def test_what_cannot_be_read_runs_in_python_with_one_line():
    system = autonomous(Counter().rate, name="kept")
    (line,) = against_control(system, 0.0, 1.0, engine="python")
    assert line.startswith("kept runs in Python, not as machine code: kept.update: rate keeps")


def test_a_function_that_keeps_is_called_once_for_each_sample():
    gap = control.friction_backlash_nonlinearity(0.4)
    worn = control.nlsys(None, lambda t, x, u, p: gap(u[0]), inputs=1, outputs=["y"], name="worn")
    with pytest.warns(UserWarning, match="keeps what its next call reads"):
        run = clpt.simulate(worn, T, np.sin(3 * T))
    place, wanted = 0.0, []
    for u in np.sin(3 * T):  # the play, its gap 0.4
        place = min(max(place, u - 0.2), u + 0.2)
        wanted.append(place)
    np.testing.assert_allclose(run.y, wanted, atol=1e-12)


def test_circles_of_blocks_that_are_none_of_signals():
    A = control.nlsys(
        lambda t, x, u, p: [-x[0] + 0.1 * u[0]],
        lambda t, x, u, p: [x[0], u[0]],
        **{"inputs": ["a"], "outputs": ["p", "q"], "states": 1, "name": "A"},
    )
    B = control.nlsys(None, lambda t, x, u, p: 2 * u[0] + t, inputs=["b"], outputs=["r"], name="B")
    loop = control.interconnect([A, B], [["B.b", "A.p"], ["A.a", "B.r"]], outlist=["A.q", "B.r"])
    assert wiring_of(loop).order == (0, 1, 0)
    against_control(loop, 0.0, [1.0])
    circle = control.interconnect(
        [B, B.copy("C")], [["B.b", "C.r"], ["C.b", "B.r"]], outlist=["B.r"]
    )
    for engine in ("native", "python"):
        with pytest.raises(DiagramError, match="algebraic loop"):
            clpt.simulate(circle, T, engine=engine)


def test_samples_on_one_line_are_one_piece():
    system = control.nlsys(lambda t, x, u, p: u - x, None, inputs=1, outputs=1, states=1)
    times = np.linspace(0.0, 1.0, 1001)
    held, ramp, bent = (
        clpt.simulate(system, times, one, 0.0, engine="python").solver_evaluations
        for one in (1.0, 0.1 + 3.0 * times, np.where(times < 0.5, times, 1.0 - times))
    )
    assert ramp <= 1.1 * held + 50
    assert bent <= 3 * held


def test_a_system_without_states_and_a_dense_one():
    static = control.nlsys(None, lambda t, x, u, p: u[0] ** 2 + t, inputs=1, outputs=1)
    against_control(static, np.sin(T))
    random = np.random.default_rng(0)
    A = 0.1 * random.normal(size=(60, 60)) - np.eye(60)
    dense = control.ss(A, random.normal(size=(60, 1)), random.normal(size=(1, 60)), 0)
    against_control(dense, np.sin(T), close=1e-6)


def test_inputs_with_the_name_of_an_output_stay_apart():
    """An output u and three inputs u[0], u[1], u[2]: none is taken for the other."""
    plant = control.nlsys(
        lambda t, x, u, params: [u[0] - x[0]],
        lambda t, x, u, params: [2.0 * x[0]],
        inputs=3, outputs=["u"], states=1, name="plant",
    )  # fmt: skip
    run = clpt.simulate(plant, [0.0, 1.0], [[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]], [1.0])
    np.testing.assert_allclose(run.u, [2.0, 2.0], rtol=1e-9)
    np.testing.assert_array_equal(run.u_input, [[1.0, 2.0, 3.0]] * 2)
