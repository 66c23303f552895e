"""Turn NMEA 0183 sentences into lines for `clpt estimate -`.

    python examples/nmea_fixes.py < log.nmea | clpt estimate - --scenario mine.toml --state s.json

RMC has time, date and position: a fix, unless its status is not A or its mode is estimated (E),
none (N) or a simulator (S).  VHW has true heading and speed through the water: they hold until
the next VHW.  VHW has no time, so its line gets that of the last RMC, valid or not: receivers
keep their clock under water.  Sentences with a wrong checksum, or with fields that are empty or
short, are skipped.  A magnetic heading alone is told once.
"""

import json
import sys
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

KNOT = 1852 / 3600  # m/s
NO_FIX = ("E", "N", "S")  # modes of RMC: estimated, none, simulator
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
    """Return the line of an RMC, or None if it is no fix."""
    mode = fields[12] if len(fields) > 12 else "A"
    if fields[2] != "A" or mode in NO_FIX:
        return None
    return {
        "time": time,
        "latitude": degrees(fields[3], fields[4]),
        "longitude": degrees(fields[5], fields[6]),
    }


def lines(sentences: Iterable[str]) -> Iterator[dict[str, float]]:
    """Yield a line for each fix and each change of heading or speed."""
    time, is_told = None, False
    for sentence in sentences:
        fields = fields_of(sentence)
        if fields is None:
            continue
        kind = fields[0][2:]
        try:
            if kind == "RMC":
                clock = datetime.strptime(fields[9] + fields[1][:6], "%d%m%y%H%M%S")
                time = clock.replace(tzinfo=UTC).timestamp()
                if line := fix_of(fields, time):
                    yield line
            elif kind == "VHW" and time is not None and fields[1]:
                speed = float(fields[5]) * KNOT
                yield {"time": time, "course": float(fields[1]), "speed": speed}
            elif kind == "VHW" and fields[3] and not is_told:
                print(MAGNETIC, file=sys.stderr)
                is_told = True
        except (ValueError, IndexError):
            # a field that is empty or short
            continue


if __name__ == "__main__":
    for line in lines(sys.stdin):
        print(json.dumps(line), flush=True)
