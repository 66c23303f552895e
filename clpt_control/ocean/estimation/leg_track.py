"""A leg under way: its prediction z and the integral m of phi, between two fixes.

    z' = theta_hat phi(z) + v,    m' = phi(z)        (`predict` of the law fix-regression)

v is the velocity through the water, constant along each stretch.  Stretches that are short against
the functions are joined.  A stretch is integrated by the method of Runge and Kutta of order 4.
Numbers are in units of the scenario.

m leaves out that an error of theta moves the track, and with it phi. If the flow turns along the
leg, the regression misses about half of that turn times the error of z (`LegTrack.turn`).
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from math import ceil, hypot
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from ...paper.blocks.flow import phi_and_slopes, turning_rate, unspanned
from ...paper.laws.fix_bound import LegRegressor
from ...paper.laws.memory_laws import predict
from ...paper.scenario.experiment import Scenario
from .fix_settings import FixSettings, LocalFrame, rotated

JOINED = (
    32  # stretches that are shorter than this part of a width or a period are joined
)
STEPS = 4  # of the integration, at least, while the vehicle crosses a width
STEPS_OF_PERIOD = 24
TOLD_TURN, LONG, MOST_TURN = 1.0, 3.0, 8.0  # rad along a leg
DIFFERENCE = 1e-3  # of a width, of the differences of phi
STRAIGHT = 1e-3  # rad, a turn that does not count

Stretch = tuple[float, float, float]  # time at its end, displacement along both axes


class Arrival(NamedTuple):
    """End of a leg: z (2,), m (N,), and time, place and length of each step, (n, 4).

    `path` is m at the begin of each step, (n, N).
    """

    z: np.ndarray
    m: np.ndarray
    points: np.ndarray
    path: np.ndarray


class Ahead(NamedTuple):
    """A forecast of a fix.

    Attributes
    ----------
    time, latitude, longitude : float
        s since 1970 UTC, degrees.
    radius : float
        Radius of the region that contains the fix with probability `LEVEL`, m.
    """

    time: float
    latitude: float
    longitude: float
    radius: float


class Turn(NamedTuple):
    """Angle by which the flow turns along a leg, rad: as learned, and with the error of theta."""

    learned: float
    likely: float


class Regression(NamedTuple):
    """Y = theta m + n over a leg: Y (2,), m (N,), duration, time of its middle, parts of r^2.

    `bend` and `turn` are two terms added. `path` is m along the leg, as predicted with `theta`.
    """

    Y: np.ndarray
    m: np.ndarray
    duration: float
    middle: float
    noise: np.ndarray
    bend: float
    turn: Turn
    theta: np.ndarray
    path: LegRegressor | None = None

    @property
    def added(self) -> float:
        """Share of the variance m^T P m that the turn adds."""
        return (min(self.turn.likely, MOST_TURN) / 2) ** 2


@dataclass
class Leg:
    """Way through the water since a fix.

    `time` is the end of the last stretch, and `known` the time that stretches cover; `waiting` is
    the last stretch, to which short ones are still joined.  `flow` is the learned flow to the east
    at the begin, `east` the reckoned way over ground.  `shown` is the mean flow on the leg before.
    """

    start: float
    place: list[float]
    time: float
    known: float = 0.0
    stretches: list[Stretch] = field(default_factory=list)
    waiting: Stretch | None = None
    flow: float = field(default=0.0, compare=False)
    east: float = 0.0
    shown: list[float] | None = field(default=None, compare=False)

    def move(
        self, frame: LocalFrame, stretches: np.ndarray, size: tuple[float, float]
    ) -> np.ndarray:
        """Add rows of time, east and north (s, m); return their speeds.

        East and north are those of the middle of each stretch, as the leg is reckoned.
        """
        ends = frame.own_time(stretches[:, 0])
        spans = np.diff(ends, prepend=self.time)
        moved = stretches[:, 1:] / frame.metres
        # one by one, so that rows at once are the same as rows one by one
        east = np.cumsum(np.append(self.east, moved[:, 0] + self.flow * spans))
        angle, growth = frame.axes(np.array(self.place))
        moved = rotated(moved, angle + growth * (east[1:] + east[:-1]) / 2)
        self.east = float(east[-1])
        self.known += float(np.sum(spans))
        for t, (x, y) in zip(ends.tolist(), moved.tolist(), strict=True):
            self.add(t, x, y, size)
        lasts = spans > 0
        return np.hypot(*moved[lasts].T) / spans[lasts]

    def turn(self, angle: float) -> None:
        """Turn all stretches anticlockwise by an angle, rad."""
        turned = [
            (t, *rotated(np.array(moved), angle).tolist()) for t, *moved in self.way
        ]
        self.stretches = turned[: len(self.stretches)]
        self.waiting = self.waiting and turned[-1]

    def add(self, t: float, x: float, y: float, size: tuple[float, float]) -> None:
        """Add a stretch; `size` is the least width and the least period of the functions."""
        begin = self.stretches[-1][0] if self.stretches else self.start
        if self.waiting is not None:
            x, y = self.waiting[1] + x, self.waiting[2] + y
        self.waiting, self.time = (t, x, y), t
        width, period = size
        if JOINED * hypot(x, y) >= width or JOINED * (t - begin) >= period:
            self.stretches.append(self.waiting)
            self.waiting = None

    @property
    def moved(self) -> np.ndarray:
        """Displacement through the water, (2,)."""
        return np.sum([stretch[1:] for stretch in self.way] or np.zeros((1, 2)), axis=0)

    @property
    def spans(self) -> Iterator[tuple[float, float, float, float]]:
        """Begin, duration and displacement of each stretch that lasts."""
        t = self.start
        for end, x, y in self.way:
            if end > t:
                yield t, end - t, x, y
            t = end

    @property
    def way(self) -> list[Stretch]:
        """All stretches."""
        return [*self.stretches, *([self.waiting] if self.waiting else [])]


class LegTrack:
    """Integration of legs over the basis functions of a scenario."""

    def __init__(self, scenario: Scenario, settings: FixSettings) -> None:
        self.scenario, self.settings = scenario, settings
        self.basis = scenario.basis_block("z")
        lengths = scenario.basis.lengths
        self.size = float(np.min(lengths)), float(np.min(scenario.periods))

    def phi(self, t: float, place: np.ndarray) -> np.ndarray:
        """Return phi of Eq. (5)."""
        output: Any = self.basis.output_function
        return output(t, np.zeros(0), place, self.basis.parameters)

    def end(
        self, leg: Leg, theta: np.ndarray, drift: np.ndarray | float = 0.0
    ) -> "Arrival":
        """Integrate a leg to its end.

        `drift` is a velocity in addition to flow and velocity through the water.
        """
        state = np.append(leg.place, np.zeros(theta.shape[1]))  # z and m
        x, u = SimpleNamespace(alpha=-theta), SimpleNamespace()

        def rates(time: float, state: np.ndarray) -> np.ndarray:
            u.phi_z = self.phi(time, state[:2])
            rate = predict(time, x, u, None)
            return np.append(rate["z"], rate["m"])

        points, path = [], []
        for t, span, east, north in leg.spans:
            u.v_x = np.array([east, north]) / span + drift
            flow = theta @ self.phi(t, state[:2])
            way = hypot(*u.v_x) * span + hypot(*flow) * span
            count = self.steps(way, span)
            step = span / count
            for k in range(count):
                points.append((t + k * step, *state[:2], step))
                path.append(state[2:])
                state = runge_kutta(rates, t + k * step, state, step)
        rows = np.array(points).reshape(-1, 4)
        return Arrival(state[:2], state[2:], rows, np.array(path))

    def slopes(
        self, times: np.ndarray, points: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return phi (n, N) and its slopes (n, N, 2) at n points."""
        step = DIFFERENCE * self.size[0]
        return phi_and_slopes(self.basis, times, points, step)

    def turn(self, arrival: "Arrival", theta: np.ndarray, P: Any) -> Turn:
        """Return the turns int |d(theta phi)/dx| dt along a leg, rad."""
        times, places, steps = np.split(arrival.points, [1, 3], axis=1)
        flow = np.linalg.norm(theta) + np.sqrt(np.trace(np.atleast_2d(P)))
        if flow * steps.sum() < STRAIGHT * self.size[0]:
            return Turn(0.0, 0.0)
        _, slopes = self.slopes(times[:, 0], places)
        rates = [turning_rate(slopes, theta, covariance) for covariance in (0.0, P)]
        return Turn(*(rates @ steps[:, 0]).tolist())

    def beside(self, arrival: Arrival, fixes: list) -> float:
        """Return the error of the way by the flow where functions die out, length."""
        places = arrival.points[:, 1:3]
        if not len(places):
            return 0.0
        basis, prior = self.scenario.basis, self.settings.beside
        _, v, _ = unspanned(basis, prior, places, np.reshape(fixes, (-1, 2)))
        return float(np.sum(arrival.points[:, 3]) * np.mean(v) ** 0.5)

    def bend(self, leg: Leg, fastest: float) -> float:
        """Return the error of a way that may have been bent, length: root of sum of squares."""
        width, _ = self.size
        total = 0.0
        for _, span, x, y in leg.spans:
            off = np.sqrt(max((fastest * span) ** 2 - x * x - y * y, 0.0)) / 2
            total += (span * min(off / width, 1.0)) ** 2
        return float(np.sqrt(total)) * self.settings.bent

    def steps(self, way: float, span: float) -> int:
        """Return the number of steps of integration in a stretch."""
        width, period = self.size
        return max(1, ceil(STEPS * way / width), ceil(STEPS_OF_PERIOD * span / period))


def runge_kutta(
    rates: Callable[[Any, np.ndarray], np.ndarray], t: Any, state: np.ndarray, step: Any
) -> np.ndarray:
    """Return a state after one step."""
    k1 = rates(t, state)
    k2 = rates(t + step / 2, state + step / 2 * k1)
    k3 = rates(t + step / 2, state + step / 2 * k2)
    k4 = rates(t + step, state + step * k3)
    return state + step * ((k1 + 2 * k2 + 2 * k3 + k4) / 6)


def long_interval(turn: float) -> list[str]:
    """Return a note on a flow that turns far between fixes, rad."""
    if turn <= TOLD_TURN:
        return []
    note = f"the interval is long for this flow: it turns by {turn:.1f} radians between fixes"
    if turn > LONG:
        note += ", so the estimate may be far off. Take fixes more often"
    return [f"{note}; recorded legs: --method tomography"]
