"""Write a page to send of anything that clpt writes: a run, a team's, an ensemble or a replay.

The file itself tells which of them it is.
"""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from ...base.arguments import public
from ...base.errors import DataError
from ...base.figures import ONE_DRAWING, checked_formats
from ...base.files import check_writable, make_folder, write_together
from ...base.files.reading import open_netcdf
from ...base.run_attributes import beyond_scenario
from ...paper.scenario.recorded_run import (
    check_response,
    check_run,
    is_response,
    kind_of,
)

if TYPE_CHECKING:
    import xarray

    from ...base.page import Page
    from ...ocean.forecast.replay import Replay
    from ...paper.scenario.experiment import Scenario

NEEDED = (  # variables of a run
    "time",
    "position",
    "predicted_position",
    "clpe",
    "feedback_gain",
    "feedforward_gain",
    "flow_parameters_estimate",
)


@public
def report(
    run: Union["xarray.Dataset", "Replay", str, Path],
    path: str | Path,
    title: str | None = None,
    figures: str | Path | None = None,
    formats: Sequence[str] = ("svg", "pdf"),
) -> dict[str, Any]:
    """Write a page to send: one HTML file that needs nothing else.

    Nothing is run again, nothing is fetched, and no script is needed to read it.

    Parameters
    ----------
    run : xarray.Dataset, Replay, str or Path
        A run, a team's run, a diagram's, an ensemble, a replay or a flow learned from fixes; or
        the file or folder of one.
    path : str or Path
        The page, such as ``report.html``.
    title : str, optional
        In place of the scenario's.
    figures : str or Path, optional
        Folder to write the figures to as well.
    formats : sequence of str, optional
        Of these figures: ``"svg"``, ``"pdf"``, ``"png"``.

    Returns
    -------
    dict
        ``file``, ``bytes``, ``kind``, ``title``, ``sentences`` (of what it is, and
        warnings) and ``figures``, the files written.

    Raises
    ------
    DataError
        If it cannot be read, is nothing that clpt writes, or the page cannot be written.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 60}))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     made = clpt.report(run, folder + "/report.html", title="A first minute")
    >>> made["kind"], made["title"]
    ('Run of a scenario', 'A first minute')
    """
    from ...base.page import page_html

    path, kinds = Path(path), checked_formats(formats)
    check_writable(path, "a page", (".html", ".htm"))
    source, name = run, "the replay"
    with ONE_DRAWING:
        if isinstance(run, str | Path):
            source, name = read(Path(run)), str(run)
        folder = None if figures is None else make_folder(figures)
        page = page_of(source, title, name)
        text = page_html(page)
        results = {}
        if folder is not None:
            results = {
                folder / f"{item.name}.{end}": item.figure
                for item in page.figures
                for end in kinds
            }
        write_together({path: text, **results})
    return {
        "file": str(path),
        "bytes": len(text.encode()),
        "kind": page.kind,
        "title": page.title,
        "sentences": [*page.sentences, *page.warnings],
        "figures": [str(item) for item in results],
    }


def page_of(data: Any, title: str | None, name: str) -> "Page":
    """Return the page of a run, a team's or a diagram's, of an ensemble, fixes or a replay."""
    from ...paper.scenario.team import system_of_run
    from .ensemble_page import ensemble_page
    from .fixes_page import fixes_page
    from .run_page import diagram_page, run_page

    if hasattr(data, "steps") or kind_of(data) == "replay":
        return _page_of_replay(data, title, name)
    if kind_of(data) == "ensemble":
        return ensemble_page(data, title)
    if kind_of(data) == "fixes":
        return fixes_page(data, title)
    of_run = title or _title_of(data)
    if is_response(data):
        check_response(data)
        return diagram_page(data, of_run)
    system = system_of_run(data)
    check_run(data, system, *NEEDED)
    return run_page(data, system, of_run)


def _title_of(run: "xarray.Dataset") -> str:
    """Return the title of a run; a changed run of the paper's scenario has a title of its own."""
    from ...paper.scenario.file import paper_scenario
    from ...paper.scenario.team import scenario_of_run

    title = str(run.attrs.get("title") or "A run without a title")
    paper = paper_scenario()
    if title != paper.title:
        return title
    changes = beyond_scenario(run.attrs)
    if "scenario" in run.attrs:
        values, of_paper = map(_by_key, (scenario_of_run(run), paper))
        keys = [key for key in values if values[key] != of_paper.get(key)]
        changes += [f"other {', '.join(keys)}"] if keys else []
    return f"The paper's loop with {'; '.join(changes)}" if changes else title


def _by_key(scenario: "Scenario") -> dict[str, Any]:
    """Return the values of a scenario's keys; those of the run itself are left out."""
    tables = scenario.model_dump(exclude={"title", "run"}, exclude_none=True)
    return {
        f"{name}.{key}".rstrip("."): value
        for name, table in tables.items()
        for key, value in (table.items() if isinstance(table, dict) else [("", table)])
    }


def _page_of_replay(data: Any, title: str | None, name: str) -> "Page":
    """Return the page of a replay, or refuse one that is damaged."""
    from ...ocean.forecast.netcdf_export import report_of
    from ...ocean.forecast.replay_page import replay_page

    replay = report_of(data, name)
    try:
        return replay_page(replay, title=title)
    except (
        LookupError,
        ArithmeticError,
        TypeError,
        ValueError,
        AttributeError,
    ) as error:
        reason = f"{type(error).__name__}: {error}"
        raise DataError(
            f"the replay is damaged or of another version, {reason[:80]}. Run `clpt replay` again"
        ) from None


# --- what a file or folder is --------------------------------------------------------------------


def read(path: Path) -> "xarray.Dataset":
    """Return what lies there: a run, an ensemble or a replay."""
    if os.path.isdir(path):  # noqa: PTH112 - never raises
        from ...ensemble.results import open_ensemble

        return open_ensemble(path)
    from ...simulation.run_file import load_run

    with open_netcdf(path) as data:
        if kind_of(data) in ("replay", "fixes"):
            return data.load()
    return load_run(path)
