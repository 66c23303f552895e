"""Does a block do what every block must?  `clpt.conformance.conformance(my_block)` checks.

A block that passes can be wired, compiled, proved with, pickled, linearized and
integrated like the paper's own.  Each check is a generator that takes random
arguments and gives one plain sentence for each failure.
"""

import pickle
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

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
    differ,
    python_values,
    random_samples,
    roles,
    unit_check,
)

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
