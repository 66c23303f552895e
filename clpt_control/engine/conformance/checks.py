"""Conformance checks of a block: `clpt.check(my_block)`.

A block that passes can be wired, compiled, proved, linearized and integrated like the blocks of
this package.  Each check is a generator that takes random arguments and yields one sentence for
each failure, or a `Note` that does not fail.  Equations must be repeatable and finite, machine code
must agree with Python, and declared units must be consistent.  For an output y of unit m^a s^b, in
a unit of length 1/c times as long,

    y(c^.. u, c^.. p) = c^a y(u, p)

A number with a unit inside the equations, a sum of two units, or a wrong declaration breaks this
equation.  m and km are two different units here.
"""

import pickle
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from typing import Any, NamedTuple

import control
import numpy as np

from ...base.arguments import Count, Seed, public
from ...base.errors import BlockError, DiagramError, Uncompiled
from ..diagram.block_numbers import blocks_of
from ..diagram.linearization import linearize
from ..model.block import Block
from ..model.declaration import powers
from ..model.sampled import Sampled
from ..solver.engine_choice import difference_at
from ..solver.inputs import read_inputs
from ..solver.native_diagram import NativeDiagram
from ..solver.termination import Solution
from .confirmation import EXACT, Tolerance, differ, differences

FACTOR = 1.7  # ratio of the old unit to the new unit
IN_OTHER_UNITS = Tolerance(of_largest=1e-9)
LINEAR = Tolerance(of_largest=1e-4, least=1e-4)


class Note(str):
    """A sentence of a check that is no failure."""


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


@np.errstate(all="ignore")
def python_values(block: Block, role: str, sample: Sample) -> np.ndarray:
    """Return what Python computes for one sample, whose arguments are copied."""
    size = block.noutputs if role == "output" else block.nstates
    arrays = {
        f: v.copy() for f, v in sample.p._asdict().items() if isinstance(v, np.ndarray)
    }
    p = sample.p._replace(**arrays)
    return block.values(role, size, sample.t, sample.x.copy(), sample.u.copy(), p)


def _is_finite(block: Block, role: str, sample: Sample) -> bool:
    return bool(np.all(np.isfinite(python_values(block, role, sample))))


def _are_equal(a: Block, b: Block, role: str, samples: list[Sample]) -> bool:
    """Return whether two blocks, called in turn, give the same numbers at all samples."""
    first, second = (map(partial(python_values, c, role), samples) for c in (a, b))
    return not any(differences(first, second, EXACT))


def _repeats(block: Block, samples: list[Sample]) -> Iterator[str]:
    """Equations give the same when called again, and are finite for most random inputs."""
    for role in roles(block):
        if not _are_equal(block, block, role, samples):
            yield (
                f"{block.name}.{role} gives another value when called again: it must keep no memory"
            )
        finite = sum(_is_finite(block, role, sample) for sample in samples)
        if finite < len(samples) // 4:
            yield f"{block.name}.{role} is finite for {finite} of {len(samples)} random inputs only"


def _zero(block: Block, samples: list[Sample]) -> Iterator[str]:
    """Equations are finite at zero states and inputs."""
    x, u = np.zeros(block.nstates), np.zeros(block.ninputs)
    zero = Sample(0.0, x, u, block.parameters_at(0.0, block.parameters))
    for role in roles(block):
        if role != "jump" and not _is_finite(block, role, zero):
            yield (
                f"{block.name}.{role} is not finite at zero states and inputs, with which "
                "python-control starts. Keep arguments in range with np.where, np.clip or "
                "np.maximum"
            )


def _compiles(block: Block, samples: list[Sample]) -> Iterator[str]:
    """Machine code computes what Python computes."""
    times, x, u, _ = zip(*sorted(samples, key=lambda sample: sample.t), strict=True)
    try:
        runner = NativeDiagram(block)
    except Uncompiled as error:
        yield f"{block.name}: runs in Python, not as machine code: {error}"
        return
    for t, states, values in zip(times, x, u, strict=True):
        inputs = read_inputs(values, np.array([t]), block.ninputs or 0)
        at_sample = Solution(np.array([t]), states[None])
        if why := difference_at([0], runner, at_sample, inputs):
            yield f"{block.name}: differs as machine code at t = {t:.6g}: {why}"
            return


# --- as a part of diagrams ---------------------------------------------------------------------


