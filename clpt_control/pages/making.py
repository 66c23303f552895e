"""A page to send of anything that clpt writes: the file is asked what it is."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from ..arguments import public
from ..errors import DataError
from ..figures import checked_formats
from ..files import check_writable, make_folder, write_together

if TYPE_CHECKING:
    import xarray

    from ..replay.replay import Replay
    from .page import Page

ENDINGS = (".html", ".htm")


@public
def report(
    run: Union["xarray.Dataset", "Replay", str, Path],
    file: str | Path,
    title: str | None = None,
    figures: str | Path | None = None,
    formats: Sequence[str] = ("svg", "pdf"),
) -> dict[str, Any]:
    """Write a page to send: one HTML file that needs nothing else.

    Nothing is run again, nothing is fetched, and no script is needed to read it.

    Parameters
    ----------
    run : xarray.Dataset, Replay, str or Path
        A run, a team's run, an ensemble or a replay; or the file or folder of one.
    file : str or Path
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
        ``file``, ``bytes``, ``kind``, ``title``, ``sentences`` (what was asked and found) and
        ``figures``, the files written.

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
    from ..replay.dataset import carried
    from .kinds import checked_replay, read

    path, kinds = check_page(file), checked_formats(formats)
    found: Any = read(Path(run)) if isinstance(run, str | Path) else run
    if "dive" in getattr(found, "dims", ()):
        found = checked_replay(carried(found, "the replay"), "the replay")
    if hasattr(found, "steps") or isinstance(found, dict):
        return _replay(found, path, title, figures)
    folder = None if figures is None else make_folder(figures)
    return _written(page_of(found, title), path, folder, kinds)


def check_page(file: str | Path) -> Path:
    """Return where a page is to be written; refuse a place where it cannot be."""
    path = Path(file)
    check_writable(path)
    if path.suffix.lower() not in ENDINGS:
        raise DataError(f"{path}: a page's name must end in {' or '.join(ENDINGS)}")
    return path


def page_of(data: "xarray.Dataset", title: str | None = None) -> "Page":
    """Return the page of a run, of a team's run or of an ensemble."""
    from ..scenario.team_file import system_of_run
    from .kinds import checked_run, is_ensemble

    if not hasattr(data, "attrs") or not hasattr(data, "dims"):
        raise DataError(
            f"{data!r:.60}: must be a run, an ensemble or a replay; clpt.load_run reads a run"
        )
    if is_ensemble(data):
        from .ensemble_page import ensemble_page

        return ensemble_page(data, title)
    checked_run(data)
    from .run_page import run_page

    return run_page(data, system_of_run(data), title)


def _written(page: "Page", path: Path, folder: Path | None, kinds: Sequence[str]) -> dict[str, Any]:
    """Write a page and its figures, all or none."""
    from .page import page_html

    text = page_html(page)
    results: dict[Path, Any] = {path: text}
    if folder is not None:
        for one in page.figures():
            results |= {folder / f"{one.name}.{kind}": one.figure for kind in kinds}
    write_together(results)
    return {
        "file": str(path),
        "bytes": len(text.encode()),
        "kind": page.kind,
        "title": page.title,
        "sentences": list(page.sentences),
        "figures": [str(one) for one in results if one != path],
    }


def _replay(
    found: Any, path: Path, title: str | None, figures: str | Path | None
) -> dict[str, Any]:
    """Write the page for one on watch with a glider."""
    from ..replay.outcome import summary
    from ..replay.page import replay_page
    from ..replay.sentences import next_surfacing
    from ..replay.surfacing import next_dive
    from .kinds import checked_replay

    if figures is not None:
        raise DataError("figures: a replay's are written by `clpt replay --out`; leave it away")
    if hasattr(found, "steps"):
        ahead = next_dive(found).as_dict() if found.steps else None
        found = checked_replay({**summary(found), "next_dive": ahead}, "the replay")
    try:
        text = replay_page(found, title=title)
        said = next_surfacing(found["next_dive"])
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        what = f"{type(error).__name__}: {error}"
        raise DataError(
            f"the replay's JSON is damaged or of another version, {what[:80]}; run `clpt replay` "
            "again"
        ) from None
    write_together({path: text})
    return {
        "file": str(path),
        "bytes": len(text.encode()),
        "kind": "Replay of a glider's dives",
        "title": title or f"{found['vehicle']}: where it comes up next",
        "sentences": [said],
        "figures": [],
    }
