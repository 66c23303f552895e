"""Diagrams joined by the names of their ports; the table of the paper's, what it conserves."""

import control
import numpy as np
import pytest
from engine_runs import Diagram, wiring_of
from error_sentences import says

import clpt_control as clpt
from clpt_control import BlockError, DiagramError

TIMES = np.linspace(0.0, 3.0, 7)
ENGINES = ("native", "python")


def leak(k, name, u, y):
    rate = lambda t, x, u, p: -p["k"] * x + u  # noqa: E731
    return control.nlsys(
        rate, inputs=u, outputs=y, states=1, params={"k": k}, name=name
    )


def through(name, takes, makes):
    """A block that hands one signal on."""
    return control.ss([], [], [], 1.0, inputs=takes, outputs=makes, name=name)


def with_a_law(**own):
    """A tank and its controller, which has no error yet."""
    return [clpt.parts.lag(1.0, y="h"), clpt.parts.pid(1, 0.1, y="h", **own)]


PAPER = clpt.paper_scenario()
PAPERS = clpt.paper_blocks(PAPER)
NAMED = {block.name: block for block in PAPERS}
VEHICLE = NAMED["vehicle"]
BASIS = clpt.Block(
    "basis_z", output=lambda t, x, u, p: u.z, inputs={"z": 2}, outputs={"phi_z": 2}
)
UNFIT = [
    (
        with_a_law(),
        (),
        r"'r'.*there are h, u\. Give .*external='r' supplies it from outside",
    ),
    (with_a_law(), "rr", r"did you mean rr\?; there are h, rr, u"),
    (
        with_a_law(signals=2),
        "r",
        "'u' has 2 signals, but lag takes 1; both must have one size",
    ),
    ([BASIS, NAMED["modeled_flow"]], "z", "'phi_z' has 2 signals, but modeled_flow"),
    (
        [VEHICLE, through("a", "flow_x", "b")],
        ("flow_x", "v_x"),
        "'flow_x' has 2 .* but a takes 1",
    ),
    ([VEHICLE], ("flow_x", "v_x", "a"), "'a' cannot come from outside: no block"),
    (
        [VEHICLE],
        ("flow_x", "v_x", "x"),
        "'x' cannot come from outside: vehicle makes it",
    ),
    (
        [through("a", "u", "y"), through("b", "u", "y")],
        "u",
        "'y' is made by both a and b",
    ),
    (
        [through("a", "u", "speed"), through("b", "sped", "y")],
        "u",
        "'sped', an .* of b, .*speed",
    ),
    ([through("a", "u", "v"), through("a", "v", "w")], "u", "two .* 'a'"),
    (
        [through("a", "u", "v"), through("b", "v", "u")],
        (),
        "loop: .*[ab].* Insert a block .* states alone",
    ),
    ([through("mine", "u", "u")], (), "algebraic loop: mine"),
    (["vehicle"], (), "'vehicle' is not a block. Give"),
    ([control.tf(1, [1, 1])], "u", r"a TransferFunction without a name: .* name='lag'"),
    (
        [*PAPERS, control.ss(-1, 1, 1, 0, True, name="held")],
        "u",
        "held: dt = True is not a sampling time",
    ),
    (
        [control.tf([1, 0, 1], [1, 1], name="pd")],
        "u",
        r"pd: a numerator of higher .* fast pole",
    ),
    (
        [control.nlsys(lambda t, x, u, p: -x, states=1, name="q")],
        (),
        "q: the numbers of inputs",
    ),
    ([*PAPERS, through("p", "zc", "q")], (), r"'zc' has 2 .*signals="),
]


@pytest.mark.parametrize(
    ("blocks", "external", "said"), UNFIT, ids=[said for *_, said in UNFIT]
)
def test_what_does_not_fit_is_said_with_a_cure(blocks, external, said):
    with pytest.raises(clpt.ClptError, match=rf"\A.*{said}.*\Z"):
        wiring_of(clpt.connect(blocks, external))


def handing_on(name, port, to, unit):
    ports = {
        "inputs": {port: 1},
        "outputs": {to: 1},
        "units": {"e": unit} if unit else None,
    }
    return clpt.Block(name, output=lambda t, x, u, p: [u[0]], **ports)


def test_a_port_has_one_unit():
    sonar, log = (
        handing_on("sonar", "r", "e", "km"),
        handing_on("log", "e", "v", "m s-1"),
    )
    for maker, external, fits, does_not in (
        (sonar, "r", ("km", None), "m"),
        (log, "e", ("m/s",), "knots"),
    ):
        for unit in fits:
            clpt.connect([maker, handing_on("law", "e", "y", unit)], external)
        with pytest.raises(
            DiagramError, match=rf"'e' is in '.*' at {maker.name} and in .* at law"
        ):
            clpt.connect([maker, handing_on("law", "e", "y", does_not)], external)


