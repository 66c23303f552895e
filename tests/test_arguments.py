"""No argument of a public function is ignored: unknown ones are refused, known ones used."""

import ast
import dataclasses
import inspect
import textwrap

import numpy as np
import pytest
from responses import response
from test_documentation import methods, public_objects

import clpt_control as clpt

SCENARIO = clpt.paper_scenario().with_values({"run.duration": 2})
LOOP, STEERED = clpt.closed_loop(SCENARIO), clpt.closed_loop(SCENARIO, external="zc")
ENGINES = ("native", "python")


def public_functions():
    for name, value in public_objects():
        if inspect.isfunction(value):
            yield pytest.param(value, id=name)
            continue
        for inner, method in methods(value):
            above = any(hasattr(base, inner) for base in value.__bases__)
            if inspect.isfunction(method) and not above:
                yield pytest.param(method, id=f"{name}.{inner}")
        start = vars(value).get("__init__")
        if inspect.isfunction(start) and not dataclasses.is_dataclass(value):
            yield pytest.param(start, id=name)


@pytest.mark.parametrize("function", list(public_functions()))
def test_every_argument_is_used(function):
    (made,) = ast.parse(textwrap.dedent(inspect.getsource(function))).body
    used = {
        node.id
        for line in made.body
        for node in ast.walk(line)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
    }
    assert set(inspect.signature(function).parameters) - {"self", "cls"} <= used


NAN, INF = float("nan"), float("inf")
WRONG = {
    "timepts": ([1.0, 0.0], [1.0], [0.0, 0.0], [0.0, NAN], [0.0, INF]),
    "initial_state": ("rest", [1.0] * 15, np.full(14, 1j)),
    "inputs": (np.full((2, 2), 1j), [[1.0, 2.0]], [[1.0], [1.0, 2.0, 3.0]], lambda t: [t]),
    "rtol": (-1.0, NAN),
    "atol": (-1.0, NAN),
    "max_step": (0.0,),
    "first_step": (-1.0, NAN),
    "method": ("RK45",),
    "params": ([1.0], {"adaptation.gan": 1.0}),
}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("name", WRONG)
def test_engines_refuse_the_same_by_its_name(name, engine):
    for wrong in WRONG[name]:
        for system, times in ((SCENARIO, None), (LOOP, [0.0, 2.0]), (STEERED, [0.0, 2.0])):
            with pytest.raises(clpt.ClptError, match=f"{name}|unknown param") as caught:
                clpt.simulate(system, **{"timepts": times, name: wrong}, engine=engine)
            assert "\n" not in str(caught.value)


def test_there_is_no_other_engine():
    values = [one.values[0] for one in public_functions()]
    assert {f for f in values if "engine" in inspect.signature(f).parameters} == {clpt.simulate}
    with pytest.raises(clpt.ClptError, match="must be one of native, python"):
        clpt.simulate(LOOP, [0.0, 2.0], engine="fast")


def test_a_tolerance_of_nothing_is_not_the_default():
    """One of the two may be 0, and is taken as given; both are refused."""
    start = clpt.initial_state(SCENARIO)
    ran = [response(LOOP, [0.0, 2.0], initial_state=start, atol=a).states for a in (0.1, 1.0)]
    assert abs(ran[0] - ran[1]).max() > 0
    with pytest.raises(clpt.ClptError, match="one of them must be above 0"):
        clpt.simulate(LOOP, [0.0, 2.0], rtol=0.0, atol=0.0)


def test_an_unknown_keyword_is_refused_where_keywords_are_handed_on():
    with pytest.raises(TypeError, match="unexpected keyword"):
        clpt.gliders.make_dive(1, (0.0,) * 3, (0.0,) * 3, (0.0, 0.0), unknown_keyword=1)


def test_help_shows_signatures_that_can_be_read():
    for name in clpt.parts.__all__:
        signature = str(inspect.signature(getattr(clpt.parts, name)))
        assert "_typing" not in signature, signature
