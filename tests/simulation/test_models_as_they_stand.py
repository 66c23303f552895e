"""python-control's systems run as they stand, and python-control gives the same runs."""

from itertools import pairwise

import control
import netCDF4
import numpy as np
import pytest
from engine_runs import wiring_of
from error_sentences import says
from example_models import MODELS
from paths import REFERENCE
from responses import states_of
from still_water import CALM

import clpt_control as clpt
from clpt_control import BlockError, DataError, DiagramError, SimulationError

T = np.linspace(0.0, 2.0, 21)
TIGHT = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}
SMOOTH = "pendulum", "mrac", "tanks", "ss", "names", "table"


def autonomous(update, **more):
    """A system of one state and no input."""
    return control.nlsys(update, inputs=0, outputs=1, states=1, **more)


def rate(t, x, u, params):
    m = params.get("m", 1.0)
    return np.array([x[1], (u[0] - params["c"] * x[1] - np.sin(x[0])) / m])


def pendulum(**more):
    own = {"inputs": 1, "outputs": 1, "params": {"c": 0.2, "m": 2, "why": "a word"}}
    return control.nlsys(rate, lambda t, x, u, p: x[0], states=2, **own | more)


def nested():
    """A diagram in another, each with params of its own."""
    ports = {
        "inputs": ["r", "y"],
        "outputs": ["u"],
        "name": "gain",
        "params": {"k": 2.0},
    }
    gain = control.nlsys(None, lambda t, x, u, p: p["k"] * (u[0] - u[1]), **ports)
    plant = pendulum(name="plant", inputs=["u"], outputs=["y"])
    inner = control.interconnect(
        [plant, gain], inputs="r", outputs="y", params={"m": 5.0}
    )
    lag = control.tf([1.0], [0.3, 1.0], inputs="v", outputs="r")
    return control.interconnect(
        [inner, lag], inputs="v", outputs="y", params={"k": 3.0}
    )


def scheduled(method, points):
    """Feedback that python-control makes, its gains of a schedule."""
    plant = control.ss(
        [[0.0, 1.0], [-1.0, -0.2]], [[0.0], [1.0]], np.eye(2), 0, name="plant"
    )
    gains = [np.array([[1.0, 1.5]]), np.array([[3.0, 2.5]])]
    by = {"gainsched_indices": [*range(np.ndim(points))], "gainsched_method": method}
    return control.create_statefbk_iosystem(plant, (gains, points), **by)[1]


def servo():
    error = control.summing_junction(["r", "-y"], "e", name="error")
    law = control.tf([1, 2], [1, 0], inputs="e", outputs="u", name="law")
    plant = control.tf([1], [1, 1, 1], inputs="u", outputs="y", name="plant")
    return clpt.connect([error, law, plant], external="r", name="servo")


def circle():
    """A circle of blocks that is none of signals."""
    ports = {"inputs": ["a"], "outputs": ["p", "q"], "states": 1, "name": "A"}
    handed = lambda t, x, u, p: [x[0], u[0]]  # noqa: E731
    A = control.nlsys(lambda t, x, u, p: [-x[0] + 0.1 * u[0]], handed, **ports)
    B = control.nlsys(
        None, lambda t, x, u, p: 2 * u[0] + t, inputs=["b"], outputs=["r"], name="B"
    )
    return control.interconnect(
        [A, B], [["B.b", "A.p"], ["A.a", "B.r"]], outlist=["A.q", "B.r"]
    )


def sprung(direct=0.0):
    """A mass on a spring whose place is fed back, and whose acceleration is measured."""
    K = control.ss([], [], [], -2.0, inputs="place", outputs="back", name="K")
    total = control.summing_junction(["back", "r"], "F", name="total")
    ports = {"inputs": "F", "outputs": ["place", "pull"], "name": "mass"}
    A, C = [[0, 1], [-1, -0.5]], [[1, 0], [-1, -0.5]]
    return clpt.connect(
        [control.ss(A, [[0], [1]], C, [[direct], [1]], **ports), K, total], "r"
    )


def two_inputs():
    A, B = np.array([[-1.0, 0.4], [-0.7, -2.0]]), np.array([[1.0, 0.3], [-0.5, 2.0]])
    one = control.ss(
        A, B, [[1, -1]], [[0.5, 1]], name="one", inputs=["u[0]", "u[1]"], outputs="y"
    )
    two = control.ss(A.T, B[:, :1], [[0.3, 1]], 0, name="two", inputs="y", outputs="w")
    return clpt.connect([one, two], external="u")


