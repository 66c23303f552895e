from .ocean.forecast.aim import aims
from .ocean.forecast.flow_models import read_flow_model
from .ocean.forecast.netcdf_export import replay_dataset
from .ocean.forecast.plots import current_plot, dive_clpe_plot, replay_plot
from .ocean.forecast.replay import Replay, next_dive, replay_dives
from .ocean.forecast.replay_summary import clpe_rms, summary
from .ocean.forecast.track_map import map_plot

__all__ = [
    "Replay",
    "aims",
    "clpe_rms",
    "current_plot",
    "dive_clpe_plot",
    "map_plot",
    "next_dive",
    "read_flow_model",
    "replay_dataset",
    "replay_dives",
    "replay_plot",
    "summary",
]
