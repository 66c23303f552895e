"""Truth values, whole numbers, what is changed in place or kept: as Python has it, or refused.

Each of these once gave another number than Python does, or an exception of the reader's own.
"""

import control
import numpy as np
import pytest
from engine_runs import Unread, wiring_of
from functions_with_side_effects import PARAMS, READ, REFUSED
from recorded_blocks import recorded

STATES = (
    [0.3, -0.7, 2.0],
    [-1.2, 0.4, -0.1],
    [1.0, 1.0, 1.0],
    [0.0, 0.0, 0.0],
    [2.5, 1.5, -3.0],
)
POINTS = [
    (t, x, u)
    for t, x in zip([0.0, 2.5, 3.0, 7.0, 1.0], STATES, strict=True)
    for u in ([0.5, -0.25], [0.0, 2.0], [-1.0, 0.15])
]


def block_of(function, params):
    """Return a block of the function's outputs, as python-control would have them."""
    size = np.size(function(*map(np.array, POINTS[0]), dict(params)))
    ports = {"inputs": 2, "outputs": size, "states": 3, "params": params}
    return (
        wiring_of(control.nlsys(lambda t, x, u, p: 0.0 * x, function, **ports))
        .nodes[0]
        .system
    )


@pytest.mark.parametrize("name", READ)
def test_numbers_of_every_kind_are_as_python_has_them(name):
    block = block_of(READ[name], PARAMS)
    for t, x, u in POINTS:
        x, u = np.array(x), np.array(u)
        found = recorded(block, "output", t, x, u)
        with np.errstate(all="ignore"):
            wanted = np.ravel(
                np.asarray(READ[name](t, x.copy(), u.copy(), dict(PARAMS)), float)
            )
        np.testing.assert_allclose(np.ravel(found), wanted, rtol=1e-13, atol=1e-13)


def test_nothing_is_printed_while_a_function_is_read(capsys):
    block = block_of(READ['print("here") or x'], PARAMS)
    capsys.readouterr()
    block.array_record("output")
    assert capsys.readouterr().out == ""


@pytest.mark.filterwarnings("ignore:the matrix subclass")
@pytest.mark.filterwarnings("ignore:Bitwise inversion")  # of a bool, Python 3.12 on
@pytest.mark.parametrize("name", REFUSED)
def test_what_would_be_another_number_is_refused(name):
    with pytest.raises(Unread, match=r"output: "):
        block_of(REFUSED[name], PARAMS).array_record("output")
