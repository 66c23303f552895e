"""Parts as blocks: derivatives, mistakes, names, and in python-control."""

import pickle
import re

import control
import numpy as np
import pytest
from test_parts_closed_forms import TIMES

import clpt_control as clpt
from clpt_control import parts


def test_a_source_has_nothing_to_linearize_along():
    with pytest.raises(clpt.DiagramError, match="noise: has no states and no inputs"):
        clpt.linearize(parts.noise(1.0, 0.1), [], [], t=0.0)


# --- mistakes, names ----------------------------------------------------------------------------


MISTAKES = r"""
    parts.saturation(1, -1) -> saturation: low = 1: must be below high = -1
    parts.rate_limit(1.0) -> give lag, in continuous time, or dt
    parts.delay(1.0, dt=0.3) -> delay = 1.0: must be a multiple of dt = 0.3
    parts.lag(0.0) -> lag = 0.0: must be positive
    parts.saturation([0, 1], 3, signals=3) -> must be one number, or 3
    parts.pid(1, 0.1, hgih=1) -> has no port or parameter 'hgih', but
    parts.pid(1, 1, dt=1, tracking=0.5) -> tracking = 0.5: must be above half of
    parts.pid(1, r="a", y="a") -> pid: its inputs would be a, a; each needs its own
    parts.observer(control.ss(-np.eye(2), np.eye(2), [[1, 2]], 0), [[1, 2]]) -> must be (2, 1)
    parts.lookup_table([0, 0], [1, 2]) -> two or more increasing numbers
    parts.planar_vehicle(np.ones((3, 3)), np.eye(3)) -> m12 = m13 = 0
    parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[0]]) -> and R definite
    parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[1]], [[-1]]) -> P0: must be
"""


@pytest.mark.parametrize("mistake", MISTAKES.strip().splitlines())
def test_mistakes_are_told(mistake):
    call, said = mistake.split(" -> ")
    with pytest.raises((clpt.BlockError, clpt.ArgumentError), match=re.escape(said)):
        eval(call.strip(), {"parts": parts, "control": control, "np": np})


@pytest.mark.parametrize(
    "made",
    [
        parts.pid(2, 0.7, 0.1, dt=0.1),
        parts.rate_limit(1, dt=0.1),
        parts.backlash(1, dt=0.1),
        parts.relay(1, -1, dt=0.1),
    ],
    ids=lambda one: one.name,
)
def test_the_time_of_sampling_is_no_parameter(made):
    """It changed the equations, while the part sampled as before."""
    changed = {f"{made.name}.dt": 0.2}
    with pytest.raises(clpt.ClptError, match=f"unknown parameter '{made.name}.dt'"):
        clpt.simulate(made, [0.0, 0.1, 0.2], [1.0] * made.ninputs, params=changed)
    pickled = pickle.loads(pickle.dumps(made))
    runs = [clpt.simulate(one, [0.0, 0.1, 0.2], [1.0] * made.ninputs) for one in (made, pickled)]
    assert runs[0].equals(runs[1])


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
    def double(t, x, u, p):
        return 2 * x.x + u.u

    twice = clpt.Block("twice", update=double, inputs={"u": 1}, states={"x": 1}, dt=0.5)
    assert clpt.simulate(twice, [0, 0.5, 1.0], 1.0).x.values.tolist() == [0, 1, 3]
    theirs = control.input_output_response(twice, np.array([0, 0.5, 1.0]), np.ones(3))
    assert theirs.outputs.tolist() == [0, 1, 3]
    loop = clpt.connect([twice, parts.lag(1.0, u="x", y="y")], external="u")
    held = clpt.simulate(loop, [0, 0.25, 0.5, 0.75, 1.0], 1.0)
    assert held.x.values.tolist() == [0, 0, 1, 1, 3]
    assert twice.copy(name="other").dt == 0.5
