"""What `clpt replay` writes and prints: NetCDF and figures, a row per dive, the whole."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import typer

from .replay_ahead import Ahead
from .replay_table import show_tables

RESULTS = ("replay.nc", "replay.html", "next.geojson", "track.kml", "map.*", "clpe.*", "current.*")


def write(
    result: Any,
    skipped: list,
    folder: Path,
    ahead: Ahead,
    kinds: Sequence[str],
    again: bool = False,
) -> list[Path]:
    """Write a replay's NetCDF, page, places and figures into a folder, all or none.

    The files are returned.  ``replay.nc`` is the first and is put in place last: where it is
    new, the others are.  The page loads itself `again` where it will be written anew.
    """
    from ..files import write_together
    from ..replay.dataset import carrying, replay_dataset
    from ..replay.exchange import next_geojson, track_kml
    from ..replay.page import replay_page
    from ..replay.plots import replay_figures

    goal = ahead.next_dive(result)
    found = summary_with_next(result, skipped, ahead)
    results: dict[str, Any] = {
        "replay.nc": carrying(replay_dataset(result, found["vehicle"], ahead=goal), found),
        "replay.html": replay_page(found, again),
        "next.geojson": next_geojson(found),
        "track.kml": track_kml(found, found["vehicle"]),
    }
    for name, figure in replay_figures(result, goal, found["aim"]).items():
        results |= {f"{name}.{kind}": figure for kind in kinds}
    placed = {folder / name: one for name, one in results.items()}
    write_together(placed)
    return list(placed)


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


def show(summary: dict[str, Any]) -> None:
    """Print what `summary_with_next` returns of a replay."""
    from ..replay.sentences import aimed, next_surfacing, remarks

    if summary["each_dive"]:
        show_tables(summary)
    else:
        typer.echo("no dives yet")
    for line in remarks(summary):
        typer.echo(line)
    if summary["next_dive"] is not None:
        typer.echo(next_surfacing(summary["next_dive"]))
    for leg in summary["aim"]:
        typer.echo(aimed(leg))
