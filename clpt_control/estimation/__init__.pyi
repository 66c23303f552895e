from .estimators import make_estimator
from .fix_model import FixModel
from .priors import Priors
from .theta_from_fixes import (
    FlowEstimate,
    dive_basis,
    flow_estimate,
    known_flow_scenario,
)

__all__ = [
    "FixModel",
    "FlowEstimate",
    "Priors",
    "dive_basis",
    "flow_estimate",
    "known_flow_scenario",
    "make_estimator",
]