def dense():
    random = np.random.default_rng(0)
    A = 0.1 * random.normal(size=(60, 60)) - np.eye(60)
    return control.ss(A, random.normal(size=(60, 1)), random.normal(size=(1, 60)), 0)


OPEN = control.nlsys(lambda t, x, u, p: -x + u[0] * np.array([1.0, 2.0]) + u[-1], None)
STATIC = control.nlsys(None, lambda t, x, u, p: u[0] ** 2 + t, inputs=1, outputs=1)
MATRIX = control.tf(
    [[[1], [2]], [[0], [1, 3]]], [[[1, 1], [1, 2]], [[1], [1, 4]]], name="M"
)
OTHERS = {"law.C": [[3.0]], "law.D": [[0.5]], "plant.A": [[-2.0, -1.0], [1.0, 0.0]]}
NEAREST, AT_LEVELS = (
    scheduled("nearest", [[-1.0, 0.0], [1.0, 0.0]]),
    0.2 * np.sin(T) - 1.0,
)
CASES = {  # system, inputs, start, params
    **{
        n: (MODELS[n].system, MODELS[n].u or 0.0, MODELS[n].start, None) for n in SMOOTH
    },
    "a param": (pendulum(), np.sin(T), [0.3, 0.0], {"m": 1000}),
    "a word": (pendulum(), np.sin(T), [0.3, 0.0], {"m": 3, "why": "another word"}),
    "nested": (nested(), np.cos(T), 0.1, None),
    "params handed down": (nested(), np.cos(T), 0.1, {"k": 1.0, "m": 7, "c": 0.0}),
    "a schedule": (
        scheduled("linear", [-1.0, 1.0]),
        [0.5 * np.sin(T), 0, 0],
        [0.1, 0.0],
        None,
    ),
    "nearest gains": (NEAREST, [AT_LEVELS, 0, 0], [-1.0, 0.0], None),
    "a servo": (servo(), 1.0, 0.0, None),
    "other matrices": (servo(), 1.0, 0.0, OTHERS),
    "a matrix of transfer functions": (clpt.connect([MATRIX], "u"), [1, -1], 0.0, None),
    "a circle of blocks": (circle(), 0.0, [1.0], None),
    "a circle through an entry of D that is 0": (sprung(), 1.0, 0.0, None),
    "no states": (STATIC, np.sin(T), 0.0, None),
    "a dense matrix": (dense(), np.sin(T), 0.0, None),
    "open sizes": (OPEN, np.vstack([np.sin(T), T]), [1.0, 0.5], None),
    "open sizes, a list": (OPEN, [np.sin(T), 0.5], [1.0, 0.5], None),
    "open sizes, numbers": (OPEN, [0.5, 2.0], [1.0, 0.5], None),
    "arrays stacked": (two_inputs(), [T - 1.0, 0], [[0.5, -1.0], 0], None),
    "numbers and arrays": (two_inputs(), [2.0, T - 1.0], [0.5, [1.0, 0.0], 0], None),
    "one number for all": (two_inputs(), np.vstack([T, T]), 1.0, None),
    "a short start": (two_inputs(), 0, [0], None),
}


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("name", CASES)
def test_a_run_is_python_controls(name, engine):
    system, inputs, start, params = CASES[name]
    given = [system, T, inputs, start]
    run = clpt.simulate(*given, params, engine=engine, rtol=1e-10, atol=1e-12)
    asked = control.input_output_response(*given, params=params, solve_ivp_kwargs=TIGHT)
    made = np.reshape(np.asarray(asked.outputs), (-1, len(T)))
    ours = np.vstack(
        [np.reshape(one.values.T, (-1, len(T))) for one in run.data_vars.values()]
    )
    np.testing.assert_allclose(
        ours[: len(made)], made, atol=1e-6 * (1.0 + np.abs(made).max())
    )
    assert run.attrs["engine"] == engine


def test_what_is_told_of_a_circle_a_start_and_a_matrix_that_is_none():
    assert wiring_of(circle()).order == (0, 1, 0)
    for system, params in (
        (sprung(0.5), None),
        (sprung(), {"mass.D": [[0.5], [1]]}),  # the same system, by a call
    ):
        says(
            DiagramError,
            "algebraic loop: mass <- total <- K",
            clpt.simulate,
            system,
            T,
            1.0,
            params=params,
        )
    with pytest.raises(BlockError, match=r"unknown parameter 'plant\.D'"):
        # it has none to change
        clpt.simulate(servo(), T, 1.0, params={"plant.D": [[1.0]]})
    with pytest.warns(UserWarning, match="filled with zeros"):
        clpt.simulate(pendulum(), T, 0.0, np.array([0.4]))


