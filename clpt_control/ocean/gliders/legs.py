"""Legs of any vehicle: its fixes and its way through the water between them."""

from dataclasses import replace
from math import isfinite
from pathlib import Path

from ...base.errors import DataError
from ..estimation.dive import Dive
from .dive_files import read_all_dives
from .dives import Skipped
from .fix_log import NO_MOTION
from .usable_dives import usable


def read_legs(
    path: str | Path, drifting: bool = False
) -> tuple[list[Dive], list[Skipped]]:
    """Return the usable legs of a table or of vehicle files, and what was skipped.

    With `drifting` an unknown displacement through the water is 0.
    """
    legs, skipped = read_all_dives(path)
    known = [isfinite(leg.dr_east) and isfinite(leg.dr_north) for leg in legs]
    if drifting:
        legs = [
            leg if is_known else replace(leg, dr_east=0.0, dr_north=0.0, notes=())
            for leg, is_known in zip(legs, known, strict=True)
        ]
    elif not any(known) and all(NO_MOTION in leg.notes for leg in legs):
        raise DataError(f"{path}: {NO_MOTION}")
    used, unused = usable(legs, least_duration=0.0)
    if not used:
        raise DataError(f"{path}: no usable leg. First reason: {unused[0].why}")
    return used, [*skipped, *unused]
