"""What a block's equations must hold to, asked with random inputs.

Each check is a generator of sentences, one for each failure; `conformance`
runs them all.
"""

import re
from collections.abc import Iterator

import numpy as np

from ...errors import ClptError
from ..block import Block
from .samples import Sample, differ, equations, python_values


def _in_range(block: Block, sample: Sample) -> bool:
    return all(np.all(np.isfinite(python_values(f, sample, n))) for _, f, n in equations(block))


def _repeats(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations give the same when called again, and are finite for most random inputs."""
    for role, function, size in equations(block):
        finite = 0
        for sample in drawn:
            first, again = (python_values(function, sample, size) for _ in range(2))
            finite += bool(np.all(np.isfinite(first)))
            if not np.array_equal(first, again, equal_nan=True):
                yield f"{role} gives another value when called again: it must keep no memory"
        if finite < len(drawn) // 4:
            yield f"{role} is finite for {finite} of {len(drawn)} random inputs only"


def _zero(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Equations are finite where states and inputs are zero."""
    x, u = np.zeros(block.nstates or 0), np.zeros(block.ninputs or 0)
    zero = Sample(0.0, x, u, block.parameters_at(0.0, block.parameters))
    for role, function, size in equations(block):
        if not np.all(np.isfinite(python_values(function, zero, size))):
            yield (
                f"{role} is not finite at zero states and inputs, with which python-control "
                "starts; keep arguments in range with where, clip or maximum"
            )


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


def _readings(block: Block, drawn: list[Sample]) -> Iterator[str]:
    """Every reading that a command can run gives what Python gives."""
    from ...native.all_readings import readings

    for name, ask in readings(block).items():
        for sample in drawn:
            point = sample.t, sample.x, sample.u
            ours = python_values(block.output_function, sample, block.noutputs)
            rates = np.zeros(0)
            if block.update_function is not None:
                rates = python_values(block.update_function, sample, block.nstates)
            try:
                theirs = ask(*point)
            except ClptError as error:
                yield f"{block.name}: the reading '{name}' refuses: {error}"
                break
            if differ(rates, theirs[0]) or differ(ours, theirs[1]):
                yield (
                    f"{block.name}: Python gives {rates} and {ours}, the reading '{name}' "
                    f"{theirs[0]} and {theirs[1]} at {sample}"
                )
                break