class Spring:
    """Reads `slack` in one of its ways alone, through a method; calls of it are counted."""

    calls = 0

    def force(self, x, params):
        return params["slack"] * x[0]

    def rate(self, t, x, u, params):
        if params.get("mode", "firm") == "soft":
            return [x[1], -self.force(x, params)]
        return [x[1], -params["c"] * x[0]]

    def worn(self, t, x, u, params):
        self.calls += 1
        return [
            x[1],
            -(1.0 if self.calls % 2 else 1.0 + 1e-12) * params.get("k", 1) * x[0],
        ]


def by_number(t, x, u, params):
    return [x[1], -sum(params.get(f"k{i}", 1.0) * x[0] ** i for i in range(1, 3))]


def all_at_once(t, x, u, params):
    own = {"k": 1.0, **params}
    return [x[1], -own["k"] * x[0]]


NAMES = {  # what may be given, and what no function reads
    rate: ([{"m": 2.0}, {"c": 0.1}], ["M", "mm", "typo", "rood.m"]),
    Spring().rate: ([{"slack": 1.0}, {"mode": "soft", "slack": 2.0}], ["slak", "x"]),
    by_number: ([{"k2": 2.0}], ["k3", "l2"]),
    all_at_once: ([{"k": 2.0}, {"any": 1.0}], []),
    Spring().worn: ([{"k": 2.0}, {"any": 1.0}], []),
}


@pytest.mark.parametrize("looped", [False, True], ids=["alone", "in a loop"])
@pytest.mark.parametrize("update", NAMES, ids=lambda f: f.__name__)
@pytest.mark.filterwarnings("ignore:.*(runs in Python|hidden state)")
def test_names_that_functions_read_are_known_and_no_others(update, looped):
    known, unknown = NAMES[update]
    sizes = {
        "inputs": ["u[0]"],
        "outputs": ["x[0]", "x[1]"],
        "states": 2,
        "params": {"c": 1.0},
    }
    system = control.nlsys(update, name="rod", **sizes)
    short = [0.0, 0.2], 0.0, [0.3, 0.1]
    calls = [lambda p: clpt.simulate(system, *short, params=p)]
    if update.__name__ != "worn":  # which has no derivative
        calls.append(lambda p: clpt.linearize(system, short[2], params=p))
    if looped:
        ports = {"inputs": ["x[0]", "x[1]"], "outputs": ["u[0]"], "name": "back"}
        system = clpt.connect([system, control.ss([], [], [], [[-1.0, 0.0]], **ports)])
        calls.append(lambda p: control.input_output_response(system, *short, params=p))
    for call in calls:
        for params in known:
            call({"c": 2.0, **params})
        for name in unknown:
            with pytest.raises(
                BlockError, match=rf"unknown parameter '{name}'. (It has .*c|Did)"
            ):
                call({"c": 2.0, name: 1.0})
    near = {"mm": "m", "rood.m": "m"} | ({"bak.D": r"back\.D"} if looped else {})
    for name, own in near.items() if update is rate else ():
        with pytest.raises(BlockError, match=rf"Did you mean '{own}'\?"):
            calls[0]({name: 1.0})


