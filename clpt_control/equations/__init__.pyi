from .at_many import evaluate
from .block import Block
from .declaration import Guard
from .lookup import lookup
from .opaque import opaque

__all__ = ["Block", "Guard", "evaluate", "lookup", "opaque"]
