"""The paper's section III as checks on the equations that run.

`audit` judges the four theorems, `prove` a law of your own.
"""

from typing import TYPE_CHECKING

from ..lazy import lazily

if TYPE_CHECKING:
    from .proving.own_law import Verdict, prove
    from .proving.theorems import audit

__all__ = ["Verdict", "audit", "prove"]
_NAMES = {"audit": "proving.theorems", "prove": "proving.own_law", "Verdict": "proving.own_law"}
__getattr__, __dir__ = lazily(__name__, _NAMES)
