"""Where each number of a fused diagram lies.

All parameters of all blocks stand in one vector P, fields that hold the same
values once: a basis at the vehicle and at its prediction then share widths and
tides, and the compiler sees that their cosines are one.  Tables that are large
lie in T, which runs share.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..blocks import Block
from ..diagrams.wiring import Wiring

LARGE = 512  # numbers: a larger array is a table that runs share


@dataclass
class Place:
    """Where a parameter field lies.

    Attributes
    ----------
    array : str
        ``"P"``, own to a run, or ``"T"``, shared.
    offset : int
        First number.
    shape : tuple of int
        Shape of the field; empty for a number.
    """

    array: str
    offset: int
    shape: tuple[int, ...]


@dataclass
class Layout:
    """The places of all parameters of a diagram.

    Attributes
    ----------
    places : dict
        (block index, field) -> Place.
    intervals : dict
        Block index -> offset in P of its parameter `interval`.
    P, T : ndarray
        The diagram's own values.
    pattern : str
        Which fields share a place; part of the key of compiled code.
    """

    places: dict[tuple[int, str], Place] = field(default_factory=dict)
    intervals: dict[int, int] = field(default_factory=dict)
    P: np.ndarray = field(default_factory=lambda: np.zeros(0))
    T: np.ndarray = field(default_factory=lambda: np.zeros(0))
    pattern: str = ""

    def packed(self, parameters: Sequence[Any]) -> np.ndarray:
        """Return P for other parameters of the same blocks.

        Parameters
        ----------
        parameters : sequence of NamedTuple
            One for each block, in the order of the wiring.

        Returns
        -------
        ndarray
            P; fields that share a place must be equal.

        Raises
        ------
        ValueError
            If two fields that share a place differ.
        """
        P = self.P.copy()
        seen: dict[int, Any] = {}
        for (k, name), place in self.places.items():
            value = np.asarray(getattr(parameters[k], name), dtype=float).ravel()
            if place.array == "T":
                continue
            if place.offset in seen and not np.array_equal(seen[place.offset], value):
                raise ValueError(f"{name} of block {k} no longer equals the field it stands with")
            seen[place.offset] = value
            P[place.offset : place.offset + len(value)] = value
        return P


def lay_out(wiring: Wiring, parameters: Sequence[Any]) -> Layout:
    """Return every parameter of a diagram a place.

    Parameters
    ----------
    wiring : Wiring
        The diagram.
    parameters : sequence of NamedTuple
        One for each block; None for a system that is no block.

    Returns
    -------
    Layout
        Places and values.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.diagrams.wiring import read
    >>> wiring = read(clpt.closed_loop(clpt.paper_scenario()))
    >>> layout = lay_out(wiring, [node.system.parameters for node in wiring.nodes])
    >>> layout.places[(1, "widths")] == layout.places[(2, "widths")]
    True
    """
    layout = Layout()
    own: list[np.ndarray] = []
    tables: list[np.ndarray] = []
    known: dict[tuple[str, tuple[int, ...], bytes], Place] = {}
    names = []
    for k, (node, p) in enumerate(zip(wiring.nodes, parameters, strict=True)):
        if not isinstance(node.system, Block):
            continue
        for name, value in zip(p._fields, p, strict=True):
            if isinstance(value, int):
                continue
            array = np.asarray(value, dtype=float)
            key = (name, array.shape, array.tobytes())
            if name == "interval":
                key = (f"{name} {k}", (), b"")
            if key not in known:
                large = array.size > LARGE
                stack = tables if large else own
                offset = sum(part.size for part in stack)
                stack.append(array.ravel())
                known[key] = Place("T" if large else "P", offset, array.shape)
            layout.places[(k, name)] = known[key]
            names.append(f"{k}.{name}:{known[key].array}{known[key].offset}{array.shape}")
            if name == "interval" and node.system.breakpoints_function is not None:
                layout.intervals[k] = known[key].offset
    layout.P = np.concatenate([np.zeros(0), *own])
    layout.T = np.concatenate([np.zeros(0), *tables])
    layout.pattern = " ".join(names)
    return layout
