"""Runs that slide on several switches at once, against solutions from event to event."""

from itertools import product

import control
import numpy as np
import pytest
import scipy.integrate
from test_event_location import system

import clpt_control as clpt

REST = 1e-9  # speed below which a joint is at rest


class Joints:
    """M(q) v' = h(t, q, v) - F s, where s is the sign of v - belt, or between -1 and 1 at rest."""

    def __init__(self, M, h, F, belt=0.0):
        self.M, self.h, self.F, self.belt = M, h, np.asarray(F), belt

    def rates(self, t, x, u, p):
        """Return the rates as a user writes them."""
        q, v = np.split(x, 2)
        return np.concatenate([v, self.accelerations(t, q, v, np.sign(v - self.belt))])

    def accelerations(self, t, q, v, s):
        return np.linalg.solve(self.M(q), self.h(t, q, v) - self.F * s)

    def motion(self, t, x, modes):
        """Return accelerations and all s; a joint of mode 0 is at rest."""
        q, v = np.split(x, 2)
        rest = np.asarray(modes) == 0
        s = np.array(modes, dtype=float)
        M = self.M(q)
        free = self.h(t, q, v) - self.F * s
        a = np.zeros(len(q))
        moving = np.ix_(~rest, ~rest)
        a[~rest] = np.linalg.solve(M[moving], free[~rest])
        s[rest] = ((free - M @ a) / self.F)[rest]
        return a, s

    def modes(self, t, x):
        """Return the modes with which Newton's law and Coulomb's law both hold."""
        v = np.split(x, 2)[1] - self.belt
        choices = [
            (-1, 0, 1) if abs(speed) < REST else (int(np.sign(speed)),) for speed in v
        ]
        for modes in sorted(product(*choices), key=np.count_nonzero):
            a, s = self.motion(t, x, modes)
            leaves = (np.abs(v) < REST) & (np.array(modes) != 0)
            if np.all(np.abs(s) <= 1.0) and np.all(a[leaves] * s[leaves] > 0.0):
                return modes
        raise AssertionError("no mode is consistent")

    def rates_of(self, modes):
        """Return the rates with joints at rest."""
        return lambda t, x: [*np.split(x, 2)[1], *self.motion(t, x, modes)[0]]

    def margin(self, k, modes):
        """Return the event that ends the mode of a joint."""

        def margin(t, x):
            if modes[k]:
                speed = np.split(x, 2)[1][k] - self.belt
                return modes[k] * speed + 1e-13
            _, s = self.motion(t, x, modes)
            return 1.0 - abs(s[k]) + 1e-13

        margin.terminal, margin.direction = True, -1.0
        return margin

    def from_event_to_event(self, times, x):
        """Integrate one combination of modes after the other."""
        states = []
        t, x = times[0], np.array(x, dtype=float)
        while True:
            modes = self.modes(t, x)
            found = scipy.integrate.solve_ivp(
                self.rates_of(modes),
                (t, times[-1]),
                x,
                "DOP853",
                times[times >= t],
                rtol=1e-12,
                atol=1e-13,
                max_step=0.02,
                events=[self.margin(k, modes) for k in range(len(modes))],
            )
            states += [*np.transpose(found.y)]
            if found.status == 0:
                return np.array(states)
            k = next(k for k, at in enumerate(found.t_events) if len(at))
            t, x = found.t_events[k][0], found.y_events[k][0]
            if np.any(found.t == t):
                states.pop()
            if modes[k]:
                x[len(modes) + k] = self.belt


def chain(count):
    """Masses between walls, joined by springs, each with its own friction; the first is pulled."""
    stiffness = 4.0 * (2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1))
    first = np.eye(count)[0]

    def pull(t, q, v):
        return -stiffness @ q + first * 1.5 * np.sin(t)

    friction = np.linspace(0.3, 0.5, count)
    return Joints(lambda q: np.eye(count), pull, friction)


def arm(load):
    """A two-link arm in a plane, with torques in both joints and dry friction."""

    def M(q):
        c = 0.6 * np.cos(q[1])
        return np.array([[2.0 + 2.0 * c, 0.5 + c], [0.5 + c, 0.5]])

    def torque(t, q, v):
        s = 0.6 * np.sin(q[1])
        bend = np.array([-s * v[1] * (2.0 * v[0] + v[1]), s * v[0] ** 2])
        drive = load * np.array([np.sin(1.3 * t), 0.6 * np.sin(2.1 * t)])
        return drive - bend - np.array([1.0, 0.4]) * q

    return Joints(M, torque, [0.5, 0.25])


