"""Output of `clpt replay`, and forecasts of dives to come: `--next` and `--aim`.

The table has a row for each dive, as many columns as the terminal is wide: columns join in
the order of their rank while they fit; those of rank 0 always stand.
A folder that is followed is watched for new files of dives.
"""

import os
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from math import hypot, isfinite
from pathlib import Path
from typing import Any

from ...base.errors import DataError, ScenarioError
from ...base.files import make_folder, write_together
from ...base.html import Result
from ...base.progress import interrupt, progress_bar, tell
from ...base.units import DAY
from .printing import LONG, Report, terminal_width

EDGES, EDGE = 3, 1  # letters around a cell, and of the table's own edge
ROWS = {
    "clpe_rms": "after the first dive",
    "clpe_rms_all": "all, the first with no flow",
    "clpe_rms_after_3": "after the third dive",
}
LONGEST = DAY  # s between looks
SENSOR_LISTS = (".cac", ".ccc")  # that files of a Slocum need


@dataclass
class Job:
    """A replay that grows, what is asked of it, and the formats of its figures.

    Dives must last longer than `least`, s. `plan` is of the next dive (s; m east, m north);
    `targets` are waypoints to aim at. Speed (m/s), duration (s) and variation (degrees east) are
    for aiming. `follows`: what the dives so far do not allow is told once, and work goes on. A
    vehicle that no file names is called `name`.
    """

    replay: Any
    plan: tuple = ()
    targets: Sequence[tuple[float, float]] = ()
    speed: float | None = None
    duration: float | None = None
    variation: float | None = None
    follows: bool = False
    kinds: Sequence[str] = ()
    least: float = 0.0
    told: set[str] = field(default_factory=set)
    name: str = ""

    def check(self) -> None:
        """Refuse what cannot be, before work begins."""
        from ...ocean.forecast.aim import checked_target
        from ...ocean.forecast.surfacing import check_flown

        if self.plan:
            time, displacement = self.plan
            check_flown(hypot(*displacement) / time if time > 0 else 0.0, time)
        if not self.targets and (self.speed, self.duration) != (None, None):
            raise ScenarioError(
                "--speed and --hours are for --aim LAT LON. Give a waypoint"
            )
        for target in self.targets:
            checked_target(*target)
        duration = 3600.0 if self.duration is None else self.duration
        check_flown(1.0 if self.speed is None else self.speed, duration)

    @contextmanager
    def so_far(self) -> Iterator[None]:
        """Go on, where a folder is followed, after what dives do not allow, which is told once."""
        try:
            yield
        except (DataError, ScenarioError) as error:
            if not self.follows:
                raise
            if str(error) not in self.told:
                tell(f"so far, {error}")
            self.told.add(str(error))

    def aims(self) -> list[Any]:
        """Return an `Aim` for each waypoint."""
        how = self.targets, self.speed, self.duration, self.variation
        with self.so_far():
            return self.replay.aims(*how) if self.targets else []
        return []

    def found(self, dives: Any, unread: Any) -> Report:
        """Replay the dives that can be used; return what `--json` prints."""
        from ...ocean.forecast.quality_control import check_tides
        from ...ocean.gliders.samples import with_variation
        from ...ocean.gliders.usable_dives import last_fix, usable

        if self.variation is not None:
            if not self.follows and all(dive.turned is None for dive in dives):
                raise ScenarioError(
                    f"--variation {self.variation:g}: no dive has dead reckoning from a "
                    "magnetic heading. Leave it out"
                )
            dives = [with_variation(dive, self.variation) for dive in dives]
        used: list[Any] = []
        unused: list[Any] = []
        with self.so_far():
            used, unused = usable(dives, self.least)
        skipped = [*unread, *unused]
        if not (self.follows or used):
            raise DataError(f"no usable dive: dive {unused[0].dive}: {unused[0].why}")
        with self.so_far():
            check_tides(self.replay.model.flow, used)
        with progress_bar("replaying dives", max(len(used), 1)) as report:
            self.replay.feed(used, report)
        if used:
            self.replay.seen = last_fix(dives, used[-1])
        return self.summary(skipped)

    def summary(self, skipped: Sequence[Any] = ()) -> Report:
        """Return what `--json` prints: the summary, where the next dive ends, aim and paste."""
        from ...ocean.forecast.aim_files import paste

        replay = self.replay
        if not replay.steps:
            return replay.summary(skipped) | {"paste": None}
        legs = self.aims()
        aimed = legs and not self.plan
        goal = legs[0].ahead if aimed else replay.next_dive(*self.plan)
        report = replay.summary(skipped, goal, legs)
        if self.name and not replay.steps[-1].dive.vehicle:
            report["vehicle"] = self.name
        return report | {"paste": paste(report)}

    def learn(
        self, dives: tuple[Any, Any], files: int, out: Path
    ) -> tuple[Report, str]:
        """Replay dives and write the results; return them with a line on the new files."""
        from ...ocean.forecast.aim import aim_sentence
        from ...ocean.forecast.table_rows import place, when

        summary = self.found(*dives)
        used = len(self.replay.steps)
        line = (
            f"{files} new file{'s'[: files != 1]}, {used} dive{'s'[: used != 1]} used"
        )
        if not used:
            return summary, line
        write(summary, out, self.kinds, again=True)
        step = self.replay.steps[-1]
        to_come = summary["next_dive"]
        position = place(to_come["latitude"], to_come["longitude"])
        return summary, (
            f"{line}; dive {step.dive.number}: position error {step.clpe['adaptive']:.0f} m"
            + f"; next surfacing {when(to_come)}, near {position}"
            + (f"; {aim_sentence(summary['aim'][0])}" if summary["aim"] else "")
        )


