"""Estimators between fixes, chosen by name.

`gradient` is the paper's law, Eq. (22), in integral form; `rls` recursive least
squares with forgetting; `kalman` a bank of Kalman filters.  All forecast a dive
before they see its end, and share the forecast with the previous dive's current
as far as that has proved right (`combination`).
"""

from collections.abc import Callable

from ..errors import ScenarioError
from .combination import Combination
from .estimator import Estimator
from .fix_model import FixModel
from .gradient import Gradient
from .kalman import KalmanBank
from .recursive import RecursiveLeastSquares

ESTIMATORS: dict[str, Callable[[FixModel], Estimator]] = {
    "kalman": KalmanBank,
    "rls": RecursiveLeastSquares,
    "gradient": Gradient,
}


def make_estimator(name: str, model: FixModel) -> Combination:
    """Make an estimator by its name.

    Parameters
    ----------
    name : str
        ``"gradient"``, ``"rls"`` or ``"kalman"``.
    model : FixModel
        The parameters.

    Returns
    -------
    Combination
        That has seen no dive.

    Raises
    ------
    ScenarioError
        If the name is unknown.

    Examples
    --------
    >>> make_estimator("rls", FixModel()).estimate()[2].any()
    np.False_
    """
    if name not in ESTIMATORS:
        raise ScenarioError(f"estimator '{name}': must be one of {', '.join(ESTIMATORS)}")
    return Combination(ESTIMATORS[name](model))
