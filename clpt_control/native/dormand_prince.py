"""Text of the stages of DOP853, from scipy's table of coefficients.

Dormand and Prince's method of order 8 with error estimates of orders 5 and 3
and an interpolant of order 7 (Hairer, Norsett, Wanner, Solving Ordinary
Differential Equations I, 1993, section II.10).  The coefficients are scipy's;
zeros are left out of the sums.
"""

from typing import Any

import numpy as np

STAGES = 12


def coefficients() -> Any:
    """Give scipy's table: A, B, C, D, E3 and E5."""
    from scipy.integrate._ivp import dop853_coefficients

    return dop853_coefficients


def weighted_sum(weights: np.ndarray, fused: bool = False) -> str:
    """Give a_0 K_0 + a_1 K_1 + ..., rows of K behind each other.

    Parameters
    ----------
    weights : ndarray
        a_0, a_1, ...; zeros are left out.
    fused : bool, optional
        Nested calls of ``fma`` in place of products and sums.

    Returns
    -------
    str
        An expression in i.

    Examples
    --------
    >>> weighted_sum(np.array([0.5, 0.0, 0.25]))
    '0.5 * Z[1 * NX + i] + 0.25 * Z[3 * NX + i]'
    """
    terms = [(repr(float(w)), f"Z[{1 + j} * NX + i]") for j, w in enumerate(weights) if w != 0.0]
    if not fused:
        return " + ".join(f"{w} * {k}" for w, k in terms) or "0.0"
    total = f"{terms[0][0]} * {terms[0][1]}"
    for w, k in terms[1:]:
        total = f"fma({w}, {k}, {total})"
    return total


def _ahead(weights: np.ndarray, fused: bool) -> str:
    total = weighted_sum(weights, fused)
    return f"fma(h, {total}, Z[i])" if fused else f"Z[i] + h * ({total})"


def stage_lines(indent: str, fused: bool = False) -> str:
    """Give the lines that fill the argument of stage s = 1 ... 12.

    Parameters
    ----------
    indent : str
        Spaces before each line.
    fused : bool, optional
        Sums as nested calls of ``fma``.

    Returns
    -------
    str
        ``if s == 1: ...``; the last is the new state itself.

    Examples
    --------
    >>> stage_lines("").splitlines()[0]
    'if s == 1:'
    """
    table = coefficients()
    lines = []
    for s in range(1, STAGES + 1):
        weights = table.B if s == STAGES else table.A[s, :s]
        lines.append(f"{'if' if s == 1 else 'elif'} s == {s}:")
        lines.append("    for i in range(NX):")
        lines.append(f"        Z[Y + i] = {_ahead(weights, fused)}")
    return "\n".join(indent + line for line in lines)


def extra_lines(indent: str, fused: bool = False) -> str:
    """Give the lines for the arguments of the stages 13 to 15.

    Examples
    --------
    >>> extra_lines("").splitlines()[0]
    'if s == 13:'
    """
    table = coefficients()
    lines = []
    for s in range(STAGES + 1, STAGES + 4):
        lines.append(f"{'if' if s == STAGES + 1 else 'elif'} s == {s}:")
        lines.append("    for i in range(NX):")
        lines.append(f"        Z[Y + i] = {_ahead(table.A[s, :s], fused)}")
    return "\n".join(indent + line for line in lines)


def error_lines(indent: str, fused: bool = False) -> str:
    """Give the lines for both error estimates of component i.

    Examples
    --------
    >>> error_lines("").splitlines()[0][:4]
    'e5 ='
    """
    table = coefficients()
    lines = [f"e5 = {weighted_sum(table.E5, fused)}", f"e3 = {weighted_sum(table.E3, fused)}"]
    return "\n".join(indent + line for line in lines)


def dense_lines(indent: str, fused: bool = False) -> str:
    """Give the lines for the interpolant's terms of component i.

    Examples
    --------
    >>> dense_lines("").splitlines()[0]
    'delta = Z[Y + i] - Z[i]'
    """
    table = coefficients()
    lines = [
        "delta = Z[Y + i] - Z[i]",
        "F[i] = delta",
        "F[NX + i] = h * Z[NX + i] - delta",
        f"F[2 * NX + i] = 2.0 * delta - h * (Z[{STAGES + 1} * NX + i] + Z[NX + i])",
    ]
    lines += [
        f"F[{3 + row} * NX + i] = h * ({weighted_sum(table.D[row], fused)})" for row in range(4)
    ]
    return "\n".join(indent + line for line in lines)


def stage_times() -> list[float]:
    """Give the stage times c_0 ... c_15 in parts of the step."""
    table = coefficients()
    c = [*map(float, table.C[:STAGES]), 1.0, *map(float, table.C[STAGES + 1 :])]
    return c
