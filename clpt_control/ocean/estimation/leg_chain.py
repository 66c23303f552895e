"""Chain of the places of a vehicle, linked by pieces of its legs.

The places are those at fixes, and at nodes within a leg where a track is predicted piece by piece:

    x_{k+1} = z(x_k, theta) + n,    z' = theta phi(z) + v

All pieces are integrated at once, with the derivatives of z by theta and by x_k.  Numbers are in
units of the scenario.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, hypot
from typing import NamedTuple

import numpy as np

from ...engine.model.block import evaluate
from .fix_settings import FixSettings
from .leg_track import Leg, LegTrack, runge_kutta

NODES = 2.0  # pieces of a leg for each width that the vehicle crosses
NODES_OF_PERIOD = 4.0
CURRENT = 0.5  # m/s, that crosses widths too
LEAST_PROCESS = 1e-3  # of the noise of a fix: noise of a track that is exact


class FlownLeg(NamedTuple):
    """A leg, the fix at its end, and the error of a way that may have been bent, length."""

    leg: Leg
    end: np.ndarray
    bend: float


class Shot(NamedTuple):
    """Ends z of pieces (m, 2), dz/dtheta (m, 2, 2N) and dz/dx (m, 2, 2)."""

    z: np.ndarray
    by_theta: np.ndarray
    by_place: np.ndarray


@dataclass
class LegChain:
    """Nodes and pieces of legs.

    Attributes
    ----------
    places : ndarray, shape (n, 2)
        First guess of the places: on the ways through the water, drawn evenly to the fixes.
    fixes : ndarray, shape (n, 2)
        The fixes; NaN at other nodes.
    links : ndarray, shape (m,)
        Node at the beginning of each piece, which ends at the next one.
    noise, deviation : ndarray, shape (m,)
        Standard deviations on each axis, length: of the track of each piece, and of the position
        error of its whole leg.
    steps : ndarray, shape (K, m, 4)
        Time, length, and velocity through the water of each step of integration.
    """

    track: LegTrack
    places: np.ndarray
    fixes: np.ndarray
    links: np.ndarray
    noise: np.ndarray
    deviation: np.ndarray
    steps: np.ndarray

    def shoot(self, places: np.ndarray, theta: np.ndarray, slopes: bool = True) -> Shot:
        """Integrate all pieces from their places by Runge and Kutta's method.

        Without `slopes` the derivatives are those of still water.
        """
        n, N = len(places), theta.shape[1]
        # z, dz/dtheta and dz/dx
        state = np.zeros((n, 2, 2 * N + 3))
        state[:, :, 0] = places
        state[:, 0, 2 * N + 1] = state[:, 1, 2 * N + 2] = 1

        def rates(t: np.ndarray, state: np.ndarray) -> np.ndarray:
            rate, z, times = np.zeros_like(state), state[:, :, 0], t[:, 0, 0]
            if not slopes:
                phi = evaluate(self.track.basis, times, z)
            else:
                phi, by_place = self.track.slopes(times, z)
                flow_by_place = np.einsum("ak,nkb->nab", theta, by_place)
                rate[:, :, 1:] = flow_by_place @ state[:, :, 1:]
                rate[:, 0, 1 : N + 1] += phi
                rate[:, 1, N + 1 : 2 * N + 1] += phi
            rate[:, :, 0] = phi @ theta.T + v
            return rate

        for row in self.steps:
            t, h, v = row[:, :1, None], row[:, 1:2, None], row[:, 2:]
            state = runge_kutta(rates, t, state, h)
        z, by_theta, by_place = np.split(state, [1, 2 * N + 1], axis=2)
        return Shot(z[:, :, 0], by_theta, by_place)


def chain_of(
    legs: Sequence[FlownLeg], settings: FixSettings, track: LegTrack, nodes: bool
) -> LegChain:
    """Return the chain of legs, with nodes within a leg or without."""
    width, period = track.size
    places: list[np.ndarray] = []
    fixes: list[np.ndarray] = []
    pieces: list[np.ndarray] = []
    of_pieces = []  # links, noise, deviation
    unknown = np.full(2, np.nan)
    last: np.ndarray | None = None
    for leg, end, bend in legs:
        start = np.array(leg.place)
        if last is None or not np.array_equal(last, start):
            places.append(start)
            fixes.append(start)
        steps = _steps_of(leg, settings, track)
        T = leg.time - leg.start
        cuts, moves = np.array([0, len(steps)]), steps[:, 1:2] * steps[:, 2:]
        if nodes:
            way = np.abs(moves).sum(axis=0)
            crossed = (hypot(*way) + CURRENT / settings.speed * T) / width
            count = max(1, ceil(NODES * crossed), ceil(NODES_OF_PERIOD * T / period))
            cuts = np.linspace(0, len(steps), min(count, len(steps)) + 1).round()
        moved = np.cumsum(moves, axis=0)
        variance = float(settings.noise_of(T).sum())
        of_track = max(
            variance - 2 * settings.fix**2, (LEAST_PROCESS * settings.fix) ** 2
        )
        for begin, stop in pairwise(cuts.astype(int)):
            piece = steps[begin:stop]
            pieces.append(piece)
            noise = ((of_track + bend**2) * piece[:, 1].sum() / T) ** 0.5
            of_pieces.append((len(places) - 1, noise, hypot(variance**0.5, bend)))
            gone = steps[:stop, 1].sum() / T
            drawn = gone * (end - start - moved[-1])
            places.append(start + moved[stop - 1] + drawn)
            fixes.append(end if stop == len(steps) else unknown)
        last = end
    table = np.zeros((max(map(len, pieces)), len(pieces), 4))
    for number, piece in enumerate(pieces):
        table[: len(piece), number] = piece
        table[len(piece) :, number, 0] = piece[-1, 0] + piece[-1, 1]
    links, noises, deviations = np.transpose(of_pieces)
    nodes_of = np.array(places), np.array(fixes), links.astype(int)
    return LegChain(track, *nodes_of, noises, deviations, table)


def _steps_of(leg: Leg, settings: FixSettings, track: LegTrack) -> np.ndarray:
    """Return the steps of integration of a leg: time, length, velocity, (K, 4)."""
    steps = []
    for t, span, x, y in leg.spans:
        way = hypot(x, y) + CURRENT / settings.speed * span
        count = track.steps(way, span)
        length = span / count
        steps += [(t + k * length, length, x / span, y / span) for k in range(count)]
    return np.array(steps)
