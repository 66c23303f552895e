"""What `clpt replay` writes and prints: NetCDF and figures, a row per dive, the whole."""

from pathlib import Path
from typing import Any

import typer

from .printing import print_table

RESULTS = ("replay.nc", "map.png", "clpe.png", "current.png")
COLUMNS = {
    "no_flow": "no flow",
    "previous_dive": "previous",
    "adaptive": "adaptive",
    "flow_model": "model",
}
ROWS = {
    "clpe_rms": "after the first dive",
    "clpe_rms_all": "all, the first with no flow",
    "clpe_rms_after_3": "after the third dive",
}


def write(result: Any, folder: Path, ahead: tuple) -> list[Path]:
    """Write a replay's NetCDF and figures into a folder, all or none, and return the files.

    ``replay.nc`` is the first and is put in place last: where it is new, the figures are.
    """
    from ..files import write_together
    from ..replay.dataset import replay_dataset
    from ..replay.plots import replay_figures
    from ..replay.surfacing import next_dive

    goal = next_dive(result, *ahead)
    figures = replay_figures(result, goal)
    results: dict[Path, Any] = {folder / RESULTS[0]: replay_dataset(result, ahead=goal)}
    results |= {folder / name: figure for name, figure in figures.items()}
    write_together(results)
    return list(results)


def summary_with_next(result: Any, skipped: list, ahead: tuple) -> dict[str, Any]:
    """Return what `--json` prints: the summary and the next surfacing."""
    from ..replay.outcome import summary
    from ..replay.surfacing import next_dive

    ahead_of = next_dive(result, *ahead).as_dict() if result.steps else None
    return {**summary(result, skipped), "next_dive": ahead_of}


def show(result: Any, summary: dict[str, Any]) -> None:
    """Print a replay and what `summary_with_next` returns of it."""
    if result.steps:
        show_tables(result, summary)
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
        typer.echo(f"learned: {shortened(summary['learned']) or 'nothing'}")
    if summary["held"]:
        typer.echo(f"held, hardly better known than before the dives: {shortened(summary['held'])}")
    for line in by_reason(summary["notes"], "note"):
        typer.echo(line)
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        typer.echo(f"skipped {name}: {entry['why']}")
    if summary["next_dive"] is not None:
        typer.echo(next_surfacing(summary["next_dive"]))


def show_tables(result: Any, summary: dict[str, Any]) -> None:
    """Print a row per dive, then the CLPE rms."""
    from ..replay.step import ellipse

    rows = []
    for step in result.steps:
        current = " ".join(
            f"{v:+.3f}({1000 * e:.0f})"
            for v, e in zip(step.current, step.current_error, strict=True)
        )
        long, short, angle = ellipse(step.covariance)
        rows.append(
            [
                str(step.dive.number),
                *(metres(step.clpe[key]) for key in result.models),
                current,
                f"{step.speed:.3f}({1000 * step.speed_error:.0f})",
                f"{step.forecast[0]:+.0f} {step.forecast[1]:+.0f}",
                f"{long:.0f} x {short:.0f}, {angle:.0f}",
                "in" if step.inside else "OUT",
                "" if step.anomaly is None else "SPEED" if step.anomaly.certain else "SPEED?",
            ]
        )
    models = [COLUMNS[key] for key in result.models]
    columns = ["dive", *models, "current E N (m/s)", "speed", "E N of DR (m)"]
    print_table(
        "CLPE (m), one dive ahead; learned (standard error, last digits); forecast surfacing",
        [*columns, "90 % ellipse (m, deg)", "", ""],
        rows,
    )
    means = {name: summary[key] for key, name in ROWS.items()}
    if "flow_model" in summary and 0 < summary["flow_model"]["covered"] < summary["used"]:
        means["covered, after the first dive"] = summary["flow_model"]["clpe_rms"]
    table = [[name, *map(metres, rms.values())] for name, rms in means.items()]
    print_table("CLPE rms (m)", ["", *models], table)


def metres(size: float | None) -> str:
    """Return a length as the table shows it, m."""
    return "-" if size is None else f"{size:.0f}"


def next_surfacing(ahead: dict[str, Any]) -> str:
    """Return the sentence on `NextDive.as_dict`."""
    uncovered = ahead["flow_model_covers"] is False
    return (
        f"next surfacing, after {ahead['duration'] / 3600:.2f} h and {ahead['dr_east']:+.0f} m "
        f"east, {ahead['dr_north']:+.0f} m north through the water: "
        f"{place(ahead['latitude'], ahead['longitude'])}, 90 % within "
        f"{ahead['ellipse_90_long']:.0f} x {ahead['ellipse_90_short']:.0f} m"
        + (f"; the flow model does not cover it: {ahead['why_uncovered']}" if uncovered else "")
    )


def place(lat: float, lon: float) -> str:
    """Return a place in words, degrees.

    >>> place(-42.93, 8.42)
    '42.9300 S 8.4200 E'
    """
    return f"{abs(lat):.4f} {'NS'[lat < 0]} {abs(lon):.4f} {'EW'[lon < 0]}"


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
