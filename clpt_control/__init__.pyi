from . import (
    blocks,
    conformance,
    currents,
    diagrams,
    ensemble,
    equations,
    estimation,
    gliders,
    native,
    pages,
    parts,
    replay,
    scenario,
    simulation,
    theory,
)
from .app.pages.writing import report
from .base.errors import (
    ArgumentError,
    BlockError,
    ClptError,
    DataError,
    DiagramError,
    ScenarioError,
    SimulationError,
)
from .engine.diagram.interconnection import connect
from .engine.diagram.linearization import linearize
from .engine.model.block import Block
from .ensemble import run_ensemble
from .paper.laws.table import laws
from .paper.scenario.experiment import Scenario
from .paper.scenario.file import paper_scenario, save_scenario
from .paper.scenario.team import Team, load_scenario
from .plots.drawing.figure import draw
from .simulation import (
    animate,
    closed_loop,
    compare,
    export,
    fit_parameters,
    initial_state,
    load_diagram,
    load_run,
    paper_blocks,
    save_run,
    sensitivity,
    simulate,
)
from .theory import certify, gramian, lyapunov, prove, refute

__version__: str
__all__ = [
    "ArgumentError",
    "Block",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "Scenario",
    "ScenarioError",
    "SimulationError",
    "Team",
    "animate",
    "blocks",
    "certify",
    "closed_loop",
    "compare",
    "conformance",
    "connect",
    "currents",
    "diagrams",
    "draw",
    "ensemble",
    "equations",
    "estimation",
    "export",
    "fit_parameters",
    "gliders",
    "gramian",
    "initial_state",
    "laws",
    "linearize",
    "load_diagram",
    "load_run",
    "load_scenario",
    "lyapunov",
    "native",
    "pages",
    "paper_blocks",
    "paper_scenario",
    "parts",
    "prove",
    "refute",
    "replay",
    "report",
    "run_ensemble",
    "save_run",
    "save_scenario",
    "scenario",
    "sensitivity",
    "simulate",
    "simulation",
    "theory",
]
