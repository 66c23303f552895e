"""Where a run ends: guards of one's own, and the first number that is not finite."""

import control
import numpy as np
import pytest
from engine_runs import ENGINES, LANES, NativeDiagram, Status, side_by_side, wiring_of
from error_sentences import says
from text_systems import written

import clpt_control as clpt
from clpt_control import Guard


def height(t, x, u, p):
    return x[0]


def landed(t, u, p):
    return f"it landed at time {t:g}"


def falling(**guard):
    own = {"distance": height, "policy": "raise", "sentence": landed, **guard}
    return moving(-1.0, Guard(**own))


def moving(rate, guard):
    return clpt.Block(
        "stone", update=lambda t, x, u, p: rate, states={"h": 1}, guard=guard
    )


every_engine = pytest.mark.parametrize("engine", ["native", "python"])
every_form = pytest.mark.parametrize("engine", ENGINES)


@every_form
def test_a_look_that_meets_the_edge_itself_finds_the_crossing(engine):
    def on_the_edge(
        t, x, u, p
    ):  # by less than rounding cannot make, then far beyond it
        return np.where(x[0] < 0.25, 1.0, np.where(x[0] < 0.6, -5e-10, -1.0))

    stone = moving(1.0, Guard(on_the_edge, "stop", landed))
    assert (
        0.25 - 1e-15
        <= ENGINES[engine](stone).run([0.0], [0.0, 2.0], max_step=1.0).t[-1]
        < 0.6 + 1e-11
    )


@every_form
@pytest.mark.parametrize(
    ("start", "advice", "said"), [(2, "", 2), (2, "drop it", "2; drop it"), (-1, "", 0)]
)
def test_a_run_that_fails_says_what_its_own_guard_says(engine, start, advice, said):
    """Beyond the edge it ends at once."""
    with pytest.raises(clpt.SimulationError, match=f"^it landed at time {said}$"):
        ENGINES[engine](falling(advice=advice)).run([start], [0.0, 5.0])


@every_form
def test_a_run_that_stops_keeps_what_was_reached(engine):
    found = ENGINES[engine](falling(policy="stop", advice="never said")).run(
        [2.0], [0.0, 1.0, 5.0]
    )
    assert (found.status, found.message) == ("stopped", "stopped: it landed at time 2")
    np.testing.assert_allclose(found.t, [0.0, 1.0, 2.0])


@pytest.mark.parametrize("engine", ["unrolled", "looped"])
def test_a_switch_is_located_while_a_run_rests_on_the_edge(engine):
    """The edge is missed by rounding, 0.3 - 0.1*3 = -6e-17, until the stone moves at t = 1."""
    stone = clpt.Block(
        "stone",
        update=lambda t, x, u, p: np.where(t < 1.0, 0.0, -1.0),
        states={"h": 1},
        guard=Guard(lambda t, x, u, p: x[0] - 0.1 * 3, "stop", landed),
    )
    found = ENGINES[engine](stone).run([0.3], [0.0, 5.0])
    assert found.t[-1] == pytest.approx(1.0, abs=1e-9)


NO_GUARDS = [
    ({"policy": "halt"}, "policy 'halt' must be one of raise, stop, jump"),
    ({"sentence": "left"}, "Guard: sentence = .left.: must be a function"),
    ({"distance": lambda t, x, u, p: float(print("side effect")) + x[0]},
     r"stone\.guard: <lambda>, line \d+: TypeError"),
    ({"distance": lambda t, x, u, p: None}, r"stone\.guard"),
    ({"distance": lambda t, x, u, p, y: None}, r"stone\.guard"),
    ({"distance": 3}, "Guard: distance = 3: must be a function"),
]  # fmt: skip


@pytest.mark.parametrize(("guard", "said"), NO_GUARDS)
def test_a_guard_that_no_run_could_ask_is_refused(guard, said):
    says(clpt.ClptError, said, falling, **guard)
    says(clpt.ClptError, "guard = a function: must be a Guard", moving, -1.0, height)


@every_engine
@pytest.mark.parametrize("level", [0.5, 1.0, 2.0, 3.0, 4.0])
def test_a_run_that_ends_at_a_sample_has_it_once(engine, level):
    # y = t
    rising, times = (control.ss(0, 1, 1, 0, name="rising"), np.linspace(0.0, 5.0, 51))
    run = clpt.simulate(
        rising, times, 1.0, engine=engine, stop=lambda t, y, u: level - y[0]
    )
    assert run.time.values.tolist() == times[times < level + 1e-9].tolist()
    assert float(run.y[-1]) == pytest.approx(level, abs=1e-12)


