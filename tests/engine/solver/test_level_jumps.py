"""States that jump where a guard is left, against closed forms and SciPy's events."""

from itertools import pairwise

import control
import numpy as np
import pytest
import scipy.integrate

import clpt_control as clpt

G = 9.81
T = np.linspace(0.0, 3.0, 61)


def ball(name="ball", r=0.8):
    """A ball that bounces on the ground with a coefficient of restitution."""
    return clpt.Block(
        name,
        update=lambda t, x, u, p: [x[1], -G],
        states={f"{name}_h": 1, f"{name}_v": 1},
        parameters={"r": r},
        jump=lambda t, x, u, p: [0.0, -p.r * x[1]],
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )


def bouncing(t, h, v, r):
    """Height and velocity of a ball, flight by flight."""
    landing = (v + np.sqrt(v * v + 2.0 * G * h)) / G
    while t >= landing:
        v = -r * (v - G * landing)
        t, h, landing = t - landing, 0.0, 2.0 * v / G
    return h + v * t - 0.5 * G * t * t, v - G * t


@pytest.mark.parametrize("method", ["dop853", "rodas5p"])
@pytest.mark.parametrize("start", [(1.0, 0.0, 0.8), (0.0, 2.5, 0.9), (0.4, -1.0, 1.0)])
def test_a_ball_bounces(start, method):
    """From rest, thrown up from the ground itself, and thrown down."""
    h, v, r = start
    run = clpt.simulate(ball(r=r), T, None, [h, v], method=method)
    wanted = [bouncing(t, h, v, r) for t in T]
    np.testing.assert_allclose(run.states.values, wanted, atol=1e-8)
    assert run.attrs["method"].endswith(" jumps at levels")


def test_a_sample_at_a_jump_is_after_it():
    saw = clpt.Block(
        "saw",
        update=lambda t, x, u, p: [-1.0],
        states={"s": 1},
        jump=lambda t, x, u, p: [1.0],
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )
    run = clpt.simulate(saw, [0.0, 0.5, 1.0, 1.5, 1.75], None, [1.0])
    np.testing.assert_allclose(run.s.values.ravel(), [1.0, 0.5, 1.0, 0.5, 0.25])


def test_each_flight_of_a_stiff_ball_goes_on_by_an_implicit_method():
    """A sensor that follows the height in 10 us is behind it by 10 us of its rate."""

    def rates(t, x, u, p):
        return [x[1], -G, 1e5 * (x[0] - x[2])]

    block = clpt.Block(
        "ball",
        states={"h": 1, "v": 1, "y": 1},
        update=rates,
        jump=lambda t, x, u, p: [0.0, -p.r * x[1], x[2]],
        parameters={"r": 1.0},
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )
    run = clpt.simulate(block, T, None, [1.0, 0.0, 1.0], params={"ball.r": 0.8})
    for t, (h, v, y) in zip(T, run.states.values, strict=True):
        np.testing.assert_allclose([h, v], bouncing(t, 1.0, 0.0, 0.8), atol=1e-7)
        if t > 0.0:
            np.testing.assert_allclose(y, h - 1e-5 * v - 1e-10 * G, atol=1e-7)
    methods, jumps = run.attrs["method"].rsplit(", ", 1)
    assert methods.startswith("DOP853, from t = ")
    assert methods.endswith(" Rodas5P")
    assert jumps.endswith(" jumps at levels")
    members = clpt.run_ensemble(
        block,
        {"ball.r": [0.9, 0.8]},
        timepts=T,
        initial_state=[1.0, 0.0, 1.0],
        trajectories=True,
    )
    np.testing.assert_array_equal(members.h.values[1].ravel(), run.states.values[:, 0])


def test_many_bounces_keep_the_energy():
    times = np.linspace(0.0, 200.0, 7)
    run = clpt.simulate(ball(r=1.0), times, None, [1.0, 0.0])
    h, v = run.states.values.T
    np.testing.assert_allclose(G * h + 0.5 * v**2, G, rtol=1e-9)
    wanted = [bouncing(t, 1.0, 0.0, 1.0) for t in times]
    np.testing.assert_allclose(run.states.values, wanted, atol=1e-8)


