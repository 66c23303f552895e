from .ocean.forecast.aim import aims as aims
from .ocean.forecast.flow_models import read_flow_model as read_flow_model
from .ocean.forecast.netcdf_export import replay_dataset as replay_dataset
from .ocean.forecast.replay import Replay as Replay
from .ocean.forecast.replay import next_dive as next_dive
from .ocean.forecast.replay import replay_dives as replay_dives
from .ocean.forecast.replay_summary import summary as summary
