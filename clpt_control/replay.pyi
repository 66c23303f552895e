from .ocean.forecast.aim import aims
from .ocean.forecast.flow_models import read_flow_model
from .ocean.forecast.netcdf_export import replay_dataset
from .ocean.forecast.replay import Replay, next_dive, replay_dives
from .ocean.forecast.replay_summary import summary

__all__ = [
    "Replay",
    "aims",
    "next_dive",
    "read_flow_model",
    "replay_dataset",
    "replay_dives",
    "summary",
]
