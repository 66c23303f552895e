"""The table of laws: `learning.law` is a name of it, `clpt laws` prints it, `clpt prove` proves it.

To add a law, write its page and put its row, `LAW`, in here; CONTRIBUTING has the recipe.
"""

from ...arguments import public
from . import (
    composite_least_squares,
    composite_memory,
    concurrent,
    dead_zone,
    drem,
    fix_regression,
    kalman_flow,
    known_flow,
    leakage,
    learned_flow,
    least_squares,
    normalised_gradient,
    projection,
)
from .law import Law

PAPER = (learned_flow.LAW, known_flow.LAW, kalman_flow.LAW)
LEAKS = (leakage.SIGMA, leakage.SWITCHING_SIGMA, leakage.E_MODIFICATION)
ROBUST = (*LEAKS, dead_zone.LAW, projection.LAW)  # against disturbances
FILTERED = (normalised_gradient.LAW, least_squares.LAW, composite_least_squares.LAW)
REMEMBERING = (composite_memory.LAW, concurrent.LAW, drem.LAW, fix_regression.LAW)
LAWS: dict[str, Law] = {law.name: law for law in PAPER + ROBUST + FILTERED + REMEMBERING}


@public
def table_of_laws() -> dict[str, Law]:
    """Return the rows of the table of laws, by name.

    Returns
    -------
    dict of str to Law
        A row has what ``learning.law`` takes as `name`, and `promise`, `needs`, `settings` and
        `page`: its equations, V and source in words.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> laws = clpt.blocks.table_of_laws()
    >>> len(laws), laws["known-flow"].given_estimate
    (15, True)
    """
    return dict(LAWS)
