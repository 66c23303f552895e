"""What all laws of the table share: ports, K' and Gamma', gains that are held, and V.

K' = -gamma_K z e, Gamma' = gamma_Gamma zc e, Eqs. (22)-(23), by gains of their own.
"""

import numpy as np
import pytest
from small_scenarios import paper_of

from clpt_control import ScenarioError
from clpt_control.paper.laws.law import Gains, Truth
from clpt_control.paper.laws.table import LAWS
from clpt_control.paper.scenario.quantities import keys_of, keys_of_law
from clpt_control.simulation.user_components import functions_of

N = 2
TRUTH = Truth(
    np.array([[0.1, 0.2], [-0.1, -0.2]]), np.array([1.0, 0.7]), np.array([1.2, -0.5])
)
AT_TRUTH = {"alpha": -TRUTH.theta.ravel(), "K": TRUTH.KD, "Gamma": TRUTH.GammaD}


def made(name, **gains):
    known = paper_of(N, name).known_to_law
    given = {
        "parameters": 0.5,
        "feedback": 0.3,
        "feedforward": 0.2,
        "shared": False,
        **gains,
    }
    return LAWS[name].block(known._replace(gains=Gains(**given)))


def place(ports, port):
    """Return where a port lies among all."""
    names = [name for name, size in ports.items() for _ in range(size)]
    return [k for k, name in enumerate(names) if name == port]


def rates(block, seed=0):
    """Return the rates by state at a random point, and the inputs there."""
    random = np.random.default_rng(seed)
    x, u = random.normal(size=block.nstates), random.normal(size=block.ninputs)
    dx = block.dynamics(0.0, x, u)
    given = {port: u[place(block.input_ports, port)] for port in block.input_ports}
    return {
        port: dx[place(block.state_ports, port)] for port in block.state_ports
    }, given


@pytest.mark.parametrize("name", LAWS)
def test_a_law_has_the_ports_of_the_diagram_and_starts_of_its_own_and_holds_gains(name):
    law, block = LAWS[name], made(name, feedback=0.0, feedforward=0.0)
    assert (block.name, functions_of(block)) == ("adaptation", N)
    assert not block.feedthrough
    for port, value in law.starts(paper_of(N, name).known_to_law).items():
        assert np.size(value) == block.state_ports[port]
        assert port not in ("alpha", "K", "Gamma")
    if not law.at_fixes:
        found, _ = rates(block)
        assert not np.any([found["K"], found["Gamma"]])


OWN_V = {  # law -> V at the true parameters, if not |e|^2/2
    "dead-zone": lambda e, p: np.sum(np.maximum(np.abs(e) - p.zone, 0.0) ** 2) / 2
}


@pytest.mark.parametrize("name", LAWS)
def test_V_is_zero_at_the_truth_and_e_squared_over_2_beside_it(name):
    block = made(name)
    V = LAWS[name].V(block.parameters, TRUTH)
    assert V.output_ports == {"V": 1}
    assert set(V.input_ports) <= {"e", *block.output_ports}
    at = AT_TRUTH | LAWS[name].starts(paper_of(N, name).known_to_law)
    for e in ([0.0, 0.0],) if LAWS[name].at_fixes else ([0.0, 0.0], [0.3, -0.4]):
        u = np.concatenate([np.ravel(at.get(port, e)) for port in V.input_ports])
        wanted = OWN_V.get(name, lambda e, p: np.dot(e, e) / 2)(e, block.parameters)
        assert V.output(0.0, [], u)[0] == pytest.approx(wanted, abs=1e-15)


@pytest.mark.parametrize("name", ["learned-flow", "known-flow"])
def test_V_weighs_each_error_by_its_gain(name):
    V = LAWS[name].V(made(name).parameters, TRUTH)
    off = {"e": 0.0, "alpha": 0.1, "K": 0.2, "Gamma": 0.3}
    u = np.concatenate(
        [AT_TRUTH.get(port, np.zeros(2)) + off[port] for port in V.input_ports]
    )
    alpha = 2 * N * 0.1**2 / 0.5 if name == "learned-flow" else 0.0
    wanted = (alpha + 2 * 0.2**2 / 0.3 + 2 * 0.3**2 / 0.2) / 2
    assert V.output(0.0, [], u)[0] == pytest.approx(wanted, rel=1e-14)


@pytest.mark.parametrize("name", [name for name in LAWS if name != "known-flow"])
def test_rates_are_read_for_every_N_unless_they_count(name):
    operations = made(name).array_record("update").operations
    counts = name in ("drem", "kalman-flow")  # a determinant, an identity
    assert any("N" in operation.shape for operation in operations) != counts


KEYS = {
    **{
        "learning.gain": 1.3,
        "vehicle.feedback": [1.1, 0.8],
        "vehicle.feedforward": [1.1, -0.6],
    },
    **{
        "vehicle.position": [5.0, 6.0],
        "reference.dwell": 17.0,
        "localization.interval": 6.0,
    },
    **{"localization.latency": 0.5, "localization.noise": 0.2},
    "model.parameters": [[0.1, 0.2], [0.3, 0.4]],
    "learning.parameters": [[0.5, 0.2], [0.3, 0.4]],
    "learning.theta_estimate": [[0.5, 0.2], [0.3, 0.4]],
}


@pytest.mark.parametrize("name", LAWS)
def test_what_a_law_is_made_of_is_what_changes_it(name):
    """A key is in another form in a law where its value changes more than what holds it."""
    law, scenario = LAWS[name], paper_of(N, name)

    def values(known):
        return {**law.parameters_of(known)._asdict(), **law.starts(known)}

    for key, value in KEYS.items():
        try:
            other = scenario.with_values({key: value})
        except ScenarioError:
            continue  # the law has no use for it
        first, second = values(scenario.known_to_law), values(other.known_to_law)
        formed = key in keys_of_law(other)
        held = {
            one
            for one in first
            if not formed and key in keys_of(other, f"adaptation.{one}")
        }
        moved = {one for one in first if not np.array_equal(first[one], second[one])}
        assert bool(moved - held) == formed, (key, moved, held)
