"""The registry: every engine that is timed, and what it can do.

To add one, write a function that prepares a case, and give it a line in
`ENGINES`:

    def prepare(case):          # a cases.Case; compile here, this is not timed
        def run():              # from 0 to the end
            return states, seconds      # at case.times, shape (n, 2 N + 8)
        return run

    def prepare_members(scenario):
        def run(parameters, states):    # as cases.members draws them
            return final_states, seconds
        return run
"""

import importlib.util
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from .build import compiler
from .cases import Case


@dataclass(frozen=True)
class Engine:
    """One way to run the closed loop.

    Attributes
    ----------
    title : str
        What the tables call it.
    prepare : callable or None
        Case -> function of no arguments -> states, seconds.
    members : callable, optional
        Scenario -> function of parameters and states -> states, seconds.
    needs : str, optional
        Module without which it is left out; ``"cc"``: a C compiler.
    waypoints : int, optional
        It is too slow for a whole run: so many waypoints are timed.
    largest : int, optional
        Most basis functions that it is asked to run.
    note : str, optional
        What a reader of its figures must know.
    """

    title: str
    prepare: Callable[[Case], Callable[[], tuple[np.ndarray, float]]] | None
    members: Callable[[Any], Callable] | None = None
    needs: str = ""
    waypoints: int | None = None
    largest: int = 500
    note: str = ""

    def missing(self) -> str | None:
        """Say what it lacks here; None where it can run."""
        if self.needs == "cc":
            return None if compiler() else "there is no C compiler"
        if self.needs and importlib.util.find_spec(self.needs) is None:
            return f"{self.needs} is not installed (benchmarks/requirements.txt)"
        return None


def timed(function: Callable, *arguments) -> tuple[Any, float]:
    """Call a function; give its result and the seconds."""
    begin = time.perf_counter()
    result = function(*arguments)
    return result, time.perf_counter() - begin


def _c(*options: str, source: str = "scalar"):
    def fastest(N: int, run) -> Any:
        """Return the faster of: N known to the compiler, N read at run time."""
        from .c_engine import Program

        programs = [Program(N, source, *options, constant=c) for c in (True, False)]
        return min(programs, key=lambda program: min(run(program)[1] for _ in range(3)))

    def prepare(case: Case):
        from .c_engine import Program

        constant = Program(case.N, source, *options)
        program = fastest(case.N, lambda p: p.run(case)) if case.N < 100 else constant
        return lambda: program.run(case)

    def members(scenario):
        from .c_engine import Program

        program = Program(scenario.basis.N, source, *options)
        return lambda parameters, states: program.members(scenario, parameters, states)

    return prepare, members


def _from(module: str, name: str) -> Callable:
    """Return a function of a module that is imported when it is first called."""

    def call(*arguments):
        return getattr(importlib.import_module(f"benchmarks.{module}"), name)(*arguments)

    return call


_diagram, _diagram_members = _c()
_shared, _ = _c("-DSHARE_TIDE")
_cancelled, _cancelled_members = _c("-DCANCEL")
_lanes_of_basis, _ = _c("-DCANCEL", "-DBASIS_LANES")
_, _lanes = _c(source="lanes")
_, _lanes_cancelled = _c("-DCANCEL", source="lanes")

ENGINES = {
    "c": Engine("C, both phi as the diagram does", _diagram, _diagram_members, "cc"),
    "c-tide": Engine("C, the cosines shared by both phi", _shared, None, "cc"),
    "c-cancel": Engine("C, phi(z) cancelled by hand", _cancelled, _cancelled_members, "cc"),
    "c-basis": Engine("C, cancelled, SIMD over the basis", _lanes_of_basis, None, "cc"),
    "c-lanes": Engine("C, a run in each SIMD lane", None, _lanes, "cc"),
    "c-lanes-cancel": Engine("C, SIMD lanes, cancelled", None, _lanes_cancelled, "cc"),
    "native": Engine(
        "clpt-control, the fused diagram",
        _from("native_engine", "prepare"),
        _from("native_engine", "members"),
    ),
    "simulate": Engine(
        "clpt-control, simulate() to a Dataset", _from("native_engine", "simulate"), largest=50
    ),
    "python": Engine("clpt-control, blocks in Python", _from("python_engines", "plain"), largest=3),
    "python-control": Engine(
        "python-control, input_output_response",
        _from("python_engines", "python_control"),
        waypoints=10,
        largest=50,
    ),
    "heyoka": Engine(
        "heyoka (Taylor)",
        _from("heyoka_engine", "prepare"),
        _from("heyoka_engine", "members"),
        "heyoka",
        largest=50,
        note="the blocks' equations traced; sqrt(d2 + 1e-24), for it has no series at x = c",
    ),
    "diffrax": Engine(
        "diffrax Dopri8",
        _from("diffrax_engine", "prepare"),
        _from("diffrax_engine", "members"),
        "diffrax",
        largest=3,
        note=(
            "the blocks' equations traced number by number, which does not suit XLA: "
            "written again by hand on vectors they take about a quarter of the time"
        ),
    ),
}
