from .paper.scenario.experiment import Scenario
from .paper.scenario.file import load_scenario, paper_scenario, save_scenario
from .paper.scenario.team import Team, load_team
from .paper.scenario.tidal_periods import period

__all__ = [
    "Scenario",
    "Team",
    "load_scenario",
    "load_team",
    "paper_scenario",
    "period",
    "save_scenario",
]
