"""Linearization of a diagram with sampled blocks: the discrete system of the whole loop.

    x(t + T) = expm(A T) x(t) + ...    between samples, with held inputs of the sampled blocks
    x_d(k + 1) = F x_d(k) + G h(k)     the update of a sampled block at each of its samples
    h(k) = S x(k) + ...                its sampled inputs, held until the next sample

The states of the result are those of the continuous blocks and of the sampled blocks, without the
held inputs, which follow from the other states at a sample.  The period of the result is the common
multiple of all periods.  The diagram's inputs are held for this period.

Source: Kalman, R. E., Bertram, J. E. (1959), A unified approach to the theory of sampling systems,
J. Franklin Institute 267(5).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from scipy.linalg import expm

from ...base.errors import DiagramError
from ..model.sampled import Sampled
from .wiring import Wiring

ROUNDING = 1e-9  # relative: ratios of periods that differ by less are equal
MOST_SAMPLES = 10_000  # within the common period


@dataclass
class SampledBlock:
    """Indices of a sampled block's states among all states of the diagram."""

    name: str
    period: float
    updated: np.ndarray  # states that the block updates
    hold: np.ndarray  # states that are its inputs, held since the last sample


def sampled_blocks(wiring: Wiring) -> list[SampledBlock]:
    """Return the sampled blocks of a diagram."""
    blocks = []
    for node in wiring.nodes:
        if isinstance(node.system, Sampled):
            sampled = node.system
            states = np.arange(node.states.start, node.states.stop)
            updated, hold = np.split(states, [sampled.inner.nstates])
            blocks.append(SampledBlock(node.name, sampled.period, updated, hold))
    return blocks


def common_period(blocks: Sequence[SampledBlock]) -> float:
    """Return the least common multiple of the periods; refuse periods without a small one."""
    base = blocks[0].period
    ratios = [Fraction(block.period / base).limit_denominator(1000) for block in blocks]
    numerator = lcm(*(ratio.numerator for ratio in ratios))
    period = base * numerator / gcd(*(ratio.denominator for ratio in ratios))
    pairs = zip(blocks, ratios, strict=True)
    errors = [abs(block.period / base / ratio - 1) for block, ratio in pairs]
    samples = sum(period / block.period for block in blocks)
    if max(errors) > ROUNDING or samples > MOST_SAMPLES:
        periods = ", ".join(f"{block.name} {block.period:g}" for block in blocks)
        raise DiagramError(
            f"the sampled blocks have no small common period ({periods}). Give them periods of a "
            "simple ratio"
        )
    return period


@dataclass
class SampledSlopes:
    """Slopes of a diagram in all states and inputs, a column for each."""

    rates: np.ndarray  # (n, n + m); 0 for the states of sampled blocks
    signals: np.ndarray  # (q, n + m)
    jumps: np.ndarray  # (n, n + m): updates of sampled states, and sampled inputs

    def sampled(self, blocks: Sequence[SampledBlock]) -> np.ndarray:
        """Return the map of states and inputs by which blocks sample, one after the other."""
        hold = np.concatenate([block.hold for block in blocks]).astype(int)
        size = self.jumps.shape[1]
        free = np.setdiff1d(np.arange(size), hold)
        # x[hold] = jumps[hold, hold] x[hold] + jumps[hold, free] x[free]
        implicit = np.eye(len(hold)) - self.jumps[np.ix_(hold, hold)]
        explicit = self.jumps[np.ix_(hold, free)]
        result = np.eye(size)
        result[hold] = 0.0
        result[np.ix_(hold, free)] = np.linalg.solve(implicit, explicit)
        return result

    def updated(self, blocks: Sequence[SampledBlock]) -> np.ndarray:
        """Return the map by which blocks update their states, all at once."""
        states = np.concatenate([block.updated for block in blocks]).astype(int)
        result = np.eye(self.jumps.shape[1])
        result[states] = self.jumps[states]
        return result


def discrete_system(
    slopes: SampledSlopes, blocks: Sequence[SampledBlock], period: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return A, B, C, D over the common period, and the indices of the remaining states."""
    nstates, size = slopes.rates.shape
    rates = np.zeros((size, size))
    rates[:nstates] = slopes.rates
    counts = [round(period / block.period) for block in blocks]
    sample_times = [
        {Fraction(k, count) for k in range(1, count + 1)} for count in counts
    ]

    # the map of states and inputs over the period, from sample to sample; times in periods
    time = Fraction(0)
    first_sample = slopes.sampled(blocks)
    total = first_sample
    for sample_time in sorted(set().union(*sample_times)):
        pairs = zip(blocks, sample_times, strict=True)
        due = [block for block, times in pairs if sample_time in times]
        flow = expm(rates * (period * float(sample_time - time)))
        total = slopes.updated(due) @ flow @ total
        if sample_time < 1:
            total = slopes.sampled(due) @ total
        time = sample_time

    hold = np.concatenate([block.hold for block in blocks])
    remaining = np.setdiff1d(np.arange(nstates), hold)
    inputs = np.arange(nstates, size)
    columns = np.concatenate([remaining, inputs])
    n = len(remaining)
    A, B = np.split(total[np.ix_(remaining, columns)], [n], axis=1)
    signals = slopes.signals @ first_sample
    C, D = np.split(signals[:, columns], [n], axis=1)
    return A, B, C, D, remaining
