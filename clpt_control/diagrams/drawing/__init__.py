"""Pictures of a diagram: `draw` writes a file, `mermaid` gives text."""

from .arrows import mermaid
from .ink import draw

__all__ = ["draw", "mermaid"]
