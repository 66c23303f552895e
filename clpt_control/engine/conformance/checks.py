"""Does a block do what every block must?  `clpt.conformance.conformance(my_block)` checks.

A block that passes can be wired, compiled, proved with, pickled, linearized and integrated like
the paper's own.  Each check is a generator that takes random arguments and gives one plain
sentence for each failure.  Equations must repeat, be finite and be read as Python runs them, and
the units that are declared must fit together.

Units are checked in other units: with a metre half as long every length is twice as large a number,
every speed too, and an acceleration per second squared stays.  Equations whose units fit give, of
numbers so changed, results so changed: for an output y of unit m^a s^b, in a unit of length 1/c
times as long,

    y(c^.. u, c^.. p) = c^a y(u, p)

A number with a unit that stands inside the equations, two units added, or a unit declared
wrongly breaks it.  m and km are two units here: nobody but a reader knows what 1000 stands for.
"""

import pickle
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from ...arguments import Seed, public
from ...errors import BlockError, ClptError, DiagramError
from ..diagram.linearization import linearize
from ..model.block import Block
from ..model.declaration import powers
from ..model.sampled import Sampled
from .all_backends import readings

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
        asked = [role for role in roles(block) if role != "jump" or name != "control"]
        for sample in drawn:
            point = sample.t, sample.x, sample.u
            ours = {role: python_values(block, role, sample) for role in asked}
            try:
                theirs = dict(zip(("update", "output"), reading(*point), strict=True))
                if "jump" in asked:
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


# --- as a part of diagrams ---------------------------------------------------------------------


LINEAR = 1e-4


def _pickles(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Pickling gives the same block back."""
    try:
        twin = pickle.loads(pickle.dumps(block))
    except Exception as error:
        yield (
            f"{block.name}: cannot be pickled ({error}); define functions and parameters at the "
            "top of a module"
        )
        return
    for sample in drawn[:3]:
        for role in roles(block):
            ours, theirs = (python_values(one, role, sample) for one in (block, twin))
            if not np.array_equal(ours, theirs, equal_nan=True):
                yield f"{block.name}: pickling gives other values"


def _linearizes(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """python-control's `linearize`, which sees no samples, agrees with the exact one."""
    for sample in () if block.opaque or isinstance(block, Sampled) else drawn[:3]:
        at = sample.x, sample.u, sample.t
        found = block.linearize(*at[:2], t=sample.t)
        try:
            exact = linearize(block, *at)
        except DiagramError:  # it jumps there, or has nothing to linearize along
            return
        for name in "ABCD":
            ours, theirs = getattr(found, name), getattr(exact, name)
            if differ(ours, theirs, LINEAR):
                yield f"{block.name}: linearize gives {name} = {ours}, exactly it is {theirs}"
                return


def _jumps(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Breakpoints are sorted, in (t0, t1], and number the intervals."""
    if block.breakpoints_function is None:
        return
    end = 1.0
    while len(block.breakpoints(0.0, end)) < 8 and end < 1e9:
        end *= 2.0
    times = block.breakpoints(0.0, end)
    if np.any(np.diff(times) <= 0) or np.any(times <= 0) or np.any(times > end):
        yield f"{block.name}: breakpoints are not increasing times in (t0, t1]"
        return
    for middle in (0.37 * end, *times[:3]):
        parts = [block.breakpoints(0.0, middle), block.breakpoints(middle, end)]
        if not np.array_equal(np.concatenate(parts), times):
            yield f"{block.name}: breakpoints over two spans differ from those over both"
            return
    for k, time in enumerate(times):
        at = [block.interval_at(t) for t in (np.nextafter(time, 0.0), time)]
        if at != [k, k + 1]:
            yield f"{block.name}: breakpoint {k + 1} does not end interval {k}"
            return


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


# --- the report --------------------------------------------------------------------------------


Check = Callable[[Block, list[Sample]], Iterator[str]]
CHECKS: tuple[Check, ...] = (_repeats, _zero, _readings, _pickles, _linearizes, _jumps)


class ConformanceReport(NamedTuple):
    """What the checks of a block found.

    Attributes
    ----------
    block : str
        Name of the block.
    checks : tuple of str
        What was checked.
    failures : tuple of str
        One sentence for each failure; empty if the block conforms.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.vehicle import vehicle
    >>> clpt.conformance.check_block(vehicle()).ok
    True
    """

    block: str
    checks: tuple[str, ...]
    failures: tuple[str, ...]

    @property
    def ok(self) -> bool:
        """Return whether nothing failed."""
        return not self.failures

    def __repr__(self) -> str:
        return f"<ConformanceReport {str(self).splitlines()[0]}>"

    def __str__(self) -> str:
        if self.ok:
            return f"{self.block}: conforms ({len(self.checks)} checks)"
        count = len(self.failures)
        return "\n".join([f"{self.block}: {count} failure{'s'[: count > 1]}", *self.failures])


@public
def conformance(
    block: Block, seed: Seed = 0, samples: int = 20, units: Mapping[str, str] | None = None
) -> None:
    """Raise an error unless a block conforms.

    Parameters
    ----------
    block, seed, samples, units
        As `check_block` takes them.

    Raises
    ------
    BlockError
        With every failure, a sentence each.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.vehicle import vehicle
    >>> clpt.conformance.conformance(vehicle())
    """
    report = check_block(block, seed, samples, units)
    if not report.ok:
        raise BlockError(str(report))


@public
def check_block(
    block: Block, seed: Seed = 0, samples: int = 20, units: Mapping[str, str] | None = None
) -> ConformanceReport:
    """Check a block and return a report.

    Parameters
    ----------
    block : Block
        Any block.
    seed : int, optional
        Seed of the random arguments.
    samples : int, optional
        Number of random arguments.
    units : mapping of str to str, optional
        Unit of each port and each parameter that is no whole number, such as
        ``{"e": "m", "gain": "1/s"}``, and of the time ``t``, ``"s"`` by default. The equations
        are then tried in other units, in which they must hold alike.

    Returns
    -------
    ConformanceReport
        The checks and the failures.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.vehicle import vehicle
    >>> print(clpt.conformance.check_block(vehicle()))
    vehicle: conforms (6 checks)
    """
    block.read_anew()
    drawn = random_samples(block, seed, max(samples, 4))
    checked: list[str] = []
    failures: list[str] = []
    for check in (*CHECKS, *([] if units is None else [unit_check(units)])):
        checked.append((check.__doc__ or "").splitlines()[0])
        try:
            failures.extend(check(block, drawn))
        except Exception as error:  # any error of a user's function is a failure
            what = check.__name__.strip("_").replace("_", " ")
            failures.append(f"{block.name}: {what}: {type(error).__name__}: {error}")
        if check is _repeats:
            if failures:
                break
            drawn = [sample for sample in drawn if _in_range(block, sample)]
    return ConformanceReport(block.name, tuple(checked), tuple(dict.fromkeys(failures)))
