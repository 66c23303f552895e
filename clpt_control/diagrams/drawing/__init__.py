"""Pictures of a diagram: `draw` writes a file, `mermaid` gives text."""

from .arrows import mermaid
from .figure import draw

__all__ = ["draw", "mermaid"]
