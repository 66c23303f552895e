"""A formula of the method: an ordinary function of numbers, read in two ways.

For machine code it is run on LLVM's numbers, eight states or eight runs at once (`kernels`); for
equations in Python on NumPy's rows (`on_rows`).
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

Row = Callable[[int], Any]
Rows = dict[int, Any]


class Formula(NamedTuple):
    """What is computed for each state, and then for each lane.

    ``each(z, lane, tolerance)`` returns rows of Z, and `sums` numbers to sum over the states;
    ``after(lane, sums)`` returns rows of numbers.
    """

    each: Callable[[Row, Row, Row], tuple[Rows, Sequence[Any]]] | None = None
    after: Callable[[Row, Sequence[Any]], Rows] | None = None
    sums: int = 0


def _word(name: str, on_rows: Callable) -> Callable:
    def word(*arguments: Any) -> Any:
        kind = next((a.kind for a in arguments if hasattr(a, "kind")), None)
        if kind is None:
            return on_rows(*arguments)
        from .elementary import OPERATIONS

        return OPERATIONS[name](*(a if hasattr(a, "kind") else kind.number(a) for a in arguments))

    word.__doc__ = f"Return {name} of LLVM's numbers, or of rows."
    return word


joined = _word("fmuladd", lambda a, b, c: a * b + c)  # rounded once where the processor can
where = _word("where", np.where)
minimum, maximum = _word("minimum", np.minimum), _word("maximum", np.maximum)
sqrt, power = _word("sqrt", np.sqrt), _word("pow", np.power)
ceil = _word("ceil", np.ceil)


def on_rows(formula: Formula, n: int) -> Callable:
    """Return what applies a formula in NumPy, called like a kernel."""

    def apply(
        numbers: Any, Z: np.ndarray, at: int, P: Any, T: Any, W: Any, D: Any, to: int
    ) -> None:
        numbers, rows_of_Z = numbers.reshape(-1), Z.reshape(-1, n)
        summed: Sequence[Any] = ()
        with np.errstate(all="ignore"):
            if formula.each is not None:
                rows, summed = formula.each(
                    rows_of_Z.__getitem__, numbers.__getitem__, T.__getitem__
                )
                for r, value in rows.items():
                    rows_of_Z[r] = value
            if formula.after is not None:
                found = formula.after(numbers.__getitem__, [np.sum(s) for s in summed])
                for r, value in found.items():
                    numbers[r] = value

    return apply
