from .drawing import draw
from .interconnection import Diagram, connect

__all__ = [
    "Diagram",
    "connect",
    "draw",
]
