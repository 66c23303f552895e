"""The paper's symbols for a diagram's ports and parameters.

A port `x[2]` becomes x_1, x_2; a port of 2N signals, such as `alpha`, becomes
alpha_1[1] ... alpha_2[N], axis then basis function, both from 1.  A parameter
field that several blocks hold with the same value is one symbol: the diagram
gives them one alpha_M.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np
import sympy

from ..blocks import Block
from ..errors import DiagramError

POSITIVE = {"gain", "KD"}
SPELLING = {"gain": "gamma"}


def port_symbols(port: str, size: int, N: int | None = None, function_of: tuple = ()) -> np.ndarray:
    """Give the symbols of one port, flattened row by row.

    Parameters
    ----------
    port : str
        Name of the port.
    size : int
        Number of signals.
    N : int, optional
        Number of basis functions: a port of N or 2N signals is numbered by it.
    function_of : tuple, optional
        Arguments; then the symbols are undefined functions of them.

    Returns
    -------
    ndarray of sympy.Expr
        Shape (size,).

    Examples
    --------
    >>> port_symbols("alpha", 4, N=2)
    array([alpha_1[1], alpha_1[2], alpha_2[1], alpha_2[2]], dtype=object)
    """
    if N is not None and port.startswith("phi") and size == N:
        names = [f"{port}[{k + 1}]" for k in range(size)]
    elif N is not None and port in ("alpha", "eta") and size >= 2 * N:
        names = [f"{port}_{k // N + 1}[{k % N + 1}]" for k in range(2 * N)]
        names += [f"{port}_{k + 1}" for k in range(2 * N, size)]
    else:
        names = [f"{port}_{k + 1}" for k in range(size)]
    if function_of:
        return np.array([sympy.Function(name, real=True)(*function_of) for name in names], object)
    return np.array([sympy.Symbol(name, real=True) for name in names], dtype=object)


def parameter_symbols(blocks: Iterable[Block]) -> dict[str, Any]:
    """Give each block's parameters as symbols.

    Parameters
    ----------
    blocks : iterable of Block
        Blocks of one diagram.

    Returns
    -------
    dict
        Block name -> NamedTuple of symbols; whole numbers stay numbers.

    Raises
    ------
    DiagramError
        If two blocks hold different values under one field name, so that one
        symbol cannot stand for both.

    Examples
    --------
    >>> from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
    >>> parameter_symbols([adaptation(LearnedFlowParameters(3, 0.8))])["adaptation"].gain
    gamma
    """
    values: dict[str, tuple[str, Any]] = {}
    symbols = {}
    for block in blocks:
        fields = []
        for field, value in zip(block.parameters._fields, block.parameters, strict=True):
            owner, known = values.setdefault(field, (block.name, value))
            if not np.array_equal(known, value) and not (block.opaque or field == "interval"):
                raise DiagramError(
                    f"{owner}.{field} and {block.name}.{field} differ; "
                    "one symbol cannot stand for both: make them equal or rename one field"
                )
            fields.append(value if isinstance(value, int) else _symbol(field, np.shape(value)))
        symbols[block.name] = type(block.parameters)(*fields)
    return symbols


def _symbol(field: str, shape: tuple[int, ...]) -> Any:
    name = SPELLING.get(field, field)
    sort: dict[str, Any] = {"positive": True} if field in POSITIVE else {"real": True}
    if not shape:
        return sympy.Symbol(name, **sort)
    array = np.empty(shape, dtype=object)
    for index in np.ndindex(shape):
        place = f"_{index[0] + 1}" if shape[0] == 2 else f"[{index[0] + 1}]"
        place += "".join(f"[{k + 1}]" for k in index[1:])
        array[index] = sympy.Symbol(name + place, **sort)
    return array
