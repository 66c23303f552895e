"""Learn the flow from NMEA 0183 sentences as they arrive, and go on after a restart.

    python examples/nmea_fixes.py mine.toml learned.state < log.nmea

RMC has time, date and position: a fix, unless its status is not A or its mode is estimated (E),
none (N) or a simulator (S).  VHW has true heading and speed through the water: they hold until
the next VHW.  VHW has no time, so it gets that of the last RMC, valid or not: receivers keep
their clock under water.  Of several VHW between two RMC the mean velocity is used.  Sentences with
a wrong checksum, or with fields that are empty or short, are skipped.  A magnetic heading alone is
told once, and a log in which nothing was read at its end.

Each fix is answered by one object of JSON, and the learner is saved.  A killed process is started
again with the sentences since the last fix, or all of them: sentences before the last fix are not
learned again.  If sentences are lost, the motion until the next fix is unknown, and that fix
begins a leg.
"""

import json
import sys
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from math import cos, radians, sin
from pathlib import Path
from typing import Any

import numpy as np

import clpt_control as clpt

KNOT = 1852 / 3600  # m/s
FASTEST = 5.0  # m/s through the water; a greater speed is taken as unknown
NO_FIX = ("E", "N", "S")  # modes of RMC: estimated, none, simulator
NOTHING = (
    "no RMC with a fix was read. Give lines that begin with $ and end with a checksum, such as "
    "$GPRMC,120000,A,3642.00,N,12206.00,W,0.0,0.0,010526,,,A*65"
)
MAGNETIC = "VHW has a magnetic heading alone. Turn it by the variation of the place"


def fields_of(sentence: str) -> list[str] | None:
    """Return the fields of a sentence, or None if its checksum is wrong."""
    body, _, checksum = sentence.strip().removeprefix("$").partition("*")
    total = 0
    for letter in body:
        total ^= ord(letter)
    return body.split(",") if checksum.upper() == f"{total:02X}" else None


def degrees(text: str, hemisphere: str) -> float:
    """Return ddmm.mmm or dddmm.mmm in degrees, negative to the south and to the west."""
    if hemisphere not in ("N", "S", "E", "W"):
        raise ValueError(hemisphere)
    whole = text.partition(".")[0]
    value = float(text[: len(whole) - 2]) + float(text[len(whole) - 2 :]) / 60
    return -value if hemisphere in ("S", "W") else value


def fix_of(fields: list[str], time: float) -> dict[str, float] | None:
    """Return the fix of an RMC, or None if it has none."""
    mode = fields[12] if len(fields) > 12 else "A"
    if fields[2] != "A" or mode in NO_FIX:
        return None
    return {
        "time": time,
        "latitude": degrees(fields[3], fields[4]),
        "longitude": degrees(fields[5], fields[6]),
    }


def readings(sentences: Iterable[str]) -> Iterator[dict[str, float]]:
    """Yield each fix and each heading (degrees) with speed (m/s)."""
    time, is_told, is_read = None, False, False
    for sentence in sentences:
        fields = fields_of(sentence)
        if fields is None:
            continue
        kind = fields[0][2:]
        try:
            if kind == "RMC":
                clock = datetime.strptime(fields[9] + fields[1][:6], "%d%m%y%H%M%S")
                time = clock.replace(tzinfo=UTC).timestamp()
                if fix := fix_of(fields, time):
                    is_read = True
                    yield fix
            elif kind == "VHW" and time is not None and fields[1]:
                speed = float(fields[5]) * KNOT
                yield {"time": time, "course": float(fields[1]), "speed": speed}
            elif kind == "VHW" and fields[3] and not is_told:
                print(MAGNETIC, file=sys.stderr)
                is_told = True
        except (ValueError, IndexError):
            # a field that is empty or short
            continue
    if not is_read:
        print(NOTHING, file=sys.stderr)


def feed(
    estimator: clpt.currents.FlowEstimator, sentences: Iterable[str]
) -> Iterator[Any]:
    """Move and fix an estimator by sentences, and yield what each fix taught."""
    velocities: list[tuple[float, float]] = []  # m/s to the east and north, of one time
    time_of_velocities = 0.0
    is_known = False  # the motion since the last fix
    for reading in readings(sentences):
        time = reading["time"]
        # s since the last stretch or fix; the estimator rounds times to about 1e-7 s
        span = round(time - estimator.time, 3)
        if is_known and span > 0:
            east, north = np.mean(velocities or [(np.nan, np.nan)], axis=0) * span
            is_known = bool(np.isfinite(east))
            if is_known:
                estimator.move(time, east, north)
        if "course" in reading:
            course, speed = radians(reading["course"]), reading["speed"]
            if not 0 <= speed <= FASTEST:
                speed = np.nan
            if time != time_of_velocities:
                velocities, time_of_velocities = [], time
            velocities.append((speed * sin(course), speed * cos(course)))
            continue
        if span > 0:
            yield estimator.fix(time, reading["latitude"], reading["longitude"])
        is_known = span >= 0 or is_known


def main(scenario: str, state: Path) -> None:
    """Go on from the saved learner if there is one, and print a line for each fix."""
    if state.exists():
        estimator = clpt.currents.FlowEstimator.load(state)
    else:
        estimator = clpt.currents.FlowEstimator(clpt.load_scenario(scenario))
    for learned in feed(estimator, sys.stdin):
        estimator.save(state)
        answer = {
            "time": learned.time,
            "latitude": learned.latitude,
            "longitude": learned.longitude,
            "error_m": None if learned.forecast is None else learned.error,
            "flow_m_s": learned.flow,
            "note": learned.note,
        }
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
