"""Measured currents: gridded fields and records, fits to them, tides.

Currents on a grid (`read_currents`, `fit_scenario`), tides of a record (`read_record`,
`fit_tides`).
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
}

__all__ = list(_NAMES)

if TYPE_CHECKING:
    from .currents import read_currents
    from .fit import fit_scenario
    from .fit_file import save_fit
    from .rayleigh import check_separable
    from .tidal.analysis import fit_tides, predict
    from .tidal.basis import tidal_basis
    from .tidal.record import read_record

__getattr__, __dir__ = lazily(__name__, _NAMES)
