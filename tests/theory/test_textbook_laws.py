"""Right laws of textbooks are proved or bounded, and not their wrong twins."""

import numpy as np
import own_laws
import pytest
from own_laws import GAIN, law
from textbook_laws import LAWS

import clpt_control as clpt
from clpt_control.blocks.lyapunov import lyapunov_candidate, one_gain
from clpt_control.theory.proving.own_law import prove

POINTS = 200


@pytest.mark.parametrize("name", LAWS)
def test_a_law_of_a_textbook_is_shown(name):
    make, more, status = LAWS[name]
    assert prove(make(), points=POINTS, **more).status == status


def test_V_of_the_paper_with_the_papers_numbers_is_proved():
    scenario = clpt.paper_scenario()
    car, N = scenario.vehicle, scenario.basis.N
    truth = (scenario.flow.parameters, car.feedback, car.feedforward)
    own = law(own_laws.shipped, {"gain": 0.8}, n=N)
    V = lyapunov_candidate("learned-flow", one_gain(0.8, *truth))
    assert prove(own, V, points=POINTS).status == "proved"
    found = prove(own, lambda truth: lyapunov_candidate("learned-flow", one_gain(0.8, *truth)))
    assert (found.status, found.for_every_N) == ("proved", True)


def test_a_V_of_other_numbers_is_not_the_truths():
    """Of V made of KD once, for every truth, nothing is shown; nor is it called wrong."""

    def made(truth):
        own = truth._replace(KD=np.array([1.0, 0.7]))
        return lyapunov_candidate("learned-flow", one_gain(0.5, *own))

    found = prove(law(own_laws.shipped, GAIN), made, points=POINTS)
    assert found.status == "open"
    assert "not shown" in found._repr_html_()
    assert "does not hold" not in found._repr_html_()
