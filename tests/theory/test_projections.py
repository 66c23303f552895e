"""Projections of the gains of a model-reference loop: what keeps V falling, and what does not.

V' is that of the gradient law, -4 e^2, less what a projection takes away.  The ideal gains are
4/3 and 5/3, |k*| = sqrt(41)/3 = 2.134.
"""

import numpy as np
import pytest
from model_reference import PROJECTIONS, V, loop, stopped_in_a_ball, stopped_smoothly

from clpt_control import lyapunov

pytestmark = pytest.mark.long  # by `make test-long`

FAST = ("if", "a box")


def judged(law, kmax):
    """Return the verdict on V of the loop with a law."""
    return lyapunov(loop(law, kmax=kmax), V, points=50)


def each(table, fast):
    """Return the names of a table, those that take long marked as slow."""
    return [
        pytest.param(name, marks=[] if name in fast else [pytest.mark.slow])
        for name in table
    ]


def goes_to_zero(found):
    """Return whether e goes to zero whatever the bounded reference is."""
    conditions = {condition.name: condition.of for condition in found.conditions}
    assert "zero inputs" not in conditions
    assert conditions["outside V, bounded"] == "ym is"
    return (found.status, found.conclusion) == ("proved", "goes to zero")


@pytest.mark.parametrize("name", each(PROJECTIONS, FAST))
def test_a_projection_beyond_the_ideal_gains_is_proved(name):
    """Each rate is taken away where it leads off both kmax = 5 and the ideal gains."""
    found = judged(PROJECTIONS[name], 5.0)
    assert goes_to_zero(found)
    assert found.claim == "V' <= -4*(y - ym)**2 <= 0"


@pytest.mark.parametrize("name", each(PROJECTIONS, ("a ball",)))
def test_a_projection_short_of_the_ideal_gains_is_not_proved(name):
    """kmax = 1 keeps from 4/3: with r it pushes V up."""
    found = judged(PROJECTIONS[name], 1.0)
    assert found.status == "refuted"
    system = loop(PROJECTIONS[name], kmax=1.0)
    (y, ym, kr, ky), rates = found.point.x, system.dynamics(*found.point)
    dy, dym, dkr, dky = rates
    slope = (y - ym) * (dy - dym) + 1.5 * ((kr - 4 / 3) * dkr + (ky - 5 / 3) * dky)
    assert slope == pytest.approx(found.value, rel=1e-6)
    assert slope > 0


RIGHT = {
    "a ball that just holds": (stopped_in_a_ball(), 2.2),
    "a ball by a root": (stopped_in_a_ball(root=True), 5.0),
    "twice the outward part": (stopped_in_a_ball(2.0), 5.0),
    "a ball about (1, 1)": (stopped_in_a_ball(center=1.0), 2.0),
    "a ball that fades": (stopped_in_a_ball(fades=True), 5.0),
    "smooth, just beyond": (stopped_smoothly(), 1.7),
}
WRONG = {
    "the outward part is added": (stopped_in_a_ball(-1.0), 5.0),
    "within the ball": (stopped_in_a_ball(side=-1.0), 5.0),
    "a ball short of the ideal gains": (stopped_in_a_ball(), 2.1),
    "a ball that fades, short": (stopped_in_a_ball(fades=True), 2.1),
    "smooth, short": (stopped_smoothly(), 1.6),
    "smooth, added": (stopped_smoothly(-1.0), 5.0),
    "smooth, below kmax": (stopped_smoothly(side=-1.0), 5.0),
    "smooth, the inward part": (stopped_smoothly(part=np.minimum), 5.0),
}


@pytest.mark.parametrize("name", each(RIGHT, ("a ball by a root",)))
def test_a_projection_of_another_form_is_proved(name):
    assert goes_to_zero(judged(*RIGHT[name]))


@pytest.mark.parametrize("name", each(WRONG, ("the outward part is added",)))
def test_an_altered_projection_is_not_proved(name):
    found = judged(*WRONG[name])
    zeroed = any(condition.name == "zero inputs" for condition in found.conditions)
    assert found.status != "proved" or zeroed
