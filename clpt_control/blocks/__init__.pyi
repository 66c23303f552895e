from . import words
from .arrays import evaluate
from .block import Block
from .checks import ConformanceReport, check_block, conformance
from .declaration import Guard
from .rules import opaque

__all__ = [
    "Block",
    "ConformanceReport",
    "Guard",
    "check_block",
    "conformance",
    "evaluate",
    "opaque",
    "words",
]
