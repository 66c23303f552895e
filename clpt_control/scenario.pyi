from .paper.scenario.experiment import Scenario
from .paper.scenario.file import paper_scenario, save_scenario
from .paper.scenario.team import Team, load_scenario

__all__ = ["Scenario", "Team", "load_scenario", "paper_scenario", "save_scenario"]
