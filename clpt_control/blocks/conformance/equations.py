"""What a block's equations must hold to, asked with random inputs.

Each check is a generator of sentences, one for each failure; `conformance`
runs them all.
"""

import re
from collections.abc import Iterator

import numpy as np

from ..block import Block
from .samples import (
    Sample,
    differ,
    equations,
    numba_values,
    own_copy,
    python_values,
    sympy_reading,
)


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
            first, again = (python_values(function, sample, size, 0.0) for _ in range(2))
            if not np.array_equal(first, again, equal_nan=True):
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


def _feedthrough(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Outputs of a block without feedthrough do not change with its inputs."""
    if block.feedthrough or not block.ninputs:
        return
    for sample, other in zip(drawn, drawn[1:] + drawn[:1], strict=True):
        other = sample._replace(u=other.u)
        function, size = block.output_function, block.noutputs
        if not np.array_equal(
            python_values(function, sample, size), python_values(function, other, size)
        ):
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


def _numba(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Numba computes what Python computes."""
    for role, function, size in equations(block):
        for sample in drawn:
            ours = python_values(function, sample, size, 0.0)
            theirs = numba_values(function, sample, size)
            if differ(ours, theirs):
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
            if differ(ours[known], theirs):
                yield f"{role}: Python gives {ours[known]} and SymPy {theirs} at {sample}"
                break
