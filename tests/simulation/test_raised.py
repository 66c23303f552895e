"""What a user's own function raises is told: block, function, line and its words."""

import math
import warnings

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.equations import Block
from clpt_control.errors import Uncompiled
from clpt_control.simulation.running import compiled

ENGINES = pytest.mark.parametrize("engine", [None, "python"])
TIMES = np.linspace(0.0, 4.0, 5)


def system(update, output=None, **given):
    """A system of one state that begins at 1."""
    return control.nlsys(
        update, output, inputs="u", outputs="y", states="y", params={"k": 1.0}, name="q", **given
    )


def decay(t, x, u, p):
    return [-p["k"] * x[0]]


def told(call, kind=clpt.SimulationError):
    """The sentence of an error; it warns of nothing but that Python runs."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "q runs in Python")
        with pytest.raises(kind) as caught:
            call()
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert "tol" not in sentence  # no advice
    return sentence


def ended(t, x, u, p):
    if t > 1:
        raise ValueError("table ends at 1 s")
    return [1.0]


def empty(t, x, u, p):
    raise ValueError("thruster table is empty")


def divided(t, x, u, p):
    return [1 / 0]


def beyond(t, x, u, p):
    return [u[1]]


def asserted(t, x, u, p):
    raise AssertionError


def long(t, x, u, p):
    raise ValueError("no table\nfor such a time")


def two(t, x, u, p):
    return [x[0], x[0]]


RAISING = [
    (empty, "empty, line {}: ValueError: thruster table is empty"),
    (divided, "divided, line {}: ZeroDivisionError: division by zero"),
    (beyond, "beyond, line {}: IndexError: index 1 is out of bounds for axis 0 with size 1"),
    (asserted, "asserted, line {}: AssertionError"),
    (long, "long, line {}: ValueError: no table for such a time"),
    (two, "returns 2 numbers; must return 1"),
]


def words(function, text):
    """What is said of a function, with the line in which it raises."""
    return text.format(function.__code__.co_firstlineno + 1)


@ENGINES
@pytest.mark.parametrize("role", ["update", "output"])
@pytest.mark.parametrize(("function", "text"), RAISING)
def test_a_function_that_raises(function, text, role, engine):
    model = system(function) if role == "update" else system(decay, function)
    said = told(lambda: clpt.simulate(model, TIMES, 1.0, [1.0], engine=engine))
    at = "the integration stopped at t = 0" if role == "update" else "at t = 0"
    assert said == f"{at}: q.{role}: {words(function, text)}"


@ENGINES
@pytest.mark.parametrize("rtol", [1e-8, 1e-5])
def test_in_the_middle_of_a_run(engine, rtol):
    line = ended.__code__.co_firstlineno + 2
    end = f"the integration stopped at t = 1: {{}}.update: ended, line {line}: ValueError: table"
    block = Block("b", update=ended, states={"y": 1})
    for model in (system(ended), block):
        said = told(lambda: clpt.simulate(model, [0.0, 5.0], engine=engine, rtol=rtol))  # noqa: B023
        assert said == f"{end.format(model.name)} ends at 1 s"


@ENGINES
def test_a_root_that_ends(engine):
    """x' = -sqrt(x) from 1 is 0 at t = 2."""
    model = system(lambda t, x, u, p: [-math.sqrt(x[0])])
    said = told(lambda: clpt.simulate(model, [0.0, 5.0], 0.0, [1.0], engine=engine))
    assert "q.update: <lambda>, line" in said
    assert "ValueError: " in said


@ENGINES
def test_a_step_that_is_tried_and_left(engine):
    """x' = -10 x^(3/2) from 1 is (1 + 5 t)^-2; a first step of 1 leads below 0."""
    asked = []

    def update(t, x, u, p):
        if engine and isinstance(x[0], float):
            asked.append(float(x[0]))
        return [-10.0 * math.sqrt(x[0]) * x[0]]

    run = clpt.simulate(system(update), [0.0, 5.0], 0.0, [1.0], engine=engine, first_step=1.0)
    assert run.y.values.ravel()[-1] == pytest.approx(26.0**-2, rel=1e-6)
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


def every_second(p, t0, t1):
    return [k for k in (1.0, 2.0, 3.0) if t0 < k <= t1]


