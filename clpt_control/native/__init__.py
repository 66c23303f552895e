"""The engine: one pass over a diagram, and integration to every breakpoint.

`compile(diagram)` fuses a diagram into machine code; `simulate` does so by
itself.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import control

    from .engine import NativeDiagram


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
        If a system is no block, or blocks feed each other at once in a circle.
    Unreadable
        If a block's equations cannot be flattened.

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
