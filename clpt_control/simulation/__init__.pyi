from .animation import animate
from .c_export import export_c
from .comparison import compare, response_plot
from .fit_problem import Fit
from .fitting import fit_parameters
from .flows import explained_variance, flow_velocity
from .fmu_export import export_fmu
from .initial_states import initial_state, state_at
from .integrate import sample_times, simulate
from .loop_blocks import paper_blocks
from .loops import closed_loop, error_loop, team_loop
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
    "error_loop",
    "explained_variance",
    "export_c",
    "export_fmu",
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
    "sample_times",
    "save_run",
    "sensitivity",
    "simulate",
    "state_at",
    "team_loop",
    "team_plot",
    "track_plot",
]
