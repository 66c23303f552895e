"""Sampled parts in continuous loops: closed forms, python-control's loops, two rates."""

import control
import numpy as np
import pytest
from engine_runs import compare_backends, compile, readings, run_many
from error_sentences import says
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control import Block, Sampled

DT = 0.5
TIMES = DT * np.arange(41)
A, B = np.array([[-0.2, 0.0], [0.1, -0.3]]), np.array([[1.0], [0.0]])
TIGHT = {"rtol": 1e-12, "atol": 1e-13}
every_engine = pytest.mark.parametrize("engine", ["native", "python"])


def tanks(name="tanks"):
    return control.ss(A, B, [[0.0, 1.0]], 0, inputs="v", outputs="y", name=name)


def moved(x, v, since):
    """Return the exact state of the tanks, v being held."""
    return (expm(np.block([[A, B], [np.zeros((1, 3))]]) * since) @ np.append(x, v))[:2]


def error():
    return control.summing_junction(["r", "-y"], "e", name="error")


def pid(made="v"):
    """A PID of Tustin's integral and a difference as derivative."""
    integral = control.tf([DT / 2, DT / 2], [1, -1], DT)
    made_of = 1.2 + 0.3 * integral + 0.4 * control.tf([1, -1], [DT, 0], DT)
    return control.tf(
        made_of.num, made_of.den, DT, inputs="e", outputs=made, name="pid"
    )


def in_a_row():
    """A filter, a feedback, a delay: at one instant each finds the new output of the other."""
    return [
        control.ss(
            [[0.6]],
            [[0.4]],
            [[1.0]],
            [[0.5]],
            DT,
            inputs="e",
            outputs="s",
            name="filter",
        ),
        control.tf([0.7, -0.2], [1, -1], DT, inputs="s", outputs="w", name="pi"),
        control.tf([1], [1, 0], DT, inputs="w", outputs="v", name="late"),
    ]


def whole():
    return control.interconnect(in_a_row(), inputs="e", outputs="v", name="whole")


def stepped(t, x, u, params):
    return np.clip(x + 0.1 * u, -params["limit"], params["limit"])


def ruled(t, x, u, params):
    return params["gain"] * (x + u) + 0.05 * np.sin(t)


def limited(gain=0.9):
    ports, params = (
        {"inputs": "e", "outputs": "v", "states": 1},
        {"limit": 0.4, "gain": gain},
    )
    return control.nlsys(stepped, ruled, **ports, dt=DT, params=params, name="limited")


def loop_of(*parts):
    """Parts between the error and the tanks."""
    return clpt.connect([error(), *parts, tanks()], external="r")


LOOPS = {  # the parts of a loop, call-time parameters, and the one controller that they are
    "a PID": (lambda: [pid()], {}, pid),
    "a row": (in_a_row, {}, whole),
    "in another order": (lambda: in_a_row()[::-1], {}, whole),
    "nested": (lambda: [whole()], {}, whole),
    "a limit": (lambda: [limited()], {}, limited),
    "another gain": (lambda: [limited()], {"limited.gain": 0.5}, lambda: limited(0.5)),
}


@every_engine
@pytest.mark.parametrize("case", LOOPS)
def test_a_sampled_controller_on_a_tank_at_its_samples_and_between(case, engine):
    """At samples it is the loop of discrete time, the plant under zero-order hold."""
    parts, params, controller = LOOPS[case]
    loop = loop_of(*parts())
    assert loop.dt == 0
    fine = np.union1d(TIMES, np.linspace(0.0, TIMES[-1], 57))
    run = clpt.simulate(loop, fine, 1.0, params=params, engine=engine, **TIGHT)
    held = control.c2d(tanks(), DT, "zoh", name="held", copy_names=True)
    wired = control.interconnect(
        [error(), controller(), held],
        inputs="r",
        outputs=["y", "v"],
        check_unused=False,
    )
    y, v = control.input_output_response(wired, TIMES, np.ones(len(TIMES))).outputs
    at, k = np.isin(fine, TIMES), np.searchsorted(TIMES, fine, side="right") - 1
    np.testing.assert_allclose([run.y[at], run.v[at]], [y, v], atol=1e-9)
    assert run.attrs["engine"] == engine
    np.testing.assert_allclose(run.v, run.v[at][k], atol=0)
    starts = run.states[at][:, -2:].values
    between = [
        moved(starts[j], v[j], t - TIMES[j]) for t, j in zip(fine, k, strict=True)
    ]
    np.testing.assert_allclose(run.states[:, -2:], between, atol=1e-9)


@pytest.mark.parametrize("start", [1e6, 1e8, 1.7e9])
def test_a_sampled_loop_may_begin_long_after_zero(start):
    loop = loop_of(pid())
    early, late = (
        clpt.simulate(loop, t, inputs=1.0, **TIGHT) for t in (TIMES, start + TIMES)
    )
    np.testing.assert_allclose(late["y"], early["y"], atol=1e-15 * start)


