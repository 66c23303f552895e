from .at_many import evaluate
from .block import Block
from .declaration import Guard
from .lookup_tables import lookup, opaque
from .sampled import Sampled

__all__ = ["Block", "Guard", "Sampled", "evaluate", "lookup", "opaque"]
