"""Time stiff problems beside SciPy's methods: `python -m benchmarks.stiff`.

For each problem and tolerance: milliseconds of a run, and its error at the end in tolerances.
SciPy is given the same rates as functions of Python, which take most of its time.
"""

import argparse
import time
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from clpt_control import Block
from clpt_control.engine.solver.native_diagram import NativeDiagram

from .stiff_problems import PROBLEMS, Problem

TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10)
PATIENCE = 20.0  # seconds of a run; longer ones of that engine are left out


def by_clpt(problem: Problem, method: str) -> Callable[[float], np.ndarray]:
    """Return what runs a problem here."""
    states = {"s": len(problem.start)}
    runner = NativeDiagram(Block("stiff", update=problem.rates, states=states))

    def run(rtol: float) -> np.ndarray:
        tolerances = {"rtol": rtol, "atol": rtol * problem.absolute}
        return runner.run(
            problem.start, [0.0, problem.end], method=method, **tolerances
        ).x[-1]

    return run


def by_scipy(problem: Problem, method: str) -> Callable[[float], np.ndarray]:
    """Return what runs a problem by SciPy."""

    def rates(t: float, x: np.ndarray) -> np.ndarray:
        return np.asarray(problem.rates(t, x, (), ()))

    def run(rtol: float) -> np.ndarray:
        tolerances = {"rtol": rtol, "atol": rtol * problem.absolute}
        return solve_ivp(
            rates, (0.0, problem.end), problem.start, method, **tolerances
        ).y[:, -1]

    return run


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.stiff", description=__doc__
    )
    parser.add_argument("--only", default="", help="part of a problem's name")
    chosen = parser.parse_args()
    print(
        "ms, and the error in tolerances, at rtol =",
        *(f"{rtol:13.0e}" for rtol in TOLERANCES),
    )
    for name, problem in PROBLEMS.items():
        if chosen.only not in name:
            continue
        for engine, make, method in (
            ("here", by_clpt, "rodas5p"),
            ("here", by_clpt, "auto"),
            ("SciPy", by_scipy, "Radau"),
            ("SciPy", by_scipy, "BDF"),
        ):
            print(
                f"{name:12s} {engine:6s} {method:8s}",
                *_row(problem, make(problem, method)),
            )


def _row(problem: Problem, run: Callable[[float], np.ndarray]) -> list[str]:
    found, took = [], 0.0
    for rtol in TOLERANCES:
        if took > PATIENCE:
            found.append(f"{'':14s}")
            continue
        run(rtol) if took < 1.0 else None  # what is compiled is compiled
        begin = time.perf_counter()
        end = run(rtol)
        took = time.perf_counter() - begin
        size = rtol * (problem.absolute + np.abs(problem.exact))
        off = np.max(np.abs(end - problem.exact) / size)
        found.append(f"{1e3 * took:8.1f} {off:6.2g}")
    return found


if __name__ == "__main__":
    main()
