"""Does a block do what every block must?  `clpt.conformance.conformance(my_block)` checks.

A block that passes can be wired, compiled, proved with, copied, pickled, linearized
and integrated like the paper's own.  Each check is a generator that takes random
arguments and gives one plain sentence for each failure.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from ..arguments import Seed, public
from ..equations.block import Block
from ..errors import BlockError
from ..html import facts, fragment, unfolding
from .diagrams import _copies, _interconnects, _jumps, _linearizes, _parameters, _pickles
from .equations import (
    Sample,
    _in_range,
    _readings,
    _repeats,
    _zero,
    keeps_units,
    random_samples,
)

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
    for check in (*CHECKS, *([] if units is None else [keeps_units(units)])):
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
