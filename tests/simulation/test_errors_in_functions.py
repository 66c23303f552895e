"""What raises, cannot be computed or leaves a field is said in a sentence."""

import math
import re
import warnings
from decimal import Decimal

import control
import numpy as np
import pytest
from engine_runs import Each
from error_sentences import says
from gridded_currents import field_blocks, plane_field
from still_water import PAPER

import clpt_control as clpt
from clpt_control import Block, SimulationError

ENGINES = pytest.mark.parametrize("engine", [None, "python"])
TIMES = np.linspace(0.0, 4.0, 5)


def system(update, output=None, **given):
    """A system of one state that begins at 1."""
    return control.nlsys(
        update,
        output,
        inputs="u",
        outputs="y",
        states="y",
        params={"k": 1.0},
        name="q",
        **given,
    )


def decay(t, x, u, p):
    return [-p["k"] * x[0]]


def told(call, kind=clpt.SimulationError):
    """The sentence of an error, without advice; it warns of nothing but that Python runs."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "q runs in Python")
        with pytest.raises(kind, match=r"\A((?!tol).)*\Z") as caught:
            call()
    return str(caught.value)


def ended(t, x, u, p):
    if t > 1:
        raise ValueError("table ends at 1 s")
    return [1.0]


def empty(t, x, u, p):
    raise ValueError("thruster table\nis empty")


def named(function, raises):
    line = function.__code__.co_firstlineno + (function.__name__ != "<lambda>")
    return f"{function.__name__}, line {line}: {raises}"


RAISING = {
    empty: named(empty, "ValueError: thruster table is empty"),
    (one := lambda t, x, u, p: [1 / 0]): named(
        one, "ZeroDivisionError: division by zero"
    ),
    (one := lambda t, x, u, p: [u[1]]): named(
        one, "IndexError: index 1 is out of bounds for axis"
    ),
    lambda t, x, u, p: [x[0], x[0]]: "returns 2 numbers; must return 1",
}


@ENGINES
@pytest.mark.parametrize("role", ["update", "output"])
@pytest.mark.parametrize("function", RAISING)
def test_a_function_that_raises(function, role, engine):
    model = system(function) if role == "update" else system(decay, function)
    said = told(lambda: clpt.simulate(model, TIMES, 1.0, [1.0], engine=engine))
    at = "the integration stopped at t = 0" if role == "update" else "at t = 0"
    assert said.startswith(f"{at}: q.{role}: {RAISING[function]}")


@ENGINES
def test_in_the_middle_of_a_run(engine):
    said = told(lambda: clpt.simulate(system(ended), [0.0, 5.0], engine=engine))
    line = ended.__code__.co_firstlineno + 2
    end = f"q.update: ended, line {line}: ValueError: table ends at 1 s"
    assert said == f"the integration stopped at t = 1: {end}"
    root = system(lambda t, x, u, p: [-math.sqrt(x[0])])  # from 1 it is 0 at t = 2
    said = told(lambda: clpt.simulate(root, [0.0, 5.0], 0.0, [1.0], engine=engine))
    assert re.search("q.update: <lambda>, line.*ValueError: ", said)


def test_a_function_of_math_of_a_port_of_two_signals():
    """Its message names the function of NumPy."""
    cosh = lambda t, x, u, p: {"x": -math.cosh(x.x)}  # noqa: E731
    said = told(lambda: clpt.Block("q", update=cosh, states={"x": 2}), clpt.BlockError)
    advice = "math.cosh takes one number. Use np.cosh, or an element of the port"
    assert said.endswith(advice)
    erf = lambda t, x, u, p: {"x": -math.erf(x.x)}  # noqa: E731  NumPy has none
    said = told(lambda: clpt.Block("q", update=erf, states={"x": 2}), clpt.BlockError)
    assert said.endswith("math.erf takes one number. Use an element of the port")


@pytest.mark.parametrize(
    ("value", "advice"),
    [
        ([2.0], "Give a parameter of several numbers as np.array"),
        (Decimal(2), "Give numbers as float"),
    ],
)
def test_a_parameter_that_is_no_number_has_advice(value, advice):
    falls = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0]], states=1, params={"k": 1.0}, name="falls"
    )
    with pytest.warns(UserWarning, match="runs in Python"):
        said = told(
            lambda: clpt.simulate(falls, [0, 1], params={"k": value}), clpt.BlockError
        )
    assert said.endswith(advice)


NO_NUMBERS = {
    lambda t, x, u, p: [u[0] + "1"]: TypeError,
    lambda t, x, u, p: [wibble(x[0])]: NameError,  # noqa: F821
    lambda t, x, u, p: [x.y]: AttributeError,
    lambda t, x, u, p: [p["none"] * x[0]]: KeyError,
}


@ENGINES
@pytest.mark.parametrize("function", NO_NUMBERS)
def test_what_is_no_matter_of_numbers(function, engine):
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "q runs in Python")
        with pytest.raises(
            clpt.BlockError, match=f"^q.update: {named(function, '')}"
        ) as caught:
            clpt.simulate(system(function), TIMES, engine=engine)
    assert isinstance(caught.value.__cause__, NO_NUMBERS[function])


@pytest.mark.filterwarnings("ignore:.*hidden state")
@ENGINES
def test_a_step_that_is_tried_and_left(engine):
    """x' = -10 x^(3/2) from 1 is (1 + 5 t)^-2; a first step of 1 leads below 0."""
    asked = []

    def update(t, x, u, p):
        if engine and isinstance(x[0], float):
            asked.append(float(x[0]))
        return [-10.0 * math.sqrt(x[0]) * x[0]]

    run = clpt.simulate(
        system(update), [0.0, 5.0, 300.0], 0.0, [1.0], engine=engine, first_step=1.0
    )
    assert run.y.values.ravel()[1] == pytest.approx(26.0**-2, rel=1e-6)
    if engine:
        assert min(asked) < 0.0