def test_a_param_under_the_name_of_its_system_is_for_that_one_alone():
    parts = [pendulum(name=name, inputs=["u"], outputs=[f"y{name}"]) for name in "ab"]
    two = control.interconnect(parts, inputs="u", outputs=["ya", "yb"], name="two")
    wired = clpt.connect(parts, external="u")
    around = control.interconnect(
        [two], inputs="u", outputs=["ya", "yb"], name="around"
    )
    start = [0.3, 0.0]
    wanted = [
        clpt.simulate(pendulum(), T, 0.3, start, {"m": m}).states.values
        for m in (3.0, 5.0)
    ]
    both, named = np.hstack(wanted), {"m": 3.0, "b.m": 5.0}
    several = [named, dict(reversed(named.items())), {"a.m": 3.0, "b.m": 5.0}]
    nested = [{"two.m": 3.0, "b.m": 5.0}, {"a.m": 3.0, "b.m": 9.0, "two.b.m": 5.0}]
    for system, each in (
        (two, several),
        (wired, several),
        (around, [*several, *nested]),
    ):
        for params in each:
            found = clpt.simulate(system, T, 0.3, start * 2, params).states
            np.testing.assert_allclose(found, both, rtol=1e-6, atol=1e-8)
        for name in ("typo", "a.typo", "c.m", "two"):
            with pytest.raises(BlockError, match=f"unknown parameter '{name}'"):
                clpt.simulate(system, T, 0.3, start * 2, {name: 2.0})
    given = {"params": named, "solve_ivp_kwargs": {"rtol": 1e-9}}
    theirs = control.input_output_response(wired, T, 0.3, start * 2, **given)
    np.testing.assert_allclose(theirs.states.T, both, atol=1e-5)
    alone = clpt.run_ensemble(
        parts[0], {"a.m": [3.0]}, timepts=T, inputs=0.3, initial_state=start
    )
    np.testing.assert_allclose(alone.ya_final.values[0], both[-1, 0], rtol=1e-6)


PLAN = [(0.7, 1.0), (1.3, -0.5), (1e9, 0.2)]


def stops(t, x, u, p):
    if x[0] > 0.5:
        pull = -x[0]
    return [pull]


def planned(t, x, u, p):
    for until, rate in PLAN:
        if t < until:
            return [rate]


def test_a_name_that_is_bound_where_the_run_goes_alone():
    for of_time in (
        planned,
        lambda t, x, u, p: [next(rate for end, rate in PLAN if t < end)],
    ):
        found = clpt.simulate(autonomous(of_time), T)
        assert found.engine == "native"
        np.testing.assert_allclose(found.states[-1, 0], 0.7 - 0.3 + 0.14, rtol=1e-11)
    for engine in ("native", "python"):
        with pytest.raises(
            SimulationError, match=r"0\.693147.*stops, line \d+: UnboundLocalError"
        ):
            clpt.simulate(autonomous(stops), T, 0.0, 1.0, engine=engine)


def test_a_function_that_keeps_runs_in_python_and_is_called_once_for_each_sample():
    gap = control.friction_backlash_nonlinearity(0.4)
    worn = control.nlsys(
        None, lambda t, x, u, p: gap(u[0]), inputs=1, outputs=["y"], name="worn"
    )
    said = (
        r"^worn runs in Python, not as machine code: worn.output: "
        ".*which outlives the call"
    )
    with pytest.warns(UserWarning, match=said) as warned:
        run = clpt.simulate(worn, T, np.sin(3 * T))
    place, wanted = 0.0, []
    for u in np.sin(3 * T):  # the play, its gap 0.4
        place = min(max(place, u - 0.2), u + 0.2)
        wanted.append(place)
    np.testing.assert_allclose(run.y, wanted, atol=1e-12)
    assert len(warned) == 1


def test_samples_on_one_line_are_one_piece():
    system = control.nlsys(
        lambda t, x, u, p: u - x, None, inputs=1, outputs=1, states=1
    )
    times = np.linspace(0.0, 1.0, 1001)
    held, ramp, bent = (
        clpt.simulate(system, times, one, 0.0, engine="python").solver_evaluations
        for one in (1.0, 0.1 + 3.0 * times, np.where(times < 0.5, times, 1.0 - times))
    )
    assert ramp <= 1.1 * held + 50
    assert bent <= 3 * held


def test_counts_may_be_numpys():
    """x' = u - x from 0, alone and with u = r - 2 x."""
    one = np.int64(1)
    counts = {"inputs": one, "outputs": one, "states": one}
    plant = control.nlsys(
        lambda t, x, u, p: u - np.eye(len(x)) @ x, **counts, name="plant"
    )
    twice = control.nlsys(
        None, lambda t, x, u, p: 2.0 * u, inputs=one, outputs=one, name="twice"
    )
    for system, rate in ((plant, 1.0), (control.feedback(plant, twice), 3.0)):
        run = clpt.simulate(system, [0, 1], 1.0)
        assert run.attrs["engine"] == "native"
        np.testing.assert_allclose(
            run.states[-1], (1 - np.exp(-rate)) / rate, rtol=1e-6
        )


