"""Systems of discrete time, random ones too: python-control's numbers, and what is refused."""

import random

import control
import numpy as np
import pytest
from error_sentences import says
from random_diagrams import random_diagram

import clpt_control as clpt

DT, STEPS = 0.5, 12
TIMES = DT * np.arange(STEPS)


def first_order(dt=DT):
    return control.ss(
        [[0.9]], [[0.1]], [[1.0]], 0, dt, inputs="u", outputs="y", name="lag"
    )


def two_by_three():
    rng, shapes = np.random.default_rng(7), ((5, 5), (5, 3), (2, 5), (2, 3))
    A, *others = (rng.normal(size=shape) for shape in shapes)
    return control.ss(0.4 * A, *others, DT, name="two_by_three")


def moving():
    def step(t, x, u, params):
        return np.array([0.5 * x[0] + np.sin(params["omega"] * t) * u[0], x[0]])

    seen = lambda t, x, u, params: np.array([x[1] + 0.1 * t, x[0] * u[0]])  # noqa: E731
    sizes = {"inputs": 1, "outputs": 2, "states": 2}
    return control.nlsys(
        step, seen, **sizes, dt=DT, params={"omega": 0.3}, name="moving"
    )


def counted():
    """A filter whose length is a whole number among its params."""
    step = lambda t, x, u, params: np.append(u[:1], x[:-1])  # noqa: E731
    mean = lambda t, x, u, params: np.sum(x[: params["length"]]) / params["length"]  # noqa: E731
    sizes = {"inputs": 1, "outputs": 1, "states": 6}
    return control.nlsys(
        step, mean, **sizes, dt=DT, params={"length": 4}, name="counted"
    )


SYSTEMS = {
    "ss, 3 inputs, 2 outputs": two_by_three,
    "gain": lambda: control.ss([], [], [], [[2.0]], DT, name="gain"),
    "tf, biproper": lambda: control.tf([1, 0.3], [1, -0.4], DT, name="biproper"),
    "zpk": lambda: control.zpk([0.2], [0.5, -0.4], 1.5, DT, name="zpk"),
    "nlsys in time": moving,
    "nlsys in time, another omega at call time": moving,
    "nlsys with a count": counted,
    "dt = True": lambda: first_order(True),
    **{
        f"random diagram {k}": lambda k=k: random_diagram(random.Random(k), dt=DT)
        for k in range(10, 20)
    },
}
every_engine = pytest.mark.parametrize("engine", ["native", "python"])


def ran(system, engine, u, x0=0.0, **given):
    """Return outputs and states as python-control stacks them."""
    run = clpt.simulate(system, TIMES, u, x0, engine=engine, **given)
    assert run.attrs["engine"] == engine
    ports = [run[n] for n in run.data_vars if n != "states" and "time" in run[n].dims]
    return np.vstack([port.values.reshape(STEPS, -1).T for port in ports])


@every_engine
@pytest.mark.parametrize("case", SYSTEMS)
def test_a_system_of_discrete_time_is_that_of_python_control(case, engine):
    system, given = (
        SYSTEMS[case](),
        {"params": {"omega": 1.1}} if "another" in case else {},
    )
    u = np.random.default_rng(3).normal(size=(system.ninputs, STEPS))
    if isinstance(system, control.TransferFunction):
        x0, expected = 0.0, control.forced_response(system, TIMES, u).outputs
    else:
        x0 = 0.3 + 0.1 * np.arange(system.nstates) if system.nstates else 0.0
        expected = control.input_output_response(system, TIMES, u, x0, **given).outputs
    expected = np.reshape(expected, (-1, STEPS))
    found = ran(system, engine, u, x0, **given)[: len(expected)]
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-11)


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

        return control.nlsys(
            update, output, inputs=1, outputs=1, states=1, dt=DT, name="held"
        )

    expected = control.input_output_response(held(), TIMES, TIMES).outputs
    assert np.ptp(expected) > 0.1
    with pytest.warns(UserWarning, match="runs in Python"):
        run = clpt.simulate(held(), TIMES, TIMES)
    np.testing.assert_array_equal(run.y.values.ravel(), expected)


def test_a_long_run_is_made_of_many_calls():
    times, seen = np.arange(400_001.0), []
    system = control.ss([[1.0]], [[1.0]], [[1.0]], 0, 1, name="sum")
    run = clpt.simulate(system, times, 1.0, progress=seen.append)
    np.testing.assert_array_equal(run.y.values.ravel(), times)
    assert (seen, seen[-1]) == (sorted(seen), 400_000)
    assert len(seen) > 2


MISFITS = [
    ([0, 0.5, 1.25], {}, r"timepts: .*\(dt = 0\.5\) takes times that are 0\.5 apart"),
    ([0.0, 1.0, 3.0], {"system": first_order(True)}, "evenly spaced"),
    (
        [0.0, 0.1],
        {"system": control.tf([2], [1], 0.5)},
        r"takes times that are 0\.5 apart",
    ),
    ([0.0, 0.5], {"rtol": 1e-6}, "rtol: a diagram of discrete time has none"),
    ([0.0, 0.5], {"stop": lambda t, y, u: 1.0}, "stop: a diagram of discrete time"),
]


@every_engine
@pytest.mark.parametrize(("times", "given", "said"), MISFITS)
def test_what_does_not_fit_is_refused(times, given, said, engine):
    given = {
        "system": first_order(),
        "timepts": times,
        "inputs": 1.0,
        "engine": engine,
    } | given
    says(clpt.ClptError, said, clpt.simulate, **given)


@every_engine
def test_a_number_that_is_not_finite_is_named(engine):
    """10^(2^k - 1) 2^(2^k) is a number up to k = 7; what would come after a run is not asked."""
    grown = lambda t, x, u, params: [0.5 * x[0], 10 * x[1] ** 2]  # noqa: E731
    system = control.nlsys(
        grown, None, inputs=1, outputs=2, states=2, dt=1, name="burst"
    )
    with pytest.raises(
        clpt.SimulationError, match=r"t = 7: .* x\[1\] of block burst is not"
    ):
        clpt.simulate(system, np.arange(9.0), 0.0, [2.0, 2.0], engine=engine)
    run = clpt.simulate(system, np.arange(8.0), 0.0, [2.0, 2.0], engine=engine)
    assert np.isfinite(run.states.values).all()


@pytest.mark.parametrize("dt", [True, 1.0])
def test_a_map_that_leaves_the_numbers_names_its_next_state(dt):
    """Of 2^(2^k), the number at k = 10 is beyond the largest, 2^1024."""
    square = control.nlsys(
        lambda t, x, u, p: [0.5 * x[0], x[1] ** 2],
        inputs=0, outputs=2, states=["a", "b"], dt=dt, name="square",
    )  # fmt: skip
    said = "stopped at t = 9: next state b of block square is not finite"
    says(
        clpt.SimulationError,
        said,
        clpt.simulate,
        square,
        np.arange(12.0),
        None,
        [1.0, 2.0],
    )