@pytest.mark.filterwarnings("ignore:the run ends at its start")
@every_engine
def test_a_diagram_without_states_ends_where_the_condition_falls(engine):
    gain = control.nlsys(
        None, lambda t, x, u, p: 2.0 * u, inputs=1, outputs=1, name="gain"
    )
    times = np.linspace(0.0, 5.0, 11)

    def stopped(stop):
        return clpt.simulate(gain, times, times, stop=stop, engine=engine)

    for at, stop in (
        (4.4, lambda t, y, u: 8.8 - y[0]),
        (2.5, lambda t, y, u: t < 2.5),
        (2.4, lambda t, y, u: np.minimum(2.4 - t, 0.0)),  # at 0 it goes on
    ):
        run = stopped(stop)
        assert [float(run.time[-1]), float(run.y[-1])] == pytest.approx(
            [at, 2 * at], abs=1e-9
        )
        assert "fell to 0" in run.attrs["message"]
    assert stopped(lambda t, y, u: t + 1.0).sizes["time"] == len(times)
    assert stopped(lambda t, y, u: False).sizes["time"] == 1


STOPS = [
    lambda t, y, u: u[0] / 2 - y[0],
    lambda t, y, u: y[0] < 0.5,
    lambda t, y, u: bool(y[0] < 0.5 and t < 4),
    lambda t, y, u: np.logical_and(t < 4, y < 0.5),
    lambda t, y, u: t < np.log(2.0),
]


@every_engine
@pytest.mark.parametrize("stop", STOPS)
def test_a_run_ends_where_a_condition_is_no_longer_true_or_falls_to_zero(stop, engine):
    lag, close = control.ss(-1, 1, 1, 0, name="lag"), {"rtol": 1e-11, "atol": 1e-12}
    run = clpt.simulate(lag, [0.0, 5.0], 1.0, stop=stop, engine=engine, **close)
    assert run.attrs["status"] == "stopped"
    assert float(run.time[-1]) == pytest.approx(np.log(2.0), abs=1e-10)


NAMES = ["y", "T", "shape"]  # also names of an array's own attributes
BY_NAME = {
    lambda t, y, u: y["y"]: np.pi / 2.0,
    lambda t, y, u: y["T"] > 0.3: np.arccos(0.3),
    lambda t, y, u: y["shape"] - u["f"]: np.arccos(0.6),
}


@every_engine
@pytest.mark.parametrize("stop", BY_NAME)
def test_signals_of_a_condition_have_names(stop, engine):
    swing = control.nlsys(
        lambda t, x, u, p: [x[1], -x[0]], lambda t, x, u, p: [x[0], x[0], x[0]],
        states=2, inputs=["f", "g"], outputs=NAMES, name="swing",
    )  # fmt: skip
    run = clpt.simulate(
        swing, [0.0, 5.0], [0.6, 0.0], [1.0, 0.0], stop=stop, engine=engine
    )
    assert float(run.time[-1]) == pytest.approx(BY_NAME[stop], abs=1e-7)


def test_a_name_that_no_signal_has_is_refused():
    lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y", name="lag")
    stop = lambda t, y, u: y["z"]  # noqa: E731
    said = "no port 'z'; there are y"
    says(clpt.ClptError, said, clpt.simulate, lag, [0.0, 1.0], 1.0, stop=stop)


@pytest.mark.parametrize("lanes", [1, LANES])
def test_beside_others_a_run_keeps_what_it_reached(lanes):
    """A signal, sqrt(1.5 - s), ends to exist at t = 1.5."""
    diagram = wiring_of(written("s' = 1 + 0*sqrt(1.5 - s)")[0])
    times, starts = np.array([0.0, 0.4, 1.1]), np.linspace(0.0, 1.0, 5)[:, None]
    runs = side_by_side(NativeDiagram(diagram), lanes, starts, times)
    bad = (Status.NOT_FINITE, Status.STEP_TOO_SMALL)  # they end at 1.5, 1.25, ..., 0.5
    assert [status in bad for status in runs.status] == [False, False, True, True, True]
    assert list(runs.reached) == [3, 3, 2, 2, 2]
    assert np.isnan(runs.out[2:, 2]).all()
    np.testing.assert_allclose(runs.out[:, 1], starts + 0.4, atol=1e-9)


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize(
    "stop",
    [
        lambda t, y, u: 1.0 - y.h[1] + u.q,
        lambda t, y, u: y.h[1] < 1.0 + u.q,
        lambda t, y, u: 1.0 - y[1] + u[0],
        lambda t, y, u: 1.0 + u.q - np.max(y.h),
        lambda t, y, u: y.level < 2.0 + u.q,
    ],
)
def test_stop_reads_outputs_and_inputs_by_name(engine, stop):
    """h = (0, t), level = 1 + t: the run ends at t = 1 + q."""
    tank = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"h": np.array([0.0, 1.0])},
        output=lambda t, x, u, p: {"h": x.h, "level": 1.0 + x.h[1]},
        states={"h": 2},
        inputs={"q": 1},
        outputs={"h": 2, "level": 1},
    )
    run = clpt.simulate(
        tank, np.linspace(0.0, 4.0, 5), {"q": 0.5}, engine=engine, stop=stop
    )
    assert run.attrs["engine"] == engine
    np.testing.assert_allclose(run.time[-1], 1.5, rtol=1e-9)


def test_a_wrong_name_in_stop_is_answered_with_the_ports():
    wrong = {"stop": lambda t, y, u: y.w}
    said = "no port 'w'; there are h"
    says(clpt.BlockError, said, clpt.simulate, falling(), [0.0, 1.0], **wrong)
