from .at_many import evaluate
from .block import Block
from .declaration import Guard
from .lookup_tables import lookup
from .sampled import Sampled

__all__ = ["Block", "Guard", "Sampled", "evaluate", "lookup"]
