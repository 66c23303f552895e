"""Random inputs for a block, and what Python makes of them.

`conformance` asks every question with these: times up to 100, normal states
and inputs, the block's own parameters.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..block import Block
from ..ports import Equations
from ..running import running


class Sample(NamedTuple):
    """Arguments of a block's equations."""

    t: float  # time
    x: np.ndarray  # states and inputs
    u: np.ndarray  # states and inputs
    p: Any  # the block's parameters, `interval` filled in


def draw(block: Block, seed: int, count: int) -> list[Sample]:
    """Draw random arguments for a block.

    Parameters
    ----------
    block : Block
        Gives the sizes and the parameters.
    seed : int
        Seed of the random numbers.
    count : int
        How many to draw.

    Returns
    -------
    list of Sample
        The first half near zero, the rest within a few units.

    Examples
    --------
    >>> from clpt_control.blocks.clpe import clpe
    >>> [sample.u.shape for sample in draw(clpe(), seed=0, count=2)]
    [(4,), (4,)]
    """
    rng = np.random.default_rng(seed)
    samples = []
    for k in range(count):
        size = 0.3 if k < count // 2 else 2.0
        t = float(rng.uniform(0.0, 100.0))
        x = size * rng.standard_normal(block.nstates or 0)
        u = size * rng.standard_normal(block.ninputs or 0)
        samples.append(Sample(t, x, u, block.parameters_at(t, block.parameters)))
    return samples


def equations(block: Block) -> Iterator[tuple[str, Equations, int]]:
    """Return a block's equations, one by one."""
    if block.update_function is not None:
        yield f"{block.name}.update", block.update_function, block.nstates
    yield f"{block.name}.output", block.output_function, block.noutputs


def python_values(function: Equations, sample: Sample, size: int) -> np.ndarray:
    """Return what Python makes of one sample."""
    out = np.zeros(size)
    with np.errstate(all="ignore"):
        running(function)(
            np.float64(sample.t), sample.x.copy(), sample.u.copy(), own_copy(sample.p), out
        )
    return out


def own_copy(p: Any) -> Any:
    """Return the same parameters with arrays of their own."""
    return type(p)(*(value.copy() if isinstance(value, np.ndarray) else value for value in p))


def differ(a: np.ndarray, b: np.ndarray, tolerance: float = 1e-12) -> bool:
    """Return whether two results differ by more than rounding."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    if a.shape != b.shape or not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return True
    finite = np.isfinite(a)
    size = max(1.0, float(np.max(np.abs(a[finite]), initial=0.0)))
    return bool(np.any(np.abs(a[finite] - b[finite]) > tolerance * size))
