"""Estimators and vehicles against SciPy and Fossen; parts as blocks: mistakes, names, pickles."""

import inspect
import pickle
import re
from pathlib import Path

import control
import numpy as np
import pytest
from error_sentences import says
from scipy.integrate import simpson, solve_ivp
from scipy.linalg import expm
from test_parts_closed_forms import TIGHT, TIMES, every_engine, run

import clpt_control as clpt
from clpt_control import parts

# --- estimators ---------------------------------------------------------------------------------

A, B, C = (
    np.array([[0.0, 1.0], [-1.0, 0.3]]),
    np.array([[0.0], [1.0]]),
    np.array([[1.0, 0.0]]),
)
Q, R = np.array([[0.3, 0.1], [0.1, 0.5]]), np.array([[0.2]])


def test_the_error_of_an_observer_decays_by_its_poles():
    L, start = control.place(A.T, C.T, [-2.0, -3.0]).T, np.array([1.0, -0.5])
    plant = control.ss(A, B, C, 0, inputs="u", outputs="y", name="plant")
    loop = clpt.connect([plant, parts.observer(plant, L)], external="u")
    found = run(loop, TIMES, [np.sin(TIMES)], [*start, 0, 0])
    exact = [expm((A - L @ C) * t) @ start for t in TIMES]
    x = found.states.values
    np.testing.assert_allclose(x[:, :2] - x[:, 2:], exact, atol=1e-8)


GAIN = np.ones((3, 2)) / 9
ESTIMATORS = {
    "observer": lambda plant, **names: parts.observer(plant, GAIN, **names),
    "kalman_filter": lambda plant, **names: parts.kalman_filter(
        plant, np.eye(3), np.eye(2), **names
    ),
}


@pytest.mark.parametrize("dt", [0, 0.1])
@pytest.mark.parametrize("kind", ESTIMATORS)
@pytest.mark.parametrize("names", [{}, {"u": "f", "y": "q"}])
@pytest.mark.parametrize("beside", [False, True])
def test_an_estimator_reads_a_plant_by_its_names(dt, kind, names, beside):
    """Beside a clock, an estimator with dt samples."""
    signals = {"inputs": ["f1", "f2"], "outputs": ["q1", "q2"]}
    if names:
        signals = {"inputs": ["f[0]", "f[1]"], "outputs": ["q[0]", "q[1]"]}
    drag = np.diag([1.0, 0.5, 0.3])
    A, B, C = np.eye(3) - drag if dt else -drag, np.ones((3, 2)), np.eye(2, 3)
    plant = control.ss(A, B, C, np.zeros((2, 2)), dt, **signals, name="plant")
    estimator = ESTIMATORS[kind](plant, **names)
    assert estimator.input_labels == [*signals["inputs"], *signals["outputs"]]
    clock = clpt.Block("clock", output=lambda t, x, u, p: t, outputs={"time": 1})
    parts_of_loop = [plant, estimator, *[clock] * beside]
    loop = clpt.connect(parts_of_loop, external=["f"] if names else ["f1", "f2"])
    if kind == "observer" and not beside:
        times = 0.1 * np.arange(20)
        options = {} if dt else TIGHT
        start = [1, 2, 3, 0, 0, 0]
        run = clpt.simulate(loop, times, np.ones((2, 20)), start, **options)
        error = A - GAIN @ C
        powers = [
            np.linalg.matrix_power(error, k) if dt else expm(error * times[k])
            for k in range(20)
        ]
        x = run.states.values
        np.testing.assert_allclose(
            x[:, :3] - x[:, 3:], powers @ np.array([1.0, 2, 3]), atol=1e-8
        )


def test_an_estimator_by_the_names_of_a_plant_is_the_one_by_u_and_y():
    signals = {"inputs": ["force"], "outputs": ["angle", "rate"]}
    matrices = [[0, 1], [-1, -0.1]], [[0], [1]], np.eye(2), np.zeros((2, 1))
    named = control.ss(*matrices, **signals, name="plant")
    gain = [[1.0, 0.5], [0.2, 2.0]]
    push = np.sin(np.arange(20.0))
    runs = [
        clpt.simulate(
            clpt.connect([plant, parts.observer(plant, gain)], external=force),
            0.1 * np.arange(20),
            push,
            [1, 2, 0, 0],
        ).x_hat.values
        for plant, force in (
            (named, "force"),
            (control.ss(*matrices, name="plant"), "u"),
        )
    ]
    np.testing.assert_array_equal(*runs)


