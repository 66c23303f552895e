"""Checks of a block's equations, and the random arguments of all checks."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..equations.block import Block
from ..errors import ClptError
from .all_readings import readings


class Sample(NamedTuple):
    """Arguments of a block's equations."""

    t: float
    x: np.ndarray
    u: np.ndarray
    p: Any  # the block's parameters, `interval` filled in


def random_samples(block: Block, seed: int, count: int) -> list[Sample]:
    """Return random arguments: t up to 100, x and u near zero, then within a few units."""
    rng = np.random.default_rng(seed)
    samples = []
    for k in range(count):
        size = 0.3 if k < count // 2 else 2.0
        t = float(rng.uniform(0.0, 100.0))
        x = size * rng.standard_normal(block.nstates or 0)
        u = size * rng.standard_normal(block.ninputs or 0)
        samples.append(Sample(t, x, u, block.parameters_at(t, block.parameters)))
    return samples


def roles(block: Block) -> list[str]:
    """Return the roles of a block's equations."""
    own = {"update": block.update_function, "jump": block.jump_function}
    return ["output", *(role for role, function in own.items() if function is not None)]


def python_values(block: Block, role: str, sample: Sample) -> np.ndarray:
    """Return what Python computes for one sample, whose arguments are copied."""
    if role == "output" and block.states_are_outputs:
        return sample.x.copy()
    given = sample.t, sample.x.copy(), sample.u.copy(), own_copy(sample.p)
    return block.values(role, block.noutputs if role == "output" else block.nstates, *given)


def control_values(system: Any, role: str, sample: Sample) -> np.ndarray:
    """Return what python-control gives when it calls a block or a diagram."""
    call = system.output if role == "output" else system.dynamics
    return call(sample.t, sample.x, sample.u)


def own_copy(p: Any) -> Any:
    """Return the same parameters with arrays of their own."""
    return p._replace(**{f: v.copy() for f, v in p._asdict().items() if isinstance(v, np.ndarray)})


def differ(a: np.ndarray, b: np.ndarray, tolerance: float = 1e-12) -> bool:
    """Return whether two results differ by more than rounding, NaN in the same places aside."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    if a.shape != b.shape or not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return True
    finite = np.isfinite(a)
    size = max(1.0, float(np.max(np.abs(a[finite]), initial=0.0)))
    return bool(np.any(np.abs(a[finite] - b[finite]) > tolerance * size))


def _in_range(block: Block, sample: Sample) -> bool:
    return all(np.all(np.isfinite(python_values(block, r, sample))) for r in roles(block))


def _repeats(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations give the same when called again, and are finite for most random inputs."""
    for role in roles(block):
        finite = 0
        for sample in drawn:
            first, again = (python_values(block, role, sample) for _ in range(2))
            finite += bool(np.all(np.isfinite(first)))
            if not np.array_equal(first, again, equal_nan=True):
                yield (
                    f"{block.name}.{role} gives another value when called again: it must keep no "
                    "memory"
                )
        if finite < len(drawn) // 4:
            yield (f"{block.name}.{role} is finite for {finite} of {len(drawn)} random inputs only")


def _zero(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations are finite where states and inputs are zero."""
    x, u = np.zeros(block.nstates or 0), np.zeros(block.ninputs or 0)
    zero = Sample(0.0, x, u, block.parameters_at(0.0, block.parameters))
    for role in roles(block):
        if role == "jump":  # which python-control does not call
            continue
        if not np.all(np.isfinite(python_values(block, role, zero))):
            yield (
                f"{block.name}.{role} is not finite at zero states and inputs, with which "
                "python-control starts; keep arguments in range with np.where, np.clip or "
                "np.maximum"
            )


def _readings(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Every reading computes what Python computes."""
    for name, reading in readings(block).items():
        for sample in drawn:
            point = sample.t, sample.x, sample.u
            ours = python_values(block, "output", sample)
            rates = np.zeros(0)
            if block.update_function is not None:
                rates = python_values(block, "update", sample)
            try:
                theirs = reading(*point)
            except ClptError as error:
                yield f"{block.name}: the reading '{name}' refuses: {error}"
                break
            if block.jump_function is not None and name != "control":
                after = python_values(block, "jump", sample)
                if differ(after, read := reading.jump(*point)):
                    yield (
                        f"{block.name}: Python jumps to {after}, the reading '{name}' to {read} "
                        f"at {sample}"
                    )
                    break
            if differ(rates, theirs[0]) or differ(ours, theirs[1]):
                yield (
                    f"{block.name}: Python gives {rates} and {ours}, the reading '{name}' "
                    f"{theirs[0]} and {theirs[1]} at {sample}"
                )
                break
