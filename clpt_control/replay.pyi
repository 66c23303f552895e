from .ocean.forecast.flow_models import read_flow_model as read_flow_model
from .ocean.forecast.replay import Replay as Replay
from .ocean.forecast.replay import replay_dives as replay_dives
