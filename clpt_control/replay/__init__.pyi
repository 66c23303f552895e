from .file import replay_dataset
from .flow_model_file import read_flow_model
from .flow_models import carried
from .plots import save_replay_figures
from .replay import Replay
from .session import replay_dives
from .surfacing import next_dive

__all__ = [
    "Replay",
    "carried",
    "next_dive",
    "read_flow_model",
    "replay_dataset",
    "replay_dives",
    "save_replay_figures",
]
