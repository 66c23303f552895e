"""Sensitivities along a run: closed forms, and differences of runs on models of many kinds."""

import control
import numpy as np
import pytest
from adaptive_loop import mrac
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control.equations.declaration import Each

EXACT = {"rtol": 1e-12, "atol": 1e-13}


def autonomous(update, **params):
    """A system of one state and no input."""
    ports = {"states": ["x"], "inputs": 0, "outputs": ["x"]}
    return control.nlsys(update, None, name="lag", params=params, **ports)


def decay(k):
    return autonomous(lambda t, x, u, p: [-p["k"] * x[0]], k=k)


def pendulum():
    def update(t, x, u, p):
        pull = -p["g"] / p["l"] * np.sin(x[0])
        return [x[1], pull - p["c"] * x[1] * abs(x[1]) + u[0]]

    return control.nlsys(
        update,
        lambda t, x, u, p: [p["l"] * np.sin(x[0])],
        name="pendulum",
        states=["theta", "omega"],
        inputs=["torque"],
        outputs=["place"],
        params={"g": 9.81, "l": 1.2, "c": 0.3},
    )


def discrete():
    controller = control.ss([[1.0]], [[0.1]], [[0.8]], [[2.0]], True, name="pi", inputs="e",
                            outputs="u")  # fmt: skip

    def update(t, x, u, p):
        return [x[0] + p["h"] * (-p["k"] * x[0] ** 3 + u[0])]

    plant = control.nlsys(update, None, name="plant", states=["x"], inputs=["u"], outputs=["y"],
                          params={"h": 0.1, "k": 0.7}, dt=True)  # fmt: skip
    error = control.summing_junction(["r", "-y"], "e", name="error")
    error.dt = True
    return control.interconnect(
        [controller, plant, error], inputs=["r"], outputs=["y", "u"], name="discrete", dt=True
    )


def sampled_tank():
    """A PI controller at samples of 0.5 s, a tank with a valve that saturates."""

    def level(t, x, u, p):
        inflow = min(max(u.q[0], 0.0), 3.0)
        return [(inflow - p.c * np.sqrt(x.h[0] + 0.01)) / p.area]

    tank = clpt.Block("tank", update=level, inputs={"q": 1}, states={"h": 1},
                      parameters={"c": 1.0, "area": 2.0})  # fmt: skip
    pi = clpt.Block(
        "pi", update=lambda t, x, u, p: [p.target - u.h[0]],
        output=lambda t, x, u, p: [p.kp * (p.target - u.h[0]) + p.ki * x.integral[0]],
        inputs={"h": 1}, outputs={"q": 1}, states={"integral": 1},
        parameters={"kp": 2.0, "ki": 0.7, "target": 1.5},
    )  # fmt: skip
    return clpt.connect([tank, clpt.equations.Sampled(pi, 0.5)], name="level")


def tanks():
    """Two tanks whose areas stand in one array."""

    def update(t, x, u, p):
        return (u[0] - x) / np.array([p["area"], p["wide"]])

    return control.nlsys(update, None, name="tanks", states=2, inputs=1, outputs=2,
                         params={"area": 1.0, "wide": 2.0})  # fmt: skip


def van_der_pol():
    def update(t, x, u, p):
        return [x[1], p["mu"] * (1.0 - x[0] ** 2) * x[1] - x[0]]

    names = {"states": ["x", "v"], "inputs": 0, "outputs": ["x", "v"]}
    return control.nlsys(update, None, name="vdp", params={"mu": 500.0}, **names)


def rooted():
    """A power of a magnitude that begins at zero."""
    return autonomous(lambda t, x, u, p: [p["b"] - np.abs(x[0]) ** 0.3 * x[0]], b=0.6)


