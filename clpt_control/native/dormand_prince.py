"""Text of the stages of DOP853, from scipy's table of coefficients.

Dormand and Prince's method of order 8 with error estimates of orders 5 and 3
and an interpolant of order 7 (Hairer, Norsett, Wanner, Solving Ordinary
Differential Equations I, 1993, section II.10).  The coefficients are scipy's;
zeros are left out of the sums.
"""

import numpy as np
from scipy.integrate import DOP853
from scipy.integrate._ivp import dop853_coefficients as table

STAGES = DOP853.n_stages  # 12


def _sum(weights: np.ndarray, rows: int = 1) -> str:
    """a_0 K_0 + a_1 K_1 + ..., the rows of K behind each other in Z."""
    terms = [f"{float(w)!r} * Z[{(rows + j)} * NX + i]" for j, w in enumerate(weights) if w != 0.0]
    return " + ".join(terms) or "0.0"


def stage_lines(indent: str) -> str:
    """Give the lines that fill the argument of stage s = 1 ... 12.

    Parameters
    ----------
    indent : str
        Spaces before each line.

    Returns
    -------
    str
        ``if s == 1: ...``; the last is the new state itself.

    Examples
    --------
    >>> stage_lines("").splitlines()[0]
    'if s == 1:'
    """
    lines = []
    for s in range(1, STAGES + 1):
        weights = table.B if s == STAGES else table.A[s, :s]
        lines.append(f"{'if' if s == 1 else 'elif'} s == {s}:")
        lines.append("    for i in range(NX):")
        lines.append(f"        Z[Y + i] = Z[i] + h * ({_sum(weights)})")
    return "\n".join(indent + line for line in lines)


def extra_lines(indent: str) -> str:
    """Give the lines for the arguments of the stages 13 to 15.

    Examples
    --------
    >>> extra_lines("").splitlines()[0]
    'if s == 13:'
    """
    lines = []
    for s in range(STAGES + 1, STAGES + 4):
        lines.append(f"{'if' if s == STAGES + 1 else 'elif'} s == {s}:")
        lines.append("    for i in range(NX):")
        lines.append(f"        Z[Y + i] = Z[i] + h * ({_sum(table.A[s, :s])})")
    return "\n".join(indent + line for line in lines)


def error_lines(indent: str) -> str:
    """Give the lines for both error estimates of component i.

    Examples
    --------
    >>> error_lines("").splitlines()[0][:4]
    'e5 ='
    """
    lines = [f"e5 = {_sum(table.E5)}", f"e3 = {_sum(table.E3)}"]
    return "\n".join(indent + line for line in lines)


def dense_lines(indent: str) -> str:
    """Give the lines for the interpolant's terms of component i.

    Examples
    --------
    >>> dense_lines("").splitlines()[0]
    'delta = Z[Y + i] - Z[i]'
    """
    lines = [
        "delta = Z[Y + i] - Z[i]",
        "F[i] = delta",
        "F[NX + i] = h * Z[NX + i] - delta",
        f"F[2 * NX + i] = 2.0 * delta - h * (Z[{STAGES + 1} * NX + i] + Z[NX + i])",
    ]
    lines += [f"F[{3 + row} * NX + i] = h * ({_sum(table.D[row])})" for row in range(4)]
    return "\n".join(indent + line for line in lines)


def stage_times() -> list[float]:
    """Give the stage times c_0 ... c_15 in parts of the step."""
    c = [*map(float, table.C[:STAGES]), 1.0, *map(float, table.C[STAGES + 1 :])]
    return c
