"""Pictures of a diagram: `draw` draws for a notebook or into a file, `mermaid` gives text."""

from .figure import draw, mermaid

__all__ = ["draw", "mermaid"]