def test_a_kalman_bucy_filter_settles_at_care():
    filter = parts.kalman_filter(control.ss(A, B, C, 0), Q, R, P0=2 * np.eye(2))
    found = run(filter, [0.0, 1.0, 60.0], [0.0, 0.0])

    def riccati(t, P):
        P = P.reshape(2, 2)
        return (A @ P + P @ A.T + Q - P @ C.T @ np.linalg.inv(R) @ C @ P).ravel()

    exact = solve_ivp(riccati, (0, 1), 2 * np.eye(2).ravel(), rtol=1e-11, atol=1e-12).y[
        :, -1
    ]
    settled = control.lqe(A, np.eye(2), C, Q, R)[1].ravel()
    P = found.P.values.reshape(3, 4)
    np.testing.assert_array_equal(P[0], 2 * np.eye(2).ravel())
    np.testing.assert_allclose(P[1:], [exact, settled], atol=1e-8)


def test_a_sampled_kalman_filter_settles_at_dare():
    F = expm(0.1 * A)
    plant = control.ss(F, B, C, 0, 0.1)
    found = clpt.simulate(
        parts.kalman_filter(plant, Q, R), 0.1 * np.arange(200), [0.0, 1.0]
    )
    L, P, _ = control.dlqe(F, np.eye(2), C, Q, R)
    K = P @ C.T / (C @ P @ C.T + R)
    np.testing.assert_allclose(
        found.P[-1].values.reshape(2, 2), P - K @ C @ P, atol=1e-10
    )
    kept = (np.eye(2) - K @ C) @ F  # steady: x = F x_hat, x_hat = x + K (1 - C x)
    assert np.max(np.abs(np.linalg.eigvals(kept))) < 0.95
    steady = np.linalg.solve(np.eye(2) - kept, K[:, 0])
    np.testing.assert_allclose(found.x_hat[-1].values, steady, atol=1e-3)
    np.testing.assert_allclose(F @ K, L, atol=1e-10)


@pytest.mark.parametrize("dt", [0, 0.02])
def test_the_covariance_stays_symmetric_over_a_long_run_of_an_unstable_plant(dt):
    """A cart with an inverted pendulum; a skew part of P would grow by exp(2.2 t)."""
    A, B, C = np.zeros((4, 4)), np.array([[0.0], [0], [1], [2]]), np.eye(2, 4)
    A[0, 2] = A[1, 3] = 1.0
    A[2:, 1] = 1.962, 23.544
    plant = control.ss(A, B, C, 0)
    model = control.c2d(plant, dt) if dt else plant
    R, Q = np.diag([4e-6, 2.5e-5]), model.B @ model.B.T
    times = np.linspace(0, 40, 2001)
    found = clpt.simulate(
        parts.kalman_filter(model, Q, R, 1e-4 * np.eye(4)), times, np.zeros((3, 2001))
    )
    solve = control.dare if dt else control.care
    settled = solve(model.A.T, C.T, Q, R)[0]
    if dt:
        K = settled @ C.T @ np.linalg.inv(C @ settled @ C.T + R)
        settled = settled - K @ C @ settled
    last = found.P[-1].values.reshape(4, 4)
    np.testing.assert_allclose(last, settled, atol=1e-9)


