"""Sensitivities along a run: closed forms, and differences of runs on models of many kinds."""

import control
import numpy as np
import pytest
from engine_runs import Each
from example_models import MODELS, autonomous, decay, mrac, stepping
from scipy.linalg import expm

import clpt_control as clpt

EXACT = {"rtol": 1e-12, "atol": 1e-13}


@pytest.mark.parametrize(
    "name", [name for name, model in MODELS.items() if model.varied]
)
def test_differences_agree(name):
    system, start, u, h, params, move = MODELS[name]
    labels, start, times = (
        system.state_labels,
        np.array(start),
        100.0 * h * np.arange(6),
    )
    given = {"inputs": u or 0.0, **({} if name == "discrete" else EXACT)}
    given |= {"method": "rodas5p", "rtol": 1e-11} if name == "stiff" else {}
    of_start = [] if name == "root" else labels[: len(start)]
    to = [*params, *(f"x0.{label}" for label in of_start)]
    found = clpt.sensitivity(system, times, to=to, initial_state=start, **given).states
    for place, param in enumerate([*params, *range(len(of_start[:2]))]):
        step, moved = move * max(1.0, abs(params.get(param, 0.0))), []
        for by in (step, -step):
            if param in params:
                moved.append(
                    {"params": {param: params[param] + by}, "initial_state": start}
                )
            else:
                moved.append({"initial_state": start + by * np.eye(len(start))[param]})
        more, less = (
            clpt.simulate(system, times, **given, **one).states.values for one in moved
        )
        own = (more - less) / (2.0 * step)
        ours = found.isel(parameter=place).values
        assert np.abs(own - ours).max() < 1e-6 * max(1.0, np.abs(own).max()), param
    if name == "root":
        with pytest.raises(
            clpt.SimulationError, match=r"derivative of d_x.* of block lag"
        ):
            clpt.sensitivity(system, times, to="x0")


def test_closed_forms():
    times = np.linspace(0.0, 2.0, 9)
    found = clpt.sensitivity(
        decay(2.0), times, "x", ["k", "x0"], initial_state=[3.0], **EXACT
    )
    assert found.x.sel(parameter="k").values == pytest.approx(
        -times * 3 * np.exp(-2 * times)
    )
    assert found.x.sel(parameter="x0.x").values == pytest.approx(np.exp(-2 * times))
    plant = control.ss(
        [[0.0, 1.0], [-2.0, -0.3]], [[0.0], [1.0]], np.eye(2), 0, name="plant"
    )
    found = clpt.sensitivity(plant, times, to=["plant.A[1,0]", "x0"], initial_state=[1.0, 0.0],
                             **EXACT)  # fmt: skip
    big = np.kron(np.eye(2), plant.A) + np.kron([[0, 0], [1, 0]], [[0, 0], [1, 0]])
    for k, t in enumerate(times):
        # Van Loan: the exponential of a matrix and of its slope
        whole = expm(t * big)
        assert found.states[k, :, 1:].values == pytest.approx(
            expm(t * plant.A), abs=1e-9
        )
        assert found.states[k, :, 0].values == pytest.approx(whole[2:, 0], abs=1e-9)


def test_outputs_are_chosen_and_named():
    times = [0.0, 1.0]
    found = clpt.sensitivity(mrac(), times, of=["e", "states"], to="gain", inputs=1.0)
    assert (list(found), list(found.parameter.values)) == (["e", "states"], ["gain"])
    units = clpt.sensitivity(
        clpt.connect([teeth()]), times, "x", "teeth.slope"
    ).x.attrs["units"]
    assert units == "m per unit of the parameter"
    both = {"of": ["e"], "to": ["adaptation.gain", "vehicle_x"]}
    found = clpt.sensitivity(clpt.paper_scenario(), times, **both)
    assert [*found.parameter.values[1:]] == ["x0.vehicle_x[0]", "x0.vehicle_x[1]"]
    assert found.e.dims == ("time", "e_index", "parameter")


def teeth():
    ports = {"states": {"x": 1}, "breakpoints": Each("period"), "units": {"x": "m"}}
    ports["parameters"] = {"slope": 1.0, "period": 1.0, "interval": -1.0}
    halved = lambda t, x, u, p: [0.5 * x[0]]  # noqa: E731
    return clpt.Block(
        "teeth", update=lambda t, x, u, p: [p.slope], jump=halved, **ports
    )


def with_output(output, rate, **params):
    names = {"name": "faster", "inputs": 0, "outputs": ["y"], "states": ["x"]}
    return control.nlsys(
        lambda t, x, u, p: [rate(x[0], p)], output, params=params, **names
    )


