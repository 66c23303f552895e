from .aim import aims
from .dataset import replay_dataset
from .flow_model_file import read_flow_model
from .flow_models import carried
from .outcome import clpe_rms, summary
from .plots import save_replay_figures
from .replay import Replay, replay_dives
from .surfacing import next_dive

__all__ = [
    "Replay",
    "aims",
    "carried",
    "clpe_rms",
    "next_dive",
    "read_flow_model",
    "replay_dataset",
    "replay_dives",
    "save_replay_figures",
    "summary",
]
