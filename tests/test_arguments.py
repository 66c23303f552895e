"""No argument of a public function is ignored: unknown ones are refused, known ones used."""

import ast
import dataclasses
import inspect
import textwrap
from itertools import product

import numpy as np
import pytest
from responses import response
from sentences import says
from test_documentation import methods, public_objects

import clpt_control as clpt

SCENARIO = clpt.paper_scenario().with_values({"run.duration": 2})
LOOP, STEERED = clpt.closed_loop(SCENARIO), clpt.closed_loop(SCENARIO, external="zc")
ENGINES = ("native", "python")


def public_functions():
    for name, value in public_objects():
        found = {name: value}
        if inspect.isclass(value):
            bases = {inner for base in value.__bases__ for inner in dir(base)}
            found = {f"{name}.{n}": method for n, method in methods(value) if n not in bases}
            if not dataclasses.is_dataclass(value):
                found[name] = vars(value).get("__init__")
        yield from (pytest.param(one, id=n) for n, one in found.items() if inspect.isfunction(one))


@pytest.mark.parametrize("function", list(public_functions()))
def test_every_argument_is_used(function):
    (made,) = ast.parse(textwrap.dedent(inspect.getsource(function))).body
    names = (node for line in made.body for node in ast.walk(line) if isinstance(node, ast.Name))
    used = {node.id for node in names if isinstance(node.ctx, ast.Load)}
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
    systems = ((SCENARIO, None), (LOOP, [0.0, 2.0]), (STEERED, [0.0, 2.0]))
    for wrong, (system, times) in product(WRONG[name], systems):
        given = {"timepts": times, name: wrong, "engine": engine}
        says(clpt.ClptError, f"{name}|unknown param", clpt.simulate, system, **given)


def test_there_is_no_other_engine():
    values = [one.values[0] for one in public_functions()]
    assert {f for f in values if "engine" in inspect.signature(f).parameters} == {clpt.simulate}
    said = "must be one of native, python"
    says(clpt.ClptError, said, clpt.simulate, LOOP, [0.0, 2.0], engine="fast")


def test_a_tolerance_of_nothing_is_not_the_default():
    """One of the two may be 0, and is taken as given; both are refused."""
    start = clpt.initial_state(SCENARIO)
    ran = [response(LOOP, [0.0, 2.0], initial_state=start, atol=a).states for a in (0.1, 1.0)]
    assert abs(ran[0] - ran[1]).max() > 0
    said = "one of them must be above 0"
    says(clpt.ClptError, said, clpt.simulate, LOOP, [0.0, 2.0], rtol=0.0, atol=0.0)


def test_an_unknown_keyword_is_refused_where_keywords_are_handed_on():
    given = 1, (0.0,) * 3, (0.0,) * 3, (0.0, 0.0)
    says(TypeError, "unexpected keyword", clpt.gliders.make_dive, *given, unknown_keyword=1)


def test_help_shows_signatures_that_can_be_read():
    shown = [str(inspect.signature(getattr(clpt.parts, name))) for name in clpt.parts.__all__]
    assert [one for one in shown if "_typing" in one] == []
