"""Machine code: the same numbers as python-control, and what it cannot do is said."""

import re

import control
import numpy as np
import pytest
from engine_runs import NativeDiagram, PythonDiagram

import clpt_control as clpt


def test_code_is_made_once_for_diagrams_that_differ_in_numbers():
    def code(**changes):
        changes = {key.replace("_", "."): value for key, value in changes.items()}
        return NativeDiagram(
            clpt.closed_loop(clpt.paper_scenario().with_values(changes))
        ).code

    assert code(learning_gain=2.0) is code(learning_gain=0.5)
    assert code(basis_kernel="gaussian") is not code()


IGNORED = [
    ({"x0": [0.0] * 13}, "must have 14 finite numbers"),
    ({"times": [0.0]}, "times = [0.0]: must be at least two"),
    ({"max_step": 0.0}, "max_step = 0.0: must be a number, above 0"),
]


@pytest.mark.parametrize("made", [NativeDiagram, PythonDiagram])
@pytest.mark.parametrize(("changes", "sentence"), IGNORED)
def test_every_engine_refuses_what_it_would_have_to_ignore(made, changes, sentence):
    runner = made(clpt.closed_loop(clpt.paper_scenario()))
    given = {"x0": np.zeros(14), "times": [0.0, 1.0], **changes}
    with pytest.raises(clpt.ClptError, match=re.escape(sentence)):
        runner.run(given.pop("x0"), given.pop("times"), **given)


MIXER = np.array([[1.0] * 6, [1.0, -1.0, 2.0, -2.0, 3.0, -3.0]])


def hovers(t, x, u, p):
    """Rise and roll by six rotors; at rest the sum of their forces is the weight, to rounding."""
    force, moment = np.dot(MIXER, 16.35 + 0.1 * x[1] * np.arange(6.0))
    return [x[1], force / 10.0 - 9.81, moment / 3.0 - 0.2 * x[2]]


def test_a_start_where_rates_are_but_rounding_is_read(recwarn):
    craft = control.nlsys(hovers, None, inputs=0, outputs=3, states=3, name="craft")
    run = clpt.simulate(craft, [0.0, 1.0, 2.0], 0.0, 0.0)
    assert run.attrs["engine"] == "native"
    assert np.abs(run.y.values).max() < 1e-12
    assert "craft_rates" in clpt.export(craft)
    assert not [one for one in recwarn if "Python" in str(one.message)]
