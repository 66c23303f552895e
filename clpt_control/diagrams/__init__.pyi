from .drawing import draw, mermaid
from .interconnection import Diagram, connect

__all__ = [
    "Diagram",
    "connect",
    "draw",
    "mermaid",
]
