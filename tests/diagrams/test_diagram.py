"""The paper's diagram: its table, its mistakes by name, and what it conserves."""

import control
import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from clpt_control.blocks import clpe as clpe_block
from clpt_control.blocks import flow, vehicle
from clpt_control.diagrams import wiring
from clpt_control.diagrams.interconnection import Diagram, connect
from clpt_control.equations import Block
from clpt_control.errors import BlockError, DiagramError
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.starts import initial_state

PAPER = clpt.paper_scenario()
KNOWN = PAPER.with_values(
    {
        "learning.law": "known-flow",
        "learning.parameters": None,
        "learning.theta_estimate": [[0.9, 0.5, 0.7], [1.0, 0.3, 0.9]],
    }
)
SQUARE = {"kind": "square", "amplitude": [0.05, 0.02], "period": 1.7951958}
DISTURBED = PAPER.with_values({"flow.disturbance": SQUARE})

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


# --- the table --------------------------------------------------------------------------------


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


def test_known_flow_law_has_fewer_states_and_the_same_outputs():
    loop = clpt.closed_loop(KNOWN)
    law = loop.syslist[-1]
    assert law.state_labels == ["K[0]", "K[1]", "Gamma[0]", "Gamma[1]"]
    assert law.output_labels == flat({"alpha": 6, "K": 2, "Gamma": 2})
    assert loop.nstates == len(initial_state(KNOWN)) == 8


def test_disturbed_flow_takes_delta():
    loop = clpt.closed_loop(DISTURBED)
    blocks = {block.name: block for block in loop.syslist}
    assert blocks["true_flow"].input_labels == flat({"x": 2, "phi_x": 3, "delta": 2})
    assert blocks["disturbance"].output_labels == ["delta[0]", "delta[1]"]
    assert len(loop.syslist) == 13


@pytest.mark.parametrize(
    ("external", "gone", "states"),
    [
        ("zc", {"reference"}, 14),
        ("x", {"true_flow", "vehicle_controller", "vehicle"}, 12),
        (("x", "zc"), {"reference", "true_flow", "vehicle_controller", "vehicle"}, 12),
    ],
)
def test_what_comes_from_outside_leaves_out_what_makes_it(external, gone, states):
    loop = clpt.closed_loop(PAPER, external=external)
    assert loop.input_labels == [f"{port}[{k}]" for port in np.ravel(external) for k in (0, 1)]
    assert [block.name for block in loop.syslist] == [n for n, *_ in TABLE if n not in gone]
    assert len(initial_state(loop)) == loop.nstates == states


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


# --- mistakes, by name ------------------------------------------------------------------------


def follows(t, x, u, p):
    """y = u, Eq. (1): u = a[1], y = b[1]."""
    return u[0]


def follower(name, takes, makes):
    return Block(name, output=follows, inputs={takes: 1}, outputs={makes: 1})


STILL = np.zeros((2, 2)), np.ones(2), np.zeros(2), np.zeros(2)


@pytest.mark.parametrize(
    ("blocks", "external", "said"),
    [
        (
            (follower("first", "a", "b"), follower("second", "a", "b")),
            "a",
            "'b' is made by both first and second",
        ),
        (
            (follower("first", "a", "speed"), follower("second", "sped", "c")),
            "a",
            r"'sped', an input of second, .* no block.*speed",
        ),
        (
            (
                flow.flow_basis("basis_z", "z", "gaussian", *STILL),
                flow.modeled_flow(np.zeros((2, 3))),
            ),
            "z",
            "'phi_z' has 2 signals, but modeled_flow takes 3",
        ),
        (
            (vehicle.vehicle(), follower("first", "flow_x", "b")),
            ("flow_x", "v_x"),
            "'flow_x' has 2 signals, but first takes 1",
        ),
        ((vehicle.vehicle(),), ("flow_x", "v_x", "a"), "'a' cannot come from outside: no block"),
        (
            (vehicle.vehicle(), clpe_block.clpe()),
            ("flow_x", "v_x", "z", "x"),
            "'x' cannot come from outside: vehicle makes it",
        ),
        ((follower("first", "a", "b"), follower("first", "b", "c")), "a", "two .* 'first'"),
        (("vehicle",), (), "'vehicle' is no block"),
    ],
)
def test_what_does_not_fit_is_named(blocks, external, said):
    with pytest.raises(DiagramError, match=said):
        connect(blocks, external)


def test_an_unknown_external_port_is_named():
    with pytest.raises(DiagramError, match=r"external = 'zcc': must be among the ports .*\bzc\b"):
        clpt.closed_loop(PAPER, external=("zcc",))


def test_algebraic_loop_names_its_blocks():
    blocks = [follower("first", "a", "b"), follower("second", "b", "a"), follower("x", "b", "c")]
    with pytest.raises(DiagramError, match=r"loop: .*(first|second).* break .* that has states"):
        wiring.wiring_of(connect(blocks))
    with pytest.raises(DiagramError, match="algebraic loop: mine"):
        wiring.wiring_of(connect([follower("mine", "a", "a")]))


