"""The paper's diagram, a page for each block, and what makes blocks of equations.

`block` makes a block.  Equations may use `words`; `rules` refuses all else; `trace`
runs them on `tracers` and keeps their `record`; `ieee`, `arrays` and `symbolic` are
readings; `checks` compares all readings.  Every other file is a page of the paper.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
