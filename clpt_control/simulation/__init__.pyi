from .animation import animate
from .comparison import compare, response_plot
from .fit_problem import Fit
from .fitting import fit_parameters
from .flows import explained_variance, flow_velocity
from .initial_states import initial_state
from .integrate import simulate
from .loop_blocks import paper_blocks
from .loops import closed_loop
from .program_export import export
from .run_file import load_diagram, load_run, save_run
from .run_plots import clpe_plot, learning_plot, run_plot
from .sensitivities import sensitivity
from .summary import claims, run_and_report
from .team_plots import team_plot
from .track_chart import track_plot

__all__ = [
    "Fit",
    "animate",
    "claims",
    "closed_loop",
    "clpe_plot",
    "compare",
    "explained_variance",
    "export",
    "fit_parameters",
    "flow_velocity",
    "initial_state",
    "learning_plot",
    "load_diagram",
    "load_run",
    "paper_blocks",
    "response_plot",
    "run_and_report",
    "run_plot",
    "save_run",
    "sensitivity",
    "simulate",
    "team_plot",
    "track_plot",
]
