from .between_fixes import make_estimator
from .fix_model import FixModel
from .least_squares import evaluate

__all__ = [
    "FixModel",
    "evaluate",
    "make_estimator",
]