@pytest.mark.parametrize("limited", [False, True])
def test_a_sampled_kalman_filter_closes_an_lqg_loop(limited):
    """A plant with D = 0 against the recursion of the sampled loop, written out."""
    plant = control.ss([[0, 1], [1, 0]], [[0], [1]], C, 0, name="plant")
    plant.set_inputs("u")
    plant.set_outputs("y")
    d = control.c2d(plant, 0.1)
    gain, _, _ = control.dlqr(d, np.eye(2), [[1]])
    filter = parts.kalman_filter(d, Q, R)
    wanted = "wanted" if limited else "u"
    lqr = control.ss([], [], [], -gain, 0.1, inputs=2, outputs=wanted, name="lqr")
    lqr.set_inputs(["x_hat[0]", "x_hat[1]"])
    limit = [parts.saturation(-0.3, 0.3, u="wanted", y="u")] if limited else []
    loop = clpt.connect([plant, filter, lqr, *limit])
    times = 0.1 * np.arange(51)
    found = run(loop, times, None, [0.1, *np.zeros(loop.nstates - 1)]).y.values

    x, X, P, seen = np.array([0.1, 0.0]), np.zeros(2), np.zeros((2, 2)), []
    for _ in times:
        seen.append(x[0])
        K = P @ C.T / (C @ P @ C.T + R)
        x_hat = X + K[:, 0] * (x[0] - X[0])
        u = np.clip(-gain @ x_hat, -0.3, 0.3) if limited else -gain @ x_hat
        x, X = d.A @ x + d.B @ u, d.A @ x_hat + d.B @ u
        P = d.A @ (P - K @ C @ P) @ d.A.T + Q
    np.testing.assert_allclose(found.ravel(), seen, atol=1e-8)


def test_feedthrough_of_a_kalman_filter_stays_where_the_plant_has_it():
    plant = control.ss([[0.5]], [[1]], [[1]], [[1]], 1.0, name="plant")
    plant.set_inputs("u")
    plant.set_outputs("y")
    filter = parts.kalman_filter(plant, [[1]], [[1]], P0=[[1]])
    # K = 1/2 of y - D u = 3 - 2
    found = clpt.simulate(filter, [0.0, 1.0], [[2, 2], [3, 3]])
    assert found.x_hat.values[0] == 0.5
    lqr = control.ss([], [], [], -0.1, 1.0, inputs="x_hat", outputs="u", name="lqr")
    loop = clpt.connect([plant, filter, lqr])
    says(clpt.DiagramError, "algebraic loop", clpt.simulate, loop, [0.0, 1.0])


def test_a_filter_is_as_uncertain_as_it_says():
    """Of a random walk seen with noise the mean square error is P."""
    q, r, times = 0.04, 1.0, np.arange(20_000.0)
    walk = np.cumsum(np.sqrt(q) * np.random.default_rng(2).standard_normal(len(times)))
    seen = walk + clpt.simulate(parts.noise(np.sqrt(r), 1.0, seed=7), times).n.values
    filter = parts.kalman_filter(control.ss(1, 1, 1, 0, 1.0), [[q]], [[r]])
    found = clpt.simulate(filter, times, np.stack([0 * times, seen]))
    squared = np.mean((found.x_hat.values.squeeze() - walk)[100:] ** 2)
    assert squared == pytest.approx(float(found.P.values.squeeze()[-1]), rel=0.05)


def test_noise_is_the_same_everywhere_and_a_signals_own():
    """Of the hash `blocks/test_blocks_closed_forms` asks whether it is white and normal."""
    source, middles = (
        parts.noise([2.0, 0.5], 0.1, signals=2, seed=3),
        0.1 * np.arange(2e4) + 0.05,
    )
    found = run(source, middles).n.values
    others = run(source, middles[:500], engine="python").n.values
    np.testing.assert_allclose(found[:500], others, rtol=1e-13)
    np.testing.assert_allclose(found.std(0), [2.0, 0.5], rtol=0.02)
    np.testing.assert_allclose(found.mean(0), 0, atol=0.04)
    other = run(parts.noise(2.0, period=0.1, seed=4), middles).n.values.squeeze()
    for one in (other, found[:, 1]):
        assert abs(np.corrcoef(one, found[:, 0])[0, 1]) < 0.03


# --- vehicles -----------------------------------------------------------------------------------


M = np.array([[60.0, 0, 0], [0, 90, 5], [0, 5, 20]])
D, QUADRATIC = np.diag([30.0, 60, 20]), np.diag([10.0, 20, 5])


