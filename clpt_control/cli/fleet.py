"""`clpt replay --fleet`: every vehicle of a folder tree, one row each.

A folder with files of dives holds a vehicle, or several that their files name.  What was read of
it, its page and its numbers are kept in a folder of the same name within the results.
"""

import os
import re
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from ..errors import ClptError, DataError
from ..files import make_folder, write_text
from ..html import Result
from .alerts import Alerts
from .printing import terminal_width
from .replay_report import Ahead, Take, fitting, summary_with_next, write

RESULTS = "replay.nc"  # in a folder of results


def folders(top: Path, out: Path) -> Iterator[tuple[Path, str]]:
    """Return each folder of dives below one, and why it cannot be looked into, if so."""
    from ..gliders.dive_files import may_hold_dives

    faults: list[OSError] = []
    for where, inner, names in os.walk(top, onerror=faults.append):
        here = Path(where)
        inner[:] = sorted(
            name for name in inner if name[0] != "." and (here / name).resolve() != out.resolve()
        )
        if RESULTS in names:
            inner.clear()
        elif any(may_hold_dives(Path(name)) for name in names):
            yield here, ""
    for fault in faults:
        yield Path(fault.filename), f"{fault.filename}: {fault.strerror}"


def look_at(
    take: Take, top: Path, out: Path, kinds: Sequence[str], alert: Sequence[str]
) -> tuple[dict[str, Any], Path]:
    """Replay each vehicle below a folder and write the fleet's page; return what is found."""
    from ..gliders.dive_files import FROM_GLIDER
    from ..replay.fleet import fleet_page, ordered, standing, unread
    from ..replay.follow import following
    from ..replay.wording import utc

    if not top.is_dir():
        raise DataError(f"{top}: no such folder; give one with a folder for each vehicle")
    make_folder(out)
    rows = []
    for folder, fault in folders(top, out):
        place = out / folder.relative_to(top)
        named = folder.parent if folder.name.lower() == FROM_GLIDER else folder
        name = vehicle = named.resolve().name
        try:
            if fault:
                raise DataError(fault)
            with following(folder, place) as follower:
                follower.look()
                dives, bad = follower.dives()
                if not dives:
                    raise DataError(bad[0].why if bad else f"{folder}: no file is there any more")
                names = {dive.vehicle or name for dive in dives}
                alerts = Alerts(alert, place)
                for vehicle in sorted(names):
                    own = [dive for dive in dives if (dive.vehicle or name) == vehicle]
                    replay, skipped = take(own, bad)
                    found, goal = summary_with_next(replay, skipped, Ahead())
                    found["vehicle"] = vehicle
                    page = place / re.sub(r"[^\w.-]", "_", vehicle) if len(names) > 1 else place
                    write(replay, found, make_folder(page), goal, kinds, again=True)
                    shown = (page / "replay.html").relative_to(out).as_posix()
                    rows.append(standing(found, shown, time.time()))
                    alerts.tell(found)
        except ClptError as error:
            rows.append(unread(vehicle, str(error)))
    if not rows:
        raise DataError(f"{top}: no folder below it has files of dives")
    fleet = {"folder": str(top), "now": utc(time.time()), "vehicles": ordered(rows)}
    write_text(out / "fleet.html", fleet_page(fleet))
    return fleet, out / "fleet.html"


def fleet_results(found: dict[str, Any]) -> list[Result]:
    """Return what a terminal shows of a fleet."""
    from ..replay.fleet import FLEET, fleet_cells, fleet_sentence

    cells = [fleet_cells(row) for row in found["vehicles"]]
    titles = fitting(cells, terminal_width(), FLEET)
    lines = [[row[title] for title in titles] for row in cells]
    said = [f"{row['vehicle']}: {one}" for row in found["vehicles"] for one in row["said"]]
    return [Result("Fleet", titles, lines, [*said, fleet_sentence(found["vehicles"])])]