def test_inputs_with_the_name_of_an_output_stay_apart():
    """An output u and three inputs u[0], u[1], u[2]: none is taken for the other."""
    rate, twice = lambda t, x, u, p: [u[0] - x[0]], lambda t, x, u, p: [2.0 * x[0]]
    plant = control.nlsys(rate, twice, inputs=3, outputs=["u"], states=1, name="plant")
    run = clpt.simulate(plant, [0.0, 1.0], [[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]], [1.0])
    np.testing.assert_allclose(run.u, [2.0, 2.0], rtol=1e-9)
    np.testing.assert_array_equal(run.u_input, [[1.0, 2.0, 3.0]] * 2)


@pytest.mark.parametrize("form", [2, "two", 0])
def test_a_run_of_a_later_version_is_refused(form, tmp_path):
    clpt.save_run(clpt.simulate(CALM), tmp_path / "run.nc")
    with netCDF4.Dataset(tmp_path / "run.nc", "a") as file:
        assert file.run_format == 1
        file.run_format = form
        file.source = "clpt-control 9.0"
    for read in (clpt.load_run, clpt.load_scenario):
        with pytest.raises(
            DataError, match=f"{form}, written by clpt-control 9.0.*reads 1 to 1"
        ):
            read(tmp_path / "run.nc")


FOLDER = REFERENCE


def test_every_scenario_has_its_reference(reference):
    assert {path.stem for path in FOLDER.glob("*.toml")} == set(reference)


def test_the_paper_is_the_scenario_that_ships():
    ours, theirs = clpt.paper_scenario(), clpt.load_scenario(FOLDER / "paper.toml")
    for part in ("units", "basis", "flow", "vehicle", "reference", "run"):
        assert getattr(ours, part) == getattr(theirs, part)
    assert ours.learning.gain == theirs.learning.gain
    np.testing.assert_array_equal(clpt.initial_state(ours), clpt.initial_state(theirs))


@pytest.mark.long
@pytest.mark.parametrize(
    ("dwell", "end"), [(5.0, 15.0), pytest.param(20.0, 2000.0, marks=pytest.mark.slow)]
)
def test_python_control_gives_the_same_run(dwell, end):
    """Its own solver, started again at each waypoint."""
    scenario = clpt.paper_scenario().with_values({"reference.dwell": dwell})
    loop = clpt.closed_loop(scenario)
    theirs = [clpt.initial_state(scenario)]
    times = np.arange(0, end + 1, dwell)
    own = {
        "solve_ivp_method": "DOP853",
        "solve_ivp_kwargs": {"rtol": 1e-10, "atol": 1e-12},
    }
    for k, span in enumerate(pairwise(times)):
        at = {"params": {"reference.interval": float(k)}, **own}
        theirs.append(
            control.input_output_response(loop, span, 0, theirs[-1], **at).states[:, -1]
        )
    ours = clpt.simulate(scenario, times, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(states_of(ours), theirs, rtol=0, atol=1e-7)


class KeysAsAttributes(dict):
    """Of which `getattr` raises a KeyError for a name that is not a key."""

    def __getattr__(self, name):
        return self[name]


class Rate(KeysAsAttributes):
    def __call__(self, t, x, u, p):
        return [-self.k * x[0]]

    def method(self, t, x, u, p):
        return [-self.k * x[0]]


def rates():
    """Functions of the three kinds; pytest cannot collect such objects of a module."""
    numbers, rate = KeysAsAttributes(k=2.0), Rate(k=2.0)
    return [lambda t, x, u, p: [-numbers.k * x[0]], rate, rate.method]


@pytest.mark.parametrize("kind", range(3))
def test_objects_whose_getattr_raises_a_key_error(kind, tmp_path):
    decay = control.nlsys(rates()[kind], states=1, inputs=0, outputs=1, name="decay")
    run = clpt.simulate(decay, [0, 1], initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    assert run.states.values[-1, 0] == pytest.approx(np.exp(-2), abs=1e-8)
    assert clpt.linearize(decay).A == -2
    assert str(clpt.equations(decay)).startswith("x' = -2*x")
    assert clpt.check(decay).ok
    clpt.export(decay, tmp_path / "decay.c")


@pytest.mark.parametrize("place", ["system", "timepts", "inputs", "initial_state"])
def test_such_an_object_in_place_of_an_argument_is_refused(place):
    given = {"system": control.ss(-1, 1, 1, 0), "timepts": [0, 1], place: Rate(k=2.0)}
    says(clpt.ClptError, "must be |has no", clpt.simulate, **given)