PAPER = clpt.closed_loop(clpt.paper_scenario())
STIFF = {"rtol": 1e-11, "atol": 1e-13, "method": "rodas5p"}
MODELS = {  # system, end, parameters, start, tolerances and input, step
    "pendulum": (pendulum(), 5.0, {"g": 9.81, "l": 1.2, "c": 0.3}, [1.0, 0.0],
                 {"inputs": [0.7], **EXACT}, 1e-5),
    "mrac": (mrac(), 5.0, {"a": 1.0, "b": 3.0, "gain": 2.0}, [0.0] * 4,
             {"inputs": [1.0], **EXACT}, 1e-5),
    "discrete": (discrete(), 40.0, {"k": 0.7}, [0.2, 1.0], {"inputs": [1.0]}, 1e-5),
    "tanks": (tanks(), 5.0, {"area": 1.0, "wide": 2.0}, [0.3, 0.1], {"inputs": 1.0, **EXACT}, 1e-5),
    "tank": (sampled_tank(), 7.3, {"tank.c": 1.0, "pi.kp": 2.0, "pi.target": 1.5},
             [0.1, 0.0, 0.0], EXACT, 1e-6),
    "paper": (PAPER, 50.0, {"adaptation.gain": 0.8}, clpt.initial_state(PAPER), EXACT, 1e-4),
    "stiff": (van_der_pol(), 300.0, {"mu": 500.0}, [2.0, 0.0], STIFF, 1e-4),
    "rooted": (rooted(), 2.0, {"b": 0.6}, None, EXACT, 1e-4),
}  # fmt: skip


def by_differences(system, times, start, param, value, h, **given):
    """Return states differentiated by a parameter, or by a state at the start."""
    h *= max(1.0, abs(value or 0.0))
    if isinstance(param, str):
        moved = [{"params": {param: value + step}, "initial_state": start} for step in (h, -h)]
    else:
        moved = [{"initial_state": start + step * np.eye(len(start))[param]} for step in (h, -h)]
    ends = [clpt.simulate(system, times, **given, **one).states.values for one in moved]
    return (ends[0] - ends[1]) / (2.0 * h)


@pytest.mark.parametrize("name", MODELS)
def test_differences_agree(name):
    system, end, params, start, given, h = MODELS[name]
    times = np.arange(0.0, end + 1) if name == "discrete" else np.linspace(0.0, end, 7)
    labels = () if start is None else system.state_labels[: len(start)]  # a held one is no start
    start = start if start is None else np.array(start)
    to = [*params, *(f"x0.{label}" for label in labels)]
    found = clpt.sensitivity(system, times, to=to, initial_state=start, **given).states
    for place, param in enumerate([*params, *range(min(2, len(labels)))]):
        own = by_differences(system, times, start, param, params.get(param), h, **given)
        ours = found.isel(parameter=place).values
        assert np.abs(own - ours).max() < 1e-6 * max(1.0, np.abs(own).max()), param
    if name == "rooted":
        with pytest.raises(clpt.SimulationError, match=r"derivative of d_x.* of block lag"):
            clpt.sensitivity(system, times, to="x0")


def test_closed_forms():
    times = np.linspace(0.0, 2.0, 9)
    found = clpt.sensitivity(decay(2.0), times, "x", ["k", "x0"], initial_state=[3.0], **EXACT)
    assert found.x.sel(parameter="k").values == pytest.approx(-times * 3 * np.exp(-2 * times))
    assert found.x.sel(parameter="x0.x").values == pytest.approx(np.exp(-2 * times))
    plant = control.ss([[0.0, 1.0], [-2.0, -0.3]], [[0.0], [1.0]], np.eye(2), 0, name="plant")
    found = clpt.sensitivity(plant, times, to=["plant.A[1,0]", "x0"], initial_state=[1.0, 0.0],
                             **EXACT)  # fmt: skip
    big = np.kron(np.eye(2), plant.A) + np.kron([[0, 0], [1, 0]], [[0, 0], [1, 0]])
    for k, t in enumerate(times):  # Van Loan: the exponential of a matrix and of its slope
        whole = expm(t * big)
        assert found.states[k, :, 1:].values == pytest.approx(expm(t * plant.A), abs=1e-9)
        assert found.states[k, :, 0].values == pytest.approx(whole[2:, 0], abs=1e-9)


