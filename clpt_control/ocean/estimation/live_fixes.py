"""Learning from fixes that arrive, a line of JSON each.

A line is a row of a log (`gliders.dive_table`), with the same names:

    {"time": T, "latitude": LAT, "longitude": LON}     a fix
    {"time": T, "course": DEG, "speed": M_PER_S}       holds until the next line
    {"time": T, "dr_east_m": M, "dr_north_m": M}       displacement since the line before

T is in s since 1970 UTC or ISO 8601.  A fix may carry `"plan"`, a list of such lines with the times
at which each stretch of the plan ends: the answer then has the forecast of the next fix.  Each fix
is answered by one object, and so is each line, or part of one, that is left out (`log_rows`).

The state is written whole at each fix; lines between two fixes are appended, and read again when
the state is taken up.
"""

import json
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import asdict
from math import atan2, degrees, hypot, inf, isfinite, isnan, nan
from pathlib import Path
from typing import Any

import numpy as np

from ...base.errors import DataError, import_optional
from ...base.files import write_file
from ...base.files.reading import read_text
from ...base.units import finite_or_none, iso, seconds_since_1970
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import scenario_to_text
from ..gliders.dives import PLACE, STEERING, STRETCH, velocity_of
from ..gliders.log_rows import NOT_GIVEN, LogRows, time_fault
from ..gliders.usable_dives import LONGEST
from .fix_model import LEVEL
from .flow_estimator import Ahead, FlowEstimator, Learned, move_through, pass_unknown

PARTS = (PLACE, STEERING, STRETCH)
KEYS = {"time", "plan", *(key for part in PARTS for key in part)}
MOTION = {*STEERING, *STRETCH}
FORMAT = 3  # of the file of the state


class LiveFixes:
    """Learner that reads lines and keeps its state in a file.

    The state of a file is taken up again if the file exists.
    """

    def __init__(
        self, scenario: Scenario, path: Path | None = None, **limits: float
    ) -> None:
        self.scenario, self.path, self.limits = scenario, path, limits
        self.text = scenario_to_text(scenario)
        self._begin()
        if path is not None and path.exists():
            self._resume(path)

    def _begin(self) -> None:
        """Know nothing."""
        self.estimator = FlowEstimator(self.scenario, **self.limits)
        self.rows = LogRows()

    def answer(self, line: str) -> dict[str, Any] | None:
        """Read a line; return the answer to a fix or a line that is left out, or None."""
        has_learned = False
        try:
            answer, has_learned = self._read(line)
        finally:
            if self.path is not None:
                self._keep(self.path, "" if has_learned else line.strip())
        return answer

    def _keep(self, path: Path, line: str) -> None:
        """Write the state to its file, or a line that was read since behind it."""
        if not line or not path.exists():
            write_file(path, json.dumps(self._state()) + "\n")
        if line:
            with path.open("a", encoding="utf-8") as journal:
                journal.write(line + "\n")

    def _read(self, line: str) -> tuple[dict[str, Any] | None, bool]:
        """Return the answer to a line, and whether a fix was learned."""
        try:
            return self._read_row(_row(line))
        except DataError:
            self.rows.lost = "a line before it could not be read"  # which may be a turn
            raise

    def _read_row(self, row: dict[str, Any]) -> tuple[dict[str, Any] | None, bool]:
        """Return the answer to a row, and whether a fix was learned."""
        time = row["time"]
        place, steering, stretch = (
            (row[part[0]], row[part[1]]) if part[0] in row else None for part in PARTS
        )
        if stretch is not None and self.estimator.leg is None:
            raise DataError("no fix yet. Give a fix first")
        is_early = not self.estimator.legs and self.rows.time - time > LONGEST
        if is_early and place is not None:
            # nothing is lost: the clock of the lines before was ahead
            self._begin()
        reading = self.rows.read(time, place, steering, stretch)
        answer: dict[str, Any] = {"time": iso(time)} if time_fault(time) == "" else {}
        if self.estimator.leg is not None and reading.moved is not None:
            move_through(self.estimator, np.array([[time, *reading.moved]]))
        elif self.estimator.leg is not None and reading.unknown:
            pass_unknown(self.estimator, time)
        told = [reading.skipped]
        if reading.unknown not in ("", NOT_GIVEN) and self.estimator.leg is not None:
            told.append(f"motion unknown: {reading.unknown}")
        has_learned = False
        if reading.place is not None:
            try:
                learned = self.estimator.fix(time, *reading.place)
                answer, has_learned = answer_of(learned, self.estimator), True
            except DataError as error:
                told.append(str(error))
        if told := [text for text in told if text]:
            answer["skipped"] = "; ".join(told)
        elif not has_learned:
            return None, False
        if "plan" in row and time == self.rows.time:
            answer |= self._ahead(row["plan"], time)
        return answer, has_learned

    def _ahead(self, plan: Any, time: float) -> dict[str, Any]:
        """Return the forecast of the next fix, or why the plan is refused."""
        try:
            return {"next": forecast_of(self.estimator.forecast(_plan(plan, time)))}
        except DataError as error:
            return {"plan_refused": str(error)}

    def _resume(self, path: Path) -> None:
        """Take up a state from its file, and read the lines after it again."""
        try:
            first, *lines = read_text(path, "is not the state of an estimate").split(
                "\n"
            )
            stored = json.loads(first)
            form, text = stored["format"], stored["scenario"]
        except (ValueError, KeyError, TypeError):
            raise DataError(
                f"{path}: is not the state of an estimate. Give another --state, or remove the file"
            ) from None
        if form != FORMAT or text != self.text:
            raise DataError(
                f"{path}: is the state of another scenario. Give that scenario, or another --state"
            )
        self.estimator.state = stored["estimator"]
        east, north = stored["rows"].pop("velocity")
        self.rows = LogRows(**stored["rows"], velocity=(east, north))
        # a killed process may have left a part of its last line: nothing is appended to it
        for line in lines[:-1]:
            with suppress(DataError):
                self._read(line)
        if lines and lines[-1]:
            self._keep(path, "")

    def _state(self) -> dict[str, Any]:
        return {
            "format": FORMAT,
            "scenario": self.text,
            "estimator": self.estimator.state,
            "rows": asdict(self.rows),
        }