@every_engine
def test_forces_do_the_work_of_a_planar_vehicle(engine):
    """nu^T M nu / 2 grows by nu^T (tau - D nu - Q |nu| nu): C takes and gives nothing."""
    tau, start = np.array([15.0, -4.0, 3.0]), [0.0, 0, 0.3, 0.5, -0.4, 0.6]
    block, times = parts.planar_vehicle(M, D, QUADRATIC), np.linspace(0, 10, 4001)
    nu = run(block, times, [*tau, 0, 0], start, engine=engine).nu.values
    first, last = (0.5 * nu[k] @ M @ nu[k] for k in (0, -1))
    power = np.sum(nu * (tau - nu @ D - np.abs(nu) * nu @ QUADRATIC), axis=1)
    assert last - first == pytest.approx(simpson(power, x=times), abs=1e-8)


def test_coriolis_is_fossens_matrix():
    rng = np.random.default_rng(3)
    for nu, tau in rng.standard_normal((20, 2, 3)):
        a, b = M[1, 1] * nu[1] + M[1, 2] * nu[2], M[0, 0] * nu[0]
        rate = np.linalg.solve(
            M, tau - np.array([[0, 0, -a], [0, 0, b], [a, -b, 0]]) @ nu - D @ nu
        )
        found = parts.planar_vehicle(M, D).dynamics(
            0, [0, 0, rng.normal(), *nu], [*tau, 0, 0]
        )
        np.testing.assert_allclose(found[3:], rate, atol=1e-12)


# --- the page of parts ---------------------------------------------------------------------------

PAGE = (Path(__file__).parents[2] / "docs" / "parts.md").read_text()
CALLS = re.findall(r"^\| `(\w+)\((.*?)\)` \|", PAGE, flags=re.MULTILINE)


@pytest.mark.parametrize(("name", "arguments"), CALLS)
def test_a_row_of_the_page_is_a_call(name, arguments):
    """Places before the first keyword are those of the signature; keywords are its names."""
    names = [*inspect.signature(getattr(parts, name)).parameters]
    words = filter(None, arguments.split(", "))
    places = [word for word in words if "=" not in word]
    keywords = re.findall(r"(\w+)=", arguments)
    assert places == names[: len(places)]
    assert {*keywords} <= {*names}


def test_every_part_has_a_row_on_the_page():
    assert {name for name, _ in CALLS} == {*parts.__all__}


def test_every_part_is_in_a_test():
    files = Path(__file__).parent.glob("test_*.py")
    text = "".join(file.read_text("utf-8") for file in files)
    assert [name for name in parts.__all__ if f"parts.{name}(" not in text] == []


# --- as blocks: mistakes, names ------------------------------------------------------------------

MISTAKES = r"""
    parts.saturation(1, -1) -> saturation: low = 1: must be below high = -1
    parts.rate_limit(1.0) -> give lag, in continuous time, or dt
    parts.delay(1.0, dt=0.3) -> delay = 1.0: must be a multiple of dt = 0.3
    parts.lag(0.0) -> lag = 0.0: must be positive
    parts.saturation([0, 1], 3, signals=3) -> must be one number, or 3
    parts.pid(1, 0.1, hgih=1) -> hgih= is not an argument. Did you mean 'high'?
    parts.pid(1, limits=(0, 1)) -> limits= is not an argument. Give the limits as low=, high=
    parts.pid(1, 0.1, u_max=1) -> Give the limits as low=, high=
    parts.relay(1, -1, lag=1, output_limits=(0, 1)) -> Give the limits as low=, high=
    parts.pid(1, 1, dt=1, tracking=0.5) -> tracking = 0.5: must be above half of
    parts.pid(1, r="a", y="a") -> pid: its inputs would be a, a; each needs its own
    parts.observer(control.ss(-np.eye(2), np.eye(2), [[1, 2]], 0), [[1, 2]]) -> must be (2, 1)
    parts.lookup_table([0, 0], [1, 2]) -> two or more increasing numbers
    parts.planar_vehicle(np.ones((3, 3)), np.eye(3)) -> m12 = m13 = 0
    parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[0]]) -> and positive definite
    parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[1]], [[-1]]) -> P0 = [[-1.0]]: must be
    parts.kalman_filter(control.ss(-1, 1, 1, 0), [[np.nan]], [[1]]) -> Q = [[nan]]: must be
    parts.noise([1, -1], 0.1, signals=2) -> std = [1, -1]: must be positive or 0
    parts.point_vehicle(1, -1) -> damping = -1: must be positive or 0
    parts.lag(1.0, signals=0) -> signals = 0: must be a whole number, 1 or more
    parts.planar_vehicle([[1]], np.eye(3)) -> M = [[1]]: must have the shape (3, 3)
    parts.observer(control.tf(1, [1, 1]), [[1]]) -> control.ss(system) or clpt.linearize
    clpt.linearize(parts.noise(1.0, 0.1), [], [], t=0.0) -> noise: has no states and no inputs
"""


