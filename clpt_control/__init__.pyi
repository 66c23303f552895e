from . import currents, gliders, parts, replay, theory
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
from .engine.conformance.checks import check
from .engine.diagram.interconnection import connect
from .engine.diagram.linearization import linearize
from .engine.diagram.symbolic_equations import equations
from .engine.model.block import Block
from .engine.model.declaration import Guard
from .engine.model.sampled import Sampled
from .engine.trace.interpolators import lookup
from .ensemble.run import run_ensemble
from .ensemble.tune import tune_law
from .paper.laws.table import laws
from .paper.scenario.experiment import Scenario
from .paper.scenario.file import paper_scenario, save_scenario
from .paper.scenario.team import Team, load_scenario
from .plots.drawing.figure import draw
from .simulation.animation import animate
from .simulation.comparison import compare
from .simulation.fitting import fit_parameters
from .simulation.initial_states import initial_state
from .simulation.integrate import simulate
from .simulation.loop_blocks import paper_blocks
from .simulation.loops import closed_loop
from .simulation.program_export import export
from .simulation.run_file import load_diagram, load_run, save_run
from .simulation.sensitivities import sensitivity
from .theory.excitation.certify import certify
from .theory.excitation.gramian import gramian
from .theory.lyapunov_function import lyapunov
from .theory.proofs.prove_law import prove
from .theory.refuting import refute

__version__: str
__all__ = [
    "ArgumentError",
    "Block",
    "BlockError",
    "ClptError",
    "DataError",
    "DiagramError",
    "Guard",
    "Sampled",
    "Scenario",
    "ScenarioError",
    "SimulationError",
    "Team",
    "animate",
    "certify",
    "check",
    "closed_loop",
    "compare",
    "connect",
    "currents",
    "draw",
    "equations",
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
    "lookup",
    "lyapunov",
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
    "sensitivity",
    "simulate",
    "theory",
    "tune_law",
]
