from .ocean.currents.current_record import read_record
from .ocean.currents.fit import fit_current, save_fit
from .ocean.currents.grid_file import read_currents, sample_currents
from .ocean.currents.tidal_constants import tidal_basis
from .ocean.currents.tidal_fit import fit_tides, predict

__all__ = [
    "fit_current",
    "fit_tides",
    "predict",
    "read_currents",
    "read_record",
    "sample_currents",
    "save_fit",
    "tidal_basis",
]