def _pickles(block: Block, samples: list[Sample]) -> Iterator[str]:
    """Pickling gives the same block back."""
    try:
        copy = pickle.loads(pickle.dumps(block))
    except Exception as error:
        yield Note(
            f"{block.name}: cannot be pickled ({error}). To send it to other processes, define "
            "functions and parameters at the top of a module"
        )
        return
    if not all(_are_equal(block, copy, role, samples[:3]) for role in roles(block)):
        yield f"{block.name}: pickling gives other values"


def _linearizes(block: Block, samples: list[Sample]) -> Iterator[str]:
    """python-control's `linearize`, which has no samples, agrees with the exact one."""
    if block.opaque or isinstance(block, Sampled):
        return
    system = block if block.ninputs else _with_an_input(block)
    for t, x, u, _ in samples[:3]:
        approximate = system.linearize(x, u if block.ninputs else [0.0], t=t)
        try:
            exact = linearize(block, x, u, t)
        except DiagramError:  # a jump at this point, or nothing to linearize
            return
        for name in "ABCD" if block.ninputs else "AC":
            matrix, expected = getattr(approximate, name), getattr(exact, name)
            if differ(matrix, expected, LINEAR).any():
                yield f"{block.name}: linearize gives {name} = {matrix}, exactly it is {expected}"
                return


def _with_an_input(block: Block) -> control.NonlinearIOSystem:
    """Return a system without inputs with one that it ignores, as `linearize` needs one."""
    return control.nlsys(
        lambda t, x, u, params: block.dynamics(t, x, []),
        lambda t, x, u, params: block.output(t, x, []),
        inputs=1,
        outputs=block.noutputs,
        states=block.nstates,
        dt=block.dt,
    )


def _jumps(block: Block, samples: list[Sample]) -> Iterator[str]:
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
        two_spans = [block.breakpoints(0.0, middle), block.breakpoints(middle, end)]
        if not np.array_equal(np.concatenate(two_spans), times):
            yield f"{block.name}: breakpoints over two spans differ from those over both"
            return
    for k, time in enumerate(times):
        intervals = [block.interval_at(t) for t in (np.nextafter(time, 0.0), time)]
        if intervals != [k, k + 1]:
            yield f"{block.name}: breakpoint {k + 1} does not end interval {k}"
            return


# --- other units ------------------------------------------------------------------------------


def unit_check(
    units: Mapping[str, str],
) -> Callable[[Block, list[Sample]], Iterator[str]]:
    """Return the check of a block whose ports, parameters and time t have these units."""

    def check(block: Block, samples: list[Sample]) -> Iterator[str]:
        """Equations hold in other units alike."""
        yield from _unit_failures(block, samples, {"t": "s", **units})

    return check


def _unit_failures(
    block: Block, samples: list[Sample], units: Mapping[str, str]
) -> Iterator[str]:
    ports = block.input_ports | block.state_ports | block.output_ports
    fields = [
        name
        for name, value in block.parameters._asdict().items()
        if name != "interval" and not isinstance(value, int)
    ]
    unknown = set(units) - {"t", *ports, *fields}
    missing = {*ports, *fields} - set(units)
    if unknown:
        yield f"{block.name}: units: no port or parameter is called '{min(unknown)}'"
    if missing:
        yield (
            f"{block.name}: units: '{min(missing)}' has none. Give one to each port and each "
            "parameter that is not a whole number, '1' where there is none"
        )
    if unknown or missing:
        return
    symbols = set().union(*map(powers, units.values()))
    for symbol in sorted(symbols):
        factors = {
            name: FACTOR ** powers(unit).get(symbol, 0) for name, unit in units.items()
        }
        for role in roles(block):
            failures = (
                _unit_failure(block, role, sample, factors, fields)
                for sample in samples
            )
            for port, value, expected in islice(filter(None, failures), 1):
                yield (
                    f"{block.name}.{role}: {port} is not of the unit '{units[port]}' that is "
                    f"declared: in a smaller {symbol} it becomes {value:.6g}, not "
                    f"{expected:.6g}; "
                    "a number in the equations has a unit, or one is declared wrongly"
                )


def _unit_failure(
    block: Block,
    role: str,
    sample: Sample,
    factors: Mapping[str, float],
    fields: Sequence[str],
) -> tuple[str, float, float] | None:
    """Return port, value and expected value of a signal that is not scaled as its unit."""

    def scaled(values: np.ndarray, ports: Mapping[str, int]) -> np.ndarray:
        return values * np.repeat([factors[port] for port in ports], [*ports.values()])

    results = block.output_ports if role == "output" else block.state_ports
    expected = scaled(python_values(block, role, sample), results)
    if role == "update":
        expected /= factors["t"]
    t, x, u, p = sample
    x, u = scaled(x, block.state_ports), scaled(u, block.input_ports)
    p = p._replace(**{name: getattr(p, name) * factors[name] for name in fields})
    values = python_values(block, role, Sample(t * factors["t"], x, u, p))
    is_wrong = differ(values, expected, IN_OTHER_UNITS) & ~np.isnan(values)
    for k in np.flatnonzero(is_wrong)[:1]:
        return np.repeat([*results], [*results.values()])[k], values[k], expected[k]
    return None