def fitted(
    title: str, rows: list[dict[str, str]], columns: Any, sentences: Sequence[str] = ()
) -> Result:
    """Return rows of cells by title as a table of the columns that fit the terminal."""
    size = {
        name: EDGES + max(len(name), *(min(len(row[name]), LONG) for row in rows))
        for name in rows[0]
    }
    room = terminal_width() - EDGE
    chosen = set()
    for name in sorted(size, key=lambda name: columns[name][0]):
        if columns[name][0] == 0 or size[name] <= room:
            chosen.add(name)
            room -= size[name]
    titles = [name for name in size if name in chosen]
    return Result(
        title, titles, [[row[column] for column in titles] for row in rows], sentences
    )


def results(summary: Report) -> list[Result]:
    """Return a summary as tables and sentences: dives, misses, what was learned, what comes."""
    from ...ocean.forecast import replay_summary, table_rows

    rows = summary["each_dive"]
    sentences = replay_summary.remarks(summary) + replay_summary.coming(summary)
    if paste := summary.get("paste"):
        sentences += [f"to paste, {paste['file']}:", paste["text"].rstrip()]
    if not rows:
        return [Result(sentences=["no dives yet", *sentences])]
    ahead = table_rows.cells_ahead(summary["next_dive"])
    dives = [*map(table_rows.cells, rows), ahead]
    means = {name: summary[key] for key, name in ROWS.items()}
    model = summary.get("flow_model")
    if model and 0 < model["covered"] < summary["used"]:
        means["covered, after the first dive"] = model["clpe_rms"]
    models = table_rows.MODELS[: len(rows[0]["clpe"])]
    rows = [
        [name, *map(table_rows.metres, rms.values())] for name, rms in means.items()
    ]
    return [
        fitted(table_rows.TITLE, dives, table_rows.COLUMNS),
        Result("Position error, rms (m)", ["over", *models], rows, sentences),
    ]


