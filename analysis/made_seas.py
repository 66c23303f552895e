"""Made seas: gliders whose current, speed and faults are known.

A vehicle dives on headings of some pattern; between its fixes it moves by

    dx/dt = f R(psi) v_dr + u(x, t)

with u the sum of what a `Sea` names: a mean, a random walk, parts that are
forgotten in a time (Ornstein-Uhlenbeck, once or twice), tides, inertial
oscillations, an eddy, a jet.  Sizes are plausible, not measured: 0.1 to 0.3 m/s of
eddies that last days, tides of 0.3 m/s on shelves, a jet of 1.4 m/s, internal waves
of 2 to 3 cm/s, speeds known to 5 or 10 %.
"""

import math
from typing import NamedTuple

import numpy as np

from clpt_control.gliders import Dive

PERIODS = {
    "M2": 44714.16,
    "S2": 43200.0,
    "K1": 86164.09,
    "O1": 92949.63,
}  # s (Foreman 1977)
DAY, QUARTER_DAY, TICK = 86400.0, 21600.0, 600.0  # s
LATITUDE, LONGITUDE = 40.0, 8.0  # degrees, of all dives
ROTATION = 7.292115e-5  # rad/s, of the Earth
SURFACE = 900.0  # s between dives
SPEED, FIX = 0.25, 20.0  # m/s through the water; m, error of a displacement


class Sea(NamedTuple):
    """A sea and a vehicle in it.

    `walk` is in m/s per sqrt(6 h); `eddying` lists (size m/s, memory s, order 1
    or 2); `tides` amplitudes in m/s by name; `inertial` (size m/s, memory s); `eddy` and `jet`
    (speed m/s, radius m); `scatter` in m/s per dive; `speed_sd`, `compass_sd`
    (rad) how wrong the vehicle is; `heading` any, one, legs, mower or wander;
    `hours` of a dive; `dives` of a record.
    """

    walk: float = 0.0
    eddying: tuple = ()
    tides: tuple = ()
    inertial: tuple[float, float] | None = None
    eddy: tuple = ()
    jet: tuple = ()
    scatter: float = 0.0
    speed_sd: float = 0.0
    compass_sd: float = 0.0
    heading: str = "legs"
    hours: float = 4.0
    dives: int = 30


def headings(rng: np.random.Generator, count: int, kind: str) -> np.ndarray:
    """Return the headings of dives, rad from east."""
    start, leg = rng.uniform(0, 2 * np.pi), int(rng.integers(4, 8))
    k = np.arange(count)
    small = 0.1 * rng.normal(size=count)
    return {
        "any": rng.uniform(0, 2 * np.pi, count),
        "one": start + small,
        "legs": start + np.pi * ((k // leg) % 2) + small,
        "mower": start + np.pi / 2 * np.array([0, 1, 2, 1])[(k // leg) % 4] + small,
        "wander": start + np.cumsum(4 * small),
    }[kind]


def remembered(
    rng: np.random.Generator, size: float, memory: float, order: int, n: int
):
    """Return n ticks of an Ornstein-Uhlenbeck current, order 1 or 2."""
    keep = math.exp(-TICK / memory)
    kicks = rng.normal(size=(n, 2))
    y = np.empty((n, 2))
    y[0] = kicks[0]
    for k in range(1, n):
        y[k] = keep * y[k - 1] + math.sqrt(1 - keep**2) * kicks[k]
    if order == 2:
        smooth = np.empty((n, 2))
        smooth[0] = y[0]
        for k in range(1, n):
            smooth[k] = keep * smooth[k - 1] + (1 - keep) * y[k]
        y = math.sqrt(2) * smooth
    return size * y


def background(sea: Sea, rng: np.random.Generator, end: float) -> np.ndarray:
    """Return the current without eddy and jet, (n, 2) m/s, every tick."""
    n = int(end / TICK) + 2
    time = TICK * np.arange(n)
    u = np.tile([0.1, -0.05], (n, 1))
    if sea.walk:
        kicks = sea.walk * math.sqrt(TICK / QUARTER_DAY) * rng.normal(size=(n, 2))
        u += np.cumsum(kicks, axis=0)
    for size, memory, order in sea.eddying:
        u += remembered(rng, size, memory, order, n)
    for name, size in sea.tides:
        turn = 2 * np.pi / PERIODS[name] * time + rng.uniform(0, 2 * np.pi)
        u += size * np.stack(
            [np.cos(turn), rng.uniform(-0.7, 0.7) * np.sin(turn)], axis=1
        )
    if sea.inertial:  # what turns clockwise and is forgotten: a complex OU current
        slow = remembered(rng, *sea.inertial, 1, n)
        turn = 2 * ROTATION * np.sin(np.radians(LATITUDE)) * time
        turning = (slow[:, 0] + 1j * slow[:, 1]) * np.exp(-1j * turn)
        u += np.stack([turning.real, turning.imag], axis=1)
    return u


def made_dives(sea: Sea, seed: int, lost: float = 0.0, since: int = 0) -> list[Dive]:
    """Return the dives of a vehicle in a sea, all at 40 N 8 E.

    It has `lost` a share of its speed from the dive `since` on.
    """
    rng = np.random.default_rng(seed)
    factor, compass = 1 + sea.speed_sd * rng.normal(), sea.compass_sd * rng.normal()
    T = 3600 * sea.hours * rng.uniform(0.75, 1.25, sea.dives)
    start = np.concatenate([[0.0], np.cumsum(T[:-1] + SURFACE)])
    u = background(sea, rng, start[-1] + T[-1] + TICK)
    ticks = TICK * np.arange(len(u))
    center = rng.uniform(-1, 1, 2)
    along = rng.uniform(0, 2 * np.pi)
    ahead, aside = (
        np.array([np.cos(along), np.sin(along)]),
        np.array([-np.sin(along), np.cos(along)]),
    )
    c, s = np.cos(compass), np.sin(compass)
    x, dives = np.zeros(2), []
    for k, angle in enumerate(headings(rng, sea.dives, sea.heading)):
        dr = SPEED * T[k] * np.array([np.cos(angle), np.sin(angle)])
        f = factor * (1 - lost if k >= since else 1)
        water = f * np.array([c * dr[0] + s * dr[1], c * dr[1] - s * dr[0]]) / T[k]
        steps, here = 40, x
        for i in range(steps):
            t = start[k] + (i + 0.5) * T[k] / steps
            flow = np.array([np.interp(t, ticks, u[:, j]) for j in (0, 1)])
            if sea.eddy:
                r = x / sea.eddy[1] - center
                flow += (
                    sea.eddy[0] * math.exp(0.5 - 0.5 * r @ r) * np.array([-r[1], r[0]])
                )
            if sea.jet:
                flow += (
                    sea.jet[0]
                    * math.exp(-0.5 * (x @ aside / sea.jet[1] - 0.8) ** 2)
                    * ahead
                )
            x = x + (water + flow) * T[k] / steps
        moved = (
            x
            - here
            + FIX * rng.normal(size=2)
            + sea.scatter * T[k] * rng.normal(size=2)
        )
        t = 1.6e9 + start[k]
        dives.append(
            Dive(k, t, LATITUDE, LONGITUDE, t + T[k], LATITUDE, LONGITUDE, *moved, *dr)
        )
    return dives
