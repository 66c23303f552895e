"""A diagram with sampled blocks, linearized: the discrete system of the whole loop.

    x(t + T) = expm(A T) x(t) + ...    between samples, with held inputs of the sampled blocks
    x_d(k + 1) = F x_d(k) + G h(k)     the update of a sampled block at each of its samples
    h(k) = S x(k) + ...                what it samples then and holds until the next

The states are those of the continuous blocks and of the sampled ones.  What is held follows from
them at a sample, so it is none.  Blocks of several periods sample together at each common multiple,
which is the period of the system; the diagram's inputs are held for that time.

Source: Kalman, R. E., Bertram, J. E. (1959), A unified approach to the theory of sampling systems,
J. Franklin Institute 267(5).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from scipy.linalg import expm

from ...errors import DiagramError
from ..model.sampled import Sampled
from .wiring import Wiring

SAME = 1e-9  # relative: ratios of periods that differ by less are equal
MOST_SAMPLES = 10_000  # within the common period


@dataclass
class SampledBlock:
    """The places of a sampled block's states among all states of the diagram."""

    name: str
    period: float
    updated: np.ndarray  # its own states
    held: np.ndarray  # the inputs that it holds


def sampled_blocks(wiring: Wiring) -> list[SampledBlock]:
    """Return the sampled blocks of a diagram."""
    found = []
    for node in wiring.nodes:
        if isinstance(node.system, Sampled):
            places = np.arange(node.states.start, node.states.stop)
            own = node.system.inner.nstates
            found.append(SampledBlock(node.name, node.system.period, places[:own], places[own:]))
    return found


def common_period(blocks: Sequence[SampledBlock]) -> float:
    """Return the least common multiple of the periods; refuse periods without a small one."""
    first = blocks[0].period
    ratios = [Fraction(one.period / first).limit_denominator(1000) for one in blocks]
    period = first * lcm(*(r.numerator for r in ratios)) / gcd(*(r.denominator for r in ratios))
    apart = [abs(one.period / first / ratio - 1) for one, ratio in zip(blocks, ratios, strict=True)]
    if max(apart) > SAME or sum(period / one.period for one in blocks) > MOST_SAMPLES:
        periods = ", ".join(f"{one.name} {one.period:g}" for one in blocks)
        raise DiagramError(
            f"the sampled blocks have no small common period ({periods}); give them periods of a "
            "simple ratio"
        )
    return period


@dataclass
class SampledSlopes:
    """Slopes of a diagram in all states and inputs, a column for each."""

    rates: np.ndarray  # (n, n + m); 0 for the states of sampled blocks
    signals: np.ndarray  # (q, n + m)
    jumps: np.ndarray  # (n, n + m): updates of sampled states, and what is sampled


def discrete_system(
    slopes: SampledSlopes, blocks: Sequence[SampledBlock], period: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return A, B, C, D over the common period, and the places of the states that remain."""
    n, both = slopes.rates.shape
    held = np.concatenate([one.held for one in blocks])
    remaining = np.setdiff1d(np.arange(n), held)
    inputs = np.arange(n, both)

    def sampled(due: Sequence[SampledBlock]) -> np.ndarray:
        """Return the map of states and inputs by which blocks sample, one behind the other."""
        places = np.concatenate([one.held for one in due]).astype(int)
        inner = np.eye(len(places)) - slopes.jumps[np.ix_(places, places)]
        others = np.setdiff1d(np.arange(both), places)
        result = np.eye(both)
        result[places] = 0.0
        result[np.ix_(places, others)] = np.linalg.solve(inner, slopes.jumps[places][:, others])
        return result

    def updated(due: Sequence[SampledBlock]) -> np.ndarray:
        """Return the map by which blocks update their states, all at once."""
        places = np.concatenate([one.updated for one in due]).astype(int)
        result = np.eye(both)
        result[places] = slopes.jumps[places]
        return result

    whole = np.zeros((both, both))
    whole[:n] = slopes.rates
    counts = [round(period / one.period) for one in blocks]
    fractions = [{Fraction(k, count) for k in range(1, count + 1)} for count in counts]
    now, first = Fraction(0), sampled(blocks)
    total = first
    for share in sorted(set().union(*fractions)):
        due = [one for one, own in zip(blocks, fractions, strict=True) if share in own]
        total = updated(due) @ expm(whole * (period * float(share - now))) @ total
        if share < 1:
            total = sampled(due) @ total
        now = share
    columns = np.concatenate([remaining, inputs])
    step, outputs = total[np.ix_(remaining, columns)], (slopes.signals @ first)[:, columns]
    k = len(remaining)
    return step[:, :k], step[:, k:], outputs[:, :k], outputs[:, k:], remaining
