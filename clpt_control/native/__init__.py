"""The engine: one pass over a diagram, and integration to every breakpoint.

`compile(diagram)` makes machine code of a diagram; `simulate` does so by itself.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..lazy import lazily

if TYPE_CHECKING:
    import control

    from .engine import NativeDiagram
    from .readings import readings

__all__ = ["compile", "readings"]
__getattr__, __dir__ = lazily(__name__, {"readings": "readings"})


def compile(
    diagram: "control.NonlinearIOSystem", params: Mapping[str, Any] | None = None
) -> "NativeDiagram":
    """Compile an interconnected diagram to machine code.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Blocks, wired; nested diagrams and several vehicles included.
    params : mapping, optional
        Call-time parameters by qualified name, ``{"adaptation.gain": 2.0}``.

    Returns
    -------
    NativeDiagram
        Ask it to `run` from an initial state, or `run_many` from many.

    Raises
    ------
    DiagramError
        If a system is no block, the diagram is too large, or blocks feed each
        other at once in a circle.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> native = clpt.native.compile(clpt.closed_loop(scenario))
    >>> native.run(clpt.initial_state(scenario), [0.0, 20.0]).status
    'finished'
    """
    from .engine import NativeDiagram

    return NativeDiagram(diagram, params)
