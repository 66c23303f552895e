from .base.errors import (
    ArgumentError,
    BlockError,
    ClptError,
    DataError,
    DiagramError,
    ScenarioError,
    SimulationError,
    Uncompiled,
)

__all__ = [
    "ArgumentError",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "ScenarioError",
    "SimulationError",
    "Uncompiled",
]
