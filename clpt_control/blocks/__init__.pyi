from . import conformance
from .arrays import evaluate
from .block import Block
from .ports import Guard
from .rules import opaque

__all__ = [
    "Block",
    "Guard",
    "conformance",
    "evaluate",
    "opaque",
]