def test_two_values_of_one_parameter_are_refused():
    """python-control gives both systems that of the last."""
    with pytest.raises(
        DiagramError, match=r"k = 3\.0 of two is 1\.0 of one: .*{'one\.k': \.\.\.}"
    ):
        clpt.connect(
            [leak(1.0, "one", "u", "v"), leak(3.0, "two", "v", "y")], external="u"
        )
    loop = clpt.connect(
        [leak(3.0, "one", "u", "v"), leak(3.0, "two", "v", "y")], external="u"
    )
    run = clpt.simulate(loop, TIMES, 1.0, params={"one.k": 1.0})
    np.testing.assert_allclose(run.v, 1 - np.exp(-TIMES), atol=1e-7)


@pytest.mark.long
def test_one_vehicle_of_two_diagrams_is_reached_by_its_name():
    own = clpt.closed_loop(PAPER)
    a, b = own.copy(name="a"), own.copy(name="b")
    ports = {"outlist": ["a.e[0]", "b.e[0]"], "outputs": 2, "check_unused": False}
    both = control.interconnect([a, b], **ports)
    x, start = (
        np.random.default_rng(1).normal(size=28),
        [*clpt.initial_state(PAPER)] * 2,
    )
    one, two = (own.dynamics(1.0, half, [])[4:] for half in (x[:14], x[14:]))
    for changes, factors in (
        ({"a.adaptation.gain": 1.6}, (2, 1)),
        ({"adaptation.gain": 1.6}, (2, 2)),
        ({"adaptation.gain": 1.6, "a.adaptation.gain": 2.4}, (3, 2)),
    ):
        rate = both.dynamics(1.0, x, [], params=changes)
        np.testing.assert_allclose(rate[4:14], factors[0] * one, rtol=1e-13)
        np.testing.assert_allclose(rate[18:], factors[1] * two, rtol=1e-13)
        runs = [
            clpt.simulate(both, [0, 3], 0, start, changes, engine=e, rtol=1e-10)
            for e in ENGINES
        ]
        np.testing.assert_allclose(runs[0].states, runs[1].states, rtol=0, atol=1e-8)
    with pytest.raises(BlockError, match=r"unknown parameter 'c\.adaptation\.gain'"):
        clpt.simulate(both, [0, 3], 0, start, params={"c.adaptation.gain": 2.0})
    says(
        DiagramError,
        r"made by both a and b.*control\.interconnect",
        clpt.connect,
        [a, b],
    )


def test_states_and_inputs_that_do_not_fit():
    lags = [
        control.ss(-1, [[1, 1]], 1, 0, name="a", inputs=["u[0]", "u[1]"], outputs="y")
    ]
    loop = clpt.connect(
        [*lags, control.ss(-1, 1, 1, 0, name="b", inputs="y", outputs="w")], "u"
    )
    with pytest.raises(clpt.ArgumentError, match=r"initial_state = .*: must have 2"):
        clpt.simulate(loop, TIMES, 0, [[1, 2], [3, 4], 0])
    for inputs in ([TIMES[1:], 0], [[TIMES, TIMES], TIMES], [TIMES, "fast"]):
        says(clpt.ClptError, "inputs", clpt.simulate, loop, TIMES, inputs)


def test_ports_in_another_order_than_their_makers():
    def block(name, inputs, outputs):
        return clpt.Block(
            name, output=lambda t, x, u, p: u, inputs=inputs, outputs=outputs
        )

    last = block("last", {"d": 1, "c": 2, "w": 1}, {"e": 4})
    middle = block("middle", {"b": 2, "a": 2}, {"c": 2, "d": 1, "f": 1})
    blocks = [last, middle, block("first", {"w": 1, "v": 3}, {"a": 2, "b": 2})]
    for external, values in ((["v", "w"], [1, 2, 3, 4]), (["w", "v"], [4, 1, 2, 3])):
        run = clpt.simulate(clpt.connect(blocks, external), [0.0, 1.0], values)
        # d, c, w of a = [4, 1], b = [2, 3]
        assert run.e[0].values.tolist() == [4, 2, 3, 4]


def test_a_part_of_a_port_that_nothing_feeds_is_zero():
    """As in python-control, also where its signals go on one by one."""
    half = clpt.Block(
        "half", output=lambda t, x, u, p: u.u[2:], inputs={"u": 4}, outputs={"y": 2}
    )
    plus = clpt.Block(
        "plus",
        output=lambda t, x, u, p: u.w + u.r,
        inputs={"w": 1, "r": 1},
        outputs={"z": 1},
    )
    loop = control.interconnect(
        [half, plus],
        connections=[["plus.w", "half.y[1]"]],
        inplist=["plus.r"],
        inputs=["r"],
        outlist=["plus.z"],
        outputs=["z"],
        check_unused=False,
    )
    assert clpt.simulate(loop, [0.0, 1.0], 3.0).z.values.tolist() == [3.0, 3.0]
    assert control.input_output_response(loop, [0.0, 1.0], 3.0).outputs.tolist() == [
        3.0,
        3.0,
    ]


