"""Section IV of the paper: its scenario and what it claims.

The scenario ships as a commented TOML file, the one that `clpt init` writes.
"""

from importlib import resources
from pathlib import Path

from .experiment import Scenario
from .file import scenario_from_text


def paper_text() -> str:
    """Return the paper's scenario as commented TOML text.

    Examples
    --------
    >>> paper_text().splitlines()[0].startswith("#")
    True
    """
    return resources.files("clpt_control.data").joinpath("paper.toml").read_text("utf-8")


def paper_scenario() -> Scenario:
    """Return the scenario of section IV.

    Returns
    -------
    Scenario
        Three exponential basis functions, ten waypoints, t = 0 to 2000.

    Examples
    --------
    >>> paper_scenario().cycle
    200.0
    """
    return scenario_from_text(paper_text(), "paper.toml", Path())
