from .drawing import draw, mermaid
from .interconnection import Diagram, connect
from .linearization import linearize
from .on_symbols import Equations, equations

__all__ = ["Diagram", "Equations", "connect", "draw", "equations", "linearize", "mermaid"]
