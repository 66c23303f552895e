from .ocean.estimation.fix_model import FixModel
from .ocean.estimation.priors import Priors
from .ocean.estimation.theta_from_fixes import (
    FlowEstimate,
    flow_estimate,
    known_flow_scenario,
)

__all__ = ["FixModel", "FlowEstimate", "Priors", "flow_estimate", "known_flow_scenario"]
