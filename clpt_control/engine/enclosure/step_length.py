"""Steps in time: their lengths, as balls, and the powers of these."""

import numpy as np

from . import balls
from .balls import Ball, between
from .noise import REACH

TRUNCATION = 2.0**-53  # wished remainder, of the size of a state
UNDERFLOW = 2.0**-1000  # more than the errors of powers that underflow
SHARE = 1e-4  # and of the radius of its box


def moved(t: float, new: float) -> Ball:
    """Return the difference of two times."""
    length = new - t
    return between(np.nextafter(length, 0), np.nextafter(length, np.inf))


def powers(h: Ball, count: int) -> Ball:
    """Return h^0, h^1, ...; no h is below 0."""
    i = np.arange(count)
    low, high = (
        np.cumprod(np.append(1.0, np.full(count - 1, max(float(end), 0.0))))
        for end in (h.lower, h.upper)
    )
    share, tiny = i * balls.UNIT, np.where(i > 1, UNDERFLOW, 0.0)
    return between(low * (1.0 - share) - tiny, high * (1.0 + share) + tiny)


def step_length(F: Ball, box: Ball, h: float, least: float) -> tuple[float, np.ndarray]:
    """Return a length by the last coefficients, and errors allowed to the states."""
    p, sizes = F.c.shape[1] - 2, F.size
    while True:
        terms = sizes * h ** np.arange(p + 2)
        allowed = TRUNCATION * np.sum(terms[:, : p + 1], axis=1)
        allowed += SHARE * box.r + REACH
        worst = float(np.max(terms[:, p:].T / allowed))
        if worst <= 1.0 or h < least:
            return h, allowed
        h *= max(0.2, 0.95 * worst ** (-1.0 / (p + 1))) if worst < np.inf else 0.2
