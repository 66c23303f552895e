"""Does a block do what every block must?  `clpt.conformance.conformance(my_block)` checks.

A block that passes can be wired, compiled, proved with, copied, pickled, linearized
and integrated like the paper's own.  Each check is a generator that takes random
arguments and gives one plain sentence for each failure.
"""

import pickle
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

import control
import numpy as np

from ..arguments import Seed, public
from ..diagrams.linearization import linearize
from ..equations.block import Block
from ..errors import BlockError, DiagramError
from ..html import facts, fragment, unfolding
from .equation_checks import (
    Sample,
    _in_range,
    _readings,
    _repeats,
    _zero,
    called_roles,
    control_values,
    copied,
    differ,
    python_values,
    random_samples,
    roles,
    unit_check,
)

# --- as a part of diagrams ---------------------------------------------------------------------


LINEAR = 1e-4


def _copies(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """A copy under a new name shares nothing with the original."""
    before = copied(block.parameters)
    twin = block.copy(name=f"{block.name}_copy")
    if twin.name != f"{block.name}_copy" or list(twin.params) != [twin.name]:
        yield f"{block.name}: a copy with a new name keeps the old one in its parameters"
    yield from _twins(block, twin, drawn, "a copy")
    for value in twin.parameters:
        if isinstance(value, np.ndarray):
            value.flags.writeable = True
            value += 1.0
    for field, old, new in zip(before._fields, before, block.parameters, strict=True):
        if not np.array_equal(old, new):
            yield f"{block.name}: changing {field} of a copy changes the original"


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
    yield from _twins(block, twin, drawn, "pickling")


def _twins(block: Block, twin: Block, drawn: list[Sample], what: str) -> Iterator[str]:
    for sample in drawn[:3]:
        for role in roles(block):
            ask = python_values if role == "jump" else control_values
            ours, theirs = (ask(one, role, sample) for one in (block, twin))
            if not np.array_equal(ours, theirs, equal_nan=True):
                yield f"{block.name}: {what} gives other values"


def _linearizes(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """python-control's `linearize` agrees with the exact one."""
    for sample in () if block.opaque else drawn[:3]:
        at = sample.x, sample.u, sample.t
        found = block.linearize(*at[:2], t=sample.t)
        try:
            exact = linearize(block, *at)
        except DiagramError:  # it samples, jumps there, or has nothing to linearize along
            return
        for name in "ABCD":
            ours, theirs = getattr(found, name), getattr(exact, name)
            if differ(ours, theirs, LINEAR):
                yield f"{block.name}: linearize gives {name} = {ours}, exactly it is {theirs}"
                return


def _interconnects(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """python-control's interconnection of the block alone gives the same."""
    diagram = _alone(block)
    for sample in drawn[:5]:
        for role in called_roles(block):
            ours = python_values(block, role, sample)
            if differ(ours, control_values(diagram, role, sample)):
                what = {"output": "outputs", "update": "derivatives"}[role]
                yield f"{block.name}: other {what} inside control.interconnect than alone"


def _alone(block: Block) -> control.InterconnectedSystem:
    names = [f"{block.name}.{label}" for label in block.input_labels]
    return control.interconnect(
        [block],
        connections=False,
        inplist=names,
        outlist=[f"{block.name}.{label}" for label in block.output_labels],
        inputs=block.input_labels,
        outputs=block.output_labels,
        name="alone",
        check_unused=False,
    )


def _parameters(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Call-time parameters reach the block by qualified name; unknown names are errors."""
    diagram, sample = _alone(block), drawn[0]
    arguments = (sample.t, sample.x, sample.u)
    for field, value in zip(block.parameters._fields, block.parameters, strict=True):
        if isinstance(value, int):
            continue
        other = (
            3.0 if field == "interval" else np.where(value == 0, 0.125, 1.25 * np.asarray(value))
        )
        other = float(other) if np.ndim(value) == 0 else other
        changed = {f"{block.name}.{field}": other}
        arrived = block.with_params(changed)
        if not np.array_equal(getattr(arrived, field), other):
            yield f"{block.name}: params {{'{block.name}.{field}': ...}} does not reach the block"
        p = block.parameters_at(sample.t, arrived)
        try:
            calls = [system.output(*arguments, params=changed) for system in (block, diagram)]
        except RuntimeError:  # python-control takes NaN, as of a table too short, for a loop
            continue
        finally:
            block._update_params(None)
        ours = python_values(block, "output", sample._replace(p=p))
        if any(differ(ours, given) for given in calls):
            yield f"{block.name}: params {{'{block.name}.{field}': ...}} gives other outputs"
    for unknown in (f"{block.name}.no_such_field", "no_such_block.gain", "no_such_name"):
        try:
            block.output(*arguments, params={unknown: 1.0})
        except BlockError:
            continue
        yield f"{block.name}: the unknown parameter '{unknown}' is not an error"
    ours = block.output(*arguments)
    if differ(ours, diagram.output(*arguments, params={"another_block.gain": 1.0})):
        yield f"{block.name}: another block's parameter changes this one"


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


# --- the report --------------------------------------------------------------------------------


Check = Callable[[Block, list[Sample]], Iterator[str]]
CHECKS: tuple[Check, ...] = (
    _repeats,
    _zero,
    _readings,
    _copies,
    _pickles,
    _linearizes,
    _interconnects,
    _parameters,
    _jumps,
)


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

    def _repr_html_(self) -> str:
        said = "conforms" if self.ok else f"{len(self.failures)} failures"
        rows = [("failure", failure) for failure in self.failures]
        checked = unfolding(f"{len(self.checks)} checks", "\n".join(self.checks))
        return fragment("Conformance", f"{self.block}: {said}", facts(rows), checked)

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
    vehicle: conforms (9 checks)
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
