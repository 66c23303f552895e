"""What `clpt replay` writes and prints: NetCDF and figures, a row per dive, the whole."""

from pathlib import Path
from typing import Any

import typer

from .replay_ahead import Ahead, aimed, next_surfacing
from .replay_table import show_tables

RESULTS = ("replay.nc", "map.png", "clpe.png", "current.png")


def write(result: Any, folder: Path, ahead: Ahead) -> list[Path]:
    """Write a replay's NetCDF and figures into a folder, all or none, and return the files.

    ``replay.nc`` is the first and is put in place last: where it is new, the figures are.
    """
    from ..files import write_together
    from ..replay.dataset import replay_dataset
    from ..replay.plots import replay_figures

    goal = ahead.next_dive(result)
    figures = replay_figures(result, goal)
    results: dict[Path, Any] = {folder / RESULTS[0]: replay_dataset(result, ahead=goal)}
    results |= {folder / name: figure for name, figure in figures.items()}
    write_together(results)
    return list(results)


def summary_with_next(result: Any, skipped: list, ahead: Ahead) -> dict[str, Any]:
    """Return what `--json` prints: the summary, the next surfacing, where to aim."""
    from ..replay.outcome import summary

    if not result.steps:
        return {**summary(result, skipped), "next_dive": None, "aim": []}
    return {
        **summary(result, skipped),
        "next_dive": ahead.next_dive(result).as_dict(),
        "aim": [leg.as_dict() for leg in ahead.aims(result)],
    }


def show(result: Any, summary: dict[str, Any]) -> None:
    """Print a replay and what `summary_with_next` returns of it."""
    if result.steps:
        show_tables(summary)
    else:
        typer.echo("no dives yet")
    if "flow_model" in summary and result.steps:
        typer.echo("\n".join(coverage(summary["flow_model"], summary["used"])))
    for step in result.steps:
        if step.anomaly:
            typer.echo(f"speed anomaly: {step.anomaly}")
    if summary["dac_identity_median"] is not None:
        typer.echo(
            "miss / duration differs from the file's depth-averaged current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if result.steps:
        typer.echo(f"surfaced in the 90 % ellipse: {100 * summary['inside_90']:.0f} %")
        if summary["parts"]:
            chances = ", ".join(f"{name} {p:.2f}" for name, p in summary["parts"].items())
            typer.echo(f"probability that a part is present: {chances}")
        typer.echo(f"learned: {summary['said']['sentence']}")
    if summary["held"]:
        typer.echo(f"not yet known from these dives: {shortened(summary['held'])}")
    for line in by_reason(summary["notes"], "note"):
        typer.echo(line)
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        typer.echo(f"skipped {name}: {entry['why']}")
    if summary["next_dive"] is not None:
        typer.echo(next_surfacing(summary["next_dive"]))
    for leg in summary["aim"]:
        typer.echo(aimed(leg))


def shortened(names: list[str]) -> str:
    """Return names of parameters on a line, gaussians by their number.

    >>> shortened(["speed", "gaussian[0,0]_east", "gaussian[0,0]_north"])
    'speed, 2 of gaussians'
    """
    plain = [name for name in names if not name.startswith("gaussian[")]
    places = len(names) - len(plain)
    return ", ".join([*plain, *([f"{places} of gaussians"] if places else [])])


def coverage(given: dict[str, Any], used: int) -> list[str]:
    """Return lines that say which dives a flow model covers, and why not the others.

    >>> none = {"dive": 7, "why": "outside the forecast's area"}
    >>> given = {"source": "f.nc", "about": "gridded", "covered": 3, "uncovered": [none]}
    >>> for line in coverage(given, 4):
    ...     print(line)
    flow model f.nc (gridded) covers 3 of 4 dives
    no flow model for dive 7: outside the forecast's area
    """
    lines = [
        f"flow model {given['source']} ({given['about']}) covers {given['covered']} of {used} dives"
    ]
    return [*lines, *by_reason(given["uncovered"], "why", "no flow model for ")]


def by_reason(entries: list[dict[str, Any]], key: str, before: str = "") -> list[str]:
    """Return a line for each reason, with the dives that share it.

    >>> by_reason([{"dive": 3, "note": "odd"}, {"dive": 5, "note": "odd"}], "note")
    ['dives 3, 5: odd']
    """
    reasons: dict[str, list[str]] = {}
    for entry in entries:
        reasons.setdefault(entry[key], []).append(str(entry["dive"]))
    lines = []
    for why, dives in reasons.items():
        named = f"dive{'s'[: len(dives) > 1]} {', '.join(dives)}"
        if len(dives) > 6:
            named = f"{len(dives)} dives from {dives[0]} to {dives[-1]}"
        lines.append(f"{before}{named}: {why}")
    return lines
