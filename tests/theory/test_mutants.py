"""One sign altered anywhere in a block's equations: is it seen?

The mutants come from the syntax tree of every function that a block runs; none is listed
by hand.  The code object is exchanged in place, so that every table and helper sees the
altered equation.  Equations of the paper are the theorems' to defend, those of a law its own
row's, those of a team its proof's, sources of time and tables those of `source_checks`.
"""

import ast
import inspect
import random
import textwrap
from functools import cache

import numpy as np
import pytest
from source_checks import CHECKS

import clpt_control as clpt
from clpt_control.blocks import basis, disturbance, error_system, field, lyapunov
from clpt_control.blocks.declaration import states_as_outputs
from clpt_control.blocks.functions import helpers_of
from clpt_control.blocks.laws.table import LAWS
from clpt_control.currents.field_file import GriddedField
from clpt_control.simulation.loops import paper_blocks
from clpt_control.simulation.teams import team_blocks
from clpt_control.theory.proving import (
    judged_laws,
    kept_loop,
    limited_speed,
    team,
    theorem_loop,
    theorems,
)
from clpt_control.theory.proving.misprints import misprints
from clpt_control.theory.proving.theorems import THEOREMS, audit

FIRST = {"error_system": "3.3"}  # where to look first; every theorem is tried before giving up
PAGES = sorted(
    {"laws.law", "laws.filtered_flow", "laws.commanded_gains", "laws.covariance"}
    | {law.block.__module__.partition("blocks.")[2] for law in LAWS.values()}
)
ALL_SIZES = kept_loop.SIZES
SOURCES = ("basis", "reference", "disturbance", "field")


def every_block():
    """Every kind of block of the package."""
    paper = clpt.paper_scenario()
    known = paper.with_values(
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": [[0.5] * 3] * 2,
            "flow.disturbance": {"kind": "sine", "amplitude": [0.1, 0.1], "period": 3.0},
        }
    )
    yield from paper_blocks(paper)
    yield from paper_blocks(known)
    yield from paper_blocks(paper.with_values({"vehicle.max_speed": 1.5}))
    for kernel in basis.KERNELS:
        yield from paper_blocks(paper.with_values({"basis.kernel": kernel}))[1:2]
    for kind in disturbance.KINDS:
        yield disturbance.disturbance(kind, [0.1, 0.1])
    axis = np.arange(4.0)
    grid = GriddedField(axis, axis, axis, np.ones((4, 4, 4)), np.zeros((4, 4, 4)))
    for disturbed in (False, True):
        yield field.gridded_flow(grid, disturbed=disturbed)
    yield error_system.error_system(error_system.ErrorSystemParameters(3, np.ones(2)))
    yield error_system.parameter_system(error_system.ParameterSystemParameters(3, 0.8))
    truth = lyapunov.one_gain(0.8, np.ones((2, 3)), np.ones(2), np.ones(2))
    for law in lyapunov.LAWS:
        yield lyapunov.lyapunov_candidate(law, truth)
    for law in LAWS.values():
        yield from theorem_loop.law_and_V(law, judged_laws.N)
    yield from team_blocks(team.team_of(team.GRAPHS["two vehicles"], 2))
    yield team.total_candidate(["a", "b"])


def functions():
    """Every function that a block runs, helpers included, in a fixed order."""
    found = {}

    def visit(function):
        key = f"{function.__module__.partition('blocks.')[2]}.{function.__name__}"
        if function is not states_as_outputs and key not in found:
            found[key] = function
            for helper in helpers_of(function).values():
                visit(helper)

    for block in every_block():
        for function in (block.update_function, block.output_function, block.jump_function):
            if function is not None:
                visit(function)
    return found


def is_sign(node):
    binary = isinstance(node, ast.BinOp | ast.AugAssign) and isinstance(node.op, ast.Add | ast.Sub)
    return binary or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub))


class Flip(ast.NodeTransformer):
    """Alter the sign numbered `which`."""

    def __init__(self, which):
        self.left = which

    def visit(self, node):
        node = self.generic_visit(node)
        if not is_sign(node):
            return node
        self.left -= 1
        if self.left != -1:
            return node
        if isinstance(node, ast.UnaryOp):
            return node.operand
        node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        return node