def second(t, x, u, p):
    if t > 1.5:
        raise ValueError("no second jump")
    return [0.0]


def law(t, x, u, p):
    if t > 1.2:
        raise ValueError("the law ends")
    return [x[0] + u[0]]


@ENGINES
@pytest.mark.parametrize("times", [[0.0, 4.0], TIMES])
def test_jumps_and_sampled_parts(engine, times):
    ports = {
        "states": {"s": 1},
        "parameters": {"interval": -1.0},
        "breakpoints": Each(1.0),
    }
    saw = Block("saw", update=lambda t, x, u, p: [1.0], jump=second, **ports)
    said = told(lambda: clpt.simulate(saw, times, engine=engine))
    assert said.startswith("the integration stopped at t = 2: saw.jump: second, line ")
    assert said.endswith("ValueError: no second jump")
    with pytest.raises(clpt.ArgumentError, match=r"finite; number 0 is nan"):
        clpt.simulate(saw, times, initial_state=[math.nan], engine=engine)
    sampled = Block("law", update=law, inputs={"y": 1}, states={"w": 1}, dt=0.5)
    plant = Block(
        "plant", update=lambda t, x, u, p: u.w - x, inputs={"w": 1}, states={"y": 1}
    )
    said = told(
        lambda: clpt.simulate(clpt.connect([sampled, plant]), times, engine=engine)
    )
    assert said.startswith("the integration stopped at t = 2: law.update: law, line ")
    said = told(lambda: clpt.simulate(sampled, np.arange(0.0, 4.0, 0.5), engine=engine))
    assert said.startswith("the run stopped at t = 1.5: law.update: law, line ")


def caught(t, x, u, p):
    """Python's float raises where a double is infinite, and the function goes on."""
    try:
        rate = 1.0 / p["k"]
    except ZeroDivisionError:
        rate = 2.0
    return -rate * x


@ENGINES
def test_what_a_function_catches_itself(engine):
    model = system(caught)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "q runs in Python.*q.update")
        run = clpt.simulate(model, TIMES, 1.0, [1.0], params={"k": 0.0}, engine=engine)
        data = clpt.run_ensemble(
            model, {"k": [0.0, 1.0]}, timepts=TIMES, initial_state=[1.0]
        )
    assert run.y.values.ravel() == pytest.approx(np.exp(-2.0 * TIMES), abs=1e-8)
    assert data.y_final.values == pytest.approx(np.exp([-8.0, -4.0]), abs=1e-8)


@pytest.mark.filterwarnings("ignore:q runs in Python")
@pytest.mark.parametrize(
    ("model", "role", "end"),
    [
        (system(empty), "update", "thruster table is empty"),
        (system(decay, ended), "output", "table ends at 1 s"),
    ],
)
def test_an_ensemble(model, role, end):
    said = rf"^2 of 2 members did .*; the first is member 0: not finite: .*q.{role}: .*: {end}\Z"
    with pytest.warns(UserWarning, match=said) as caught:
        data = clpt.run_ensemble(model, {"k": [1.0, 2.0]}, timepts=TIMES)
    assert sum("did not finish" in str(one.message) for one in caught) == 1
    assert np.all(data.status == 3)


@pytest.mark.long
@pytest.mark.parametrize("engine", ["native", "python"])
def test_what_is_infinite_is_named(engine):
    x0 = clpt.initial_state(PAPER)
    x0[1] = np.nan
    with pytest.raises(clpt.ArgumentError, match="finite; number 1 is nan"):
        clpt.simulate(PAPER, [0, 1], initial_state=x0, engine=engine)
    burst = clpt.Block("burst", update=lambda t, x, u, p: x[0] ** 2, states={"x": 1})
    with pytest.raises(SimulationError, match=r"\A.*stopped at t = (0\.9|1).*\Z"):
        clpt.simulate(burst, [0.0, 2.0], initial_state=[1.0], engine=engine)


