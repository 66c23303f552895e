from .at_many import evaluate
from .block import Block
from .declaration import Guard
from .rows import lookup
from .sampled import Sampled
from .undefined import opaque

__all__ = ["Block", "Guard", "Sampled", "evaluate", "lookup", "opaque"]
