"""Blocks of equations, and what a function does to arrays: an engine that serves any paper.

`block` makes a block of functions; `reading` runs them on `arrays` without values and keeps
their `record`.  `elements`, `symbolic` and `derivative` are readings of it.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
