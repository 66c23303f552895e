from .experiment import Scenario
from .file import load_scenario, paper_scenario, save_scenario
from .tides import period

__all__ = [
    "Scenario",
    "load_scenario",
    "paper_scenario",
    "period",
    "save_scenario",
]