# --- the report --------------------------------------------------------------------------------


Check = Callable[[Block, list[Sample]], Iterator[str]]
CHECKS: tuple[Check, ...] = (_repeats, _zero, _compiles, _pickles, _linearizes, _jumps)


class ConformanceReport(NamedTuple):
    """Results of a block's checks.

    Attributes
    ----------
    block : str
        Name of the block.
    checks : tuple of str
        Descriptions of the checks.
    failures : tuple of str
        One sentence for each failure; empty if the block conforms.
    notes : tuple of str
        One sentence for each restriction, such as a function that cannot be pickled.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.paper.blocks.vehicle import vehicle
    >>> clpt.check(vehicle()).ok
    True
    """

    block: str
    checks: tuple[str, ...]
    failures: tuple[str, ...]
    notes: tuple[str, ...] = ()

    @property
    def ok(self) -> bool:
        """Return whether nothing failed."""
        return not self.failures

    def __repr__(self) -> str:
        return f"<ConformanceReport {str(self).splitlines()[0]}>"

    def __str__(self) -> str:
        count = len(self.failures)
        verdict = f"{self.block}: {count} failure{'s'[: count > 1]}"
        if self.ok:
            verdict = f"{self.block}: conforms ({len(self.checks)} checks)"
        notes = [f"Note: {note}" for note in self.notes]
        return "\n".join([verdict, *self.failures, *notes])


@public
def check(
    block: Block | control.NonlinearIOSystem,
    seed: Seed = 0,
    samples: Count = 20,
    units: Mapping[str, str] | None = None,
) -> ConformanceReport:
    """Compare a block's machine code with Python, and test it alone.

    Parameters
    ----------
    block : Block or control.NonlinearIOSystem
        Any block, or a `control.nlsys` or `control.ss`.
    seed : int, optional
        Seed of the random arguments.
    samples : int, optional
        Number of random arguments.
    units : mapping of str to str, optional
        Unit of each port and each parameter that is not a whole number, such as
        ``{"e": "m", "gain": "1/s"}``, and of the time ``t``, ``"s"`` by default. The equations
        are then tested in other units, too. For a Block only.

    Returns
    -------
    ConformanceReport
        The checks that the block passed.

    Raises
    ------
    BlockError
        With every failure, a sentence each.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.paper.blocks.vehicle import vehicle
    >>> print(clpt.check(vehicle()))
    vehicle: conforms (6 checks)
    """
    if isinstance(block, control.InterconnectedSystem):
        raise BlockError(f"{block.name}: is a diagram. Check each of its blocks")
    if not isinstance(block, Block):
        if units is not None:
            raise BlockError(
                f"{block.name}: units: are checked of a clpt.Block alone. Write it as a Block"
            )
        [(_, block)] = blocks_of(block)
    report = check_block(block, seed, samples, units)
    if not report.ok:
        raise BlockError(str(report))
    return report


def check_block(
    block: Block,
    seed: int = 0,
    samples: Count = 20,
    units: Mapping[str, str] | None = None,
) -> ConformanceReport:
    """Return the checks of a block and the failures."""
    block.read_anew()
    drawn = random_samples(block, seed, max(samples, 4))
    checks = [*CHECKS, *([] if units is None else [unit_check(units)])]
    descriptions = []
    failures: list[str] = []
    notes: list[str] = []
    for check in checks:
        descriptions.append((check.__doc__ or "").splitlines()[0])
        try:
            for sentence in check(block, drawn):
                (notes if isinstance(sentence, Note) else failures).append(sentence)
        except Exception as error:  # any error of a user's function is a failure
            name = check.__name__.strip("_").replace("_", " ")
            failures.append(f"{block.name}: {name}: {type(error).__name__}: {error}")
        if check is _repeats:
            if failures:
                break
            drawn = [
                sample
                for sample in drawn
                if all(_is_finite(block, role, sample) for role in roles(block))
            ]
    return ConformanceReport(
        block.name, tuple(descriptions), tuple(dict.fromkeys(failures)), tuple(notes)
    )
