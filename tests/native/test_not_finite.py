"""A signal that is NaN in the middle of a run is named: block, signal and time."""

import math
import re

import numpy as np
import pytest

from clpt_control import simulate
from clpt_control.diagrams.interconnection import connect
from clpt_control.equations import Block
from clpt_control.errors import SimulationError
from clpt_control.native import solver
from clpt_control.native.batch import Batch
from clpt_control.native.ending import Status
from clpt_control.native.machine import LANES
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram


def root_of(t, x, u, p):
    """y = sqrt(1.5 - s), section 2: u = s[1], y = root[1]."""
    return math.sqrt(1.5 - u[0])


def line(t, x, u, p):
    """s' = 1, section 2: u = root[1], state s[1]."""
    return 1.0 + 0.0 * u[0]


def diagram():
    """A signal that ends to exist at t = 1.5."""
    return connect(
        [
            Block("root", output=root_of, inputs={"s": 1}, outputs={"root": 1}),
            Block("line", update=line, inputs={"root": 1}, states={"s": 1}),
        ]
    )


def said(sentence):
    """The time that a sentence names, with the block and its signal."""
    assert "signal root[0] of block root is not finite" in sentence
    assert "\n" not in sentence
    return float(re.search(r"t = ([0-9.e+-]+)", sentence).group(1))


@pytest.mark.parametrize("engine", ["native", "python"])
def test_simulate_names_it(engine):
    with pytest.raises(SimulationError) as caught:
        simulate(diagram(), [0.0, 0.4, 3.0], engine=engine)
    assert 0.4 <= said(str(caught.value)) <= 1.5 + 1e-9


@pytest.mark.parametrize(
    "made", [PythonDiagram, NativeDiagram, lambda diagram: NativeDiagram(diagram, form="looped")]
)
@pytest.mark.parametrize("step", [None, 0.01])
def test_every_engine_and_method_names_it(made, step):
    with pytest.raises(SimulationError) as caught:
        made(diagram()).run([0.0], [0.0, 1.0, 3.0], step=step)
    assert 1.0 <= said(str(caught.value)) <= 1.5 + 0.02


@pytest.mark.parametrize("lanes", [1, LANES])
@pytest.mark.parametrize("step", [None, 0.01])
def test_beside_others_a_run_keeps_what_it_reached(lanes, step):
    native = NativeDiagram(diagram())
    starts = np.linspace(0.0, 1.0, 5)[:, None]  # they end at 1.5, 1.25, ..., 0.5
    P = np.tile(native.parameters(), (5, 1))
    times = np.array([0.0, 0.4, 1.1])
    callee = native.callee(lanes, None, solver.DOP853 if step is None else solver.RK4)
    pieces, longest = [native.schedule(0.0, 1.1)], np.inf if step is None else step
    runs = Batch(callee, starts, P, times, pieces, None, longest)
    runs.adaptive(1e-8, 1e-10)
    bad = (Status.NOT_FINITE, Status.TOO_SMALL)
    assert [status in bad for status in runs.status] == [False, False, True, True, True]
    assert list(runs.reached) == [3, 3, 2, 2, 2]
    assert np.isnan(runs.out[2:, 2]).all()
    np.testing.assert_allclose(runs.out[:, 1], starts + 0.4, atol=1e-9)