@pytest.fixture
def drift(tmp_path):
    """Connect a vehicle that swims nowhere and a uniform current, as `made` says."""

    def made(outside, u=1.0, v=0.0, end=10.0, *more, external=("v_x",)):
        """Return the diagram on x1 = -2 ... 2 km, x2 = -1 ... 1 km, from 0 h to the end."""
        axes = [np.linspace(0, end, 5), np.linspace(-1, 1, 5), np.linspace(-2, 2, 9)]
        flow = (np.full((5, 5, 9), speed) for speed in (u, v))
        plane_field(tmp_path / "field.nc", *axes, *flow, "km", "h")
        blocks = field_blocks(tmp_path / "field.nc", outside, "km", "h")
        return clpt.connect([*blocks, *more], external=external)

    return made


WHERE = r"\(2, 0.5\) km, time 2 h.*x1 -2 to 2, x2 -1"
LEFT = [  # its start, its span, the field, and what of the place, the time and the bounds is said
    (
        [0.0, 0.5],
        np.linspace(0, 5, 11),
        {},
        WHERE + " to 1 km, time 0 to 10 h.*clip.*stop",
    ),
    ([0.0, 0.0], [0.0, 5.0], {"u": 0.1, "end": 3.0}, "time 3 h; .*time 0 to 3 h"),
    ([3.0, 0.0], [0.0, 1.0], {}, r"\(3, 0\) km, time 0 h"),
]


@pytest.mark.parametrize(("start", "times", "given", "said"), LEFT)
def test_leaving_raises_with_position_time_and_bounds(drift, start, times, given, said):
    says(
        SimulationError,
        said,
        clpt.simulate,
        drift("raise", **given),
        times,
        initial_state=start,
    )


@pytest.mark.filterwarnings("ignore:the run ends at its start")
def test_leaving_stops_where_it_leaves_between_samples(drift):
    run = clpt.simulate(drift("stop"), [0.0, 1.0, 3.0], initial_state=[0.75, 0.5])
    np.testing.assert_allclose(run.time, [0.0, 1.0, 1.25], atol=1e-9)
    np.testing.assert_allclose(
        run.states, [[0.75, 0.5], [1.75, 0.5], [2.0, 0.5]], atol=1e-8
    )
    assert re.match("stopped.*time 1.25 h", run.message)
    run = clpt.simulate(drift("stop"), [0.0, 1.0], initial_state=[3.0, 0.0])
    assert run.time.values.tolist() == [0.0]
    run = clpt.simulate(
        drift("stop", u=0.1, end=3.0), [0.0, 5.0], initial_state=[0.0, 0.0]
    )
    np.testing.assert_allclose(run.time, [0.0, 3.0], atol=1e-9)


def test_clip_goes_on_with_the_flow_at_the_edge_and_an_end_there_is_inside(drift):
    run = clpt.simulate(
        drift("clip", v=-0.5), [0.0, 4.0, 20.0], initial_state=[0.0, 0.0]
    )
    np.testing.assert_allclose(run.states[1:], [[4.0, -2.0], [20.0, -10.0]], atol=1e-8)
    run = clpt.simulate(drift("raise"), [0.0, 2.0], initial_state=[0.0, 1.0])
    np.testing.assert_allclose(run.states[-1], [2.0, 1.0], atol=1e-9)


@pytest.mark.parametrize("farthest", [4.04, 2.02])
def test_out_and_back_within_a_step_is_found(drift, farthest):
    # x1 = a sin(pi t/10) against a current of 1: out at the first time where it is 2
    def velocity(t, x, u, p):
        return [-1.0 + farthest * math.pi / 10 * np.cos(math.pi * t / 10), 0.0]

    pushed = clpt.Block("pushed", output=velocity, outputs={"v_x": 2})
    run = clpt.simulate(drift("stop", 1.0, 0.0, 10.0, pushed, external=()), [0.0, 9.9])
    leaves = 10 / math.pi * math.asin(2 / farthest)
    assert run.time[-1] == pytest.approx(leaves, abs=1e-6)
    assert run.x[-1, 0] == pytest.approx(2.0, abs=1e-8)


@pytest.mark.long
@pytest.mark.parametrize(
    "of", [lambda s: s, clpt.closed_loop], ids=["scenario", "diagram"]
)
def test_more_samples_than_memory_holds_are_refused_before_work(of):
    said = r"timepts: 8000000 samples of \d+ states and signals"
    says(SimulationError, said, clpt.simulate, of(PAPER), 1e-4 * np.arange(8_000_000))


def test_a_mistyped_parameter_is_answered_with_the_parameters():
    declared = {"states": {"h": 1}, "parameters": {"leak": 1.0}}
    update = lambda t, x, u, p: {"h": -p.leek * x.h}  # noqa: E731
    said = "no parameter 'leek'; there are leak"
    says(clpt.BlockError, said, Block, "tank", update=update, **declared)
