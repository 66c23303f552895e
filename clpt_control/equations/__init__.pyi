from .at_many import evaluate
from .block import Block
from .declaration import Guard
from .sampled import Sampled
from .tables import lookup, opaque

__all__ = ["Block", "Guard", "Sampled", "evaluate", "lookup", "opaque"]
