from .ocean.estimation.flow_estimator import FlowEstimator
from .ocean.estimation.theta_from_fixes import flow_estimate, known_flow_scenario
from .paper.currents.current_record import read_record
from .paper.currents.fit import fit_current
from .paper.currents.grid_file import read_currents, sample_currents
from .paper.currents.tidal_constants import tidal_basis
from .paper.currents.tidal_fit import fit_tides, predict
from .simulation.flows import explained_variance, flow_velocity

__all__ = [
    "FlowEstimator",
    "explained_variance",
    "fit_current",
    "fit_tides",
    "flow_estimate",
    "flow_velocity",
    "known_flow_scenario",
    "predict",
    "read_currents",
    "read_record",
    "sample_currents",
    "tidal_basis",
]