@contextmanager
def sole_writer(path: Path | None) -> Iterator[None]:
    """Refuse a state that another process writes."""
    if path is None:
        yield
        return
    filelock = import_optional("filelock")
    with ExitStack() as locked:
        try:  # the lock of a killed process is free
            locked.enter_context(filelock.FileLock(f"{path}.lock", timeout=0))
        except filelock.Timeout:
            raise DataError(
                f"{path}: another clpt estimate writes it. End that one, or give another --state"
            ) from None
        except OSError as error:
            raise DataError(
                f"{path}: cannot be written to: {error.strerror or error}"
            ) from None
        yield


def _row(line: str) -> dict[str, Any]:
    """Return a line as numbers by name."""
    try:
        row = json.loads(line)
    except (ValueError, RecursionError):
        raise DataError(f"{line[:60]!r}: is not JSON. Give one object a line") from None
    return _checked(row)


def _checked(row: Any) -> dict[str, Any]:
    """Return a line's object with its time in s and numbers, or refuse it."""
    if not isinstance(row, dict) or row.get("time") is None:
        raise DataError('a line must be an object with "time", as {"time": 0, ...}')
    unknown = sorted(set(row) - KEYS)
    if unknown:
        raise DataError(
            f"unknown key {unknown[0]!r:.40}. Allowed: {', '.join(sorted(KEYS))}"
        )
    # null is an unknown motion, and no fix
    checked = {
        key: nan if value is None else value
        for key, value in row.items()
        if value is not None or key in MOTION
    }
    for part in PARTS:
        given = [key for key in part if key in checked]
        if len(given) == 1:
            raise DataError(f"{given[0]} without the other. Give {' and '.join(part)}")
    if STEERING[0] in checked and STRETCH[0] in checked:
        raise DataError(
            "a line with course and dr_east_m: give the displacement, or course and speed"
        )
    for key, value in checked.items():
        if key != "plan":
            checked[key] = _number(key, value)
    return checked


def _number(key: str, value: Any) -> float:
    try:
        if isinstance(value, bool):
            raise ValueError
        is_date = key == "time" and isinstance(value, str)
        number = seconds_since_1970(value) if is_date else float(value)
    except (TypeError, ValueError):
        number = inf
    if not isfinite(number) and not (isnan(number) and key in MOTION):
        raise DataError(f"{key} = {value!r:.40}: must be a finite number")
    return number


def _plan(plan: Any, time: float) -> list[tuple[float, float, float]]:
    """Return the stretches of a plan: time at the end, displacement to the east and north."""
    if not isinstance(plan, list) or not plan:
        raise DataError("plan: must be a list of lines with time and displacement")
    stretches = []
    for line in map(_checked, plan):
        end = line["time"]
        if not end > time:
            raise DataError(
                time_fault(end)
                or f"plan: time {iso(end)} must be later than {iso(time)}"
            )
        if STRETCH[0] in line:
            east, north = (line[key] for key in STRETCH)
        elif STEERING[0] in line:
            course, speed = (line[key] for key in STEERING)
            velocity = velocity_of(course, speed, "plan")
            east, north = (speed * (end - time) for speed in velocity)
        else:
            raise DataError("plan: give course and speed, or dr_east_m and dr_north_m")
        stretches.append((end, east, north))
        time = end
    return stretches


# --- answers ------------------------------------------------------------------------------------


def towards(east: float, north: float) -> dict[str, float]:
    """Return speed (m/s) and direction (degrees) of a flow."""
    return {"speed": hypot(east, north), "towards": degrees(atan2(east, north)) % 360.0}


def forecast_of(ahead: Ahead) -> dict[str, Any]:
    """Return a forecast as numbers by name: its ellipse is a circle."""
    return {
        "time": iso(ahead.time),
        "latitude": ahead.latitude,
        "longitude": ahead.longitude,
        "radius_m": ahead.radius,
        "level": LEVEL,
    }


def answer_of(learned: Learned, estimator: FlowEstimator) -> dict[str, Any]:
    """Return what a fix taught as numbers by name, ready for JSON."""
    answer: dict[str, Any] = {
        "time": iso(learned.time),
        "latitude": learned.latitude,
        "longitude": learned.longitude,
        "legs": estimator.legs,
        "error_m": finite_or_none(learned.error),
        "error_east_m": finite_or_none(learned.error_east),
        "error_north_m": finite_or_none(learned.error_north),
        "flow": towards(*learned.flow),
        "theta_m_s": learned.flow_parameters.tolist(),
        "standard_error_m_s": learned.standard_error.tolist(),
        "guaranteed_m_s": finite_or_none(learned.guaranteed),
    }
    if learned.forecast is not None:
        answer["forecast"] = forecast_of(learned.forecast)
        answer["inside"] = bool(learned.inside)
        answer["turn_rad"] = learned.turn
    if learned.note:
        answer["note"] = learned.note
    if estimator.warnings:
        answer["warnings"] = estimator.warnings
    return answer