def test_outputs_are_chosen_and_named():
    times = [0.0, 1.0]
    found = clpt.sensitivity(mrac(), times, of=["e", "states"], to="gain", inputs=1.0)
    assert list(found) == ["e", "states"]
    assert list(found.parameter.values) == ["gain"]
    units = clpt.sensitivity(clpt.connect([teeth()]), times, "x", "teeth.slope").x.attrs["units"]
    assert units == "m per unit of the parameter"
    scenario = clpt.paper_scenario()
    found = clpt.sensitivity(scenario, times, of=["e"], to=["adaptation.gain", "vehicle_x"])
    assert [*found.parameter.values[1:]] == ["x0.vehicle_x[0]", "x0.vehicle_x[1]"]
    assert found.e.dims == ("time", "e_index", "parameter")


def teeth():
    return clpt.Block(
        "teeth",
        update=lambda t, x, u, p: [p.slope],
        states={"x": 1},
        jump=lambda t, x, u, p: [0.5 * x[0]],
        breakpoints=Each("period"),
        parameters={"slope": 1.0, "period": 1.0, "interval": -1.0},
        units={"x": "m"},
    )


def stepping(before=1.0, behind=3.0, little=0.0):
    """Its rate jumps where x is the edge, or 1 and a little of it."""

    def update(t, x, u, p):
        edge = 1.0 + little * p["edge"] if little else p["edge"]
        return [before if x[0] < edge else behind]

    return autonomous(update, edge=1.0)


def with_output(output, rate, **params):
    names = {"name": "faster", "inputs": 0, "outputs": ["y"], "states": ["x"]}
    return control.nlsys(lambda t, x, u, p: [rate(x[0], p)], output, params=params, **names)


SLOWER = with_output(  # x + k changes by 0.995 with k; without the jump by 1
    lambda t, x, u, p: x + p["k"], lambda x, p: -1.0 - 0.005 * (x < p["k"]), k=0.5
)
FASTER = with_output(  # x = 3 (t + x0) - 2 a behind, beside w, whose effect is larger
    lambda t, x, u, p: x + p["w"] * t, lambda x, p: np.where(x < p["a"], 1.0, 3.0), a=1.0, w=1e5
)
PULSE = autonomous(lambda t, x, u, p: [1.0 if t < p["until"] else 0.0], until=1.0)
HEADING = autonomous(
    lambda t, x, u, p: [np.arctan2(np.sin(p["k"] * t), np.cos(p["k"] * t))], k=np.pi
)
SAW = autonomous(lambda t, x, u, p: [np.arctan(np.tan(p["k"] * t))], k=np.pi / 2)
BESIDE = np.array([0.0, 0.51, 1.51, 3.51])  # no sample lies on a jump
MOVED = {  # system, what moves its jump, start
    "a jump that is crossed": (stepping(), "edge", 0.0),  # x = edge + 3 (t - edge)
    "one of half a percent": (SLOWER, "k", 1.0),  # x = k - 1.005 (t + k - 1)
    "one that moves little": (stepping(little=1e-4), "edge", 0.0),
    "one that moves less": (stepping(little=1e-5), "edge", 0.0),  # rounding hid it, S was 0
    "one where the run begins": (stepping(-1.0, 1.0), "edge", 1.0),  # no difference has a limit
    "a time": (PULSE, "until", 0.0),  # x = until
    "a period": (clpt.connect([teeth()]), "teeth.period", 0.0),  # t - (3 - 7/8) P
    "a heading": (HEADING, "k", 0.0),  # x = k v^2/2, v = t - 2 pi n/k
    "a saw": (SAW, "k", 0.0),  # the same, of period pi/k
    "one of the start": (FASTER, "x0.x", 0.0),
    "one beside a large effect": (FASTER, ("w", "a"), 0.0),
}


@pytest.mark.parametrize("name", MOVED)
def test_what_moves_a_jump_is_refused(name):
    system, to, start = MOVED[name]
    said = f"do not confirm its derivative by {to if isinstance(to, str) else to[-1]}"
    for times in (BESIDE, [0.0, 0.5, 1.0, 3.51], [0.0, 3.51]):
        with pytest.raises(clpt.SimulationError, match=said):
            clpt.sensitivity(system, times, to=to, initial_state=[start])


