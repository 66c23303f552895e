"""The paper's diagram: its table, its mistakes by name, and what it conserves."""

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.diagrams.interconnection import Diagram
from clpt_control.simulation.starts import initial_state

PAPER = clpt.paper_scenario()

# block | inputs | states | outputs: the table of the design, with N = 3
TABLE = [
    ("reference", {}, {}, {"zc": 2}),
    ("basis_x", {"x": 2}, {}, {"phi_x": 3}),
    ("basis_z", {"z": 2}, {}, {"phi_z": 3}),
    ("true_flow", {"x": 2, "phi_x": 3}, {}, {"flow_x": 2}),
    ("modeled_flow", {"phi_z": 3}, {}, {"flow_z": 2}),
    ("vehicle_controller", {"x": 2, "zc": 2, "phi_x": 3}, {}, {"v_x": 2}),
    ("vehicle", {"flow_x": 2, "v_x": 2}, {"x": 2}, {"x": 2}),
    (
        "learning_controller",
        {"z": 2, "zc": 2, "phi_z": 3, "alpha": 6, "K": 2, "Gamma": 2, "psi": 2},
        {},
        {"v_z": 2},
    ),
    ("learning_model", {"flow_z": 2, "v_z": 2}, {"z": 2}, {"z": 2}),
    ("injection", {"phi_x": 3, "phi_z": 3, "alpha": 6}, {}, {"psi": 2}),
    ("clpe", {"x": 2, "z": 2}, {}, {"e": 2}),
    (
        "adaptation",
        {"e": 2, "phi_x": 3, "z": 2, "zc": 2},
        {"alpha": 6, "K": 2, "Gamma": 2},
        {"alpha": 6, "K": 2, "Gamma": 2},
    ),
]


def flat(ports):
    return [f"{port}[{k}]" for port, size in ports.items() for k in range(size)]


def test_closed_loop_is_the_table():
    loop = clpt.closed_loop(PAPER)
    assert isinstance(loop, control.InterconnectedSystem)
    assert [block.name for block in loop.syslist] == [name for name, *_ in TABLE]
    for block, (_, inputs, states, outputs) in zip(loop.syslist, TABLE, strict=True):
        assert block.input_labels == flat(inputs)
        assert block.state_labels == flat(states)
        assert block.output_labels == flat(outputs)
    assert loop.output_labels == [label for *_, outputs in TABLE for label in flat(outputs)]
    assert loop.ninputs == 0
    assert loop.nstates == 14


KNOWN = {
    "learning.law": "known-flow",
    "learning.parameters": None,
    "learning.theta_estimate": [[0.9, 0.5, 0.7], [1.0, 0.3, 0.9]],
}
SQUARE = {"kind": "square", "amplitude": [0.05, 0.02], "period": 1.7951958}
MAKERS_OF_X = {"true_flow", "vehicle_controller", "vehicle"}


@pytest.mark.parametrize(
    ("values", "external", "without", "states"),
    [
        ({}, "zc", {"reference"}, 14),
        ({}, "x", MAKERS_OF_X, 12),
        ({}, ("x", "zc"), MAKERS_OF_X | {"reference"}, 12),
        (KNOWN, (), set(), 8),  # alpha is an output alone
        ({"flow.disturbance": SQUARE}, (), set(), 14),
    ],
)
def test_blocks_inputs_and_states_of_other_loops(values, external, without, states):
    loop = clpt.closed_loop(PAPER.with_values(values), external=external)
    assert loop.input_labels == [f"{port}[{k}]" for port in np.ravel(external) for k in (0, 1)]
    blocks = {block.name: block for block in loop.syslist}
    made = [name for name, *_ in TABLE if name not in without]
    assert [name for name in blocks if name != "disturbance"] == made
    assert len(clpt.initial_state(loop)) == loop.nstates == states
    assert blocks["adaptation"].output_labels == flat({"alpha": 6, "K": 2, "Gamma": 2})
    if "disturbance" in blocks:
        assert blocks["true_flow"].input_labels == flat({"x": 2, "phi_x": 3, "delta": 2})


def test_initial_state_is_in_the_order_of_the_states():
    scenario = PAPER.with_values(
        {
            "vehicle.position": [1.0, 2.0],
            "learning.position": [3.0, 4.0],
            "learning.parameters": [[5.0, 6.0, 7.0], [8.0, 9.0, 10.0]],
            "learning.feedback": [11.0, 12.0],
            "learning.feedforward": [13.0, 14.0],
        }
    )
    assert initial_state(scenario).tolist() == list(range(1, 15))
    labels = clpt.closed_loop(scenario).state_labels
    ends = [label.split("_")[-1] for label in labels]
    assert ends == flat({"x": 2, "z": 2, "alpha": 6, "K": 2, "Gamma": 2})


def test_a_diagram_stays_a_diagram():
    loop = clpt.closed_loop(PAPER)
    assert isinstance(loop, Diagram)
    twin = loop.copy(name="twin")
    x = np.random.default_rng(2).normal(size=14)
    np.testing.assert_array_equal(twin.dynamics(1.0, x, []), loop.dynamics(1.0, x, []))
    twin.syslist[-1].parameters = twin.syslist[-1].parameters._replace(gain=9.0)
    assert loop.syslist[-1].parameters.gain == 0.8


def test_error_system_reproduces_the_error():
    """Eq. (27) with z eta_3, driven by the closed loop's signals, gives the closed loop's e."""
    loop, errors = clpt.closed_loop(PAPER), clpt.error_loop(PAPER)
    taken = flat({"phi_x": 3, "z": 2, "zc": 2})
    both = control.interconnect(
        [loop, errors],
        connections=[[f"error_loop.{label}", f"closed_loop.{label}"] for label in taken],
        outlist=["closed_loop.e[0]", "closed_loop.e[1]"]
        + [f"error_loop.{label}" for label in errors.output_labels],
        outputs=14,
        inputs=0,
        name="both",
        check_unused=False,
    )
    x0 = clpt.initial_state(PAPER)
    # eta is what the loop's own parameters, of these signs, are away from the truth
    truth = np.concatenate([np.ravel(PAPER.flow.parameters), [-1, -1, 1, 1]])
    sign = np.repeat([1, 1, -1], (6, 2, 2))
    start = np.concatenate([x0, x0[0:2] - x0[2:4], truth + sign * x0[4:]])
    run = clpt.simulate(both, np.arange(0.0, 60.1, 0.5), 0, start, rtol=1e-12, atol=1e-13)
    assert np.abs(run.y[:, :2]).max() > 0.05
    np.testing.assert_allclose(run.y[:, 2:4], run.y[:, :2], atol=1e-9)
    np.testing.assert_allclose(run.y[:, 4:], truth + sign * run.states[:, 4:14], atol=1e-9)