@pytest.mark.parametrize("r", [0.0, 0.1, 0.5, 0.9])
def test_bounces_that_accumulate_end_with_a_sentence(r):
    """All flights together last sqrt(2 h/g) (1 + r)/(1 - r)."""
    end = np.sqrt(2.0 / G) * (1.0 + r) / (1.0 - r)
    sentence = "ball jumps at its level without end. End the run before"
    with pytest.raises(clpt.SimulationError, match=sentence) as caught:
        clpt.simulate(ball(r=r), [0.0, 20.0], None, [1.0, 0.0])
    reached = float(str(caught.value).partition("t = ")[2].partition(":")[0])
    np.testing.assert_allclose(reached, end, atol=1e-4)
    run = clpt.simulate(ball(r=r), [0.0, 0.95 * end], None, [1.0, 0.0])
    assert run.attrs["status"] == "finished"


def test_balls_bounce_each_by_itself():
    """Two that land at one instant, and one that does not."""
    starts = {"a": (1.0, 0.8), "b": (1.0, 0.9), "c": (0.7, 1.0)}
    blocks = [ball(name, r) for name, (_, r) in starts.items()]
    state = [number for h, _ in starts.values() for number in (h, 0.0)]
    run = clpt.simulate(clpt.connect(blocks), T, None, state)
    for name, (h, r) in starts.items():
        wanted = [bouncing(t, h, 0.0, r)[0] for t in T]
        np.testing.assert_allclose(run[f"{name}_h"].values.ravel(), wanted, atol=1e-8)


def hopper(seed):
    """A mass on a spring that hits the ground, with a kink, an input that bends, and a memory.

    Return rates of (t, x, u), the jump, start, samples of the input.
    """
    random = np.random.default_rng(seed)
    stiff, damp, rest, lift = random.uniform([4, 0.0, 0.05, 0.1], [16, 0.2, 0.3, 1.0])
    pull, turn, r, kick = random.uniform([0.2, 1, 0.5, -0.5], [1.0, 4, 1.0, 0.5])

    def rates(t, x, u, p):
        spring = -stiff * (x[0] - rest) - damp * x[1]
        memory = -x[2] + pull * x[0] + np.sin(turn * t)
        return [x[1], spring + lift * np.abs(x[2]) + u[0], memory]

    def jump(t, x, u, p):
        return [0.0, -r * x[1], x[2] + kick]

    start = [random.uniform(0.5, 1.5), random.uniform(-1, 1), random.uniform(-1, 1)]
    return rates, jump, start, random.uniform(-2, 2, 7)


@pytest.mark.parametrize(
    "seed",
    [0, 1, 2, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(3, 30))],
)
def test_random_hoppers_are_those_of_scipys_events(seed):
    rates, jump, start, samples = hopper(seed)
    times = np.linspace(0.0, 6.0, 7)
    block = clpt.Block(
        "hopper",
        update=rates,
        inputs={"force": 1},
        states={"x": 3},
        jump=jump,
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )
    run = clpt.simulate(block, times, samples, start)

    def landing(t, x, *force):
        return x[0]

    landing.terminal, landing.direction = True, -1.0
    x, wanted, jumps = np.array(start), [start], 0
    for k, (begin, end) in enumerate(pairwise(times)):
        line = lambda t, k=k: [np.interp(t, times[k : k + 2], samples[k : k + 2])]  # noqa: E731
        t = begin
        while t < end:
            part = scipy.integrate.solve_ivp(
                lambda t, x, line=line: rates(t, x, line(t), None),
                (t, end),
                x,
                "DOP853",
                rtol=1e-12,
                atol=1e-13,
                max_step=0.01,
                events=landing,
            )
            t, x = part.t[-1], part.y[:, -1]
            if part.status == 1:
                x, jumps = np.array(jump(t, x, None, None)), jumps + 1
        wanted.append(x)
    assert jumps > 0
    np.testing.assert_allclose(run.states.values, wanted, atol=2e-7)


