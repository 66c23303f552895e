"""HTML of a diagram in notebooks, drawn by a function that the package's front door sets."""

from collections.abc import Callable
from typing import Any

renderer: Callable[[Any], str] | None = None  # of a diagram


def html_of(diagram: Any) -> str | None:
    """Return a diagram as HTML, or None without a renderer; notebooks then show its text."""
    return None if renderer is None else renderer(diagram)
