"""Systems of discrete time: the numbers of python-control, in every engine, and what is refused."""

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.errors import ClptError, SimulationError

DT, STEPS = 0.5, 60
TIMES = DT * np.arange(STEPS)


def first_order(dt=DT, name="lag"):
    return control.ss([[0.9]], [[0.1]], [[1.0]], 0, dt, inputs="u", outputs="y", name=name)


def oscillator():
    A = [[0.8, 0.5], [-0.5, 0.8]]
    return control.ss(A, [[0.0], [0.3]], [[1.0, 0.2]], [[0.7]], DT, name="oscillator")


def two_by_three():
    rng = np.random.default_rng(7)
    A = 0.4 * rng.normal(size=(5, 5))
    B, C, D = (rng.normal(size=shape) for shape in ((5, 3), (2, 5), (2, 3)))
    return control.ss(A, B, C, D, DT, name="two_by_three")


def matrix_of_tf():
    one, two = ([1.0], [1.0, -0.5]), ([2.0, 1.0], [1.0, 0.2, 0.1])
    return control.tf([[one[0], two[0]]], [[one[1], two[1]]], DT, name="matrix")


def delay(steps):
    return control.tf([1], [1, *[0] * steps], DT, inputs="y", outputs="late", name="delay")


def logistic(dt=DT):
    def grow(t, x, u, params):
        return params["rate"] * x * (1 - x) + 0.01 * u

    return control.nlsys(
        grow, None, inputs=1, outputs=1, states=1, dt=dt, params={"rate": 2.9}, name="logistic"
    )


def moving():
    def step(t, x, u, params):
        return np.array([0.5 * x[0] + np.sin(params["omega"] * t) * u[0], x[0]])

    def seen(t, x, u, params):
        return np.array([x[1] + 0.1 * t, x[0] * u[0]])

    return control.nlsys(
        step, seen, inputs=1, outputs=2, states=2, dt=DT, params={"omega": 0.3}, name="moving"
    )


def branching():
    def step(t, x, u, params):
        return 0.5 * x if x[0] > 0.2 else x + 0.3 + 0.1 * u

    return control.nlsys(step, None, inputs=1, outputs=1, states=1, dt=DT, name="branching")


def counted():
    """A filter whose length is a whole number among its params."""

    def step(t, x, u, params):
        return np.append(u[:1], x[:-1])

    def mean(t, x, u, params):
        return np.sum(x[: params["length"]]) / params["length"]

    return control.nlsys(
        step, mean, inputs=1, outputs=1, states=6, dt=DT, params={"length": 4}, name="counted"
    )


def loop(plant=None):
    """A loop of a controller with feedthrough, which is computed before the plant moves."""
    plant = plant or first_order()
    error = control.summing_junction(["r", "-y"], "e", name="error")
    pi = control.tf([0.8, -0.6], [1, -1], DT, inputs="e", outputs="u", name="pi")
    return control.interconnect(
        [error, pi, plant], inputs="r", outputs=["y", "u"], name="loop", check_unused=False
    )


def nested():
    late = delay(3)
    return control.interconnect([loop(), late], inputs="r", outputs=["late", "u"], name="nested")


def by_wires():
    """Two loops side by side, wired by places with gains."""
    a, b = loop(), loop(first_order(name="other"))
    a.name, b.name = "a", "b"
    return control.interconnect(
        [a, b],
        connections=[["a.r", (1, 0, -0.2)], ["b.r", ("a", "y", 0.5)]],
        inplist=[["a.r"]],
        outlist=["a.y", ("b", "u", -2.0)],
        inputs=1,
        outputs=2,
        name="by_wires",
        check_unused=False,
    )


def nonlinear_loop():
    fish = logistic()
    fish.set_inputs(["u"])
    fish.set_outputs(["y"])
    return loop(fish)


def any_step():
    return first_order(True)


SYSTEMS = {
    "ss": first_order,
    "ss with feedthrough": oscillator,
    "ss, 3 inputs, 2 outputs": two_by_three,
    "ss of 20 states": lambda: control.ss(
        np.diag(np.full(19, 0.7), 1), np.eye(20)[:, 19:], np.ones((1, 20)), 0, DT, name="chain"
    ),
    "gain": lambda: control.ss([], [], [], [[2.0]], DT, name="gain"),
    "tf, biproper": lambda: control.tf([1, 0.3], [1, -0.4], DT, name="biproper"),
    "tf, 2 inputs": matrix_of_tf,
    "zpk": lambda: control.zpk([0.2], [0.5, -0.4], 1.5, DT, name="zpk"),
    "delay": lambda: delay(4),
    "nlsys": logistic,
    "nlsys in time": moving,
    "nlsys with a branch": branching,
    "nlsys with a count": counted,
    "interconnect": loop,
    "interconnect, nonlinear": nonlinear_loop,
    "nested": nested,
    "wired by places": by_wires,
    "dt = True": any_step,
}
every_engine = pytest.mark.parametrize("engine", ["native", "python"])


def drives(count):
    return np.random.default_rng(3).normal(size=(count, STEPS))


