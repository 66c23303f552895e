"""What `clpt replay` works out and writes: NetCDF, figures, the next surfacing."""

from pathlib import Path
from typing import Any

RESULT = "replay.nc"


def advance(session: Any) -> None:
    """Replay what is new, with a bar on standard error."""
    from ..progress import progress_bar

    with progress_bar("replaying dives", max(len(session.used), 1)) as report:
        session.run(report)


def summary_with_next(session: Any, ahead: tuple) -> dict[str, Any]:
    """Return what `--json` prints: the summary and the next surfacing."""
    from ..replay.surfacing import next_dive

    result = session.replay
    summary = result.summary(session.skipped)
    summary["next_dive"] = next_dive(result, *ahead).as_dict() if result.steps else None
    return summary


def write(result: Any, folder: Path, ahead: tuple) -> list[Path]:
    """Write a replay's NetCDF and figures into a folder.

    Parameters
    ----------
    result : Replay
        With one dive at least.
    folder : Path
        An existing folder.
    ahead : tuple
        Plan of the next dive, for the map.

    Returns
    -------
    list of Path
        The files, ``replay.nc`` first; it is put in place last, so that where it
        is new the figures are.

    Raises
    ------
    DataError
        If one cannot be written; then the folder is as it was.
    """
    from ..files import write_together
    from ..replay.file import replay_dataset
    from ..replay.plots import replay_figures
    from ..replay.surfacing import next_dive

    figures = replay_figures(result, next_dive(result, *ahead))
    results: dict[Path, Any] = {folder / RESULT: replay_dataset(result)}
    results |= {folder / name: figure for name, figure in figures.items()}
    write_together(results)
    return list(results)
