"""What is changed in place under several names, and what Python is told of a number's kind.

Each of these once quietly gave another number than Python does.
"""

import math

import control
import numpy as np
import pytest
from recorded import static

from clpt_control.conformance import readings
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.equations.arrays import Unread

POINTS = [
    (0.5, [0.3, -0.7, 2.0], [0.5, -0.25]),
    (2.0, [-1.2, 0.4, -0.1], [0.0, 2.0]),
    (1.0, [1.0, 1.0, 1.0], [-1.0, 0.15]),
    (3.0, [1e3, -2e5, 0.25], [1.0, 1.0]),
]
PARAMS = {"n": 3, "zero": 0.0, "k": 1.15}
LOG = [np.array([1.0, 2.0])]
MEMORY = {"last": np.zeros(3)}


class Asking:
    """Asks what it is given."""

    table = np.array([0.0, 1.0, 3.0])

    def doubled(self, a):
        if isinstance(a, float):
            return 2.0 * a
        return np.sum(a) if isinstance(a, np.ndarray) else 0.0

    def one(self, a):
        return -a if np.isscalar(a) or not hasattr(a, "__len__") else 5.0

    def matched(self, a):
        match a:
            case float():
                return 3.0 * a
        return 0.0


ASKING = Asking()


# --- what is read as Python has it ---------------------------------------------------------------


def numbers_are_overwritten(t, x, u, p):
    y, z, A, w = np.zeros(3), np.zeros(3), np.zeros((3, 3)), np.array([1.0, np.nan])
    y[0] = 1.0
    np.copyto(y, [1.0, 2.0, 3.0])
    z.put([1], [5.0])
    np.fill_diagonal(A, 2.0)
    np.add(y, 1.0, out=y)
    w[w > p["zero"]] *= 2.0
    return [*(y * x), *(z * x), *(A @ x), *w[:1]]


def parts_are_written(t, x, u, p):
    A, B, C = np.outer(x, u), np.outer(x, u), np.outer(x, x)
    np.flipud(A)[0, 0] = 9.0
    np.moveaxis(B, 0, 1)[0, 1] = 8.0
    np.swapaxes(C, 0, 1)[1, 0] = x[0]
    return [*A.ravel(), *B.ravel(), *C.ravel()]


def copies_are_left_alone(t, x, u, p):
    A, b, c = np.outer(x, u), 2.0 * x, 3.0 * x
    flat, every_second = A.T.ravel(), b[::2].ravel()
    A[0, 0], b[0] = 9.0, 9.0
    plus, sums, product = +c, np.sum(c[None], axis=0), np.prod(c[None], axis=0)
    largest, chosen = np.maximum.reduce(c[None]), np.where(True, c, 0.0)
    for k, one in enumerate((plus, sums, product, largest, chosen)):
        one[0] = k
    return [*flat, *every_second, *c, *np.where(p["n"] == 3, 1.0, x)]


def arrays_without_axes(t, x, u, p):
    a, eye = np.where(x[0] > 0, 1.0, 2.0), np.eye(3)[1]
    others = [float(a), np.float64(a), a.item(), np.sum(a), np.max(a)]
    for k in range(5):
        others[k] += x[1]
    b = eye[1, ...]
    b += x[0]
    return [1.0 * a, *others, *eye]


def whole_numbers_are_cut(t, x, u, p):
    rows = [
        np.where(x > 0, 1, 0),
        (x > 0) * 1,
        np.select([x > 0, x > 1], [1, 2], 0),
        np.full(3, p["n"]),
        np.array([p["n"], 0, 1]),
        np.where(x > 0, 1.0, 0.0),
        np.full(3, float(p["n"])),
    ]
    for row in rows:
        row[0] = 0.7 * x[1]
    return np.concatenate(rows)


def kinds_of_numbers(t, x, u, p):
    k, half = 2, 0.5
    return [
        isinstance(p["n"], int),
        isinstance(p["n"], float),
        isinstance(p["k"], float),
        type(p["n"]) is int,
        type(k) is int,
        type(half) is float,
        isinstance(np.where(x[0] > 0, 1.0, 2.0), np.ndarray),
        hasattr(p["k"], "shape"),
    ]


def methods_ask(t, x, u, p):
    return [ASKING.doubled(x[0]), ASKING.doubled(x), ASKING.one(x[0]), ASKING.matched(x[1])]


def functions_of_math(t, x, u, p):
    return [math.dist(x[:2], u), *[math.remainder(a, 2 * math.pi) for a in x]]


