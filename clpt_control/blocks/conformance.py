"""What every block must hold to, asked of one block.

A block that passes can be wired, compiled, traced, copied, pickled, linearized
and integrated like the paper's own.  Run it on a block of yours:

    from clpt_control.blocks.conformance import conformance
    conformance(my_block)

Each check asks with random inputs and answers in plain sentences.
"""

import pickle
import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

import control
import numpy as np

from ..errors import BlockError
from .block import Block
from .random_inputs import (
    Sample,
    draw,
    equations,
    numba_values,
    own_copy,
    python_values,
    sympy_reading,
)

CLOSE = 1e-12
LINEAR = 1e-4
KINKS = ("Piecewise", "Min", "Max", "sign", "floor", "Mod", "Abs", "Heaviside")


class Report(NamedTuple):
    """What the checks found.

    Attributes
    ----------
    block : str
        Name of the block.
    checks : tuple of str
        What was asked.
    failures : tuple of str
        One sentence for each failure; empty if the block conforms.
    """

    block: str
    checks: tuple[str, ...]
    failures: tuple[str, ...]

    @property
    def ok(self) -> bool:
        """Whether nothing failed."""
        return not self.failures

    def __str__(self) -> str:
        if self.ok:
            return f"{self.block}: conforms ({len(self.checks)} checks)"
        return "\n".join([f"{self.block}: {len(self.failures)} failures", *self.failures])


def conformance(block: Block, seed: int = 0, samples: int = 20) -> None:
    """Fail unless a block conforms.

    Parameters
    ----------
    block : Block
        Any block.
    seed : int, optional
        Seed of the random inputs.
    samples : int, optional
        Number of random inputs.

    Raises
    ------
    BlockError
        With every failure, a sentence each.

    Examples
    --------
    >>> from clpt_control.blocks.vehicle import vehicle
    >>> conformance(vehicle())
    """
    report = check_block(block, seed, samples)
    if not report.ok:
        raise BlockError(str(report))


def check_block(block: Block, seed: int = 0, samples: int = 20) -> Report:
    """Ask a block everything, and report.

    Parameters
    ----------
    block : Block
        Any block.
    seed : int, optional
        Seed of the random inputs.
    samples : int, optional
        Number of random inputs.

    Returns
    -------
    Report
        Checks and failures.

    Examples
    --------
    >>> from clpt_control.blocks.vehicle import vehicle
    >>> print(check_block(vehicle()))
    vehicle: conforms (12 checks)
    """
    if not isinstance(block, Block):
        raise BlockError(f"{block!r}: must be a Block, not {type(block).__name__}")
    drawn = draw(block, seed, max(samples, 4))
    asked: list[str] = []
    failures: list[str] = []
    for check in CHECKS:
        asked.append((check.__doc__ or "").splitlines()[0])
        try:
            failures.extend(check(block, drawn))
        except Exception as error:  # whatever a user's function raises is its failure
            what = check.__name__.strip("_").replace("_", " ")
            failures.append(f"{block.name}: {what}: {type(error).__name__}: {error}")
        if check is _writes:
            if failures:
                break
            drawn = [sample for sample in drawn if _in_range(block, sample)]
    return Report(block.name, tuple(asked), tuple(dict.fromkeys(failures)))


def _apart(a: np.ndarray, b: np.ndarray, tolerance: float = CLOSE) -> bool:
    """Tell whether two results differ; NaN in both is no difference."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    if a.shape != b.shape or not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return True
    finite = np.isfinite(a)
    size = max(1.0, float(np.max(np.abs(a[finite]), initial=0.0)))
    return bool(np.any(np.abs(a[finite] - b[finite]) > tolerance * size))


def _in_range(block: Block, sample: Sample) -> bool:
    return all(np.all(np.isfinite(python_values(f, sample, n))) for _, f, n in equations(block))


def _same(a: Sample, b: Sample) -> list[str]:
    """Name what differs between two samples."""
    names = ("time", "states", "inputs")
    found = [n for n, v, w in zip(names, a, b, strict=False) if not np.array_equal(v, w)]
    fields = zip(a.p._fields, a.p, b.p, strict=True)
    return found + [f"parameter {f}" for f, v, w in fields if not np.array_equal(v, w)]


def _writes(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations write every entry of their last argument and nothing else."""
    for role, function, size in equations(block):
        finite = 0
        for sample in drawn:
            given = Sample(sample.t, sample.x.copy(), sample.u.copy(), own_copy(sample.p))
            out = np.full(size, np.nan)
            try:
                with np.errstate(all="ignore"):
                    function(*given, out)
            except (ValueError, ArithmeticError):
                continue
            finite += bool(np.all(np.isfinite(out)))
            for what in _same(sample, given):
                yield f"{role} changes its {what}: a block writes its last argument alone"
            filled = [python_values(function, sample, size, fill) for fill in (1.0, 2.0)]
            for k in np.flatnonzero(filled[0] != filled[1]):
                if np.isfinite(filled[0][k]) or np.isfinite(filled[1][k]):
                    yield (
                        f"{role} does not set entry {k} of its last argument, or reads it before "
                        "it is set"
                    )
            again = [python_values(function, sample, size, 0.0) for _ in range(2)]
            if not np.array_equal(*again, equal_nan=True):
                yield f"{role} gives another value when called again: it must keep no memory"
        if finite < len(drawn) // 4:
            yield f"{role} is finite for {finite} of {len(drawn)} random inputs only"


