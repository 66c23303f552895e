from .base.errors import (
    ArgumentError,
    BlockError,
    ClptError,
    DataError,
    DiagramError,
    ScenarioError,
    SimulationError,
)

__all__ = [
    "ArgumentError",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "ScenarioError",
    "SimulationError",
]
