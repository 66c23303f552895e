"""Estimates of the flow parameters theta from data.

From samples of a flow (`least_squares.least_squares`), or from fix to fix of a vehicle that
sees itself at surfacings only (`FixModel`, `make_estimator`).
"""

from typing import TYPE_CHECKING

from ..lazy import lazily

_NAMES = {"FixModel": "fix_model", "make_estimator": "between_fixes", "evaluate": "least_squares"}

__all__ = list(_NAMES)

if TYPE_CHECKING:
    from .between_fixes import make_estimator
    from .fix_model import FixModel
    from .least_squares import evaluate

__getattr__, __dir__ = lazily(__name__, _NAMES)
