"""`clpt replay`: a glider's dives, each forecast before its end; every vehicle of a fleet.

A folder of a fleet with files of dives holds a vehicle, or several that their files name.  What was
read of it, its page and its numbers are kept in a folder of the same name within the results.
"""

import os
import re
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any

import typer

import clpt_control as clpt

from ...base.errors import ClptError, DataError, ScenarioError
from ...base.files import make_folder, write_file
from ...base.html import Result
from . import replay_report
from .printing import Formats, Json, Report, arg, finish, flag, opt


def folder_named(text: str) -> Path:
    """Return the folder that an option names, which '' does not."""
    if not text.strip():
        raise typer.BadParameter("is empty; give the name of a folder")
    return Path(text)


def replay(
    files: list[Path] | None = arg(
        "FILES", "Files of one vehicle, or folders of them.", default=None
    ),
    sample: bool = flag("Replay the dives that come with clpt.", "--sample"),
    estimator: str = opt(
        "NAME", "gaussian-process or gradient.", default="gaussian-process"
    ),
    flow: str | None = opt(
        "PARTS",
        "steady, then any of tides, inertial, shear, gaussians, model, such as steady,M2,K1.",
    ),
    learn_speed: bool = flag(
        "Learn a factor on speed and a compass error.", default=True
    ),
    flow_model: Path | None = opt(
        "FILE", "Forecast (NetCDF) or fit (TOML) to compare with and learn from."
    ),
    units: str | None = opt(
        "UNIT", "Of u and v of a forecast, such as m/s, where it has none."
    ),
    plan: tuple[float, float, float] | None = opt(
        "HOURS EAST NORTH",
        "Plan of the next dive: hours, m east, m north through the water.",
        "--next",
    ),
    aim: tuple[float, float] | None = opt(
        "LAT LON",
        "Waypoint to aim at, degrees: the heading that the current carries there.",
    ),
    route: Path | None = opt(
        "FILE",
        "Waypoints to aim at in their order, GeoJSON or lines LAT LON: when each is made. Its "
        "polygons are areas to stay out of: how likely they are entered.",
    ),
    speed: float | None = opt(
        "M/S", "Speed through water for --aim; else that of the last dives."
    ),
    hours: float | None = opt(
        "HOURS", "Length of a dive for --aim; else that of the last dives."
    ),
    least_duration: float | None = opt("SECONDS", "Dives must last longer than this."),
    variation: float | None = opt(
        "DEGREES",
        "Variation of magnetic headings, degrees east; else the file's or IGRF.",
    ),
    out: Path | None = opt(
        "FOLDER", "Folder for NetCDF and figures.", parser=folder_named
    ),
    follow: Path | None = opt(
        "FOLDER",
        "Folder to watch for new files; --out is FOLDER/replay by default.",
        parser=folder_named,
    ),
    fleet: Path | None = opt(
        "FOLDER",
        "Look once at each vehicle of a folder tree; --out is FOLDER/replay by default.",
        parser=folder_named,
    ),
    alert: str | None = opt(
        "CMD",
        "Run this when a vehicle is OUT twice running, changes its speed or is overdue, once "
        "each; {} is the sentence, which is on its standard input too.",
    ),
    every: float = opt("SECONDS", "Time between looks at that folder.", default=10.0),
    patience: float = opt(
        "SECONDS",
        "End after this time without a new file; default: never.",
        default=inf,
        show_default=False,
    ),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Replay a glider's dives, each forecast before its end.

    Example:
        clpt replay p542*.nc --aim 41.05 -69.40 --out replay
    """
    from ...base.figures import checked_formats
    from ...ocean.forecast.fleet import checked_command
    from ...ocean.forecast.route import read_route
    from ...ocean.gliders.usable_dives import LEAST_DURATION

    if bool(files) + sample + (follow is not None) + (fleet is not None) != 1:
        raise ScenarioError(
            "give files of dives, --sample for those that come with clpt, --follow FOLDER or "
            "--fleet FOLDER"
        )
    if fleet is not None and (aim or plan or route):
        raise ScenarioError(
            "--aim, --route and --next are of one vehicle; leave --fleet out"
        )
    if route is not None and aim:
        raise ScenarioError("--route FILE has the waypoints; leave --aim out")
    if alert is not None and follow is None and fleet is None:
        raise ScenarioError("--alert is for --follow FOLDER or --fleet FOLDER")
    command = [] if alert is None else checked_command(alert)
    kinds = checked_formats(formats or ([] if fleet else ["png"]))
    replay_report.check_pace(every, patience)
    least = LEAST_DURATION if least_duration is None else least_duration
    if not least >= 0:
        raise ScenarioError(f"--least-duration {least:g} s: must be 0 s or more")
    if variation is not None and not abs(variation) <= 180:
        raise ScenarioError(
            f"--variation {variation:g} degrees: must be -180 to 180, east positive"
        )
    model = chosen_model(flow, learn_speed, flow_model is not None)
    if units is not None and flow_model is None:
        raise ScenarioError(
            f"--units {units}: is for --flow-model FILE; give one, or leave it out"
        )
    forecast = (
        None if flow_model is None else clpt.replay.read_flow_model(flow_model, units)
    )
    way, areas = (None, None) if route is None else read_route(route)
    job = replay_report.Job(
        clpt.replay.Replay(estimator, model, forecast),
        () if plan is None else (3600 * plan[0], plan[1:]),
        ([] if aim is None else [aim]) if way is None else way,
        speed,
        None if hours is None else 3600 * hours,
        variation,
        areas,
        follow is not None,
        kinds,
        least,
    )
    job.check()
    job.name = name_by_files(files or ([] if follow is None else [follow]))
    if fleet is not None:
        rows, page = look_at(job, fleet, out or fleet / "replay", command)
        finish(fleet_results(rows), rows, as_json, page)
        return
    written = []
    if follow is not None:
        summary = replay_report.watch(
            job, follow, out or follow / "replay", every, patience, command
        )
    else:
        summary = job.found(
            *(
                (clpt.gliders.sample_dives(), [])
                if sample
                else clpt.gliders.read_dives(files or [])
            )
        )
        if out is not None:
            written = replay_report.write(summary, make_folder(out), kinds)
    finish(replay_report.results(summary), summary, as_json, *written)


def name_by_files(files: Sequence[Path]) -> str:
    """Return the name of an unnamed vehicle: its file, or the folder of several.

    >>> name_by_files([Path("data/north.csv")])
    'north'
    >>> name_by_files([Path("m/1.csv"), Path("m/2.csv")])
    'm'
    """
    paths = [file.resolve() for file in files]
    if len(paths) > 1:
        return Path(os.path.commonpath([path.parent for path in paths])).name
    return "".join(path.name if path.is_dir() else path.stem for path in paths)


def chosen_model(flow: str | None, learn_speed: bool, forecast: bool) -> Any:
    """Return the `FixModel` of the options; `forecast` is whether there is a flow model.

    Then a factor on it is a parameter, which the dives may find to be near zero.
    """
    FixModel = clpt.estimation.FixModel
    parts = (
        FixModel().flow
        if flow is None
        else tuple(name.strip() for name in flow.split(","))
    )
    if not forecast and "model" in parts:
        raise ScenarioError(f"flow {flow}: its part model needs --flow-model FILE")
    if forecast and "model" not in parts:
        parts = (*parts, "model")
    return FixModel(parts, learn_speed)


STATE = "state"  # in a folder of results


def folders(top: Path, out: Path) -> Iterator[tuple[Path, str]]:
    """Return each folder of dives below one, and why it cannot be looked into, if so.

    A link to a folder elsewhere is followed, each place once.
    """
    from ...ocean.gliders.dive_files import may_hold_dives

    root = top.resolve()
    seen = {root, out.resolve()}

    def is_new(folder: Path) -> bool:
        place = folder.resolve()
        of_tree = place.is_relative_to(root) or root.is_relative_to(place)
        if place in seen or (folder.is_symlink() and of_tree):
            return False
        seen.add(place)
        return True

    faults: list[OSError] = []
    for where, inner, names in os.walk(top, onerror=faults.append, followlinks=True):
        here = Path(where)
        inner[:] = [
            name for name in sorted(inner) if name[0] != "." and is_new(here / name)
        ]
        if any(may_hold_dives(Path(name)) for name in names):
            yield here, ""
    for fault in faults:
        yield Path(fault.filename), f"{fault.filename}: {fault.strerror}"


def pages_of(vehicles: Iterable[str], place: Path) -> dict[str, Path]:
    """Return where results of the vehicles of a folder go: a folder each where they are several.

    >>> names = {"a b", "a_b", "..", "state", "$"}
    >>> {name: page.name for name, page in pages_of(names, Path("out")).items()}
    {'$': '_', '..': '_.', 'a b': 'a_b', 'a_b': 'a_b_', 'state': 'state_'}
    """
    found = {}
    taken = {STATE}
    for vehicle in sorted(vehicles):
        name = re.sub(r"[^\w.-]|^\.", "_", vehicle)
        while name in taken:
            name += "_"
        taken.add(name)
        found[vehicle] = place / name
    return found if len(found) > 1 else dict.fromkeys(found, place)


def look_at(
    job: replay_report.Job, top: Path, out: Path, alert: Sequence[str]
) -> tuple[Report, Path]:
    """Replay each vehicle below a folder and write the fleet's page; return what is found."""
    from ...ocean.forecast.fleet import Alerts, fleet_page, ordered, standing, unread
    from ...ocean.forecast.follow import following
    from ...ocean.forecast.geographic import utc
    from ...ocean.gliders.dive_files import FROM_GLIDER

    if not top.is_dir():
        raise DataError(
            f"{top}: no such folder; give one with a folder for each vehicle"
        )
    make_folder(out)
    rows = []

    @contextmanager
    def or_unread(vehicle: str) -> Iterator[None]:
        try:
            yield
        except ClptError as error:
            rows.append(unread(vehicle, str(error)))

    for folder, fault in folders(top, out):
        place = out / folder.relative_to(top)
        named = folder.parent if folder.name.lower() == FROM_GLIDER else folder
        name = named.resolve().name
        with or_unread(name):
            if fault:
                raise DataError(fault)
            with following(folder, place) as follower:
                follower.look()
                dives, bad = follower.dives()
                if not dives:
                    raise DataError(
                        bad[0].why if bad else f"{folder}: no file is there any more"
                    )
                places = pages_of({dive.vehicle or name for dive in dives}, place)
                dives = [replace(dive, vehicle=dive.vehicle or name) for dive in dives]
                alerts = Alerts(alert, place)
                for vehicle, page in places.items():
                    with or_unread(vehicle):
                        its = [dive for dive in dives if dive.vehicle == vehicle]
                        found, _ = job.learn((its, bad), 0, make_folder(page))
                        alerts.tell(found)
                        link = (page / "replay.html").relative_to(out).as_posix()
                        rows.append(standing(found, link, time.time()))
    if not rows:
        raise DataError(f"{top}: no folder below it has files of dives")
    fleet = {"folder": str(top), "now": utc(time.time()), "vehicles": ordered(rows)}
    write_file(out / "fleet.html", fleet_page(fleet))
    return fleet, out / "fleet.html"


def fleet_results(found: Report) -> list[Result]:
    """Return what a terminal shows of a fleet."""
    from ...ocean.forecast.fleet import FLEET, fleet_cells, fleet_sentence

    cells = [fleet_cells(row) for row in found["vehicles"]]
    sentences = [
        f"{row['vehicle']}: {one}" for row in found["vehicles"] for one in row["said"]
    ]
    sentences.append(fleet_sentence(found["vehicles"]))
    return [replay_report.fitted("Fleet", cells, FLEET, sentences)]