SLOWER = with_output(  # x + k changes by 0.995 with k; without the jump by 1
    lambda t, x, u, p: x + p["k"], lambda x, p: -1.0 - 0.005 * (x < p["k"]), k=0.5
)
FASTER = with_output(  # x = 3 (t + x0) - 2 a behind, beside w, whose effect is larger
    lambda t, x, u, p: x + p["w"] * t,
    lambda x, p: np.where(x < p["a"], 1.0, 3.0),
    a=1.0,
    w=1e5,
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
    "one that moves less": (
        stepping(little=1e-5),
        "edge",
        0.0,
    ),  # rounding hid it, S was 0
    "one where the run begins": (
        stepping(-1.0, 1.0),
        "edge",
        1.0,
    ),  # no difference has a limit
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
    rate = lambda t, x, u, p: [np.clip(np.where(x[0] < 1.0, 1.0, 3.0), -1.0, p["high"])]  # noqa: E731
    found = clpt.sensitivity(
        autonomous(rate, high=np.inf), [0.0, 0.5, 2.0], to=["high"]
    ).x
    assert found.values[-1] == pytest.approx([0.0])


def test_before_and_behind_a_jump_all_is_known():
    before = clpt.sensitivity(stepping(), np.linspace(0.0, 0.5, 6), to="edge")
    assert not before.x.values.any()
    times = np.linspace(0.0, 3.5, 36)
    found = clpt.sensitivity(clpt.connect([teeth()]), times, "x", ["teeth.slope", "x0"])
    # S halves at each jump
    assert found.x[-1].values == pytest.approx([0.5 + 0.875, 0.125])


def gain(output):
    ports = {"inputs": 1, "outputs": [output], "params": {"k": 2.0}}
    return control.nlsys(None, lambda t, x, u, p: [p["k"] * u[0]], **ports)


def test_systems_without_a_state():
    found = clpt.sensitivity(gain("y"), [0.0, 1.0], to="k", inputs=3.0)
    assert found.y.values.tolist() == [[3.0], [3.0]]


ASKING = autonomous(
    lambda t, x, u, p: [-p["k"] * x[0] if p["n"] > 2 else -x[0]], k=1.0, n=3.0
)
UNKNOWN = [
    (gain("y"), {"to": "x0"}, "to, or .*: no parameters"),
    (gain("parameter"), {"to": "k"}, "parameter: is a dimension"),
    (
        control.ss(1, 1, 1, 0, name="p"),
        {"to": "p.A[1,0]"},
        "or an element, counted from 0",
    ),
    (
        autonomous(lambda t, x, u, p: [float(str(x[0]))]),
        {"to": "x0"},
        "lag: has no .*<lambda>",
    ),
    (ASKING, {"to": "n"}, r"n: .*asks for its value"),
    (ASKING, {"to": "q"}, r"'q': is no .* It has k, lag\.k, lag\.n, n, x, x0"),
    (ASKING, {"to": "plant.k"}, r"Did you mean 'k'\?"),
    (ASKING, {"to": "k", "of": "q"}, "of: there is no q. It has x, states"),
    (ASKING, {"to": []}, "to, or .*: no parameters"),
]


@pytest.mark.parametrize(("system", "given", "said"), UNKNOWN)
def test_what_is_not_known_is_said(system, given, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.sensitivity(system, [0.0, 1.0], **given)


def meeting(t, x, u, p):
    place = x.reshape(-1, 2)
    apart = place[:, None, :] - place[None, :, :]
    near = ((apart**2).sum(-1) + 0.1) ** 1.5
    pull = (apart / near[..., None]).sum(1)
    return (0.3 * (np.mean(place, axis=0) - place) - p["g"] * pull).ravel()


def test_vehicles_that_have_met_are_not_misread():
    """At rest rates are rounding alone, and stay so where all move by the same."""
    three = control.nlsys(meeting, inputs=0, states=6, outputs=6, params={"g": 0.2})
    start, times = [0, 0, 1, 0.2, 0.3, 1], np.linspace(0.0, 2.0, 21)
    for to, mean in (("g", 0.0), ("x0", np.tile(np.eye(2), (3, 3)) / 3.0)):
        end = (
            clpt.sensitivity(three, times, to=to, initial_state=start, **EXACT)
            .y[-1]
            .values
        )
        np.testing.assert_allclose(end, mean + 0.0 * end, atol=1e-9)


def test_a_page_shows_sensitivities(tmp_path):
    found = clpt.sensitivity(decay(2.0), [0.0, 0.5, 1.0], to="k", initial_state=[3.0])
    clpt.report(found, tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text("utf-8")
    assert "x parameter k" in text
    assert f"{-3 * np.exp(-2.0):.6g}" in text  # dx/dk = -t x0 exp(-k t)


def test_states_below_atol_are_told_from_jumps():
    """Two rates of growth, one after the other, from 3e-12: x0 exp(a + 9 b) at t = 10."""

    def rates(t, x, u, p):
        return [(p["a"] if t <= 1.0 else p["b"]) * x[0], 1.0 - x[1]]

    grown = control.nlsys(
        rates, inputs=0, outputs=["x", "y"], states=2, params={"a": 0.9, "b": 0.4},
        name="grown",
    )  # fmt: skip
    given = grown, [0.0, 10.0], "x", ["b"], None, [3e-12, 0.0]
    with pytest.raises(clpt.SimulationError, match="Give an atol far below the sizes"):
        clpt.sensitivity(*given)
    found = clpt.sensitivity(*given, atol=1e-24)
    right = 9.0 * 3e-12 * np.exp(0.9 + 9.0 * 0.4)
    assert found.x[-1].item() == pytest.approx(right, rel=1e-6)
