"""The registry: every engine that is timed, and what it can do.

To add one, write a module with these two functions, the second if it can run ensembles,
and add it to `ENGINES`:

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
    """One way to run the closed loop."""

    title: str  # in the tables
    prepare: Callable[[Case], Callable[[], tuple[np.ndarray, float]]]
    members: Callable[[Any], Callable] | None = None
    needs: str = ""  # module without which it is left out; "cc": a C compiler
    # too slow for a whole run: so many waypoints are timed
    waypoints: int | None = None
    largest: int = 500  # most basis functions that it is asked to run
    note: str = ""  # what a reader of its figures must know

    def missing(self) -> str | None:
        """Return what it lacks here; None where it can run."""
        if self.needs == "cc":
            return None if compiler() else "there is no C compiler"
        if self.needs and importlib.util.find_spec(self.needs) is None:
            return f"{self.needs} is not installed (benchmarks/requirements.txt)"
        return None


def timed(function: Callable, *arguments) -> tuple[Any, float]:
    """Call a function; return its result and the seconds."""
    begin = time.perf_counter()
    result = function(*arguments)
    return result, time.perf_counter() - begin


def _from(module: str, name: str) -> Callable:
    """Return a function of a module that is imported when it is first called."""

    def call(*arguments):
        return getattr(importlib.import_module(f"benchmarks.{module}"), name)(
            *arguments
        )

    return call


ENGINES = {
    "c": Engine(
        "C",
        _from("c_engine", "prepare"),
        _from("c_engine", "members"),
        "cc",
        note="phi(z), which cancels in z', is left out by hand",
    ),
    "c-lanes": Engine(
        "C, in SIMD lanes",
        _from("c_engine", "prepare_in_lanes"),
        _from("c_engine", "members_in_lanes"),
        "cc",
        note="eight basis functions at once; in ensembles, a run in each lane",
    ),
    "native": Engine(
        "clpt-control", _from("own_engines", "prepare"), _from("own_engines", "members")
    ),
    "simulate": Engine(
        "clpt-control, simulate", _from("own_engines", "simulate"), largest=50
    ),
    "python": Engine(
        "clpt-control, Python", _from("own_engines", "in_python"), largest=3
    ),
    "python-control": Engine(
        "python-control",
        _from("own_engines", "python_control"),
        waypoints=10,
        largest=50,
    ),
    "heyoka": Engine(
        "heyoka (Taylor)",
        _from("heyoka_engine", "prepare"),
        _from("heyoka_engine", "members"),
        "heyoka",
        largest=50,
        note="traced; sqrt(d2 + 1e-24), as there is no series at x = c",
    ),
    "diffrax": Engine(
        "diffrax Dopri8",
        _from("diffrax_engine", "prepare"),
        _from("diffrax_engine", "members"),
        "diffrax",
        largest=3,
        note=(
            "traced number by number; by hand on vectors it takes about a quarter of the time"
        ),
    ),
}