def teeth():
    return Block(
        "saw", update=lambda t, x, u, p: [1.0], states={"s": 1}, parameters={"interval": -1.0},
        breakpoints=every_second, jump=second,
    )  # fmt: skip


@ENGINES
@pytest.mark.parametrize("times", [[0.0, 4.0], TIMES])
def test_jumps_and_sampled_parts(engine, times):
    saw = teeth()
    said = told(lambda: clpt.simulate(saw, times, engine=engine))
    assert said.startswith("the integration stopped at t = 2: saw.jump: second, line ")
    assert said.endswith("ValueError: no second jump")
    sampled = Block("law", update=law, inputs={"y": 1}, states={"w": 1}, dt=0.5)
    plant = Block("plant", update=lambda t, x, u, p: u.w - x, inputs={"w": 1}, states={"y": 1})
    loop = clpt.connect([sampled, plant])
    said = told(lambda: clpt.simulate(loop, times, engine=engine))
    assert said.startswith("the integration stopped at t = 2: law.update: law, line ")
    said = told(lambda: clpt.simulate(sampled, np.arange(0.0, 4.0, 0.5), engine=engine))
    assert said.startswith("the run stopped at t = 1.5: law.update: law, line ")


@ENGINES
def test_a_state_that_is_none_is_not_laid_to_a_jump_of_another_run(engine):
    saw = teeth()
    told(lambda: clpt.simulate(saw, [0.0, 4.0], engine=engine))
    with pytest.raises(clpt.SimulationError, match=r"t = 0: state s\[0\] of block saw is not fin"):
        clpt.simulate(saw, [0.0, 4.0], initial_state=[math.nan], engine=engine)


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
        data = clpt.run_ensemble(model, {"k": [0.0, 1.0]}, timepts=TIMES, initial_state=[1.0])
    assert run.y.values.ravel() == pytest.approx(np.exp(-2.0 * TIMES), abs=1e-8)
    assert data.y_final.values == pytest.approx(np.exp([-8.0, -4.0]), abs=1e-8)


def text(t, x, u, p):
    return [u[0] + "1"]


def absent(t, x, u, p):
    return [wibble(x[0])]  # noqa: F821


def by_name(t, x, u, p):
    return [x.y]


def of_no_key(t, x, u, p):
    return [p["none"] * x[0]]


@ENGINES
@pytest.mark.parametrize("function", [text, absent, by_name, of_no_key])
def test_what_is_no_matter_of_numbers(function, engine):
    line = function.__code__.co_firstlineno + 1
    said = told(lambda: clpt.simulate(system(function), TIMES, engine=engine), clpt.BlockError)
    assert said.startswith(f"q.update: {function.__name__}, line {line}: ")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(clpt.BlockError) as caught:
            clpt.simulate(system(function), TIMES, engine=engine)
    assert isinstance(caught.value.__cause__, TypeError | NameError | AttributeError | KeyError)


def test_a_text_among_numbers_is_no_endless_call():
    with pytest.raises(Uncompiled, match=r"q\.update: text, line \d+: calculating with a str$"):
        compiled(system(text), None)


@pytest.mark.parametrize("role", ["update", "output"])
def test_an_ensemble(role):
    model = system(empty) if role == "update" else system(decay, ended)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        data = clpt.run_ensemble(model, {"k": [1.0, 2.0]}, timepts=TIMES)
    assert np.all(data.status == 3)
    (said,) = [str(one.message) for one in caught if "did not finish" in str(one.message)]
    assert said.startswith("2 of 2 members did not finish; the first is member 0: not finite: ")
    end = "table ends at 1 s" if role == "output" else "thruster table is empty"
    assert said.endswith(f"ValueError: {end}")
    assert f"q.{role}: " in said


def test_what_is_no_diagram():
    with pytest.raises(clpt.DiagramError, match="is a FrequencyResponseData: must be blocks"):
        clpt.simulate(control.frd([1, 2], [1, 2]), TIMES)


def test_what_is_no_path(tmp_path):
    run = clpt.simulate(system(decay), TIMES, 0.0, [1.0])
    with pytest.raises(
        clpt.ArgumentError, match=r"table: path = 3: must be a text, a path or None"
    ):
        run.clpt.table(3)
    run.clpt.table(tmp_path / "run.csv")
    assert (tmp_path / "run.csv").read_text().startswith("time")
