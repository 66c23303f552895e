"""Adaptive learning for controlled Lagrangian particle tracking.

The paper of Cho, Zhang and Edwards (2016) as python-control block diagrams:
`closed_loop` wires a scenario's blocks, `simulate` runs them, and the same
equations are compiled and proved.  The names are listed in `__init__.pyi`; each is
imported when first used, so that importing the package is light.
"""

from typing import Any

from .base import notebook_display, public_modules

__version__ = "0.1.0"
__getattr__, __dir__, __all__ = public_modules.attach(__name__, __file__)
public_modules.register()


def _diagram_html(diagram: Any) -> str:
    from .plots.drawing.figure import diagram_html

    return diagram_html(diagram)


def _accessor() -> type:
    from .app.notebook.accessor import ClptAccessor

    return ClptAccessor


# the engine does not import these modules
notebook_display.diagram_renderer = _diagram_html
notebook_display.register_accessor(_accessor)
