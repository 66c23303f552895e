"""One run at a time: the paper's, and with more basis functions."""

from collections.abc import Callable

import numpy as np

from . import cases
from .cases import Case
from .engines import ENGINES, Engine
from .measure import interleave


def evaluations(case: Case) -> int:
    """Count the evaluations of DOP853 over a case, by the C program."""
    from .c_engine import Program

    program = Program(case.N)
    program.run(case)
    return program.counts.evaluations


def share(case: Case, waypoints: int) -> float:
    """Return the share of a run's evaluations that fall on its first waypoints."""
    part = shortened(case, waypoints)
    if ENGINES["c"].missing():
        return len(part.times[1:]) / len(case.times[1:])
    return evaluations(part) / evaluations(case)


def shortened(case: Case, waypoints: int) -> Case:
    """Return the first waypoints of a case."""
    end = float(case.times[min(waypoints, len(case.times) - 1)])
    return Case(
        case.name,
        case.scenario.with_values({"run.duration": end}),
        case.times[: waypoints + 1],
    )


def paper_error(engine: Engine, case: Case, states: np.ndarray) -> float:
    """Return max |state - reference| at the times of paper.json that were reached."""
    times, reference = cases.reference_states()
    at = {float(t): k for k, t in enumerate(case.times)}
    errors = [
        np.max(np.abs(states[at[t]] - row))
        for t, row in zip(times, reference, strict=True)
        if t in at
    ]
    early = engine.prepare(cases.paper(10.0))()[0][-1]  # t = 10 is inside a dwell
    return float(max(*errors, np.max(np.abs(early - reference[0]))))


def tight(case: Case) -> np.ndarray:
    """Return the states of a case by the C program at a tolerance of 1e-12."""
    from .c_engine import Program

    fine = case.scenario.with_values({"run.rtol": 1e-12, "run.atol": 1e-14})
    return Program(case.N).run(Case(case.name, fine, case.times))[0]


def measure(
    case: Case,
    chosen: list[str],
    rounds: int,
    budget: float,
    say: Callable[[str], None],
) -> list[dict]:
    """Time the chosen engines on one case, in turn, an engine for at most `budget` seconds.

    Return for each its title, median and minimum (seconds), ratio of medians to C, error,
    rounds and a note; `say` is told what is being done.
    """
    runs, rows = {}, {}
    for name in chosen:
        engine = ENGINES[name]
        if engine.largest < case.N:
            continue
        say(f"{case.name}: {engine.title}")
        part = shortened(case, engine.waypoints) if engine.waypoints else case
        scale = share(case, engine.waypoints) if engine.waypoints else 1.0
        run = engine.prepare(part)
        states = run()[0]
        if case.N == 3:
            error = paper_error(engine, part, states)
        elif ENGINES["c"].missing():
            error = float("nan")
        else:
            error = float(np.max(np.abs(states - tight(part))))
        note = engine.note
        if engine.waypoints:
            note = (
                f"{engine.waypoints} of {len(case.times) - 1} waypoints timed, "
                f"scaled by their share of the evaluations ({scale:.3f})"
            )
        rows[name] = {
            "engine": name,
            "title": engine.title,
            "error": error,
            "note": note,
        }
        runs[name] = lambda run=run, scale=scale: run()[1] / scale
    for name, figures in interleave(runs, rounds, budget, say).items():
        rows[name] |= figures
    if "c" in rows:
        for row in rows.values():
            row["ratio"] = row["median"] / rows["c"]["median"]
    return list(rows.values())
