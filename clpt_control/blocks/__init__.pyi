from ..equations.at_many import evaluate
from ..equations.block import Block
from ..equations.declaration import Guard
from .checks import ConformanceReport, check_block, conformance

__all__ = [
    "Block",
    "ConformanceReport",
    "Guard",
    "check_block",
    "conformance",
    "evaluate",
]
