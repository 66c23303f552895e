"""`clpt replay`: dives of a glider, each forecast before its end; `clpt watch`: new dives.

A folder of a fleet with files of dives holds a vehicle, or several that their files name.  Its page
and its numbers are written to a folder of the same name within the results.
"""

import os
import re
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Annotated, Any

import typer

import clpt_control as clpt

from ...base.errors import ClptError, DataError, ScenarioError
from ...base.files import make_folder, write_file
from ...base.html import Result
from . import replay_report
from .printing import Formats, Json, Report, annotated, arg, finish, flag, opt


def folder_named(text: str) -> Path:
    """Return the folder that an option names, which '' does not."""
    if not text.strip():
        raise typer.BadParameter("is empty. Give the name of a folder")
    return Path(text)


Flow = Annotated[
    str | None,
    annotated(
        "PARTS",
        "steady, then any of tides, inertial, shear, gaussians, model, such as steady,M2,K1.",
    ),
]
LearnSpeed = Annotated[
    bool, flag("Learn a factor on speed and a compass error.", default=...)
]
FlowModelFile = Annotated[
    Path | None,
    opt(
        "FILE",
        "Forecast (NetCDF) or fit (TOML) to compare with and learn from.",
        default=...,
    ),
]
Units = Annotated[
    str | None,
    annotated(
        "UNIT", "Units of u and v of a forecast, such as m/s, if the file has none."
    ),
]
Plan = Annotated[
    tuple[float, float, float] | None,
    annotated(
        "HOURS EAST NORTH",
        "Plan of the next dive: hours, m east, m north through the water.",
        "--next",
    ),
]
Aim = Annotated[
    tuple[float, float] | None,
    annotated(
        "LAT LON",
        "Waypoint to aim at, degrees: the heading by which the current leads there.",
    ),
]
Speed = Annotated[
    float | None,
    annotated("M/S", "Speed through water for --aim. Default: that of recent dives."),
]
Hours = Annotated[
    float | None,
    annotated("HOURS", "Dive duration for --aim. Default: duration of recent dives."),
]
LeastDuration = Annotated[
    float | None, annotated("SECONDS", "Dives must last longer than this.")
]
Variation = Annotated[
    float | None,
    annotated(
        "DEGREES",
        "Variation of magnetic headings, degrees east. Default: the file's, or IGRF.",
    ),
]