# --- what is refused -----------------------------------------------------------------------------


def keeps_in_a_list_beside_an_array(t, x, u, p):
    LOG.append(0.0)
    return [float(len(LOG))]


def keeps_in_a_dict_beside_an_array(t, x, u, p):
    rate = x - MEMORY["last"]
    MEMORY["last"] = x.copy()
    return rate


def adds_at_places(t, x, u, p):
    y = np.zeros(3)
    np.add.at(y, [0, 0], 1.0)
    return y * x


def changes_a_shape(t, x, u, p):
    y = np.outer(x, u)
    y.shape = (2, 3)
    return y @ x


def sorts_in_part(t, x, u, p):
    y = np.array([3.0, 1.0, 2.0])
    y.partition(1)
    return y * x


def writes_into_an_attribute(t, x, u, p):
    y = np.asarray(ASKING.table)
    y[0] = x[0]
    return ASKING.table


def catches_a_place_outside(t, x, u, p):
    try:
        return [u[int(x[0])]]
    except IndexError:
        return [-2.0]


def catches_a_parameter_of_zero(t, x, u, p):
    try:
        return [p["k"] / p["zero"] * x[0]]
    except ZeroDivisionError:
        return [5.0 * x[0]]


def limits_into_an_array(t, x, u, p):
    y, z, total = x.copy(), np.zeros(3), np.zeros(1)
    y.clip(-0.5, 0.5, out=y)
    x.cumsum(out=z)
    x.sum(out=total, axis=0, keepdims=True)
    return [*y, *z, *total, *np.maximum(x, 0.0, out=z)]


READ = [
    limits_into_an_array,
    numbers_are_overwritten,
    parts_are_written,
    copies_are_left_alone,
    arrays_without_axes,
    whole_numbers_are_cut,
    kinds_of_numbers,
    methods_ask,
    functions_of_math,
]
REFUSED = {  # with how many numbers each returns
    keeps_in_a_list_beside_an_array: 1,
    keeps_in_a_dict_beside_an_array: 3,
    adds_at_places: 3,
    changes_a_shape: 2,
    sorts_in_part: 3,
    writes_into_an_attribute: 3,
    catches_a_place_outside: 1,
    catches_a_parameter_of_zero: 1,
    lambda t, x, u, p: np.searchsorted([2.0, 1.0, 0.0], x): 3,
    lambda t, x, u, p: np.rot90(np.outer(x, u))[0]: 3,
    lambda t, x, u, p: np.clip(x, -0.5, 0.5, where=x > 0.0, out=x.copy()): 3,
    lambda t, x, u, p: [np.mean(x, where=[True, True, False])]: 1,
    lambda t, x, u, p: [round(p["k"], 1) * x[0]]: 1,
    lambda t, x, u, p: np.max(np.outer(x, u), 0, np.zeros(2)): 2,
}


def values(function, t, x, u):
    return np.array([*function(np.float64(t), np.array(x), np.array(u), dict(PARAMS))], dtype=float)


def system_of(function):
    size = REFUSED.get(function) or len(values(function, *POINTS[0]))
    sizes = {"inputs": 2, "states": 3, "outputs": size}
    return control.nlsys(lambda t, x, u, p: -x, function, params=PARAMS, name="mine", **sizes)


@pytest.mark.parametrize("function", READ)
def test_every_reading_is_as_python_has_it(function):
    asks = readings(system_of(function))
    for name in ("native", "looped", "lanes"):
        for t, x, u in POINTS:
            found = asks[name](t, x, u)[1]
            np.testing.assert_allclose(found, values(function, t, x, u), rtol=1e-13, atol=1e-12)


@pytest.mark.filterwarnings("ignore:Bitwise inversion")  # of Python 3.12 and later
@pytest.mark.parametrize("function", REFUSED)
def test_what_would_be_another_number_is_refused(function):
    with pytest.raises(Unread, match=r"mine\.output: (?!returns)"):
        wiring_of(system_of(function)).nodes[0].system.array_record("output")


def test_a_number_that_equals_the_place_of_a_value_is_not_it():
    def chosen(t, x, u, p):
        return 1.0 if u.b > 0 else u.a

    block = static(chosen, {"a": (), "b": ()}, {"y": ()})
    for a, b in ((5.0, -1.0), (5.0, 1.0)):
        wanted = 1.0 if b > 0 else a
        assert [ask(0.0, [], [a, b])[1] for ask in readings(block).values()] == [wanted] * 7
