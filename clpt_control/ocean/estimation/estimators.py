"""Estimators between fixes by name."""

from collections.abc import Callable

from ...base.arguments import public
from ...base.errors import ScenarioError
from .estimator import Estimator
from .fix_model import FixModel
from .gradient_law import Gradient
from .process_mixture import ProcessMixture

ESTIMATORS: dict[str, Callable[[FixModel], Estimator]] = {
    "gaussian-process": ProcessMixture,
    "gradient": Gradient,
}


@public
def make_estimator(name: str, model: FixModel) -> Estimator:
    """Make an estimator by its name.

    >>> make_estimator("gradient", FixModel()).estimate()[0].any()
    np.False_
    """
    if name not in ESTIMATORS:
        raise ScenarioError(
            f"estimator '{name}': must be one of {', '.join(ESTIMATORS)}"
        )
    return ESTIMATORS[name](model)
