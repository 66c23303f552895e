from .estimators import make_estimator
from .fix_model import FixModel
from .priors import Priors

__all__ = [
    "FixModel",
    "Priors",
    "make_estimator",
]
