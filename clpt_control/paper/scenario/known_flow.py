"""Scenario whose law knows the flow: the known-flow law with a given estimate, Remark 3.2."""

from typing import Any

import numpy as np

from ...base.arguments import finite, numbers, public
from ...base.units import METRES, SECONDS
from .experiment import Scenario


@public
def known_flow_scenario(scenario: Scenario, theta: np.ndarray) -> Scenario:
    """Feed the known-flow law of a scenario with an estimate.

    Parameters
    ----------
    scenario : Scenario
        With any law; what that law alone needs is left out.
    theta : array_like, shape (2, N)
        Such as `FlowEstimate.theta`.

    Returns
    -------
    Scenario
        With ``learning.law = "known-flow"`` and ``learning.theta_estimate``.

    Raises
    ------
    ArgumentError
        If theta is not two rows of N numbers.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> paper = clpt.paper_scenario()
    >>> clpt.currents.known_flow_scenario(paper, paper.flow.parameters).learning.law
    'known-flow'
    """
    learning = scenario.learning
    name = "known_flow_scenario: theta"
    theta = numbers(name, finite(name, theta), 2, scenario.basis.N)
    values: dict[str, Any] = {
        "learning.law": "known-flow",
        "learning.theta_estimate": theta,
        "learning.parameters": None,
    }
    if learning.row.settings:
        values[f"learning.{learning.row.table}"] = None
    gains = learning.used_gains
    if scenario.left_out or learning.row.at_fixes:
        fed = scenario.with_values(values | _simulated_truth(scenario, theta))
        names = ("feedback", "feedforward")  # gains of the vehicle, which the law knows
        return fed.with_values(
            {f"learning.{name}": getattr(fed.vehicle, name) for name in names}
        )
    elif not learning.adapt_gains:
        values |= {"learning.gain": None, "learning.gains": None}
    elif learning.gains is not None:
        values["learning.gains.parameters"] = None
    else:
        values["learning.gain"] = gains.feedback
    return scenario.with_values(values)


def _simulated_truth(scenario: Scenario, theta: np.ndarray) -> dict[str, Any]:
    """Return tables for a run in the learned flow, of those that the scenario leaves out.

    The vehicle visits the centers of the functions and stays for as long as it takes to cross a
    width at 1 m/s, if no reference says so; the gain is that time's and that width's.
    """
    width = float(scenario.basis.lengths.min())
    units = scenario.units
    dwell = width * METRES[units.length] / SECONDS[units.time]
    if "reference" not in scenario.left_out:
        dwell = scenario.reference.dwell
    points = list(dict.fromkeys(scenario.basis.centers))
    truth = {
        "flow": {"parameters": theta.tolist()},
        "vehicle": {"feedback": [2 / dwell] * 2, "feedforward": [2 / dwell] * 2},
        "reference": {"kind": "waypoints", "points": points, "dwell": dwell},
        "run": {
            "duration": 2 * dwell * max(len(points), 2),
            "output_step": dwell / 100,
        },
    }
    added = {name: table for name, table in truth.items() if name in scenario.left_out}
    return {**added, "localization": None, "learning.gain": 1 / (width * dwell) ** 2}
