"""One sign altered anywhere in a block's equations, or a term of a robust law dropped: is it seen?

The mutants come from the syntax tree of every function that a block runs; none is listed
by hand.  Equations of the paper are the theorems' to defend, those of a law its own row's,
those of a team its proof's, sources of time and tables those of `source_checks`.
"""

from collections import namedtuple
from functools import cache
from types import FunctionType

import numpy as np
import pytest
from altered_rows import PROOFS
from mutated_equations import alterations, altered, exchanged
from package_blocks import BLOCKS
from small_scenarios import paper_of
from source_checks import CHECKS

import clpt_control as clpt
from clpt_control.theory import audit, misprints

pytestmark = pytest.mark.long  # by `make test-long`

LAWS, Truth = clpt.laws(), namedtuple("Truth", "theta KD GammaD")
FIRST = {"clpe": "3.3"}  # where to look first; every theorem is tried before giving up
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


def law_and_V(name):
    """The blocks of a law of two functions and of its V."""
    scenario = paper_of(2, name)
    law, vehicle = LAWS[name].block(scenario.known_to_law), scenario.vehicle
    numbers = scenario.flow.parameters, vehicle.feedback, vehicle.feedforward
    return law, LAWS[name].V(law.parameters, Truth(*map(np.array, numbers)))


@cache
def functions():
    """Every function that a block of the package runs."""
    laws = [block for name in LAWS for block in law_and_V(name)]
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
    made = {name: law_and_V(name) for name in LAWS}
    return tuple(
        name for name, two in made.items() if function in reached(two).values()
    )


def said(law):
    """What is found of a law, or why it cannot be read."""
    try:
        found = PROOFS["laws"][law]()
    except clpt.ClptError as error:
        return f"{error}"
    return found.status, found.sentence, found.for_every_N


said_unaltered = cache(said)


def failed(proof):
    """The first step of a proof that fails, or why none can be read."""
    try:
        steps = proof().failed
    except clpt.ClptError as error:
        return f"{error}"
    return next((step.claim for step in steps), None)


def caught_by(function, code, first):
    """Name the step that fails on the altered function; None if none does."""
    with exchanged(function, code):
        for check in CHECKS if function.__module__.endswith(SOURCES) else ():
            try:
                check()
            except Exception:  # whatever a wrong equation does
                return check.__name__
        if function.__module__.endswith(".consensus"):
            return failed(PROOFS["team"][""])
    for law in laws_of(function):
        before = said_unaltered(law)
        with exchanged(function, code):
            if said(law) != before:
                return law
    with exchanged(function, code):
        for number in sorted(PROOFS["theorems"], key=lambda n: n != first):
            for step in audit(number)[number].failed:
                return f"{number}: {step.claim}"
        for misprint in misprints():
            if not misprint.confirmed:
                return f"misprint {misprint.equation}"
        for name, proof in PROOFS["limited_speed"].items():
            if claim := failed(proof):
                return f"{name}: {claim}"
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


@pytest.mark.parametrize(
    "room", ["vehicle", "learner", "field", "laws", "laws.consensus", "clpe"]
)
def test_altered_signs_fail_the_proof(room):
    first = next(mutant for mutant in mutants() if mutant[0].startswith(f"{room}."))
    assert survivors([first]) == []


@pytest.mark.slow
def test_every_altered_sign_fails_the_proof():
    assert survivors(mutants()) == []


# --- equations that look right -------------------------------------------------------------------


def added(t, x, u, p):
    """z' = F_M + v + d, not Eq. (2) hedged."""
    return u.flow_z + u.v_z + getattr(u, "unflown", 0.0)


def too_fast(t, x, u, p):
    """v = 2 v_c, no limit, for Eq. (1)."""
    return 2 * u.v_c


def together(t, x, u, p):
    """pull = -kappa sum_j (alpha + alpha_j), section III with a wrong sign."""
    own = (u.alpha + getattr(u, f"alpha_{j}") for j in range(p.neighbours))
    return {"pull": -p.coupling * sum(own)}


WRONG = [
    ("learner.model", added, "with hedging", "V' = -e^T KD e"),
    ("vehicle.limited", too_fast, "with hedging", "up to |v_c| = v_max"),
    ("vehicle.difference", too_fast, "with hedging", "V' = -e^T KD e"),
    ("laws.consensus.consensus", together, "", "V' = "),
]


@pytest.mark.parametrize(("key", "wrong", "name", "claim"), WRONG)
def test_a_wrong_equation_is_not_proved(key, wrong, name, claim):
    room = "limited_speed" if name else "team"
    with exchanged(functions()[key], wrong.__code__):
        assert claim in failed(PROOFS[room][name])
    assert failed(PROOFS[room][name]) is None


def test_a_team_in_which_one_does_not_hear_back_is_not_proved(monkeypatch):
    """V' is not that of the edge."""
    heard = lambda self, name: ["b"] if name == "a" else []  # noqa: E731
    monkeypatch.setattr(clpt.Team, "neighbours", heard)
    assert failed(PROOFS["team"][""])
