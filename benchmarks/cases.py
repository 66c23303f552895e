"""The runs that are timed: the paper's, with N functions, and ensembles of it."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import clpt_control as clpt
from clpt_control import initial_state

REFERENCE = Path(__file__).parent.parent / "tests" / "reference" / "paper.json"
CHUNK = 4096  # members drawn at a time


@dataclass(frozen=True)
class Case:
    """One run: a scenario with the learned-flow law, and the times of the states wanted."""

    name: str
    scenario: clpt.Scenario
    times: np.ndarray

    @property
    def N(self) -> int:
        """Number of basis functions."""
        return self.scenario.basis.N


def paper(end: float = 2000.0) -> Case:
    """Return the paper's run; its states at the waypoint ends."""
    scenario = clpt.paper_scenario().with_values({"run.duration": end})
    return _case("the paper's run", scenario)


def many(N: int, end: float = 2000.0, seed: int = 1) -> Case:
    """Return the paper's run in a flow of N random functions, of the paper's strength."""
    draw = np.random.default_rng(seed)
    theta = draw.normal(0.0, 1.2 / np.sqrt(N), (2, N))
    values = {
        "basis.centers": draw.uniform(-12, 12, (N, 2)).tolist(),
        "basis.widths": draw.uniform(3, 8, N).tolist(),
        "basis.periods": draw.uniform(8, 30, N).tolist(),
        "basis.phases": draw.uniform(-np.pi, np.pi, N).tolist(),
        "flow.parameters": theta.tolist(),
        "model.parameters": np.zeros((2, N)).tolist(),
        "learning.parameters": np.zeros((2, N)).tolist(),
        "run.duration": end,
    }
    if N == 3:
        return _case("N = 3", clpt.paper_scenario().with_values({"run.duration": end}))
    document = clpt.paper_scenario().model_dump(
        exclude_none=True, exclude_defaults=True
    )
    for key, value in values.items():
        table, name = key.split(".")
        document.setdefault(table, {})[name] = value
    return _case(f"N = {N}", clpt.Scenario.model_validate(document))


def _case(name: str, scenario: clpt.Scenario) -> Case:
    end = scenario.run.duration
    ends = scenario.reference.dwell * np.arange(
        1, np.ceil(end / scenario.reference.dwell) + 1
    )
    return Case(name, scenario, np.concatenate([[0.0], np.minimum(ends, end)]))


def flat_parameters(scenario: clpt.Scenario) -> np.ndarray:
    """Return one run's parameters in the C programs' order, shape (9 N + 5,)."""
    centers = np.array(scenario.basis.centers)
    return np.concatenate(
        [
            centers[:, 0],
            centers[:, 1],
            scenario.basis.widths,
            scenario.frequencies,
            scenario.phases,
            np.ravel(scenario.flow.parameters),
            np.ravel(scenario.model_parameters),
            scenario.vehicle.feedback,
            scenario.vehicle.feedforward,
            [scenario.learning.gain],
        ]
    )


def members(
    scenario: clpt.Scenario, chunk: int, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return parameters (count, 9 N + 5) and initial states (count, 2 N + 8) of members.

    They differ in theta (10 percent), the gain (0.4 to 1.2), and x(0), z(0) (within 1); each
    chunk has its own random stream.
    """
    draw, N = np.random.default_rng([7, chunk]), scenario.basis.N
    # a member's do not depend on count
    numbers = draw.uniform(-1, 1, (count, 2 * N + 5))
    parameters = np.tile(flat_parameters(scenario), (count, 1))
    parameters[:, 5 * N : 7 * N] *= 1 + 0.1 * numbers[:, : 2 * N]
    parameters[:, -1] = 0.8 + 0.4 * numbers[:, 2 * N]
    states = np.tile(initial_state(scenario), (count, 1))
    states[:, :4] += numbers[:, 2 * N + 1 :]
    return parameters, states


def reference_states() -> tuple[np.ndarray, np.ndarray]:
    """Return times and states of the independent reference, ordered x, z, alpha, K, Gamma."""
    states = json.loads(REFERENCE.read_text())["paper"]["states"]
    return np.array([float(t) for t in states]), np.array(list(states.values()))
