"""Adaptive learning for controlled Lagrangian particle tracking.

The paper of Cho, Zhang and Edwards (2016) as python-control block diagrams:
`closed_loop` wires a scenario's blocks, `simulate` runs them, and the same
equations are compiled and proved.  The names are listed in `__init__.pyi`; each is
imported when first used, so that importing the package is light.
"""

from typing import Any

import lazy_loader

from .base import public_modules
from .engine.diagram import html_display
from .notebook.registration import register

__version__ = "0.1.0"
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
public_modules.register()
register()  # Dataset.clpt


def _diagram_html(diagram: Any) -> str:
    from .plots.drawing.figure import diagram_html

    return diagram_html(diagram)


html_display.renderer = _diagram_html  # the engine does not import pictures
