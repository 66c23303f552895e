"""Whether a dive agrees with the depth-averaged current of its own file.

A file's own current c should be

    c = miss / duration,

and is the independent check that fixes and dead reckoning were read as they were
meant.  Seaglider basestations to version 2 compute it with 1852 m to a minute of
latitude and the time of flight, which differs from ours by up to 0.5 % of the way
between the fixes and by the minutes at the surface: some 2 mm/s, five at most in
sound dives that were tried.  More says that the samples in the file are not all
that its current was made of.
"""

from dataclasses import replace
from math import hypot, isfinite

from .dives import Dive

MENTIONED = 0.01  # m/s


def compared(dive: Dive) -> Dive:
    """Note on a dive that its file's own current is another.

    Parameters
    ----------
    dive : Dive
        As it was read.

    Returns
    -------
    Dive
        The same, with a note where the two differ by more than 10 mm/s.

    Examples
    --------
    >>> from clpt_control.gliders.dives import make_dive
    >>> fixes = (1e9, -43.0, 8.0), (1e9 + 9000, -43.0, 8.0)
    >>> compared(make_dive(1, *fixes, (0.0, 450.0), dac_east=0.0, dac_north=-0.05)).notes
    ()
    >>> compared(make_dive(1, *fixes, (0.0, 450.0), dac_east=0.03, dac_north=-0.05)).notes
    ("miss over duration differs by 30 mm/s from the file's own current",)
    """
    if dive.dac_east is None or dive.dac_north is None or not dive.duration > 0:
        return dive
    difference = hypot(
        dive.miss_east / dive.duration - dive.dac_east,
        dive.miss_north / dive.duration - dive.dac_north,
    )
    if not (isfinite(difference) and difference > MENTIONED):
        return dive
    said = f"miss over duration differs by {1e3 * difference:.0f} mm/s from the file's own current"
    return replace(dive, notes=(*dive.notes, said))
