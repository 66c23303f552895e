"""Pictures of a diagram: `draw` draws for a notebook or into a file, `mermaid` gives text."""

from .arrows import mermaid
from .figure import draw

__all__ = ["draw", "mermaid"]