def particle(name, other, gap, to_wall):
    """A particle that meets its neighbour, whose velocity it takes, or a wall."""

    def jump(t, x, u, p):
        at_wall = to_wall(x[0]) < gap(x[0], u[0])
        return [x[0], np.where(at_wall, -x[1], u[1])]

    def nearest(t, x, u, p):
        return np.minimum(gap(x[0], u[0]), to_wall(x[0]))

    return clpt.Block(
        name,
        update=lambda t, x, u, p: [x[1], 0.0],
        inputs={f"{other}_q": 1, f"{other}_v": 1},
        states={f"{name}_q": 1, f"{name}_v": 1},
        jump=jump,
        guard=clpt.Guard(nearest, "jump"),
    )


def test_two_particles_exchange_their_velocities():
    """Equal masses between walls: together they move as two that pass through each other."""
    left = particle("left", "right", lambda q, other: other - q, lambda q: q)
    right = particle("right", "left", lambda q, other: q - other, lambda q: 1.0 - q)
    times = np.linspace(0.0, 12.0, 121)
    pair = clpt.connect([left, right])
    run = clpt.simulate(pair, times, None, [0.2, 0.31, 0.6, -0.47])
    free = np.array([0.2 + 0.31 * times, 0.6 - 0.47 * times])
    wanted = np.sort(np.abs((free + 1.0) % 2.0 - 1.0), axis=0)
    found = [run.left_q.values.ravel(), run.right_q.values.ravel()]
    np.testing.assert_allclose(found, wanted, atol=1e-8)


STEP = 7.3  # time at which the reference turns


def reference(t):
    """Return 1, then -0.5."""
    return np.where(t < STEP, 1.0, -0.5)


def clegg_rates(t, x, u, p):
    """A plant of order 2 with an integrator c of e = r - y, which is reset where e is 0."""
    e = reference(t) - x[0]
    return [x[1], 3.0 * x[2] + e - 0.6 * x[1] - x[0], e, 0.0]


CLEGG = clpt.Block(
    "clegg",
    update=clegg_rates,
    states={"y": 1, "w": 1, "c": 1, "side": 1},
    jump=lambda t, x, u, p: [x[0], x[1], 0.0, -x[3]],
    guard=clpt.Guard(lambda t, x, u, p: x[3] * (reference(t) - x[0]), "jump"),
)


def from_reset_to_reset(times, x):
    """Integrate the loop by SciPy, from one reset to the next."""
    states, t = [], 0.0
    x = np.array(x)
    for end in (STEP, times[-1]):
        while True:
            level = 1.0 if end == STEP else -0.5
            if x[3] * (level - x[0]) < 1e-12:
                x = np.array([x[0], x[1], 0.0, -x[3]])

            def passed(t, x, level=level):
                return x[3] * (level - x[0])

            passed.terminal, passed.direction = True, -1.0
            found = scipy.integrate.solve_ivp(
                lambda t, x, end=end: clegg_rates(min(t, end - 1e-9), x, None, None),
                (t, end),
                x,
                "DOP853",
                times[(times >= t) & (times < end + (end == times[-1]))],
                rtol=1e-12,
                atol=1e-13,
                max_step=0.05,
                events=passed,
            )
            states += [*np.reshape(np.transpose(found.y), (-1, 4))]
            if found.status == 1:
                t, x = found.t_events[0][0], found.y_events[0][0]
                continue
            last = scipy.integrate.solve_ivp(
                lambda t, x, end=end: clegg_rates(min(t, end - 1e-9), x, None, None),
                (t, end),
                x,
                "DOP853",
                rtol=1e-12,
                atol=1e-13,
            )
            t, x = end, last.y[:, -1]
            break
    return np.array(states)


def test_a_clegg_integrator_is_reset_where_the_error_changes_sign():
    """By the plant, or by the reference."""
    times = np.linspace(0.0, 15.0, 101)
    start = [0.0, 0.0, 0.0, 1.0]
    run = clpt.simulate(CLEGG, times, None, start)
    wanted = from_reset_to_reset(times, start)
    np.testing.assert_allclose(run.states.values, wanted, atol=1e-7)
    assert int(run.attrs["method"].split()[1]) >= 5


def test_members_jump_as_runs_do():
    r = np.array([0.7, 0.8, 0.9])
    many = clpt.run_ensemble(
        ball(), {"ball.r": r}, timepts=[0.0, 1.0, 2.0], initial_state=[1.0, 0.0]
    )
    wanted = [bouncing(2.0, 1.0, 0.0, one)[0] for one in r]
    np.testing.assert_allclose(many.ball_h_final.values.ravel(), wanted, atol=1e-8)