def write(
    summary: Report, folder: Path, kinds: Sequence[str], again: bool = False
) -> list[Path]:
    """Write what `Job.summary` says of a replay into a folder, all or none.

    The files, NetCDF, page, places and figures, are returned.  ``replay.nc`` is the first and is
    put in place last: where it is new, the others are.  The page loads itself `again` where it
    will be written anew.
    """
    from ...base.figures import figure_of
    from ...base.page import page_html
    from ...ocean.forecast.map_layers import next_geojson, track_kml
    from ...ocean.forecast.netcdf_export import dataset_of
    from ...ocean.forecast.plots import replay_plot
    from ...ocean.forecast.replay_page import replay_page

    results: dict[str, Any] = {
        "replay.nc": dataset_of(summary),
        "replay.html": page_html(replay_page(summary, again)),
        "next.geojson": next_geojson(summary),
        "track.kml": track_kml(summary, summary["vehicle"]),
    }
    if paste := summary["paste"]:
        results[paste["file"]] = paste["text"]
    if kinds:
        figure = figure_of(replay_plot, summary)
        results |= {f"replay.{kind}": figure for kind in kinds}
    placed = {folder / name: content for name, content in results.items()}
    write_together(placed)
    return list(placed)


def check_pace(every: float, patience: float) -> None:
    """Refuse times (s) between looks, or without a new file, that cannot be."""
    if not (isfinite(every) and 0 < every <= LONGEST):
        raise ScenarioError(
            f"--every {every:g} s: must be above 0 s and at most {LONGEST:g} s, a day"
        )
    if not patience >= 0:
        raise ScenarioError(f"--patience {patience:g} s: must be 0 s or more")


def stamps(folder: Path, results: str, known: dict[Path, Any]) -> dict[Path, Any]:
    """Return size and times of files below a folder, except results; as known if it is gone."""
    from ...ocean.gliders.dive_files import may_hold_dives

    if known and not folder.is_dir():
        return known
    stamp_of = {}
    for where, _, names in os.walk(folder):
        for path in [Path(where, name) for name in names]:
            is_read = may_hold_dives(path) or path.suffix.lower() in SENSOR_LISTS
            if is_read and not path.is_relative_to(results):
                with suppress(OSError):
                    status = path.stat()
                    stamp_of[path] = (
                        status.st_size,
                        status.st_mtime_ns,
                        status.st_ctime_ns,
                    )
    return stamp_of


def watch(
    job: Job,
    folder: Path,
    out: Path,
    every: float,
    patience: float,
    alert: Sequence[str],
) -> Report:
    """Replay all dives of a folder whenever its files change; return what the last replay found.

    Times are in s.  Ctrl-C or SIGTERM ends it: while it waits, with the last replay; while
    it learns, by a `KeyboardInterrupt`, as no replay has all dives yet.
    """
    from ...ocean.forecast.fleet import Alerts
    from ...ocean.gliders.dive_files import read_all_dives

    inside = Path(os.path.realpath(folder))
    results = os.path.realpath(out)
    if not inside.is_dir():
        raise DataError(
            f"{folder}: folder not found. Give the folder where dives arrive"
        )
    if results == str(inside):
        raise DataError(
            f"--out {out}: results would be in the watched folder {folder} and count as new "
            "files there. Give another folder, or leave --out out"
        )
    make_folder(out)
    summary = None  # None while results are not those of all files
    current: dict[Path, Any] = {}
    alerts = Alerts(alert, out)
    since = time.monotonic()
    with interrupt.terminated():
        try:
            while True:
                previous, current = current, stamps(inside, results, current)
                if summary is None or current != previous:
                    summary = None
                    dives: tuple[Any, Any] = [], []
                    with job.so_far():
                        dives = read_all_dives(folder)
                    new = len(current.items() - previous.items())
                    learned, line = job.learn(dives, new, out)
                    faults = {skip.why for skip in dives[1]} - job.told
                    job.told |= faults
                    summary = learned  # from where the line is seen, an interrupt has its results
                    tell(line + "".join(f"; skipped {why}" for why in sorted(faults)))
                    since = time.monotonic()
                alerts.tell(summary)
                remaining = since + patience - time.monotonic()
                if remaining <= 0:
                    return summary
                interrupt.wait(min(every, remaining))
        except KeyboardInterrupt:  # the user's way to end it
            if summary is None:
                raise
            interrupt.answer()
            return summary
