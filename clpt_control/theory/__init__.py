"""The paper's section III as checks on the equations that run.

`audit` judges the four theorems, `prove` a law of your own.
"""

from typing import TYPE_CHECKING

from ..lazy import lazily

if TYPE_CHECKING:
    from .own_law import Verdict, prove
    from .theorems import audit

__all__ = ["Verdict", "audit", "prove"]
__getattr__, __dir__ = lazily(
    __name__, {"audit": "theorems", "prove": "own_law", "Verdict": "own_law"}
)
