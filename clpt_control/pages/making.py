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
    from .kinds import checked_replay, read
    from .page import page_html

    path, kinds = check_page(file), checked_formats(formats)
    found: Any = read(Path(run)) if isinstance(run, str | Path) else run
    results: dict[Path, Any] = {}
    if hasattr(found, "steps") or isinstance(found, dict) or "dive" in getattr(found, "dims", ()):
        if figures is not None:
            raise DataError("figures: a replay's are written by `clpt replay --out`; leave it out")
        found = checked_replay(found, "the replay")
        kind, named = "Replay of a glider's dives", f"{found['vehicle']}: where it comes up next"
        text, said = _replay(found, title)
    else:
        folder = None if figures is None else make_folder(figures)
        page = page_of(found, title)
        kind, named, said, text = page.kind, page.title, list(page.sentences), page_html(page)
        if folder is not None:
            drawn = list(page.figures())
            results = {folder / f"{one.name}.{end}": one.figure for one in drawn for end in kinds}
    write_together({path: text, **results})
    return {
        "file": str(path),
        "bytes": len(text.encode()),
        "kind": kind,
        "title": title or named,
        "sentences": said,
        "figures": [str(one) for one in results],
    }


def check_page(file: str | Path) -> Path:
    """Return where a page is to be written; refuse a place where it cannot be."""
    path = Path(file)
    check_writable(path)
    if path.suffix.lower() not in ENDINGS:
        raise DataError(f"{path}: a page's name must end in {' or '.join(ENDINGS)}")
    return path


def page_of(data: "xarray.Dataset", title: str | None = None) -> "Page":
    """Return the page of a run, of a team's run or of an ensemble."""
    from ..scenario.team import system_of_run
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


def _replay(found: dict[str, Any], title: str | None) -> tuple[str, list[str]]:
    """Return the page for one on watch with a glider, and its sentence."""
    from ..replay.page import replay_page
    from ..replay.sentences import next_surfacing

    try:
        return replay_page(found, title=title), [next_surfacing(found["next_dive"])]
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        what = f"{type(error).__name__}: {error}"
        raise DataError(
            f"the replay's JSON is damaged or of another version, {what[:80]}; run `clpt replay` "
            "again"
        ) from None
