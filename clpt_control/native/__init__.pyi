from .engine import NativeDiagram, compile
from .readings import readings

__all__ = [
    "NativeDiagram",
    "compile",
    "readings",
]
