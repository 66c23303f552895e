"""Checks of a block's equations, and the random arguments of all checks.

Equations must repeat, be finite and be read as Python runs them, and the units that are declared
must fit together.  These are checked in other units: with a metre half as long every length is
twice as large a number, every speed too, and an acceleration per second squared stays.  Equations
whose units fit give, of numbers so changed, results so changed: for an output y of unit m^a s^b, in
a unit of length 1/c times as long,

    y(c^.. u, c^.. p) = c^a y(u, p)

A number with a unit that stands inside the equations, two units added, or a unit declared
wrongly breaks it.  m and km are two units here: nobody but a reader knows what 1000 stands for.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..equations.block import Block
from ..equations.declaration import powers
from ..errors import ClptError
from .all_readings import readings

FACTOR = 1.7  # by which a unit is made smaller
TOLERANCE = 1e-9  # of the largest value; rounding is far below


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
    return ["output", *(role for role in ("update", "jump") if role in block._roles)]


def python_values(block: Block, role: str, sample: Sample) -> np.ndarray:
    """Return what Python computes for one sample, whose arguments are copied."""
    size = block.noutputs if role == "output" else block.nstates
    arrays = {f: v.copy() for f, v in sample.p._asdict().items() if isinstance(v, np.ndarray)}
    p = sample.p._replace(**arrays)
    return block.values(role, size, sample.t, sample.x.copy(), sample.u.copy(), p)


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
    x, u = np.zeros(block.nstates), np.zeros(block.ninputs)
    zero = Sample(0.0, x, u, block.parameters_at(0.0, block.parameters))
    for role in (role for role in roles(block) if role != "jump"):
        if not np.all(np.isfinite(python_values(block, role, zero))):
            yield (
                f"{block.name}.{role} is not finite at zero states and inputs, with which "
                "python-control starts; keep arguments in range with np.where, np.clip or "
                "np.maximum"
            )


def _readings(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Every reading computes what Python computes."""
    none = np.zeros(0)
    for name, reading in readings(block).items():
        for sample in drawn:
            point, has = (sample.t, sample.x, sample.u), roles(block)
            asked = [role for role in ("update", "output") if role in has]
            ours: dict[str, Any] = {role: python_values(block, role, sample) for role in asked}
            try:
                theirs: dict[str, Any] = dict(
                    zip(("update", "output"), reading(*point), strict=True)
                )
                if "jump" in has and name != "control":
                    ours["jump"] = python_values(block, "jump", sample)
                    theirs["jump"] = reading.jump(*point)
            except ClptError as error:
                yield f"{block.name}: the reading '{name}' refuses: {error}"
                break
            off = [role for role in theirs if differ(ours.get(role, none), theirs[role])]
            if off:
                yield (
                    f"{block.name}.{off[0]}: Python gives {ours.get(off[0], none)}, the reading "
                    f"'{name}' {theirs[off[0]]} at {sample}"
                )
                break


# --- other units ------------------------------------------------------------------------------


def unit_check(units: Mapping[str, str]) -> Callable[[Block, list[Sample]], Iterator[str]]:
    """Return the check of a block whose ports, parameters and time t have these units."""

    def check(block: Block, drawn: list[Sample]) -> Iterator[str]:
        """Equations hold in other units alike."""
        yield from _failures(block, drawn, {"t": "s", **units})

    return check


def _failures(block: Block, drawn: list[Sample], units: Mapping[str, str]) -> Iterator[str]:
    ports = {**block.input_ports, **block.state_ports, **block.output_ports}
    numbers = block.parameters._asdict()
    scaled = [n for n in numbers if n != "interval" and not isinstance(numbers[n], int)]
    unknown = set(units) - {"t", *ports, *scaled}
    missing = {*ports, *scaled} - set(units)
    if unknown:
        yield f"{block.name}: units: no port or parameter is called '{min(unknown)}'"
    if missing:
        yield (
            f"{block.name}: units: '{min(missing)}' has none; give one to each port and each "
            "parameter that is no whole number, '1' where there is none"
        )
    if unknown or missing:
        return
    each = {name: powers(unit) for name, unit in units.items()}
    for symbol in sorted({symbol for one in each.values() for symbol in one}):
        by = {name: FACTOR ** one.get(symbol, 0) for name, one in each.items()}
        for role in roles(block):
            out = block.output_ports if role == "output" else block.state_ports
            rate = by["t"] if role == "update" else 1.0
            names = [port for port, count in out.items() for _ in range(count)]
            for sample in drawn:
                other = Sample(
                    sample.t * by["t"],
                    sample.x * _along(block.state_ports, by),
                    sample.u * _along(block.input_ports, by),
                    sample.p._replace(**{n: getattr(sample.p, n) * by[n] for n in scaled}),
                )
                wanted = python_values(block, role, sample) * _along(out, by) / rate
                actual = python_values(block, role, other)
                off = np.abs(actual - wanted) > TOLERANCE * np.max(np.abs(wanted), initial=0.0)
                if off.any():
                    port = names[int(np.argmax(off))]
                    yield (
                        f"{block.name}.{role}: {port} is not of the unit '{units[port]}' that is "
                        f"declared: in a smaller {symbol} it becomes {actual[off][0]:.6g}, not "
                        f"{wanted[off][0]:.6g}; "
                        "a number in the equations has a unit, or one is declared wrongly"
                    )
                    break


def _along(ports: Mapping[str, int], by: Mapping[str, float]) -> np.ndarray:
    """Return the factor of each signal."""
    return np.array([by[port] for port, count in ports.items() for _ in range(count)])