def ran(system, engine, u, x0=0.0, **given):
    """Return inputs, outputs and states as python-control stacks them."""
    run = clpt.simulate(system, TIMES, u, x0, engine=engine, **given)
    assert run.attrs["engine"] == engine
    ports = [
        name for name, values in run.data_vars.items() if name != "states" and "time" in values.dims
    ]
    return np.vstack([run[name].values.reshape(STEPS, -1).T for name in ports])


def by_entries(system, u):
    """Return the response entry by entry, where python-control needs Slycot."""
    found = np.zeros((system.noutputs, STEPS))
    for i in range(system.noutputs):
        for j in range(system.ninputs):
            entry = control.tf(system.num[i][j], system.den[i][j], system.dt)
            found[i] += control.forced_response(entry, TIMES, u[j]).outputs
    return found


@every_engine
@pytest.mark.parametrize("make", SYSTEMS.values(), ids=SYSTEMS)
def test_a_system_of_discrete_time_is_that_of_python_control(make, engine):
    system = make()
    u = drives(system.ninputs)
    x0 = 0.3 + 0.1 * np.arange(system.nstates or 0) if system.nstates else 0.0
    if isinstance(system, control.TransferFunction):
        x0, expected = 0.0, by_entries(system, u)
    else:
        expected = control.input_output_response(system, TIMES, u, x0).outputs
    if isinstance(system, control.StateSpace) and not hasattr(system, "syslist"):
        forced = control.forced_response(system, TIMES, u, x0).outputs
        np.testing.assert_allclose(expected, forced, rtol=1e-10, atol=1e-12)
    expected = np.reshape(expected, (-1, STEPS))
    found = ran(system, engine, u, x0)[: len(expected)]
    size = np.maximum(1.0, np.abs(expected))
    assert np.max(np.abs(found - expected) / size) <= 1e-12


@every_engine
def test_params_at_call_time_are_those_of_python_control(engine):
    system, u = moving(), drives(1)
    given = {"omega": 1.1}
    expected = control.input_output_response(system, TIMES, u, [0.1, 0.2], params=given).outputs
    found = ran(system, engine, u, [0.1, 0.2], params=given)[:2]
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_an_output_reads_what_the_update_wrote():
    def held():  # as in python-control's notebook on discrete-time systems: samples each third step
        step, y = 0, 0.0

        def update(t, x, u, params):
            nonlocal step
            x = 0.9 * x + u if step == 0 else x
            step = (step + 1) % 3
            return x

        def output(t, x, u, params):
            nonlocal y
            y = float(x[0]) if step == 0 else y
            return y

        return control.nlsys(update, output, inputs=1, outputs=1, states=1, dt=DT, name="held")

    expected = control.input_output_response(held(), TIMES, drives(1)).outputs
    assert np.ptp(expected) > 0.1
    with pytest.warns(UserWarning, match="runs in Python"):
        run = clpt.simulate(held(), TIMES, drives(1))
    np.testing.assert_array_equal(run.y.values.ravel(), expected)


def test_a_long_run_is_made_of_many_calls():
    times, seen = np.arange(400_001.0), []
    system = control.ss([[1.0]], [[1.0]], [[1.0]], 0, 1, name="sum")
    run = clpt.simulate(system, times, 1.0, progress=seen.append)
    np.testing.assert_array_equal(run.y.values.ravel(), times)
    assert seen == sorted(seen)
    assert seen[-1] == 400_000
    assert len(seen) > 2


@pytest.mark.parametrize(
    ("times", "given", "said"),
    [
        (
            [0.0, 0.5, 1.5],
            {},
            r"timepts: .*\(dt = 0\.5\) takes times that are 0\.5 apart; .* 1 apart",
        ),
        ([0.0, 0.25, 0.5], {}, r"timepts: .* takes times that are 0\.5 apart"),
        ([0.0, 1.0, 3.0], {"system": any_step()}, "evenly spaced"),
        ([0.0, 0.5], {"rtol": 1e-6}, "rtol: a diagram of discrete time has none"),
        ([0.0, 0.5], {"stop": lambda t, y, u: 1.0}, "stop: a diagram of discrete time"),
    ],
)
def test_what_does_not_fit_is_refused(times, given, said):
    given = {"system": first_order(), **given}
    for engine in ("native", "python"):
        with pytest.raises(ClptError, match=said) as caught:
            clpt.simulate(timepts=times, inputs=1.0, engine=engine, **given)
        assert "\n" not in str(caught.value)


@every_engine
def test_a_part_without_states_takes_its_own_times_too(engine):
    gain = control.tf([2], [1], 0.5, name="gain")
    assert clpt.simulate(gain, [0, 0.5], 1.0, engine=engine).y.values.tolist() == [2, 2]
    with pytest.raises(SimulationError, match=r"takes times that are 0\.5 apart"):
        clpt.simulate(gain, [0, 0.1], 1.0, engine=engine)


@every_engine
def test_a_number_that_is_not_finite_is_named(engine):
    system = control.nlsys(
        lambda t, x, u, params: 10 * x**2, None, inputs=1, outputs=1, states=1, dt=1, name="burst"
    )
    with pytest.raises(SimulationError, match=r"t = \d+: .* of block burst is not finite"):
        clpt.simulate(system, np.arange(30.0), 0.0, [2.0], engine=engine)
