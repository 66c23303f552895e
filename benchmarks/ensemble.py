"""Ensembles: every member differs in parameters and initial states; T = 200.

Run by its own name it is the child process of one engine:
`python -m benchmarks.ensemble ENGINE MEMBERS` prints one JSON object.  Members
are drawn chunk by chunk and only a summary is kept.
"""

import json
import sys
from collections.abc import Callable

import numpy as np

from . import cases
from .engines import ENGINES
from .measure import alone, in_turn, peak_memory

DURATION = 200.0


def child(name: str, count: int, least: float = 0.3) -> dict:
    """Run an ensemble in this process, again and again for at least `least` seconds."""
    engine = ENGINES[name]
    assert engine.members is not None
    scenario = cases.paper(DURATION).scenario
    run = engine.members(scenario)
    warm, _ = run(*cases.members(scenario, 0, min(count, cases.CHUNK)))
    seconds, repeats, spread = 0.0, 0, 0.0
    while seconds < least:
        for chunk, first in enumerate(range(0, count, cases.CHUNK)):
            drawn = cases.members(scenario, chunk, min(cases.CHUNK, count - first))
            final, spent = run(*drawn)
            seconds += spent
            spread = max(spread, float(np.max(np.abs(final[:, :2] - final[:, 2:4]))))
        repeats += 1
    return {
        "engine": name,
        "title": engine.title,
        "members": count,
        "seconds": seconds / repeats,
        "rate": count * repeats / seconds,
        "peak_mb": peak_memory(),
        "largest_final_clpe": spread,
        "error": _error(scenario, warm[:64]),
    }


def _error(scenario, final: np.ndarray) -> float | None:
    if ENGINES["c"].missing():
        return None
    from .c_engine import Program

    fine = scenario.with_values({"run.rtol": 1e-12, "run.atol": 1e-14})
    drawn = cases.members(scenario, 0, len(final))
    exact = Program(scenario.basis.N).members(fine, *drawn)[0]
    return float(np.max(np.abs(final - exact)))


def compare(
    chosen: list[str], count: int, rounds: int, say: Callable[[str], None]
) -> list[dict]:
    """Run one size in turn; return a row for each engine that can."""
    titles = {name: ENGINES[name].title for name in chosen if ENGINES[name].members}
    return in_turn("benchmarks.ensemble", titles, count, rounds, say)


def grow(
    chosen: list[str], sizes: list[int], longest: float, say: Callable[[str], None]
) -> list[dict]:
    """Run growing ensembles, once each, while an engine stays below `longest` seconds."""
    rows: list[dict] = []
    rates: dict[str, float] = {}
    for count in sizes:
        for name in chosen:
            if (
                ENGINES[name].members is None
                or count / rates.get(name, np.inf) > longest
            ):
                continue
            say(f"{count} members: {ENGINES[name].title}")
            found = alone("benchmarks.ensemble", name, count)
            rates[name] = found["rate"] if found else 1e-9
            rows += [found] if found else []
    return rows


if __name__ == "__main__":
    print(json.dumps(child(sys.argv[1], int(sys.argv[2]))))