def test_equations_name_the_level():
    found = clpt.equations(ball())
    assert "ball_v+ = -ball_v*r at ball_h = 0" in str(found)
    assert r"\text{ at }" in found.latex()


OUTSIDE = clpt.Block(
    "sinking",
    update=lambda t, x, u, p: [-1.0],
    states={"h": 1},
    jump=lambda t, x, u, p: [-0.5],
    guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
)
REFUSED = {
    "jump at this point": lambda: clpt.linearize(ball(), [0.0, 1.0]),
    "whose time varies": lambda: clpt.sensitivity(
        ball(), T, "states", ["ball.r"], None, [1, 0]
    ),
    "proofs are for jumps in time": lambda: clpt.lyapunov(ball(), "ball_h"),
    "outside of its guard": lambda: clpt.simulate(OUTSIDE, T, None, [1.0]),
    "python-control ignores": lambda: control.input_output_response(
        ball(), T, 0, [1.0, 0.0]
    ),
    "needs a `jump`": lambda: clpt.Block(
        "b",
        update=lambda t, x, u, p: [0.0],
        states={"x": 1},
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    ),
}


@pytest.mark.parametrize("sentence", REFUSED)
def test_jumps_at_a_level_are_refused_elsewhere(sentence):
    with pytest.raises(clpt.ClptError, match=sentence):
        REFUSED[sentence]()


def test_a_point_above_the_level_has_a_linear_model():
    linear = clpt.linearize(ball(), [1.0, 0.0])
    np.testing.assert_array_equal(linear.A, [[0.0, 1.0], [0.0, 0.0]])
    (note,) = clpt.check(ball()).notes  # its functions are not at the top of a module
    assert "cannot be pickled" in note


@pytest.mark.parametrize("opaque", [False, True])
@pytest.mark.parametrize(
    "distance",
    [
        lambda t, x, u, p: x[0] > 0.5,
        lambda t, x, u, p: [x[0] > 0.5],
        lambda t, x, u, p: {"distance": x[0] > 0.5},
    ],
)
def test_a_truth_value_is_no_distance(distance, opaque):
    """It is 0 or 1, and never below 0: the run would pass the level in silence."""

    def run():
        falling = clpt.Block(
            "falling",
            update=lambda t, x, u, p: [-1.0],
            states={"h": 1},
            guard=clpt.Guard(distance, "stop"),
            opaque=opaque,
        )
        clpt.simulate(falling, [0, 1, 2], initial_state=[1.0])

    with pytest.raises(clpt.BlockError, match=r"x\[0\] - 1 for x\[0\] > 1"):
        run()


@pytest.mark.parametrize(
    "distance",
    [
        lambda t, y, u: 1 if t < 3 else 0,
        lambda t, y, u: 1.0 * (t < 3),
        lambda t, y, u: np.clip(y.h - 1, 0, 10),
        lambda t, y, u: abs(y.h),
    ],
)
def test_a_distance_that_is_never_below_0_is_refused(distance):
    """A run would pass its end in silence."""
    falling = clpt.Block("falling", update=lambda t, x, u, p: [-1.0], states={"h": 1})
    with pytest.raises(clpt.BlockError, match="is never below 0, so no run leaves it"):
        clpt.simulate(falling, [0, 1, 4], initial_state=[2.0], stop=distance)


@pytest.mark.parametrize("by", ["stop", "guard"])
def test_a_run_that_ends_where_it_begins_warns(by):
    """A reversed sign: `stop` and a guard's distance are above 0 where a run goes on."""
    guard = clpt.Guard(lambda t, x, u, p: -x[0], "stop") if by == "guard" else None
    stop = (lambda t, y, u: y.h < 0.0) if by == "stop" else None
    falling = clpt.Block(
        "falling", update=lambda t, x, u, p: [-1.0], states={"h": 1}, guard=guard
    )
    with pytest.warns(UserWarning, match="the run ends at its start"):
        run = clpt.simulate(falling, [0, 1, 2], initial_state=[1.0], stop=stop)
    assert run.sizes["time"] == 1