def _zero(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations are finite where states and inputs are zero."""
    x, u = np.zeros(block.nstates or 0), np.zeros(block.ninputs or 0)
    zero = Sample(0.0, x, u, block.parameters_at(0.0, block.parameters))
    for role, function, size in equations(block):
        if not np.all(np.isfinite(python_values(function, zero, size, 0.0))):
            yield (
                f"{role} is not finite at zero states and inputs, with which python-control "
                "starts; keep arguments in range with where, clip or maximum"
            )


def _numba(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Numba computes what Python computes."""
    for role, function, size in equations(block):
        for sample in drawn:
            ours = python_values(function, sample, size, 0.0)
            theirs = numba_values(function, sample, size)
            if _apart(ours, theirs):
                yield f"{role}: Python gives {ours} and Numba {theirs} at {sample}"
                break


def _sympy(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """SymPy reads what Python computes; an opaque block has no such reading."""
    import sympy
    from sympy.core.function import AppliedUndef

    if block.opaque:
        return
    for role, function, size in equations(block):
        reading = sympy_reading(block, function, size)
        known = [k for k, e in enumerate(reading.expressions) if not e.atoms(AppliedUndef)]
        ask = sympy.lambdify(reading.symbols, [reading.expressions[k] for k in known], "math")
        for sample in drawn:
            ours = python_values(function, sample, size, 0.0)
            theirs = np.array(ask(*reading.values(sample)), dtype=float)
            if _apart(ours[known], theirs):
                yield f"{role}: Python gives {ours[known]} and SymPy {theirs} at {sample}"
                break


def _feedthrough(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Outputs of a block without feedthrough do not change with its inputs."""
    if block.feedthrough or not block.ninputs:
        return
    for sample, other in zip(drawn, drawn[1:] + drawn[:1], strict=True):
        pair = (sample, sample._replace(u=other.u))
        values = [python_values(block.output_function, s, block.noutputs, 0.0) for s in pair]
        if not np.array_equal(*values, equal_nan=True):
            yield f"{block.name}: outputs change with inputs at once: declare feedthrough=True"
            return


def _docstrings(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Docstrings say the equation, its number and every port."""
    texts = []
    for role, function, _ in equations(block):
        text = function.__doc__ or ""
        texts.append(text)
        if not text.strip() or not text.splitlines()[0].strip():
            yield f"{role}: has no docstring that begins with a summary, such as the equation"
    text = "\n".join(texts)
    if not re.search(r"\bEqs?\.|\b[Ss]ection\b", text):
        yield f'{block.name}: no docstring names its equation: "Eq. (7)" or "section IV"'
    for port in {**block.input_ports, **block.state_ports, **block.output_ports}:
        if not re.search(rf"(?<!\w){re.escape(port)}(?!\w)", text):
            yield f"{block.name}: port '{port}' is in no docstring of its equations"


def _copies(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """A copy under a new name shares nothing with the original."""
    before = own_copy(block.parameters)
    twin = block.copy(name=f"{block.name}_copy")
    if twin.name != f"{block.name}_copy" or list(twin.params) != [twin.name]:
        yield f"{block.name}: a copy with a new name keeps the old one in its parameters"
    for sample in drawn[:3]:
        for (_, ours, size), (_, theirs, _) in zip(equations(block), equations(twin), strict=True):
            pair = [python_values(f, sample, size, 0.0) for f in (ours, theirs)]
            if not np.array_equal(*pair, equal_nan=True):
                yield f"{block.name}: a copy gives other values"
    for value in twin.parameters:
        if isinstance(value, np.ndarray):
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
    for sample in drawn[:3]:
        ours, theirs = ([b.output(sample.t, sample.x, sample.u)] for b in (block, twin))
        if block.nstates:
            ours.append(block.dynamics(sample.t, sample.x, sample.u))
            theirs.append(twin.dynamics(sample.t, sample.x, sample.u))
        if any(not np.array_equal(a, b, equal_nan=True) for a, b in zip(ours, theirs, strict=True)):
            yield f"{block.name}: pickling gives other values"


def _linearizes(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """`linearize` agrees with SymPy's Jacobian where equations are smooth."""
    import sympy

    drawn = drawn[:3]
    found = [block.linearize(s.x, s.u, t=s.t) for s in drawn]
    for role, function, size in equations(block):
        pair = [(m.A, m.B) if role.endswith(".update") else (m.C, m.D) for m in found]
        matrices = [np.hstack([np.reshape(a, (size, -1)), np.reshape(b, (size, -1))])
                    for a, b in pair]  # fmt: skip
        if any(not np.all(np.isfinite(matrix)) for matrix in matrices):
            yield f"{role}: linearize gives values that are not finite"
        if block.opaque:
            continue
        reading = sympy_reading(block, function, size)
        names = {type(e).__name__ for f in reading.expressions for e in sympy.preorder_traversal(f)}
        undefined = any(f.atoms(sympy.core.function.AppliedUndef) for f in reading.expressions)
        if undefined or names & set(KINKS):
            continue
        about = reading.states + reading.inputs
        if not about:
            continue
        jacobian = sympy.Matrix(reading.expressions).jacobian(about)
        ask = sympy.lambdify(reading.symbols, jacobian.tolist(), "math")
        for sample, matrix in zip(drawn, matrices, strict=True):
            exact = np.array(ask(*reading.values(sample)), dtype=float)
            if _apart(exact, matrix, LINEAR):
                yield f"{role}: linearize gives {matrix}, SymPy's Jacobian is {exact}"
                break


def _interconnects(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """python-control's interconnection of the block alone gives the same."""
    diagram = _alone(block)
    for sample in drawn[:5]:
        arguments = (sample.t, sample.x, sample.u)
        ours = python_values(block.output_function, sample, block.noutputs, 0.0)
        if _apart(ours, diagram.output(*arguments)):
            yield f"{block.name}: other outputs inside control.interconnect than alone"
        if block.update_function is not None:
            rates = python_values(block.update_function, sample, block.nstates, 0.0)
            if _apart(rates, diagram.dynamics(*arguments)):
                yield f"{block.name}: other derivatives inside control.interconnect than alone"


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
    """Call-time parameters arrive by qualified name; others do not pass."""
    diagram, sample = _alone(block), drawn[0]
    arguments = (sample.t, sample.x, sample.u)
    for field, value in zip(block.parameters._fields, block.parameters, strict=True):
        if isinstance(value, int):
            continue
        other = (
            3.0 if field == "interval" else np.where(value == 0, 0.125, 1.25 * np.asarray(value))
        )
        other = float(other) if np.ndim(value) == 0 else other
        changed, calls = {f"{block.name}.{field}": other}, []
        arrived = block.with_params(changed)
        if not np.array_equal(getattr(arrived, field), other):
            yield f"{block.name}: params {{'{block.name}.{field}': ...}} does not reach the block"
        p = block.parameters_at(sample.t, arrived)
        try:
            calls = [system.output(*arguments, params=changed) for system in (block, diagram)]
        except (IndexError, ValueError, ArithmeticError):
            continue  # the changed value, such as a table's shape, is out of range
        finally:
            block._update_params(None)
        ours = python_values(block.output_function, sample._replace(p=p), block.noutputs, 0.0)
        if any(_apart(ours, given) for given in calls):
            yield f"{block.name}: params {{'{block.name}.{field}': ...}} gives other outputs"
    for unknown in (f"{block.name}.no_such_field", "no_such_block.gain", "no_such_name"):
        try:
            block.output(*arguments, params={unknown: 1.0})
        except BlockError:
            continue
        yield f"{block.name}: the unknown parameter '{unknown}' is not an error"
    ours = block.output(*arguments)
    if _apart(ours, diagram.output(*arguments, params={"another_block.gain": 1.0})):
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
            yield f"{block.name}: breakpoints over (0, t] and (t, t1] differ from those over (0, t1]"
            return
    for k, time in enumerate(times):
        at = [block.interval_at(t) for t in (np.nextafter(time, 0.0), time)]
        if at != [k, k + 1]:
            yield f"{block.name}: breakpoint {k + 1} does not end interval {k}"
            return
    pinned = block.parameters._replace(interval=2.0)
    if any(block.parameters_at(t, pinned).interval != 2.0 for t in (0.0, times[0], end)):
        yield f"{block.name}: a given interval must stand, whatever the time"


Check = Callable[[Block, list[Sample]], Iterator[str]]
CHECKS: tuple[Check, ...] = (
    _writes,
    _zero,
    _feedthrough,
    _docstrings,
    _numba,
    _sympy,
    _copies,
    _pickles,
    _linearizes,
    _interconnects,
    _parameters,
    _jumps,
)
