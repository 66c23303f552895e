"""A glider's dives replayed: `replay_dives`, `next_dive`."""

from typing import TYPE_CHECKING

from ..lazy import lazily

_NAMES = {
    "Replay": "replay",
    "replay_dives": "session",
    "next_dive": "surfacing",
    "replay_dataset": "file",
    "save_replay_figures": "plots",
    "read_flow_model": "flow_model_file",
    "carried": "flow_models",
}

__all__ = list(_NAMES)

if TYPE_CHECKING:
    from .file import replay_dataset
    from .flow_model_file import read_flow_model
    from .flow_models import carried
    from .plots import save_replay_figures
    from .replay import Replay
    from .session import replay_dives
    from .surfacing import next_dive

__getattr__, __dir__ = lazily(__name__, _NAMES)