# block | inputs | states | outputs: the table of the design, with N = 3
DESIGN = """
    reference           |                                    |                 | zc 2
    basis_x             | x 2                                |                 | phi_x 3
    basis_z             | z 2                                |                 | phi_z 3
    true_flow           | x 2 phi_x 3                        |                 | flow_x 2
    modeled_flow        | phi_z 3                            |                 | flow_z 2
    vehicle_controller  | x 2 zc 2 phi_x 3                   |                 | v_x 2
    vehicle             | flow_x 2 v_x 2                     | x 2             | x 2
    learning_controller | z 2 zc 2 phi_z 3 alpha 6 K 2 Gamma 2 psi 2 |         | v_z 2
    learning_model      | flow_z 2 v_z 2                     | z 2             | z 2
    injection           | phi_x 3 phi_z 3 alpha 6            |                 | psi 2
    clpe                | x 2 z 2                            |                 | e 2
    adaptation          | e 2 phi_x 3 z 2 zc 2 | alpha 6 K 2 Gamma 2 | alpha 6 K 2 Gamma 2
"""
ROWS = [line.split("|") for line in DESIGN.splitlines()[1:]]
TABLE = {name.strip(): ports for name, *ports in ROWS}


def flat(ports):
    """Labels of the signals of ports, written as `x 2 phi_x 3`."""
    words = ports.split()
    sizes = zip(words[::2], map(int, words[1::2]), strict=True)
    return [f"{port}[{k}]" for port, size in sizes for k in range(size)]


def test_closed_loop_is_the_table():
    loop = clpt.closed_loop(PAPER)
    assert isinstance(loop, control.InterconnectedSystem)
    labels = {
        b.name: [b.input_labels, b.state_labels, b.output_labels] for b in loop.syslist
    }
    assert [*labels.items()] == [
        (name, [*map(flat, ports)]) for name, ports in TABLE.items()
    ]
    assert loop.output_labels == [
        label for *_, ports in TABLE.values() for label in flat(ports)
    ]
    assert (loop.ninputs, loop.nstates) == (0, 14)


KNOWN = {"learning.law": "known-flow", "learning.parameters": None}
KNOWN["learning.theta_estimate"] = [[0.9, 0.5, 0.7], [1.0, 0.3, 0.9]]
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
    assert loop.input_labels == [
        f"{port}[{k}]" for port in np.ravel(external) for k in (0, 1)
    ]
    blocks = {block.name: block for block in loop.syslist}
    made = [name for name in TABLE if name not in without]
    assert [name for name in blocks if name != "disturbance"] == made
    assert len(clpt.initial_state(loop)) == loop.nstates == states
    assert blocks["adaptation"].output_labels == flat("alpha 6 K 2 Gamma 2")
    if "disturbance" in blocks:
        assert blocks["true_flow"].input_labels == flat("x 2 phi_x 3 delta 2")


def test_initial_state_is_in_the_order_of_the_states():
    start = {"position": [3.0, 4.0], "parameters": [[5.0, 6.0, 7.0], [8.0, 9.0, 10.0]]}
    start |= {"feedback": [11.0, 12.0], "feedforward": [13.0, 14.0]}
    learning = {f"learning.{key}": value for key, value in start.items()}
    scenario = PAPER.with_values({"vehicle.position": [1.0, 2.0], **learning})
    assert clpt.initial_state(scenario).tolist() == list(range(1, 15))
    ends = [label.split("_")[-1] for label in clpt.closed_loop(scenario).state_labels]
    assert ends == flat("x 2 z 2 alpha 6 K 2 Gamma 2")


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
    loop, errors = clpt.closed_loop(PAPER), clpt.closed_loop(PAPER, errors=True)
    taken, e = flat("phi_x 3 z 2 zc 2"), ["closed_loop.e[0]", "closed_loop.e[1]"]
    ports = {
        "connections": [
            [f"error_loop.{label}", f"closed_loop.{label}"] for label in taken
        ]
    }
    ports["outlist"] = e + [f"error_loop.{label}" for label in errors.output_labels]
    both = control.interconnect(
        [loop, errors], outputs=14, inputs=0, check_unused=False, **ports
    )
    x0 = clpt.initial_state(PAPER)
    # eta is what the loop's own parameters, of these signs, are away from the truth
    truth = np.concatenate([np.ravel(PAPER.flow.parameters), [-1, -1, 1, 1]])
    sign = np.repeat([1, 1, -1], (6, 2, 2))
    start = np.concatenate([x0, x0[0:2] - x0[2:4], truth + sign * x0[4:]])
    run = clpt.simulate(
        both, np.arange(0.0, 60.1, 0.5), 0, start, rtol=1e-12, atol=1e-13
    )
    assert np.abs(run.y[:, :2]).max() > 0.05
    np.testing.assert_allclose(run.y[:, 2:4], run.y[:, :2], atol=1e-9)
    np.testing.assert_allclose(
        run.y[:, 4:], truth + sign * run.states[:, 4:14], atol=1e-9
    )
