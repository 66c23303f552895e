"""Turn NMEA 0183 sentences into lines for `clpt estimate -`.

    python examples/nmea_fixes.py < log.nmea | clpt estimate - --scenario mine.toml --state s.json

RMC has time, date and position: a fix.  VHW has true heading and speed through the water: they hold
until the next VHW.  VHW has no time, so its line gets that of the last RMC, valid or not: receivers
keep their clock under water.  Sentences with a wrong checksum are skipped.
"""

import json
import sys
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

KNOT = 1852 / 3600  # m/s


def fields_of(sentence: str) -> list[str] | None:
    """Return the fields of a sentence, or None if its checksum is wrong."""
    body, _, checksum = sentence.strip().removeprefix("$").partition("*")
    total = 0
    for letter in body:
        total ^= ord(letter)
    return body.split(",") if checksum.upper() == f"{total:02X}" else None


def degrees(text: str, hemisphere: str) -> float:
    """Return ddmm.mmm or dddmm.mmm in degrees, negative to the south and to the west."""
    point = text.index(".")
    value = float(text[: point - 2]) + float(text[point - 2 :]) / 60
    return -value if hemisphere in ("S", "W") else value


def lines(sentences: Iterable[str]) -> Iterator[dict[str, float]]:
    """Yield a line for each fix and each change of heading or speed."""
    time = None
    for sentence in sentences:
        fields = fields_of(sentence)
        if fields is None:
            continue
        kind = fields[0][2:]
        if kind == "RMC" and fields[1] and fields[9]:
            clock = datetime.strptime(fields[9] + fields[1][:6], "%d%m%y%H%M%S")
            time = clock.replace(tzinfo=UTC).timestamp()
            if fields[2] == "A":
                latitude = degrees(fields[3], fields[4])
                longitude = degrees(fields[5], fields[6])
                yield {"time": time, "latitude": latitude, "longitude": longitude}
        elif kind == "VHW" and time is not None and fields[1] and fields[5]:
            speed = float(fields[5]) * KNOT
            yield {"time": time, "course": float(fields[1]), "speed": speed}


if __name__ == "__main__":
    for line in lines(sys.stdin):
        print(json.dumps(line), flush=True)
