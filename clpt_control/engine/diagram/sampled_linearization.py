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

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from scipy.linalg import expm

from ...base.errors import DiagramError
from .wiring import Node

ROUNDING = 1e-9  # relative: ratios of periods that differ by less are equal
MOST_SAMPLES = 10_000  # within the common period


def states_of(blocks: Iterable[Node], are_held: bool) -> np.ndarray:
    """Return the states that are held inputs of sampled blocks, or the states that they update."""
    states = [np.zeros(0, int)]
    for node in blocks:
        own_states = np.arange(node.states.start, node.states.stop)
        states.append(np.split(own_states, [node.system.inner.nstates])[are_held])
    return np.concatenate(states)


def common_period(blocks: Sequence[Node]) -> float:
    """Return the least common multiple of the periods; refuse periods without a small one."""
    named = {node.name: node.system.period for node in blocks}
    periods = [*named.values()]
    base = periods[0]
    ratios = [Fraction(period / base).limit_denominator(1000) for period in periods]
    numerator = lcm(*(ratio.numerator for ratio in ratios))
    common = base * numerator / gcd(*(ratio.denominator for ratio in ratios))
    pairs = zip(periods, ratios, strict=True)
    errors = [abs(period / base / ratio - 1) for period, ratio in pairs]
    samples = sum(common / period for period in periods)
    if max(errors) > ROUNDING or samples > MOST_SAMPLES:
        texts = ", ".join(f"{name} {period:g}" for name, period in named.items())
        raise DiagramError(
            f"the sampled blocks have no small common period ({texts}). Give them periods of a "
            "simple ratio"
        )
    return common


def _sampled(jumps: np.ndarray, blocks: Sequence[Node]) -> np.ndarray:
    """Return the map of states and inputs by which blocks sample, one after the other."""
    hold = states_of(blocks, are_held=True)
    size = jumps.shape[1]
    free = np.setdiff1d(np.arange(size), hold)
    # x[hold] = jumps[hold, hold] x[hold] + jumps[hold, free] x[free]
    implicit = np.eye(len(hold)) - jumps[np.ix_(hold, hold)]
    explicit = jumps[np.ix_(hold, free)]
    result = np.eye(size)
    result[hold] = 0.0
    result[np.ix_(hold, free)] = np.linalg.solve(implicit, explicit)
    return result


def _updated(jumps: np.ndarray, blocks: Sequence[Node]) -> np.ndarray:
    """Return the map by which blocks update their states, all at once."""
    states = states_of(blocks, are_held=False)
    result = np.eye(jumps.shape[1])
    result[states] = jumps[states]
    return result


def discrete_system(
    slopes: np.ndarray,
    signals: np.ndarray,
    jumps: np.ndarray,
    blocks: Sequence[Node],
    period: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return A, B, C, D over the common period, and the indices of the remaining states.

    Rates, signals and jumps, which are the updates of sampled states and the sampled inputs, are
    given by their slopes in all states and inputs, a column for each.  Sampled states have no rate.
    """
    nstates, size = slopes.shape
    rates = np.zeros((size, size))
    rates[:nstates] = slopes
    counts = [round(period / node.system.period) for node in blocks]
    sample_times = [
        {Fraction(k, count) for k in range(1, count + 1)} for count in counts
    ]

    # the map of states and inputs over the period, from sample to sample; times in periods
    time = Fraction(0)
    first_sample = _sampled(jumps, blocks)
    total = first_sample
    for sample_time in sorted(set().union(*sample_times)):
        pairs = zip(blocks, sample_times, strict=True)
        due = [block for block, times in pairs if sample_time in times]
        flow = expm(rates * (period * float(sample_time - time)))
        total = _updated(jumps, due) @ flow @ total
        if sample_time < 1:
            total = _sampled(jumps, due) @ total
        time = sample_time

    remaining = np.setdiff1d(np.arange(nstates), states_of(blocks, are_held=True))
    inputs = np.arange(nstates, size)
    columns = np.concatenate([remaining, inputs])
    n = len(remaining)
    A, B = np.split(total[np.ix_(remaining, columns)], [n], axis=1)
    C, D = np.split((signals @ first_sample)[:, columns], [n], axis=1)
    return A, B, C, D, remaining
