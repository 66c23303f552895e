from .charts import track_plot
from .comparing import compare, response_plot
from .export import export_c
from .film import animate
from .fitting import Fit, fit_parameters
from .flows import explained_variance, flow_velocity
from .fmu import export_fmu
from .integrate import sample_times, simulate
from .loops import closed_loop, error_loop, paper_blocks
from .plots import clpe_plot, learning_plot, run_plot
from .run_file import load_diagram, load_run, save_run
from .starts import initial_state, state_at
from .summary import claims, run_and_report
from .tangents import sensitivity
from .team_loops import team_loop
from .team_plots import team_plot

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
