"""What readers make of a file: dives (`estimation.dive`), and what is no dive.

The depth-averaged current c that a file reports should be

    c = miss / duration,

an independent check that fixes and dead reckoning were read as they were meant.
Seaglider basestations to version 2 compute it with 1852 m to a minute of latitude
and the time of flight, which differs from ours by up to 0.5 % of the displacement
between the fixes and by the minutes at the surface: some 2 mm/s, five at most in
sound dives that were tried.  More says that the samples in the file are not all
that its current was made of.
"""

from dataclasses import dataclass, replace
from math import hypot, isfinite

from ..errors import DataError
from ..estimation.dive import Dive as Dive
from ..estimation.dive import Fix as Fix
from ..estimation.dive import make_dive as make_dive

MENTIONED = 0.01  # m/s
NUMBERS = 2**31  # dive numbers are smaller, as files keep them in 32 bits


@dataclass(frozen=True)
class Skipped:
    """A dive that is not used, or a file or line that holds none: its number, if known, and why."""

    dive: int | None
    why: str


class NotYet(DataError):
    """A file that can be read once something beside it is there; it is tried at each look."""


def whole_number(value: float | str | None) -> int | None:
    """Return the number of a dive, below `NUMBERS` in size, or None where it is none.

    >>> whole_number("7"), whole_number(7.5), whole_number("1e10"), whole_number("x")
    (7, None, None, None)
    """
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return None
    return int(number) if number.is_integer() and abs(number) < NUMBERS else None


def compared(dive: Dive) -> Dive:
    """Add a note where miss / duration differs from the file's current by over 10 mm/s.

    >>> fixes = (1e9, -43.0, 8.0), (1e9 + 9000, -43.0, 8.0)
    >>> compared(make_dive(1, *fixes, (0.0, 450.0), dac_east=0.0, dac_north=-0.05)).notes
    ()
    >>> compared(make_dive(1, *fixes, (0.0, 450.0), dac_east=0.03, dac_north=-0.05)).notes
    ("miss over duration differs by 30 mm/s from the file's depth-averaged current",)
    """
    if dive.dac_east is None or dive.dac_north is None or not dive.duration > 0:
        return dive
    difference = hypot(
        dive.miss_east / dive.duration - dive.dac_east,
        dive.miss_north / dive.duration - dive.dac_north,
    )
    if not (isfinite(difference) and difference > MENTIONED):
        return dive
    note = (
        f"miss over duration differs by {1e3 * difference:.0f} mm/s from the file's "
        "depth-averaged current"
    )
    return replace(dive, notes=(*dive.notes, note))
