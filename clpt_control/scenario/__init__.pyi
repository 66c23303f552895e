from .experiment import Scenario
from .file import load_scenario, paper_scenario, save_scenario
from .team import Team, load_team
from .tidal_periods import period

__all__ = [
    "Scenario",
    "Team",
    "load_scenario",
    "load_team",
    "paper_scenario",
    "period",
    "save_scenario",
]
