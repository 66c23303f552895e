"""What `clpt replay` writes and prints: NetCDF and figures, a row per dive, the whole."""

from pathlib import Path
from typing import Any

import typer

from .replay_ahead import Ahead, aimed, next_surfacing
from .replay_table import columns, show_tables

RESULTS = (
    "replay.nc",
    "replay.html",
    "next.geojson",
    "track.kml",
    "map.png",
    "clpe.png",
    "current.png",
)


def write(result: Any, skipped: list, folder: Path, ahead: Ahead) -> list[Path]:
    """Write a replay's NetCDF, page, places and figures into a folder, all or none.

    The files are returned.  ``replay.nc`` is the first and is put in place last: where it is
    new, the others are.
    """
    from ..files import write_together
    from ..replay.dataset import replay_dataset
    from ..replay.exchange import next_geojson, track_kml
    from ..replay.page import replay_page
    from ..replay.plots import replay_figures

    goal = ahead.next_dive(result)
    found = summary_with_next(result, skipped, ahead)
    told = told_of(result, found)
    results: dict[str, Any] = {
        "replay.nc": replay_dataset(result, told.vehicle, ahead=goal),
        "replay.html": replay_page(found, told),
        "next.geojson": next_geojson(found),
        "track.kml": track_kml(found, told.vehicle),
        **replay_figures(result, goal, found["aim"]),
    }
    write_together({folder / name: results[name] for name in RESULTS})
    return [folder / name for name in RESULTS]


def told_of(result: Any, summary: dict[str, Any]) -> Any:
    """Return what a page tells in words: those that `show` prints."""
    from ..replay.page import Told

    each = summary["each_dive"]
    table = columns(each[0])
    return Told(
        result.steps[-1].dive.vehicle or "glider",
        [next_surfacing(summary["next_dive"]), *map(aimed, summary["aim"])],
        [(column.title, column.rank) for column in table],
        [[column.cell(row) for column in table] for row in each],
        remarks(result, summary),
    )


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
    for line in remarks(result, summary):
        typer.echo(line)
    if summary["next_dive"] is not None:
        typer.echo(next_surfacing(summary["next_dive"]))
    for leg in summary["aim"]:
        typer.echo(aimed(leg))


def remarks(result: Any, summary: dict[str, Any]) -> list[str]:
    """Return lines on what was learned, noted and skipped."""
    lines: list[str] = []
    if "flow_model" in summary and result.steps:
        lines += coverage(summary["flow_model"], summary["used"])
    lines += [f"speed anomaly: {step.anomaly}" for step in result.steps if step.anomaly]
    if summary["dac_identity_median"] is not None:
        lines.append(
            "miss / duration differs from the file's depth-averaged current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if result.steps:
        lines.append(f"surfaced in the 90 % ellipse: {100 * summary['inside_90']:.0f} %")
        if summary["parts"]:
            chances = ", ".join(f"{name} {p:.2f}" for name, p in summary["parts"].items())
            lines.append(f"probability that a part is present: {chances}")
        lines.append(f"learned: {summary['said']['sentence']}")
    if summary["held"]:
        lines.append(f"not yet known from these dives: {shortened(summary['held'])}")
    lines += by_reason(summary["notes"], "note")
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        lines.append(f"skipped {name}: {entry['why']}")
    return lines


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
