"""The engine: one pass over a diagram, and integration to every breakpoint.

`compile(diagram)` makes machine code of a diagram; `simulate` does so by itself.
`docs/engine.md` leads from a diagram to machine code, step by step.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
