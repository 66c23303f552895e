from . import (
    blocks,
    currents,
    diagrams,
    ensemble,
    estimation,
    gliders,
    native,
    pages,
    replay,
    scenario,
    simulation,
    theory,
)
from .blocks import Block
from .diagrams import connect, draw
from .ensemble import run_ensemble
from .errors import (
    BlockError,
    ClptError,
    DataError,
    DiagramError,
    ScenarioError,
    SimulationError,
    Uncompiled,
)
from .pages import report
from .scenario import Scenario, Team, load_scenario, load_team, paper_scenario, save_scenario
from .simulation import (
    closed_loop,
    error_loop,
    initial_state,
    load_run,
    paper_blocks,
    save_run,
    simulate,
    state_at,
    team_loop,
)

__version__: str

__all__ = [
    "Block",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "Scenario",
    "ScenarioError",
    "SimulationError",
    "Team",
    "Uncompiled",
    "blocks",
    "closed_loop",
    "connect",
    "currents",
    "diagrams",
    "draw",
    "ensemble",
    "error_loop",
    "estimation",
    "gliders",
    "initial_state",
    "load_run",
    "load_scenario",
    "load_team",
    "native",
    "pages",
    "paper_blocks",
    "paper_scenario",
    "replay",
    "report",
    "run_ensemble",
    "save_run",
    "save_scenario",
    "scenario",
    "simulate",
    "simulation",
    "state_at",
    "team_loop",
    "theory",
]
