"""Adaptive learning for controlled Lagrangian particle tracking.

The paper of Cho, Zhang and Edwards (2016) as python-control block diagrams:
`closed_loop` wires a scenario's blocks, `simulate` runs them, and the same
equations are compiled and proved.  Names arrive when first used, so that
importing the package is light.
"""

from typing import TYPE_CHECKING

from .lazy import lazily

__version__ = "0.1.0"

_NAMES = {
    "Block": "blocks",
    "Scenario": "scenario.experiment",
    "load_scenario": "scenario.file",
    "save_scenario": "scenario.file",
    "paper_scenario": "scenario.paper",
    "paper_blocks": "simulation.closed_loop",
    "closed_loop": "simulation.closed_loop",
    "error_loop": "simulation.closed_loop",
    "connect": "diagrams.interconnection",
    "initial_state": "simulation.closed_loop",
    "simulate": "simulation.simulate",
    "save_run": "simulation.runs",
    "load_run": "simulation.runs",
    "run_ensemble": "ensemble.run",
    "draw": "diagrams.drawing",
    **dict.fromkeys(
        (
            "ClptError",
            "BlockError",
            "DiagramError",
            "ScenarioError",
            "DataError",
            "SimulationError",
        ),
        "errors",
    ),
}
_PACKAGES = (
    "blocks",
    "currents",
    "diagrams",
    "ensemble",
    "estimation",
    "gliders",
    "native",
    "replay",
    "scenario",
    "simulation",
    "theory",
)

__all__ = ["__version__", *_NAMES, *_PACKAGES]

if TYPE_CHECKING:
    from .blocks import Block
    from .diagrams.drawing import draw
    from .diagrams.interconnection import connect
    from .ensemble.run import run_ensemble
    from .errors import (
        BlockError,
        ClptError,
        DataError,
        DiagramError,
        ScenarioError,
        SimulationError,
    )
    from .scenario.experiment import Scenario
    from .scenario.file import load_scenario, save_scenario
    from .scenario.paper import paper_scenario
    from .simulation.closed_loop import closed_loop, error_loop, initial_state, paper_blocks
    from .simulation.runs import load_run, save_run
    from .simulation.simulate import simulate

__getattr__, __dir__ = lazily(__name__, _NAMES, _PACKAGES)
