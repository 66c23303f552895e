"""The paper's diagram, a file per room.

`block` makes a block of equations, `words` and `rules` say what equations may
use, `trace` records them; every other file is a page of the paper.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
