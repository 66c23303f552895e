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
    "Scenario": "scenario",
    "load_scenario": "scenario_file",
    "save_scenario": "scenario_file",
    "paper_scenario": "paper",
    "paper_blocks": "diagram",
    "closed_loop": "diagram",
    "error_loop": "diagram",
    "connect": "interconnection",
    "initial_state": "diagram",
    "simulate": "simulation",
    "save_run": "runs",
    "load_run": "runs",
    "run_ensemble": "ensemble.run",
    "draw": "drawing",
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
_PACKAGES = ("blocks", "drawing", "ensemble", "native", "theory", "estimation", "ocean", "plotting")

__all__ = ["__version__", *_NAMES, *_PACKAGES]

if TYPE_CHECKING:
    from .blocks import Block
    from .diagram import closed_loop, error_loop, initial_state, paper_blocks
    from .drawing import draw
    from .ensemble.run import run_ensemble
    from .errors import (
        BlockError,
        ClptError,
        DataError,
        DiagramError,
        ScenarioError,
        SimulationError,
    )
    from .interconnection import connect
    from .paper import paper_scenario
    from .runs import load_run, save_run
    from .scenario import Scenario
    from .scenario_file import load_scenario, save_scenario
    from .simulation import simulate

__getattr__, __dir__ = lazily(__name__, _NAMES, _PACKAGES)
