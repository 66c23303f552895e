from .estimators import make_estimator
from .fix_model import FixModel

__all__ = [
    "FixModel",
    "make_estimator",
]
