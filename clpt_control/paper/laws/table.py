"""The table of laws.

`learning.law` is the name of a row, `clpt laws` prints the table, `clpt prove` proves its laws.
To add a law, write its rates, with its page as their docstring, and its row; see CONTRIBUTING.
"""

from ...base.arguments import public
from . import least_squares, memory_laws, paper, robust
from .law import Law

ROWS = (*paper.LAWS, *robust.LAWS, *least_squares.LAWS, *memory_laws.LAWS)
LAWS: dict[str, Law] = {law.name: law for law in ROWS}


@public
def laws() -> dict[str, Law]:
    """Return the rows of the table of laws, by name.

    Returns
    -------
    dict of str to Law
        A row has what ``learning.law`` takes as `name`, and `promises`, `needs`, `settings` and
        `page`: its equations, V and source in words.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> laws = clpt.laws()
    >>> "sigma" in laws, laws["known-flow"].given_estimate
    (True, True)
    """
    return dict(LAWS)
