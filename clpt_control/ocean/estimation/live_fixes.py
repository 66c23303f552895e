"""Learning from fixes that arrive, a line of JSON each.

A line is a row of a log (`gliders.dive_table`), with the same names:

    {"time": T, "latitude": LAT, "longitude": LON}     a fix
    {"time": T, "course": DEG, "speed": M_PER_S}       holds until the next line
    {"time": T, "dr_east_m": M, "dr_north_m": M}       displacement since the line before

T is in s since 1970 UTC or ISO 8601.  A fix may carry `"plan"`, a list of such lines with the times
at which each stretch of the plan ends: the answer then has the forecast of the next fix.  Each fix
is answered by one object.  The state is written after each line, whole or not at all; a line that
is not later than the state was learned before it, and is skipped.
"""

import json
from dataclasses import asdict, dataclass, field
from math import atan2, degrees, hypot, isfinite, nan
from pathlib import Path
from typing import Any

from ...base.errors import DataError
from ...base.files import write_file
from ...base.files.reading import read_text
from ...base.units import finite_or_none, seconds_since_1970
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import scenario_to_text
from ..gliders.dives import PLACE, STEERING, STRETCH, velocity_of
from .fix_model import LEVEL
from .flow_estimator import Ahead, FlowEstimator, Learned

PARTS = (PLACE, STEERING, STRETCH)
KEYS = {"time", "plan", *(key for part in PARTS for key in part)}
FORMAT = 1  # of the file of the state


@dataclass
class Motion:
    """Velocity through the water since the last line (m/s), and what that line had."""

    time: float = nan
    velocity: tuple[float, float] = (nan, nan)
    had: list[str] = field(default_factory=list)


class LiveFixes:
    """Learner that reads lines and keeps its state in a file.

    The state of a file is taken up again if the file exists.
    """

    def __init__(self, scenario: Scenario, path: Path | None = None) -> None:
        self.estimator, self.path = FlowEstimator(scenario), path
        self.motion = Motion()
        self.text = scenario_to_text(scenario)
        if path is not None and path.exists():
            self._resume(path)

    def answer(self, line: str) -> dict[str, Any] | None:
        """Read a line; return the answer to a fix, or None."""
        row = self._row(line)
        time = row["time"]
        has = [part[0] for part in PARTS if part[0] in row]
        if self._is_before(time, has):
            skipped = {"time": time, "skipped": "not later than the state"}
            return skipped if PLACE[0] in row else None
        before = self.estimator.state, asdict(self.motion)
        try:
            answer = self._take(row)
            self.motion.had = [
                *(self.motion.had if time == self.motion.time else ()),
                *has,
            ]
            self.motion.time = time
        except DataError:
            # a line is taken as a whole or not at all
            self.estimator.state, self.motion = before[0], Motion(**before[1])
            raise
        self._save()
        return answer

    def _take(self, row: dict[str, Any]) -> dict[str, Any] | None:
        """Move, learn and steer by a line."""
        time = row["time"]
        stretch = self._stretch(row)
        if stretch is not None:
            self.estimator.move(time, *stretch)
        answer = None
        if PLACE[0] in row:
            learned = self.estimator.fix(time, *(row[key] for key in PLACE))
            answer = answer_of(learned, self.estimator)
            if "plan" in row:
                ahead = self.estimator.forecast(_plan(row["plan"], time))
                answer["next"] = forecast_of(ahead)
        if STEERING[0] in row:
            self.motion.velocity = _velocity(row, "line")
        return answer

    def _stretch(self, row: dict[str, Any]) -> tuple[float, float] | None:
        """Return the displacement since the line before, m, or None if it is not known."""
        if STRETCH[0] in row:
            return row[STRETCH[0]], row[STRETCH[1]]
        if self.estimator.leg is None:
            return None
        span = row["time"] - self.motion.time
        east, north = (speed * span for speed in self.motion.velocity)
        return (east, north) if isfinite(east) and span > 0 else None

    def _is_before(self, time: float, has: list[str]) -> bool:
        """Return whether a line was taken before."""
        if time == self.motion.time:
            return set(has) <= set(self.motion.had)
        return time < self.motion.time

    def _row(self, line: str) -> dict[str, Any]:
        """Return a line as numbers by name."""
        try:
            row = json.loads(line)
        except (ValueError, RecursionError):
            raise DataError(
                f"{line[:60]!r}: is not JSON. Give one object a line"
            ) from None
        return _checked(row)

    def _resume(self, path: Path) -> None:
        """Take up a state from its file."""
        try:
            stored = json.loads(read_text(path, "is not the state of an estimate"))
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
        self.motion = Motion(**stored["motion"])

    def _save(self) -> None:
        if self.path is None:
            return
        state = {
            "format": FORMAT,
            "scenario": self.text,
            "estimator": self.estimator.state,
            "motion": asdict(self.motion),
        }
        write_file(self.path, json.dumps(state))


def _checked(row: Any) -> dict[str, Any]:
    """Return a line's object with its time in s and numbers, or refuse it."""
    if not isinstance(row, dict) or "time" not in row:
        raise DataError('a line must be an object with "time", as {"time": 0, ...}')
    unknown = sorted(set(row) - KEYS)
    if unknown:
        raise DataError(
            f"unknown key {unknown[0]!r:.40}. Allowed: {', '.join(sorted(KEYS))}"
        )
    checked = {key: value for key, value in row.items() if value is not None}
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
        number = nan
    if not isfinite(number):
        raise DataError(f"{key} = {value!r:.40}: must be a finite number")
    return number


def _velocity(row: dict[str, Any], where: str) -> tuple[float, float]:
    course, speed = (row[key] for key in STEERING)
    return velocity_of(course, speed, where)


def _plan(plan: Any, time: float) -> list[tuple[float, float, float]]:
    """Return the stretches of a plan: time at the end, displacement to the east and north."""
    if not isinstance(plan, list) or not plan:
        raise DataError("plan: must be a list of lines with time and displacement")
    stretches = []
    for line in map(_checked, plan):
        end = line["time"]
        if not end > time:
            raise DataError(f"plan: time {end:.15g} must be later than {time:.15g}")
        if STRETCH[0] in line:
            east, north = (line[key] for key in STRETCH)
        elif STEERING[0] in line:
            velocity = _velocity(line, "plan")
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


def forecast_of(ahead: Ahead) -> dict[str, float]:
    """Return a forecast as numbers by name: its ellipse is a circle."""
    return {
        "time": ahead.time,
        "latitude": ahead.latitude,
        "longitude": ahead.longitude,
        "radius_m": ahead.radius,
        "level": LEVEL,
    }


def answer_of(learned: Learned, estimator: FlowEstimator) -> dict[str, Any]:
    """Return what a fix taught as numbers by name, ready for JSON."""
    answer: dict[str, Any] = {
        "time": learned.time,
        "latitude": learned.latitude,
        "longitude": learned.longitude,
        "legs": estimator.legs,
        "error_m": finite_or_none(learned.error),
        "error_east_m": finite_or_none(learned.error_east),
        "error_north_m": finite_or_none(learned.error_north),
        "flow": towards(*learned.flow),
        "theta_m_s": learned.flow_parameters.tolist(),
        "standard_error_m_s": learned.standard_error.tolist(),
    }
    if learned.forecast is not None:
        answer["forecast"] = forecast_of(learned.forecast)
        answer["inside"] = bool(learned.inside)
    if learned.note:
        answer["note"] = learned.note
    return answer