@pytest.mark.parametrize("mistake", MISTAKES.strip().splitlines())
def test_mistakes_are_told(mistake):
    call, said = mistake.split(" -> ")
    errors = clpt.DiagramError, clpt.BlockError, clpt.ArgumentError
    says(errors, re.escape(said), eval, call.strip(), globals())


SAMPLED = (
    *(parts.pid(2, 0.7, 0.1, dt=0.1), parts.rate_limit(1, dt=0.1)),
    *(parts.backlash(1, dt=0.1), parts.relay(1, -1, dt=0.1)),
)


@pytest.mark.parametrize("made", SAMPLED, ids=lambda one: one.name)
def test_the_time_of_sampling_is_no_parameter(made):
    """It changed the equations, while the part sampled as before."""
    given, said = (
        ([0.0, 0.1, 0.2], [1.0] * made.ninputs),
        f"unknown parameter '{made.name}.dt'",
    )
    says(
        clpt.ClptError,
        said,
        clpt.simulate,
        made,
        *given,
        params={f"{made.name}.dt": 0.2},
    )
    pickled = pickle.loads(pickle.dumps(made))
    assert clpt.simulate(made, *given).equals(clpt.simulate(pickled, *given))


@pytest.mark.parametrize("dt", [None, 0.5])
def test_a_port_is_called_as_arrays_have_it_where_the_part_reads_its_own_name(dt):
    runs, members = [], []
    for y in ("warmth", "T"):  # u.T of a block's own equations is a transpose
        pid = parts.pid(2.0, 0.3, 0.1, dt=dt, y=y, u="v")
        loop = clpt.connect([pid, parts.lag(5.0, u="v", y=y)], external="r")
        runs.append(clpt.simulate(loop, TIMES, 1.0)[y].values)
        many = clpt.run_ensemble(loop, {"pid.kp": [2.0]}, timepts=TIMES, inputs=1.0)
        members.append(float(many[f"{y}_final"][0]))
    assert np.array_equal(*runs)
    assert members == [runs[0][-1]] * 2


def test_a_block_of_discrete_time_iterates_and_samples():
    ports = {"inputs": {"u": 1}, "states": {"x": 1}, "dt": 0.5}
    twice = clpt.Block("twice", update=lambda t, x, u, p: 2 * x.x + u.u, **ports)
    assert clpt.simulate(twice, [0, 0.5, 1.0], 1.0).x.values.tolist() == [0, 1, 3]
    theirs = control.input_output_response(twice, np.array([0, 0.5, 1.0]), np.ones(3))
    assert theirs.outputs.tolist() == [0, 1, 3]
    loop = clpt.connect([twice, parts.lag(1.0, u="x", y="y")], external="u")
    assert clpt.simulate(loop, [0, 0.25, 0.5, 0.75, 1.0], 1.0).x.values.tolist() == [
        0,
        0,
        1,
        1,
        3,
    ]
    assert twice.copy(name="other").dt == 0.5


def test_a_plant_whose_input_and_output_have_one_name_is_refused():
    room = control.ss(-1.0, 1.0, 1.0, 0, inputs=["T"], outputs=["T"])
    with pytest.raises(
        clpt.ClptError, match="inputs would be T, T; each needs its own name"
    ):
        parts.observer(room, [1.0])
    assert parts.observer(room, [1.0], u="heat").input_ports == {"heat": 1, "T": 1}
