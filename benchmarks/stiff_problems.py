"""Stiff problems whose solutions are known, written as users write a model.

Robertson's, HIRES, OREGO and van der Pol's equation, and their solutions, are those of the Test Set
for Initial Value Problem Solvers (Mazzia and Magherini, 2008, https://archimede.uniba.it/~testset),
whose reference solutions carry 14 digits.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

Rates = Callable[..., list | dict | np.ndarray]


class Problem(NamedTuple):
    """Rates, the state at 0, the end of the run, and the state there."""

    rates: Rates
    start: np.ndarray
    end: float
    exact: np.ndarray
    absolute: float = 1.0  # atol, of rtol


def relaxation(t, x, u, p):
    """Prothero and Robinson's problem: fast to a slow solution, the cosine."""
    return [-1e7 * (x[0] - np.cos(t)) - np.sin(t)]


def late(t, x, u, p):
    """As `relaxation`, without the slope of what is followed."""
    return [-1e7 * (x[0] - np.cos(t))]


def van_der_pol(t, x, u, p):
    """Of the test set: eps = 1e-6."""
    return [x[1], ((1.0 - x[0] ** 2) * x[1] - x[0]) / 1e-6]


def robertson(t, x, u, p):
    """Three reactions."""
    first, second, third = 0.04 * x[0], 1e4 * x[1] * x[2], 3e7 * x[1] ** 2
    return [second - first, first - second - third, third]


def oregonator(t, x, u, p):
    """OREGO: an oscillating reaction."""
    return [
        77.27 * (x[1] + x[0] * (1.0 - 8.375e-6 * x[0] - x[1])),
        (x[2] - (1.0 + x[0]) * x[1]) / 77.27,
        0.161 * (x[0] - x[2]),
    ]


def hires(t, x, u, p):
    """High irradiance responses of a plant: eight reactions."""
    y1, y2, y3, y4, y5, y6, y7, y8 = x
    pair = 280.0 * y6 * y8
    return [
        -1.71 * y1 + 0.43 * y2 + 8.32 * y3 + 0.0007,
        1.71 * y1 - 8.75 * y2,
        -10.03 * y3 + 0.43 * y4 + 0.035 * y5,
        8.32 * y2 + 1.71 * y3 - 1.12 * y4,
        -1.745 * y5 + 0.43 * y6 + 0.43 * y7,
        -pair + 0.69 * y4 + 1.71 * y5 - 0.43 * y6 + 0.69 * y7,
        pair - 1.81 * y7,
        -pair + 1.81 * y7,
    ]


CELLS = 400


def heat(t, x, u, p):
    """Heat in a rod whose ends are cold, in 400 places."""
    y = np.concatenate([[0.0], x, [0.0]])
    return (CELLS + 1) ** 2 * (y[2:] - 2.0 * y[1:-1] + y[:-2])


def _heat_after(start: np.ndarray, t: float) -> np.ndarray:
    """The solution by eigenvectors, which are sines."""
    k = np.arange(1, CELLS + 1)
    modes = np.sqrt(2.0 / (CELLS + 1)) * np.sin(np.pi * np.outer(k, k) / (CELLS + 1))
    rates = -4.0 * (CELLS + 1) ** 2 * np.sin(0.5 * np.pi * k / (CELLS + 1)) ** 2
    return modes @ (np.exp(rates * t) * (modes @ start))


PLACES = np.arange(1, CELLS + 1) / (CELLS + 1)
HOT = np.exp(-100.0 * (PLACES - 0.4) ** 2) + (PLACES > 0.7)
LAG = 1e7  # x' = -LAG (x - cos t)
PROBLEMS = {
    "relaxation": Problem(relaxation, np.array([0.5]), 10.0, np.array([np.cos(10.0)])),
    "late": Problem(
        late,
        np.array([0.0]),
        10.0,
        np.array([LAG * (LAG * np.cos(10.0) + np.sin(10.0)) / (LAG**2 + 1.0)]),
    ),
    "van der Pol": Problem(
        van_der_pol,
        np.array([2.0, 0.0]),
        2.0,
        np.array([0.1706167732170483e1, -0.8928097010247975]),
    ),
    "Robertson": Problem(
        robertson,
        np.array([1.0, 0.0, 0.0]),
        1e11,
        np.array([0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050]),
        1e-8,
    ),
    "OREGO": Problem(
        oregonator,
        np.array([1.0, 2.0, 3.0]),
        360.0,
        np.array([0.1000814870318523e1, 0.1228178521549917e4, 0.1320554942846706e3]),
    ),
    "HIRES": Problem(
        hires,
        np.array([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057]),
        321.8122,
        np.array(
            [
                *(0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4),
                *(0.1175651343283149e-2, 0.2386356198831331e-2, 0.6238968252742796e-2),
                *(0.2849998395185769e-2, 0.2850001604814231e-2),
            ]
        ),
        1e-4,
    ),
    "heat": Problem(heat, HOT, 0.05, _heat_after(HOT, 0.05)),
}