@pytest.mark.parametrize("engine", ["native", "python"])
def test_a_circle_through_an_entry_of_d_that_is_0_is_none(engine):
    """A mass on a spring whose place is fed back, and whose acceleration is measured."""
    A, B, C = (np.array(m) for m in ([[0, 1], [-1, -0.5]], [[0], [1]], [[1, 0], [-1, -0.5]]))
    K = control.ss([], [], [], -2.0, inputs="place", outputs="back", name="K")
    total = control.summing_junction(["back", "r"], "F", name="total")
    mass = control.ss(A, B, C, [[0], [1]], inputs="F", outputs=["place", "pull"], name="mass")
    loop, times = connect([mass, K, total], "r"), np.linspace(0, 5, 11)
    run = clpt.simulate(loop, times, 1.0, rtol=1e-11, atol=1e-12, engine=engine)
    whole = control.ss(A - 2 * B @ C[:1], B, C - [[0, 0], [2, 0]], [[0], [1]])
    expected = control.forced_response(whole, times, np.ones(11)).y
    np.testing.assert_allclose(run.place, expected[0], atol=1e-9)
    np.testing.assert_allclose(run.pull, expected[1], atol=1e-9)
    assert run.attrs["engine"] == engine
    with pytest.raises(clpt.ClptError, match=r"mass\.D"):
        clpt.simulate(loop, times, 1.0, params={"mass.D": [[0.5], [1]]})
    mass.D[0, 0] = 0.5
    with pytest.raises(DiagramError, match="algebraic loop: mass <- total <- K"):
        wiring.wiring_of(connect([mass, K, total], "r"))


# --- parameters at call time ------------------------------------------------------------------


def test_qualified_parameter_reaches_its_block():
    loop, x = clpt.closed_loop(PAPER), np.random.default_rng(1).normal(size=14)
    twice = loop.dynamics(3.0, x, [], params={"adaptation.gain": 1.6})
    once = loop.dynamics(3.0, x, [])
    np.testing.assert_allclose(twice[4:], 2 * once[4:], rtol=1e-14)
    np.testing.assert_array_equal(twice[:4], once[:4])
    np.testing.assert_array_equal(loop.dynamics(3.0, x, []), once)  # and is gone again


def test_qualified_array_reaches_its_block():
    loop = clpt.closed_loop(PAPER)
    still = {"true_flow.theta": np.zeros((2, 3)), "vehicle_controller.GammaD": [0.0, 0.0]}
    rate = loop.dynamics(0.0, [1.0, 2.0, *np.zeros(12)], [], params=still)
    np.testing.assert_array_equal(rate[:2], [-1.0, -2.0])


@pytest.mark.parametrize(
    "name", ["adaptation.gian", "gain", "adaptaton.gain", "adaptation", "adaptation.gain.x", ""]
)
def test_unknown_parameter_is_an_error(name):
    loop, x = clpt.closed_loop(PAPER), np.zeros(14)
    for call in (
        lambda: loop.dynamics(0, x, [], params={name: 1.0}),
        lambda: loop.output(0, x, [], params={name: 1.0}),
        lambda: PythonDiagram(loop, {name: 1.0}),
        lambda: clpt.simulate(loop, [0, 1], initial_state=x, params={name: 1.0}),
        lambda: clpt.simulate(PAPER, [0, 1], params={name: 1.0}),
        lambda: loop.linearize(x, [], params={name: 1.0}),
    ):
        with pytest.raises(BlockError, match=rf"unknown parameter '{name}'.*adaptation\.gain"):
            call()


@pytest.mark.parametrize("value", [[1.0, 2.0], "fast", float("nan")])
def test_wrong_value_is_an_error(value):
    loop = clpt.closed_loop(PAPER)
    with pytest.raises(BlockError, match=r"adaptation\.gain = .*: must be a number, without NaN"):
        loop.dynamics(0, np.zeros(14), [], params={"adaptation.gain": value})


def test_a_diagram_stays_a_diagram():
    loop = clpt.closed_loop(PAPER)
    assert isinstance(loop, Diagram)
    twin = loop.copy(name="twin")
    x = np.random.default_rng(2).normal(size=14)
    np.testing.assert_array_equal(twin.dynamics(1.0, x, []), loop.dynamics(1.0, x, []))
    twin.syslist[-1].parameters = twin.syslist[-1].parameters._replace(gain=9.0)
    assert loop.syslist[-1].parameters.gain == 0.8


# --- one pass gives what python-control gives -------------------------------------------------


# --- what the loop conserves ------------------------------------------------------------------


def test_error_system_reproduces_the_error():
    """Eq. (27) with z eta_3, driven by the closed loop's signals, gives the closed loop's e."""
    loop, errors = clpt.closed_loop(PAPER), clpt.error_loop(PAPER)
    both = control.interconnect(
        [loop, errors],
        connections=[
            [f"error_loop.{port}[{k}]", f"closed_loop.{port}[{k}]"]
            for port, size in (("phi_x", 3), ("z", 2), ("zc", 2))
            for k in range(size)
        ],
        outlist=[f"closed_loop.e[{k}]" for k in range(2)]
        + [f"error_loop.{label}" for label in errors.output_labels],
        outputs=14,
        inputs=0,
        name="both",
        check_unused=False,
    )
    x0 = initial_state(PAPER)
    theta, alpha = np.ravel(PAPER.flow.parameters), x0[4:10]
    eta = np.concatenate([theta + alpha, x0[10:12] - 1.0, 1.0 - x0[12:14]])
    run = response(
        both,
        np.arange(0.0, 60.1, 0.5),
        initial_state=np.concatenate([x0, x0[0:2] - x0[2:4], eta]),
        rtol=1e-12,
        atol=1e-13,
    )
    assert np.abs(run.outputs[0:2]).max() > 0.05
    np.testing.assert_allclose(run.outputs[2:4], run.outputs[0:2], atol=1e-9)
    # and eta is what the loop's own parameters are away from the truth
    states = run.states
    np.testing.assert_allclose(run.outputs[4:10], theta[:, None] + states[4:10], atol=1e-9)
    np.testing.assert_allclose(run.outputs[10:12], states[10:12] - 1.0, atol=1e-9)
    np.testing.assert_allclose(run.outputs[12:14], 1.0 - states[12:14], atol=1e-9)
