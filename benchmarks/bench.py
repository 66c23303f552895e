"""Time the engines against each other: `python -m benchmarks.bench`.

One interleaved run, round-robin over the engines; medians, minima and ratios to
a C program of the same method.  Leaves performance.json, performance.md and
performance.png in the folder `--out`.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

from . import cases, ensemble, models, report, single
from .advection import PARTICLE_ENGINES
from .engines import ENGINES
from .measure import FAILURES, ROOT, in_turn, machine

SECTIONS = ("paper", "basis", "ensemble", "models", "particles")


def particles(chosen: list[str], count: int, rounds: int, say) -> list[dict]:
    """Move passive particles in turn; return a row for each engine, with its difference to C."""
    titles = {"c": "C", "native": ENGINES["native"].title, "parcels": "Parcels 3, JIT"}
    able = {name: titles[name] for name in PARTICLE_ENGINES if name in chosen}
    rows = in_turn("benchmarks.advection", able, count, rounds, say)
    exact = next((row["ends"] for row in rows if row["engine"] == "c"), None)
    for row in rows if exact else ():
        row["difference"] = float(np.max(np.abs(np.divide(row["ends"], exact) - 1)))
    return rows


def main(arguments: list[str] | None = None) -> int:
    """Run the benchmarks; return the exit status."""
    names = [*ENGINES, "parcels"]
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.bench", description=__doc__
    )
    parser.add_argument("--quick", action="store_true", help="about a minute")
    parser.add_argument("--engines", default=",".join(names), help=", ".join(names))
    parser.add_argument(
        "--sections", default=",".join(SECTIONS), help=", ".join(SECTIONS)
    )
    parser.add_argument(
        "--out", type=Path, default=ROOT / "docs", help="folder of the tables"
    )
    options = parser.parse_args(arguments)
    wanted, sections = options.engines.split(","), options.sections.split(",")
    unknown = sorted(set(wanted) - set(names)) + sorted(set(sections) - set(SECTIONS))
    if unknown:
        parser.error(f"unknown: {', '.join(unknown)}")

    def say(text: str) -> None:
        print(f"{time.strftime('%H:%M:%S')} {text}", file=sys.stderr, flush=True)

    lacking = {n: ENGINES[n].missing() for n in wanted if n in ENGINES}
    left_out = [f"{ENGINES[n].title}: {why}" for n, why in lacking.items() if why]
    for line in left_out:
        say(f"left out: {line}")
    chosen = [n for n in wanted if n in ENGINES and not lacking[n]]
    quick = options.quick
    rounds, budget = (2, 4.0) if quick else (15, 30.0)
    results: dict = {"machine": machine(), "left_out": left_out, "quick": quick}
    if "paper" in sections:
        results["paper"] = single.measure(cases.paper(), chosen, rounds, budget, say)
    if "basis" in sections:
        sizes = (3, 50) if quick else (3, 50, 500)
        few = [n for n in chosen if not (quick and ENGINES[n].waypoints)]
        end = 200.0 if quick else 2000.0
        results["basis_duration"] = end
        results["basis"] = {
            str(N): single.measure(cases.many(N, end), few, min(rounds, 5), budget, say)
            for N in sizes
        }
    if "ensemble" in sections:
        sizes = [10**k for k in range(4 if quick else 6)]
        longest = 2.0 if quick else 90.0
        results["ensemble"] = ensemble.compare(chosen, 1024, 1 if quick else 5, say)
        results["growth"] = ensemble.grow(chosen, sizes, longest, say)
    if "models" in sections:
        results["models"] = models.measure(chosen, rounds, budget, say)
    if "particles" in sections:
        able = [n for n in wanted if n == "parcels" or n in chosen]
        results["particles"] = particles(
            able, 200 if quick else 5000, 1 if quick else 5, say
        )
    results["left_out"] += list(dict.fromkeys(FAILURES))
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "performance.json").write_text(json.dumps(results, indent=1) + "\n")
    text = report.markdown(results)
    (options.out / "performance.md").write_text(text)
    report.figure(results, options.out / "performance.png")
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
