from .fit import fit_scenario
from .fit_file import save_fit
from .grid_file import read_currents
from .rayleigh import check_separable
from .sample import sample_currents
from .tidal.analysis import fit_tides, predict
from .tidal.basis import tidal_basis
from .tidal.plots import tides_plot
from .tidal.record import read_record

__all__ = [
    "check_separable",
    "fit_scenario",
    "fit_tides",
    "predict",
    "read_currents",
    "read_record",
    "sample_currents",
    "save_fit",
    "tidal_basis",
    "tides_plot",
]
