from .ocean.estimation.flow_estimator import FlowEstimator as FlowEstimator
from .ocean.estimation.theta_from_fixes import flow_estimate as flow_estimate
from .ocean.estimation.theta_from_fixes import (
    known_flow_scenario as known_flow_scenario,
)
from .paper.currents.current_record import read_record as read_record
from .paper.currents.fit import fit_current as fit_current
from .paper.currents.grid_file import read_currents as read_currents
from .paper.currents.grid_file import sample_currents as sample_currents
from .paper.currents.tidal_fit import fit_tides as fit_tides
from .simulation.flows import explained_variance as explained_variance
from .simulation.flows import flow_velocity as flow_velocity