def mutants():
    for key, function in functions().items():
        tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
        for which in range(sum(is_sign(node) for node in ast.walk(tree))):
            yield key, which


def altered(function, which):
    lines, first = inspect.getsourcelines(function)
    tree = Flip(which).visit(ast.parse(textwrap.dedent("".join(lines))))
    tree = ast.increment_lineno(ast.fix_missing_locations(tree), first - 1)
    space = {}
    exec(compile(tree, function.__code__.co_filename, "exec"), dict(function.__globals__), space)
    return space[function.__name__].__code__


@cache
def laws_of(function):
    """Name the laws whose equations or V have this function of a law's page."""
    found = []
    for law in LAWS.values() if ".laws." in function.__module__ else ():
        reached, stack = set(), []
        for block in theorem_loop.law_and_V(law, judged_laws.N):
            run = (block.update_function, block.output_function, block.jump_function)
            stack += [f for f in run if f is not None]
        while stack:
            one = stack.pop()
            if one not in reached:
                reached.add(one)
                stack += helpers_of(one).values()
        if function in reached:
            found.append(law.name)
    return tuple(found)


@cache
def judged_unaltered():
    return judged_laws.judged_laws()


def caught_by(function, which, first):
    """Name the step that fails on the altered function; None if none does."""
    own, unaltered = function.__code__, judged_unaltered()
    laws_of(function)  # before it is altered
    function.__code__ = altered(function, which)
    try:
        for check in CHECKS if function.__module__.endswith(SOURCES) else ():
            try:
                check()
            except Exception:  # whatever a wrong equation does
                return check.__name__
        for step in team.team_steps() if function.__module__.endswith(".team") else ():
            if not step.holds:
                return f"team: {step.claim}"
        for sizes in (kept_loop.SIZES, ALL_SIZES):  # the largest only for what is left
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(kept_loop, "SIZES", sizes)
                for law in laws_of(function):
                    found = judged_laws.judged(LAWS[law])
                    if found[:4] != unaltered[law][:4]:
                        return f"{law}: {found.claim}"
        for number in sorted(THEOREMS, key=lambda n: n != first):
            for step in audit(number)[number].failed:
                return f"{number}: {step.claim}"
        for misprint in misprints():
            if not misprint.confirmed:
                return f"misprint {misprint.equation}"
        for name, proof in limited_speed.judged_limits().items():
            for step in proof.failed:
                return f"{name}: {step.claim}"
    finally:
        function.__code__ = own
    return None


def survivors(chosen):
    table = functions()
    left = []
    for key, which in chosen:
        first = FIRST.get(key.split(".")[0], "3.2")
        if caught_by(table[key], which, first) is None:
            left.append((key, which))
    return left


def test_there_are_signs_to_alter():
    listed = list(mutants())
    assert len(listed) > 130
    rooms = {key.split(".")[0] for key, _ in listed}
    assert {"vehicle", "learner", "laws", "basis", "clpe", "error_system"} <= rooms


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    """The exact steps come first; blocks are called at a few points only."""
    monkeypatch.setattr(theorems, "POINTS", 100)
    monkeypatch.setattr(theorems, "FEWER", 100)
    monkeypatch.setattr(judged_laws, "POINTS", 100)
    monkeypatch.setattr(limited_speed, "POINTS", 100)
    monkeypatch.setattr(team, "POINTS", 100)
    monkeypatch.setattr(kept_loop, "SIZES", (1, 2))  # all three in test_judged_laws


@pytest.mark.parametrize(
    "room", ["vehicle", "learner", "speed_limit", *PAGES, "team", "clpe", "lyapunov", "basis"]
)
def test_altered_signs_fail_the_proof(room):
    listed = [mutant for mutant in mutants() if mutant[0].startswith(f"{room}.")]
    chosen = random.Random(1).sample(listed, min(3, len(listed)))
    assert survivors(chosen) == []


@pytest.mark.slow
def test_of_all_altered_signs_95_percent_fail_the_proof(capsys):
    listed = list(mutants())
    left = survivors(listed)
    share = 1 - len(left) / len(listed)
    with capsys.disabled():
        print(f"\n{len(listed)} mutants, {100 * share:.1f} % caught; survivors: {left}")
    assert share >= 0.95
    assert left == []
