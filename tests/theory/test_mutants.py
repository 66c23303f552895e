"""One sign altered anywhere in a block's equations, or a term of a robust law dropped: is it seen?

The mutants come from the syntax tree of every function that a block runs; none is listed
by hand.  Equations of the paper are the theorems' to defend, those of a law its own row's,
those of a team its proof's, sources of time and tables those of `source_checks`.
"""

from functools import cache
from types import FunctionType

import pytest
from mutated_equations import alterations, altered, exchanged
from package_blocks import BLOCKS
from source_checks import CHECKS

from clpt_control.paper.laws.table import LAWS
from clpt_control.theory import audit, misprints
from clpt_control.theory.proofs import (
    all_proofs,
    invariant_loop,
    team_proof,
    theorem_loop,
    theorems,
)
from clpt_control.theory.proofs.steps import proof_or_failure

FIRST = {"clpe": "3.3"}  # where to look first; every theorem is tried before giving up
ALL_SIZES = invariant_loop.SIZES
SOURCES = (".flow", "reference", "disturbance", "field", "localization")


def run_by(block):
    """The functions that a block runs itself."""
    run = (block.update_function, block.output_function, block.jump_function)
    # of a law's output
    own = [getattr(function, "beside", function) for function in run]
    return [function for function in own if isinstance(function, FunctionType)]


def helpers_of(function):
    """The functions of `blocks` that a function calls by name."""
    named = (function.__globals__.get(name) for name in function.__code__.co_names)
    return [
        one
        for one in named
        if isinstance(one, FunctionType) and ".paper." in one.__module__
    ]


def reached(blocks):
    """Every function that blocks run, helpers included, in a fixed order."""
    found, stack = (
        {},
        [function for block in blocks for function in run_by(block)][::-1],
    )
    while stack:
        function = stack.pop()
        module = function.__module__.partition("paper.")[2].removeprefix("blocks.")
        key = f"{module}.{function.__name__}"
        if key not in found and ".paper." in function.__module__:
            found[key] = function
            stack += helpers_of(function)[::-1]
    return found


@cache
def functions():
    """Every function that a block of the package runs."""
    laws = [
        b for law in LAWS.values() for b in theorem_loop.law_and_V(law, all_proofs.N)
    ]
    return reached([*BLOCKS, *laws])


def terms_too(key):
    """Whether terms and calls are dropped as well."""
    return key.startswith("laws.robust.")


@cache
def mutants():
    table = functions().items()
    return [
        (k, n) for k, f in table for n, _ in enumerate(alterations(f, terms_too(k)))
    ]


@cache
def laws_of(function):
    """Name the laws whose equations or V have this function of a law's page."""
    if ".laws." not in function.__module__:
        return ()
    made = {
        name: theorem_loop.law_and_V(law, all_proofs.N) for name, law in LAWS.items()
    }
    return tuple(
        name for name, two in made.items() if function in reached(two).values()
    )


def said(law):
    found = all_proofs.Statement("laws", law).prove()
    return found.status, found.claim, found.for_every_N


said_unaltered = cache(said)


def caught_by(function, code, first):
    """Name the step that fails on the altered function; None if none does."""
    with exchanged(function, code):
        for check in CHECKS if function.__module__.endswith(SOURCES) else ():
            try:
                check()
            except Exception:  # whatever a wrong equation does
                return check.__name__
        for step in (
            team_proof.team_steps()
            if function.__module__.endswith(".consensus")
            else ()
        ):
            if not step.holds:
                return f"team: {step.claim}"
    for sizes in (invariant_loop.SIZES, ALL_SIZES):  # the largest only for what is left
        for law in laws_of(function):
            before = said_unaltered(law)
            with pytest.MonkeyPatch.context() as patch, exchanged(function, code):
                patch.setattr(invariant_loop, "SIZES", sizes)
                if said(law) != before:
                    return law
    with exchanged(function, code):
        for number in sorted(theorems.THEOREMS, key=lambda n: n != first):
            for step in audit(number)[number].failed:
                return f"{number}: {step.claim}"
        for misprint in misprints():
            if not misprint.confirmed:
                return f"misprint {misprint.equation}"
        for name, proof in all_proofs.LIMITED_SPEED.items():
            for step in proof_or_failure("failed", proof).failed:
                return f"{name}: {step.claim}"
    return None


def survivors(chosen):
    def caught(key, which):
        function, first = functions()[key], FIRST.get(key.split(".")[0], "3.2")
        return caught_by(function, altered(function, which, terms_too(key)), first)

    return [one for one in chosen if caught(*one) is None]


def test_there_are_signs_to_alter():
    assert len(mutants()) > 130
    rooms = {key.split(".")[0] for key, _ in mutants()}
    assert {"vehicle", "learner", "laws", "flow", "clpe", "localization"} <= rooms


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    """The exact steps come first; blocks are called at a few points only."""
    monkeypatch.setattr(theorems, "POINTS", 100)
    monkeypatch.setattr(theorems, "FEWER", 100)
    monkeypatch.setattr(all_proofs, "POINTS", 100)
    monkeypatch.setattr(invariant_loop, "SIZES", (1, 2))  # `clpt prove` asks all three


@pytest.mark.parametrize(
    "room", ["vehicle", "learner", "field", "laws", "laws.consensus", "clpe"]
)
def test_altered_signs_fail_the_proof(room):
    first = next(mutant for mutant in mutants() if mutant[0].startswith(f"{room}."))
    assert survivors([first]) == []


@pytest.mark.slow
def test_every_altered_sign_fails_the_proof():
    assert survivors(mutants()) == []
