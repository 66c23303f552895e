"""A record with its loops: what its steps read, and at which places.

Arrays of a block's loops: t, x, u, ("p", field), out, K (constants) and S (what turns
compute and others read).
"""

from typing import Any, NamedTuple

from .program import Steps


class Place(NamedTuple):
    """A number in an array, at a place affine in the turns of loops."""

    array: Any
    base: int
    steps: Steps = ()


class Constant(NamedTuple):
    """A number; 0.0 is not -0.0."""

    value: float
    sign: float


class Run(NamedTuple):
    """Numbers of a parameter that `lookup` reads, evenly spaced."""

    place: Place
    stride: int
    count: int  # type: ignore[assignment]


class Rolled(NamedTuple):
    """A record with its loops.

    Attributes
    ----------
    items : tuple
        Steps, stores and loops; arguments are values, constants, places and runs.
    constants : tuple of float
        K.
    room : int
        Length of S.
    """

    items: tuple
    constants: tuple[float, ...]
    room: int