def replay(
    files: list[Path] | None = arg(
        "FILES", "Files of one vehicle, or folders of them.", default=None
    ),
    sample: bool = flag("Replay the dives that come with clpt.", "--sample"),
    flow: Flow = None,
    learn_speed: LearnSpeed = True,
    flow_model: FlowModelFile = None,
    units: Units = None,
    plan: Plan = None,
    aim: Aim = None,
    speed: Speed = None,
    hours: Hours = None,
    least_duration: LeastDuration = None,
    variation: Variation = None,
    out: Path | None = opt(
        "FOLDER",
        "Folder for NetCDF and figures; default: none are written.",
        parser=folder_named,
    ),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Replay a glider's dives, each forecast before its end.

    Example:
        clpt replay p542*.nc --aim 41.05 -69.40 --out replay
    """
    if bool(files) + sample != 1:
        raise ScenarioError(
            "no dive files. Give files, or --sample for the dives of the package; `clpt "
            "watch` is for "
            "folders that files arrive in"
        )
    job = job_of(
        replay_of(flow, learn_speed, flow_model, units),
        (plan, aim, speed, hours, variation),
        least_duration,
        formats or ["png"],
    )
    job.name = name_by_files(files or [])
    if sample:
        summary = job.found(clpt.gliders.sample_dives(), [])
    else:
        summary = job.found(*clpt.gliders.read_dives(files or [], usable=False))
    written = []
    if out is not None:
        written = replay_report.write(summary, make_folder(out), job.kinds)
    finish(replay_report.results(summary), summary, as_json, *written)


def watch(
    folder: Path = arg(
        "FOLDER", "Folder that files of dives arrive in.", parser=folder_named
    ),
    fleet: bool = flag(
        "Look once at each vehicle of a folder tree; let cron repeat it.", "--fleet"
    ),
    alert: str | None = opt(
        "CMD",
        "Run this when a vehicle is OUT twice running or is overdue, once each; {} is the "
        "sentence, which is on its standard input too.",
    ),
    every: float = opt("SECONDS", "Time between looks at the folder.", default=10.0),
    patience: float = opt(
        "SECONDS",
        "End after this time without a new file; default: never.",
        default=inf,
        show_default=False,
    ),
    flow: Flow = None,
    learn_speed: LearnSpeed = True,
    flow_model: FlowModelFile = None,
    units: Units = None,
    plan: Plan = None,
    aim: Aim = None,
    speed: Speed = None,
    hours: Hours = None,
    least_duration: LeastDuration = None,
    variation: Variation = None,
    out: Path | None = opt(
        "FOLDER", "Folder for results; default: FOLDER/replay.", parser=folder_named
    ),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Watch a folder for new dives of a vehicle, or of a fleet.

    Example:
        clpt watch incoming --out results --alert "notify-send {}"
    """
    from ...ocean.forecast.fleet import checked_command

    if fleet and (aim or plan):
        raise ScenarioError("--aim and --next are for one vehicle. Leave --fleet out")
    command = [] if alert is None else checked_command(alert)
    replay_report.check_pace(every, patience)
    job = job_of(
        replay_of(flow, learn_speed, flow_model, units),
        (plan, aim, speed, hours, variation),
        least_duration,
        formats or ([] if fleet else ["png"]),
    )
    job.follows = not fleet
    job.name = name_by_files([folder])
    results = out or folder / "replay"
    if fleet:
        rows, page = look_at(job, folder, results, command)
        finish(fleet_results(rows), rows, as_json, page)
        return
    summary = replay_report.watch(job, folder, results, every, patience, command)
    finish(replay_report.results(summary), summary, as_json)


def replay_of(
    flow: str | None, learn_speed: bool, flow_model: Path | None, units: str | None
) -> Any:
    """Return a `Replay` without dives, of the options.

    With a flow model a factor on it is a parameter, which the dives may find to be near zero.
    """
    from ...ocean.estimation.fix_model import FLOW, FixModel

    flow_parts = (
        FLOW if flow is None else tuple(name.strip() for name in flow.split(","))
    )
    if flow_model is None and "model" in flow_parts:
        raise ScenarioError(f"flow {flow}: its part model needs --flow-model FILE")
    if flow_model is not None and "model" not in flow_parts:
        flow_parts = (*flow_parts, "model")
    model, forecast = FixModel(flow_parts, learn_speed), None
    if flow_model is not None:
        forecast = clpt.replay.read_flow_model(flow_model, units)
    elif units is not None:
        raise ScenarioError(
            f"--units {units}: is for --flow-model FILE. Give one, or leave it out"
        )
    return clpt.replay.Replay(model, forecast)


def job_of(
    replay: Any,
    steering: tuple[Any, ...],
    least_duration: float | None,
    formats: list[str],
) -> replay_report.Job:
    """Return the work on a replay; options that do not fit are refused.

    `steering` has the options on dives to come: plan, aim, speed, hours and variation.
    """
    from ...base.figures import checked_formats
    from ...ocean.gliders.usable_dives import LEAST_DURATION

    plan, aim, speed, hours, variation = steering
    kinds = checked_formats(formats)
    least = LEAST_DURATION if least_duration is None else least_duration
    if not least >= 0:
        raise ScenarioError(f"--least-duration {least:g} s: must be 0 s or more")
    if variation is not None and not abs(variation) <= 180:
        raise ScenarioError(
            f"--variation {variation:g} degrees: must be -180 to 180, east positive"
        )
    job = replay_report.Job(
        replay,
        () if plan is None else (3600 * plan[0], plan[1:]),
        [] if aim is None else [aim],
        speed,
        None if hours is None else 3600 * hours,
        variation,
        kinds=kinds,
        least=least,
    )
    job.check()
    return job


def _resolved(path: Path) -> Path:
    """Return a path without links; unlike `Path.resolve`, a loop of links is not an error."""
    return Path(os.path.realpath(path))


def name_by_files(files: Sequence[Path]) -> str:
    """Return the name of an unnamed vehicle: its file, or the folder of several.

    >>> name_by_files([Path("data/north.csv")])
    'north'
    >>> name_by_files([Path("m/1.csv"), Path("m/2.csv")])
    'm'
    """
    paths = [_resolved(file) for file in files]
    if len(paths) > 1:
        return Path(os.path.commonpath([path.parent for path in paths])).name
    return "".join(path.name if path.is_dir() else path.stem for path in paths)


def folders(top: Path, out: Path) -> Iterator[tuple[Path, str]]:
    """Return each folder of dives below one, and why it cannot be looked into, if so.

    A link to a folder elsewhere is followed, each place once.
    """
    from ...ocean.gliders.dive_files import may_hold_dives

    root = _resolved(top)
    visited = {root, _resolved(out)}

    def is_new(folder: Path) -> bool:
        resolved = _resolved(folder)
        of_tree = resolved.is_relative_to(root) or root.is_relative_to(resolved)
        if resolved in visited or (folder.is_symlink() and of_tree):
            return False
        visited.add(resolved)
        return True

    faults: list[OSError] = []
    for where, inner, names in os.walk(top, onerror=faults.append, followlinks=True):
        parent = Path(where)
        inner[:] = [
            name for name in sorted(inner) if name[0] != "." and is_new(parent / name)
        ]
        if any(may_hold_dives(Path(name)) for name in names):
            yield parent, ""
    for fault in faults:
        yield Path(fault.filename), f"{fault.filename}: {fault.strerror}"


def pages_of(vehicles: Iterable[str], folder: Path) -> dict[str, Path]:
    """Return where results of the vehicles of a folder go: a folder each where they are several.

    >>> names = {"a b", "a_b", "..", "$"}
    >>> {name: page.name for name, page in pages_of(names, Path("out")).items()}
    {'$': '_', '..': '_.', 'a b': 'a_b', 'a_b': 'a_b_'}
    """
    folders_by_vehicle = {}
    used_names = set[str]()
    for vehicle in sorted(vehicles):
        name = re.sub(r"[^\w.-]|^\.", "_", vehicle)
        while name in used_names:
            name += "_"
        used_names.add(name)
        folders_by_vehicle[vehicle] = folder / name
    if len(folders_by_vehicle) > 1:
        return folders_by_vehicle
    return dict.fromkeys(folders_by_vehicle, folder)


def look_at(
    job: replay_report.Job, top: Path, out: Path, alert: Sequence[str]
) -> tuple[Report, Path]:
    """Replay each vehicle below a folder and write the fleet's page; return what is found."""
    from ...base.page import page_html
    from ...ocean.forecast.fleet import Alerts, fleet_page, ordered, standing, unread
    from ...ocean.forecast.table_rows import utc
    from ...ocean.gliders.dive_files import FROM_GLIDER, read_all_dives

    if not top.is_dir():
        raise DataError(
            f"{top}: folder not found. Give a folder with one subfolder per vehicle"
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
        results_folder = out / folder.relative_to(top)
        named = folder.parent if folder.name.lower() == FROM_GLIDER else folder
        name = _resolved(named).name
        with or_unread(name):
            if fault:
                raise DataError(fault)
            dives, bad = read_all_dives(folder)
            folders_by_vehicle = pages_of(
                {dive.vehicle or name for dive in dives}, results_folder
            )
            dives = [replace(dive, vehicle=dive.vehicle or name) for dive in dives]
            alerts = Alerts(alert, results_folder)
            for vehicle, page in folders_by_vehicle.items():
                with or_unread(vehicle):
                    dives_of_vehicle = [
                        dive for dive in dives if dive.vehicle == vehicle
                    ]
                    summary, _ = job.learn(
                        (dives_of_vehicle, bad), 0, make_folder(page)
                    )
                    alerts.tell(summary)
                    link = (page / "replay.html").relative_to(out).as_posix()
                    rows.append(standing(summary, link, time.time()))
    if not rows:
        raise DataError(
            f"{top}: no subfolder has dive files. Give a folder with one subfolder per vehicle"
        )
    fleet = {"folder": str(top), "now": utc(time.time()), "vehicles": ordered(rows)}
    write_file(out / "fleet.html", page_html(fleet_page(fleet)))
    return fleet, out / "fleet.html"


def fleet_results(fleet: Report) -> list[Result]:
    """Return what a terminal shows of a fleet."""
    from ...ocean.forecast.fleet import FLEET, fleet_cells, fleet_sentence

    cells = [fleet_cells(row) for row in fleet["vehicles"]]
    sentences = [
        f"{row['vehicle']}: {sentence}"
        for row in fleet["vehicles"]
        for sentence in row["said"]
    ]
    sentences.append(fleet_sentence(fleet["vehicles"]))
    return [replay_report.fitted("Fleet", cells, FLEET, sentences)]
