"""From fix to fix: what a vehicle knows of its way, and the flow along it.

    y = x(t2) - x(t1) - d(t2) = theta int phi(x(t), t) dt,    d(t) = int v dt since t1

is Eq. (1) with Eq. (3), integrated over a segment: y is its miss, where the vehicle comes up less
where its dead reckoning d has it, and the integral is h, shape (N,).  Where the track x(t) is
unknown it is predicted with an estimate of theta, z' = theta phi(z, t) + v, or the dead-reckoned
track is bent evenly to the fix that it ends at.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.integrate import simpson

from ..equations.at_many import evaluate
from ..equations.block import Block
from ..geodesy import displacement
from .dive import Dive
from .fix_regressor import reckoned

SAMPLES = 129  # of a segment's track, an odd number for Simpson's rule


class Segments(NamedTuple):
    """n segments, each at m times."""

    time: np.ndarray  # (n, m), from fix to fix
    water: np.ndarray  # (n, 2 m - 1, 2), d there and at the times between, length
    start: np.ndarray  # (n, 2), x(t1), length
    end: np.ndarray  # (n, 2), x(t2), length
    track: np.ndarray | None = None  # (n, m, 2), x(t), length; None where it is not known

    @property
    def miss(self) -> np.ndarray:
        """y of each segment, (n, 2), length."""
        return self.end - self.start - self.water[:, -1]

    @property
    def duration(self) -> np.ndarray:
        """Time between the fixes, (n,)."""
        return self.time[:, -1] - self.time[:, 0]

    @property
    def seen(self) -> np.ndarray:
        """The track, or the dead-reckoned one bent evenly to its end, (n, m, 2), length."""
        if self.track is not None:
            return self.track
        share = (self.time - self.time[:, :1]) / self.duration[:, None]
        return self.start[:, None] + self.water[:, ::2] + share[:, :, None] * self.miss[:, None]

    def integrals(self, basis: Block, track: np.ndarray) -> np.ndarray:
        """Return h = int phi(x(t), t) dt along tracks (n, m, 2): shape (n, N), time."""
        n, m = self.time.shape
        phi = evaluate(basis, self.time.ravel(), track.reshape(-1, 2)).reshape(n, m, -1)
        return simpson(phi, dx=1.0, axis=1) * (self.duration / (m - 1))[:, None]

    def predicted(self, basis: Block, theta: np.ndarray) -> np.ndarray:
        """Return tracks z' = theta phi(z, t) + v from the start fixes, (n, m, 2), by RK4.

        The fixes at the ends are not read.
        """
        h = (self.time[:, 1] - self.time[:, 0])[:, None]
        carried = np.zeros((*self.time.shape, 2))  # by the flow: z less start and d

        def flow(k: int, half: int, moved: np.ndarray) -> np.ndarray:
            place = self.start + self.water[:, 2 * k + half] + moved
            return evaluate(basis, self.time[:, k] + 0.5 * half * h[:, 0], place) @ theta.T

        for k in range(self.time.shape[1] - 1):
            u = carried[:, k]
            a = flow(k, 0, u)
            b = flow(k, 1, u + 0.5 * h * a)
            c = flow(k, 1, u + 0.5 * h * b)
            d = flow(k, 2, u + h * c)
            carried[:, k + 1] = u + h * (a + 2 * b + 2 * c + d) / 6
        return self.start[:, None] + self.water[:, ::2] + carried


def dive_segments(dives: Sequence[Dive], origin: tuple[float, float]) -> Segments:
    """Return dives as segments, m and s since 1970, on the plane of an origin (degrees)."""
    share, fine = np.linspace(0.0, 1.0, SAMPLES), np.linspace(0.0, 1.0, 2 * SAMPLES - 1)
    time, water, start = [], [], []
    for dive in dives:
        since, *axes = reckoned(dive)
        time.append(dive.t_gps2 + share * dive.duration)
        way = [np.interp(fine * dive.duration, since, axis) for axis in axes]
        way[0][-1], way[1][-1] = dive.dr_east, dive.dr_north
        water.append(np.stack(way, axis=1))
        start.append(displacement(*origin, dive.lat_gps2, dive.lon_gps2))
    moved = np.array([[dive.gps_east, dive.gps_north] for dive in dives])
    return Segments(np.array(time), np.array(water), np.array(start), np.array(start) + moved)
