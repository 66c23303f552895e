from .engine.diagram.interconnection import Diagram, connect
from .engine.diagram.linearization import linearize
from .engine.diagram.symbolic_equations import Equations, equations
from .plots.drawing.figure import draw

__all__ = ["Diagram", "Equations", "connect", "draw", "equations", "linearize"]
