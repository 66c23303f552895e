from .proving.own_law import Verdict, prove
from .proving.theorems import audit

__all__ = [
    "Verdict",
    "audit",
    "prove",
]