@every_engine
def test_two_rates_in_one_loop(engine):
    """The inner at 0.1, the outer at 0.3: exact from one grid of 0.1 to the next."""
    inner = control.tf([0.5], [1], 0.1, inputs="w", outputs="v", name="inner")
    outer = control.ss(1, 0.3, 1, 0.8, 0.3, inputs="e", outputs="w", name="outer")
    times = np.arange(0, 61) * 0.1
    run = clpt.simulate(loop_of(outer, inner), times, 1.0, engine=engine, **TIGHT)
    x, s, held, found = np.zeros(2), 0.0, 0.0, []
    for k in range(len(times)):
        if k % 3 == 0:
            s, held = s + 0.3 * held * (k > 0), 1.0 - x[1]
        v = 0.5 * (s + 0.8 * held)
        found.append([x[1], v])
        x = moved(x, v, 0.1)
    np.testing.assert_allclose(np.transpose([run.y, run.v]), found, atol=1e-9)


@every_engine
def test_two_rates_meet_where_the_input_is_sampled(engine):
    """6 x 0.1, 2 x 0.3 and a sample of r are one time, and not one float."""
    holds = [
        clpt.parts.hold(0.1, name="fast", u="r", y="h"),
        clpt.parts.hold(0.3, u="h", y="g"),
    ]
    loop = clpt.connect([*holds, clpt.parts.lag(1.0, u="g", y="y")], external="r")
    times, r = np.arange(15) / 5, np.random.default_rng(2).standard_normal(15)
    run = clpt.simulate(loop, times, [r], engine=engine)
    for port, dt in (("h", 0.1), ("g", 0.3)):
        expected = np.interp(dt * np.floor(times / dt + 1e-9), times, r)
        np.testing.assert_allclose(run[port], expected, atol=1e-12)


def test_a_run_goes_on_where_another_ended():
    """Also from between two samples, where what is held is in the state."""
    loop = loop_of(pid())
    whole = clpt.simulate(loop, [0.0, 2.0, 3.3, 6.0], 1.0, **TIGHT)
    for k in (1, 2):
        rest = clpt.simulate(loop, whole.time[k:], 1.0, whole.states[k].values, **TIGHT)
        np.testing.assert_allclose(rest.states[-1], whole.states[-1], atol=1e-10)


@pytest.mark.parametrize(
    "part", [clpt.parts.hold(0.25), clpt.parts.noise(1.0, 0.25, n="y")]
)
def test_a_run_that_begins_before_time_0_is_refused(part):
    """The first sample was that at 0.25, also of a run from -0.5 on."""
    loop = clpt.connect(
        [part, clpt.parts.lag(1.0, u="y", y="z")], external=("u",) * part.ninputs
    )
    for run in (
        clpt.simulate,
        lambda d, t, u: clpt.run_ensemble(d, "lag.lag=[1]", timepts=t),
    ):
        with pytest.raises(clpt.ClptError, match=r"from time 0. Begin the run at 0 or"):
            run(loop, [-0.5, 0.0, 1.0], 0.0)


def test_many_runs_begin_with_what_is_held():
    """Parameters of a part may be called as a block calls its own: `interval` is one."""
    own = {
        "inputs": "y",
        "outputs": "v",
        "dt": DT,
        "params": {"interval": -3.0},
        "name": "p",
    }
    part = control.nlsys(None, lambda t, x, u, params: params["interval"] * u, **own)
    native = compile(clpt.connect([part, tanks()]))
    starts = np.array([[9.0, 0.5, 0.1 * k] for k in range(9)])
    close = {"rtol": 1e-10, "atol": 1e-12}
    found = run_many(native, starts, TIMES[:4], 1e-10)
    alone = [native.run(start, TIMES[:4], **close) for start in starts]
    np.testing.assert_allclose(found, [one.x for one in alone], atol=1e-9)
    # y, not the 9 that was given
    assert found[:, 0, 0].tolist() == starts[:, 2].tolist()
    signals = [native.signals(one)[:, 0] for one in alone]
    np.testing.assert_allclose(signals, -3.0 * found[:, :, 2], atol=1e-9)


def law(**values):
    scenario = clpt.paper_scenario().with_values(values)
    return next(one for one in clpt.paper_blocks(scenario) if one.name == "adaptation")