def belt():
    """Two blocks on a belt, each held by a spring and both joined by a third."""
    stiffness = np.array([[3.0, -1.5], [-1.5, 4.0]])
    return Joints(lambda q: np.eye(2), lambda t, q, v: -stiffness @ q, [1.0, 0.8], 0.4)


CASES = {
    "two masses": (chain(2), [0, 0, 0.5, 0.5], 20.0),
    "four masses": (chain(4), [0, 0.3, 0, -0.2, 0, 0, 0, 0], 12.0),
    "an arm that rests": (arm(0.2), [0.1, -0.1, 0, 0], 5.0),
    "an arm that moves": (arm(2.5), [0.1, -0.1, 0, 0], 12.0),
    "a belt": (belt(), [0, 0, 0.4, 0.4], 20.0),
}


@pytest.mark.long
@pytest.mark.parametrize(
    "case",
    [
        pytest.param(name, marks=[pytest.mark.long] if name == "four masses" else [])
        for name in CASES
    ],
)
def test_dry_friction_in_several_joints_sticks_and_slips(case):
    joints, start, end = CASES[case]
    tight = {"rtol": 1e-10, "atol": 1e-12}
    tolerances = tight if case == "an arm that moves" else {}
    times = np.linspace(0.0, end, 101)
    n = len(start)
    model = control.nlsys(
        joints.rates, None, inputs=0, outputs=n, states=n, name="joints"
    )
    run = clpt.simulate(model, times, 0, start, **tolerances)
    assert run.attrs["engine"] == "native"
    assert run.attrs["status"] == "finished"
    wanted = joints.from_event_to_event(times, start)
    np.testing.assert_allclose(run.states.values, wanted, atol=2e-7)


@pytest.mark.long
def test_loads_from_rest_move_some_joints_and_leave_others():
    """Accelerations of three coupled joints are constant, as combinations of modes say."""
    rng = np.random.default_rng(1)
    root = rng.standard_normal((3, 3))
    M = root @ root.T + 0.5 * np.eye(3)
    F = np.array([0.8, 0.5, 0.6])

    def rates(t, x, u, p):
        return [*np.linalg.solve(M, x[3:] - F * np.sign(x[:3])), 0.0, 0.0, 0.0]

    model = control.nlsys(rates, None, inputs=0, outputs=6, states=6, name="joints")
    resting = set()
    for load in rng.uniform(-1.5, 1.5, (25, 3)) * np.linspace(0.1, 1.6, 25)[:, None]:
        joints = Joints(lambda q: M, lambda t, q, v, load=load: load, F)
        modes = joints.modes(0.0, np.zeros(6))
        run = clpt.simulate(model, [0, 1, 2], 0, [0, 0, 0, *load])
        wanted, _ = joints.motion(0.0, np.zeros(6), modes)
        np.testing.assert_allclose(
            run.states.values[:, :3], np.outer([0, 1, 2], wanted), atol=1e-8
        )
        resting.add(3 - np.count_nonzero(modes))
    assert resting == {0, 1, 2, 3}


AT_ZERO = {  # both rates lead to 0, and the time from which both states rest there
    "each axis": (
        "x' = -1.5*sign(x) + sin(t); y' = -2.5*sign(y) + cos(2*t) + 0.4*sign(x)",
        0.3,
    ),
    "a corner": ("x' = 2*sign(y) - sign(x); y' = -2*sign(x) - sign(y)", 0.26),
}


@pytest.mark.parametrize("several", AT_ZERO)
def test_both_states_rest_where_both_rates_lead_back(several):
    rates, since = AT_ZERO[several]
    times = np.array([0.0, since, 1.0, 5.0])
    run = clpt.simulate(system(rates, 2), times, None, [0.3, 0.2])
    np.testing.assert_allclose(run.states.values[1:], 0.0, atol=1e-8)


REFUSED = {
    "x' = -2*sign(x) + sign(x)*sign(y) + 0.5; y' = -2*sign(y)": r"\(not affine\): "
    r"`sign` in plant.update \(x\), `sign` in plant.update \(y\). Give the switch",
    "x' = -sign(x) - sign(y) - 2*sign(x + y); y' = -sign(y) - sign(x)": "3 switches at once, "
    r"which depend on each other: `sign` in plant.update \(x, y\), `sign`",
}


@pytest.mark.parametrize("rates", REFUSED)
def test_switches_whose_motion_is_not_known_are_named(rates):
    with pytest.raises(clpt.SimulationError, match=REFUSED[rates]):
        clpt.simulate(system(rates, 2), [0.0, 1.0], None, [0.3, 0.1])
