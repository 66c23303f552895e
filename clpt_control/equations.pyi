from .engine.model.block import Block
from .engine.model.declaration import Guard
from .engine.model.sampled import Sampled
from .engine.trace.interpolators import lookup

__all__ = ["Block", "Guard", "Sampled", "lookup"]