DIRECT = control.ss(A, B, [[0.0, 1.0]], [[0.5]], inputs="v", outputs="y", name="tanks")
OPEN = control.ss(-1, 1, 1, 0, True, inputs="y", outputs="v", name="p")
REFUSED = {
    "algebraic loop": lambda: clpt.simulate(
        clpt.connect([error(), pid(), DIRECT], external="r"), TIMES, 1.0
    ),
    "dt = True is not a sampling time": lambda: clpt.connect([OPEN, tanks()]),
    "its states jump": lambda: control.input_output_response(
        loop_of(pid()), TIMES, TIMES
    ),
    r"adaptation: period = 0\.0: must be a positive time": lambda: Sampled(law(), 0.0),
    "adaptation: period = inf": lambda: Sampled(law(), np.inf),
    "breakpoints or a guard": lambda: Sampled(
        law(**{"learning.law": "concurrent"}), 1.0
    ),
}


@pytest.mark.parametrize("said", REFUSED)
def test_what_is_refused(said):
    with pytest.raises(clpt.ClptError, match=said):
        REFUSED[said]()


@pytest.mark.sampled
@every_engine
def test_a_switch_that_is_sampled_does_not_chatter(engine):
    """x' = -0.2 x + v, v = sign(1 - x) each 0.1: exact from sample to sample."""
    own = {"inputs": "e", "outputs": "v", "dt": 0.1, "name": "switch"}
    switch = control.nlsys(None, lambda t, x, u, params: np.sign(u), **own)
    tank = control.ss(-0.2, 1, 1, 0, inputs="v", outputs="y", name="tank")
    times, x, found = 0.1 * np.arange(401), 0.0, []
    loop = clpt.connect([error(), switch, tank], external="r")
    run = clpt.simulate(loop, times, 1.0, engine=engine, **TIGHT)
    for _ in times:
        found.append(x)
        x = x * np.exp(-0.02) + 5 * np.sign(1 - x) * (1 - np.exp(-0.02))
    np.testing.assert_allclose(run.y, found, atol=1e-9)


@pytest.mark.long
def test_a_sampled_law_reads_alike_in_every_engine():
    loop = clpt.closed_loop(clpt.paper_scenario(), law=Sampled(law(), 0.5))
    x, asks = np.random.default_rng(2).normal(size=loop.nstates), readings(loop)
    moved = x[4:14] + 0.5 * law().dynamics(0.0, x[4:14], x[14:])
    jumped = asks["python"].jump(3.2, x, [])
    np.testing.assert_allclose(jumped[4:14], moved, rtol=1e-12)
    for name in asks.keys() - {"control"}:
        np.testing.assert_allclose(
            asks[name].jump(3.2, x, []), jumped, rtol=1e-12, err_msg=name
        )


@every_engine
def test_euler_of_constant_rates_and_of_time(engine):
    rates = lambda t, x, u, p: {"a": 1.0, "b": t * np.ones((2, 2)) * u.w[0]}  # noqa: E731
    block = Block("drift", update=rates, inputs={"w": 1}, states={"a": 2, "b": (2, 2)})
    loop, times = clpt.connect([Sampled(block, 0.5)], external="w"), np.arange(9) * 0.25
    run, k = clpt.simulate(loop, times, 3.0, engine=engine), np.floor(times / 0.5)
    np.testing.assert_allclose(run["a"].values, np.outer(0.5 * k, [1, 1]), atol=1e-12)
    sums = np.outer(3.0 * 0.25 * k * (k - 1) / 2, np.ones(4))
    np.testing.assert_allclose(run["b"].values.reshape(9, 4), sums, atol=1e-12)


def test_conformance_holds():
    """By itself a block holds what it is given."""
    for block in loop_of(limited(), pid("w")).syslist[1:3]:
        compare_backends(block)


def test_a_sampled_nlsys_takes_its_own_params():
    loop = loop_of(limited())

    def end(**params):
        named = {name.replace("_", "."): value for name, value in params.items()}
        return float(clpt.simulate(loop, TIMES, 1.0, params=named).y[-1])

    assert (
        end(gain=2.0)
        == end(limited_gain=2.0)
        == end(gain=9.0, limited_gain=2.0)
        != end()
    )
    for name in ("gain", "limited.gain"):
        runs = clpt.run_ensemble(loop, {name: [0.9, 2.0]}, timepts=TIMES, inputs=1.0)
        assert runs.y_final.values.tolist() == pytest.approx([end(), end(gain=2.0)])
    says(clpt.BlockError, "unknown parameter 'kd'", end, kd=1.0)


def test_a_period_of_one_is_no_period_left_open():
    slow, fast = (
        control.ss(0.5, 1, 1, 0, dt=dt, inputs=u, outputs=y, name=y)
        for dt, u, y in ((2, "a", "b"), (1, "r", "a"))
    )
    run = clpt.simulate(clpt.connect([fast, slow], external="r"), np.arange(10.0), 1.0)
    b, a = [0.0], 2 - 2 * 0.5 ** np.arange(10)
    for k in range(0, 8, 2):
        b.append(0.5 * b[-1] + a[k])
    assert run.b.values.tolist() == pytest.approx(np.repeat(b, 2).tolist())
