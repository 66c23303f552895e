"""Measured currents and gliders: readers, fits, tides and replay.

Currents on a grid (`read_currents`, `fit_scenario`), tides of a record
(`read_record`, `fit_tides`), dives of a glider (`read_dives`, `usable`) and their
replay (`replay_dives`, `next_dive`).
"""

from typing import TYPE_CHECKING

from ..lazy import lazily

_NAMES = {
    "read_currents": "currents",
    "fit_scenario": "fit",
    "save_fit": "fit_file",
    "read_record": "tidal.record",
    "fit_tides": "tidal.analysis",
    "predict": "tidal.analysis",
    "tidal_basis": "tidal.basis",
    "check_separable": "rayleigh",
    "Dive": "gliders.dives",
    "make_dive": "gliders.dives",
    "usable": "gliders.usable_dives",
    "read_dives": "gliders.dive_files",
    "sample_dives": "gliders.dive_table",
    "write_dive_table": "gliders.dive_table",
    "write_og1": "gliders.og1_writer",
    "Replay": "replay.replay",
    "replay_dives": "replay.session",
    "next_dive": "replay.next_dive",
    "replay_dataset": "replay.file",
    "save_replay_figures": "replay.plots",
    "read_flow_model": "replay.flow_model_file",
    "carried": "replay.flow_models",
}

__all__ = list(_NAMES)

if TYPE_CHECKING:
    from .currents import read_currents
    from .fit import fit_scenario
    from .fit_file import save_fit
    from .gliders.dive_files import read_dives
    from .gliders.dive_table import sample_dives, write_dive_table
    from .gliders.dives import Dive, make_dive
    from .gliders.og1_writer import write_og1
    from .gliders.usable_dives import usable
    from .rayleigh import check_separable
    from .replay.file import replay_dataset
    from .replay.flow_model_file import read_flow_model
    from .replay.flow_models import carried
    from .replay.next_dive import next_dive
    from .replay.plots import save_replay_figures
    from .replay.replay import Replay
    from .replay.session import replay_dives
    from .tidal.analysis import fit_tides, predict
    from .tidal.basis import tidal_basis
    from .tidal.record import read_record

__getattr__, __dir__ = lazily(__name__, _NAMES)