def test_an_endless_limit_beside_a_jump_moves_nothing():
    """There is no run a little to both sides of infinity: it ended in a traceback."""
    system = autonomous(
        lambda t, x, u, p: [np.clip(np.where(x[0] < 1.0, 1.0, 3.0), -1.0, p["high"])],
        **{"high": np.inf},
    )
    found = clpt.sensitivity(system, [0.0, 0.5, 2.0], to=["high"]).x
    assert found.values[-1] == pytest.approx([0.0])


def test_before_and_behind_a_jump_all_is_known():
    before = clpt.sensitivity(stepping(), np.linspace(0.0, 0.5, 6), to="edge")
    assert not before.x.values.any()
    times = np.linspace(0.0, 3.5, 36)
    found = clpt.sensitivity(clpt.connect([teeth()]), times, "x", ["teeth.slope", "x0"])
    assert found.x[-1].values == pytest.approx([0.5 + 0.875, 0.125])  # S halves at each jump


def test_systems_without_a_state_an_element_or_a_derivative():
    ports = {"inputs": 1, "params": {"k": 2.0}}
    gain, odd_name = (
        control.nlsys(None, lambda t, x, u, p: [p["k"] * u[0]], outputs=[output], **ports)
        for output in ("y", "parameter")
    )
    found = clpt.sensitivity(gain, [0.0, 1.0], to="k", inputs=3.0)
    assert found.y.values.tolist() == [[3.0], [3.0]]
    for system, to, said in (
        (gain, "x0", "to: nothing is varied"),
        (odd_name, "k", "parameter: is a dimension"),
        (control.ss(1, 1, 1, 0, name="p"), "p.A[1,0]", "or an element, counted from 0"),
        (autonomous(lambda t, x, u, p: [float(str(x[0]))]), "x0", "lag: has no .*<lambda>"),
    ):
        with pytest.raises(clpt.SimulationError, match=said):
            clpt.sensitivity(system, [0.0, 1.0], to=to)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"to": "n"}, r"n: .*asks for its value"),
        ({"to": "q"}, r"must be among k, lag\.k, lag\.n, n, x, x0"),
        ({"to": "plant.k"}, r"did you mean k\?"),
        ({"to": "k", "of": "q"}, "must be among x, states"),
        ({"to": []}, "to: nothing is varied"),
    ],
)
def test_what_is_not_known_is_said(given, said):
    asking = lambda t, x, u, p: [-p["k"] * x[0] if p["n"] > 2 else -x[0]]  # noqa: E731
    with pytest.raises(clpt.SimulationError, match=said):
        clpt.sensitivity(autonomous(asking, k=1.0, n=3.0), [0.0, 1.0], **given)


def test_vehicles_that_have_met_are_not_misread():
    """At rest rates are rounding alone, and stay so where all move by the same."""

    def update(t, x, u, p):
        place = x.reshape(-1, 2)
        apart = place[:, None, :] - place[None, :, :]
        near = ((apart**2).sum(-1) + 0.1) ** 1.5
        pull = (apart / near[..., None]).sum(1)
        return (0.3 * (np.mean(place, axis=0) - place) - p["g"] * pull).ravel()

    meeting = control.nlsys(
        update, None, name="meeting", inputs=0, states=6, outputs=6, params={"g": 0.2}
    )
    start, times = [0, 0, 1, 0.2, 0.3, 1], np.linspace(0.0, 2.0, 21)
    for to in ("g", "x0"):
        found = clpt.sensitivity(meeting, times, to=to, initial_state=start, **EXACT)
        end = found.y[-1].values
        mean = 0.0 if to == "g" else np.tile(np.eye(2), (3, 3)) / 3.0
        np.testing.assert_allclose(end, mean + 0.0 * end, atol=1e-9)


def test_a_page_shows_sensitivities(tmp_path):
    found = clpt.sensitivity(decay(2.0), [0.0, 0.5, 1.0], to="k", initial_state=[3.0])
    clpt.report(found, tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text("utf-8")
    assert "x parameter k" in text
    assert f"{-3 * np.exp(-2.0):.6g}" in text  # dx/dk = -t x0 exp(-k t)
