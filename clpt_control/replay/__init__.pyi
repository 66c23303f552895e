from .aim import aims
from .carried_dives import carried
from .facts import replay_dataset
from .flow_models import read_flow_model
from .outcome import clpe_rms, summary
from .plots import current_plot, dive_clpe_plot, replay_plot
from .replay import Replay, next_dive, replay_dives
from .track_map import map_plot

__all__ = [
    "Replay",
    "aims",
    "carried",
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
