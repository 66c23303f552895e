"""Pieces of a set: a box is halved where its runs bend most, or where a question is open.

Bounds of all pieces together hold for the box.
"""

from collections.abc import Callable, Iterator
from copy import deepcopy
from typing import Any

import numpy as np

from ...base.progress import interrupt
from .balls import Ball, between
from .sets import Enclosure


def enclosed(
    whole: Ball,
    schedule: Any,
    most: int,
    *arguments: Any,
    undecided: Callable[[Enclosure], bool] | None = None,
) -> list[Enclosure]:
    """Return boxes of at most so many pieces of a box.

    The earliest to end is divided first, of those that are `undecided` if that is asked.
    """
    pieces, parts = list[Enclosure](), [whole]
    while True:
        for box in parts:
            interrupt.check()
            pieces.append(Enclosure(box, *arguments))
            pieces[-1].run(schedule)
        pieces.sort(key=lambda piece: (piece.t, -np.sum(piece.bent)))
        wide = [piece for piece in pieces if np.any(piece.whole.r)]
        if undecided is not None:
            wide = [piece for piece in wide if undecided(piece)]
        elif wide:
            wide = wide[:1] if wide[0] is pieces[0] else []
        if len(pieces) >= most or not wide:
            return pieces
        pieces.remove(wide[0])
        parts = [*halves(wide[0])]


def halves(piece: Enclosure) -> Iterator[Ball]:
    """Yield the two halves of the box of a piece along what bends runs most."""
    whole = piece.whole
    k = np.flatnonzero(whole.r)[np.argmax(piece.bent)]
    for end in (whole.lower, whole.upper):
        half = deepcopy(whole)
        half.c[k], half.r[k] = between(*sorted([end[k], half.c[k]]))
        yield half
