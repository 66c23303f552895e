from . import conformance
from .block import Block
from .ports import Guard
from .rules import opaque

__all__ = [
    "Block",
    "Guard",
    "conformance",
    "opaque",
]
