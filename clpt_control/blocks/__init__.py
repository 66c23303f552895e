"""The paper's diagram, a file per room.

`block` makes a block of equations, `words` and `rules` say what equations may
use, `trace` records them; every other file is a page of the paper.
"""

from ..lazy import lazily
from .block import Block
from .ports import Guard
from .rules import opaque

__all__ = ["Block", "Guard", "conformance", "opaque"]
__getattr__, __dir__ = lazily(__name__, {}, ["conformance"])
