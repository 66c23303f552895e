"""Functions that ask, write and keep as careless ones do; each once gave another number."""

import math
import warnings

import numpy as np
from scipy.interpolate import CubicSpline, LinearNDInterpolator, RegularGridInterpolator, interp1d

RATIOS = {0: 4.0, 1: 2.0}
with warnings.catch_warnings(action="ignore"):
    SQUARE = np.asmatrix([[1.0, 2.0], [3.0, 4.0]])
SPLINE = CubicSpline([-1.0, 0.0, 0.5, 2.0], [0.0, 1.0, -1.0, 2.0])
TRACK = CubicSpline([-1.0, 0.0, 0.5, 2.0], [[0.0, 1.0], [1.0, 3.0], [-1.0, 2.0], [0.0, 1.0]])
LAP = CubicSpline([0.0, 1.0, 1.5, 3.0], [[0.0, 1.0], [1, 3], [-1, 2], [0, 1]], bc_type="periodic")
GRID = [-1.0, 0.0, 0.5, 2.0], [-0.5, 1.0, 1.5]
HEIGHTS = np.random.default_rng(0).standard_normal((4, 3))
CHART = RegularGridInterpolator(GRID, HEIGHTS, bounds_error=False, fill_value=None)
COAST = RegularGridInterpolator(GRID, HEIGHTS, bounds_error=False, fill_value=-7.0)
COLUMN = RegularGridInterpolator(
    [[0.0, 1.0], [-1.0, 1.0], [0.0, 3.0]], np.arange(8.0).reshape(2, 2, 2) ** 2, "linear", False
)
SCATTERED = LinearNDInterpolator([[0, 0], [1, 0], [0, 1], [1, 1], [0.4, 0.6]], [0.0, 1, 2, 5, 3])
PLACES = [[0, 0], [10, 0], [0, 0.1], [10, 0.1], [4, 0.06]]
RESCALED = LinearNDInterpolator(PLACES, [0.0, 1, 2, 5, 3], rescale=True)
FLAT = LinearNDInterpolator(PLACES, [0.0, 1, 2, 5, 3], fill_value=-7.0)
FILLED = interp1d([0, 1], [[0, 1], [2, 3]], axis=0, bounds_error=False, fill_value=[7.0, 9.0])
STEPPED = RegularGridInterpolator(GRID, HEIGHTS, "nearest", bounds_error=False)


class Lever:
    """Remembers in attributes."""

    def arm(self, a):
        return math.sin(a)

    def root(self, a):
        try:
            return math.sqrt(a)
        except ValueError:
            return 0.0


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


LEVER, ASKING = Lever(), Asking()


# --- truth values --------------------------------------------------------------------------------


def is_where_of_truths(t, x, u, p):
    low = np.where(x > 0.5, u[0] > 0, True)
    return [np.sum(low), np.sum(np.where(x > 0, True, False)), np.sum(np.where(x > 0, False, low))]


def writes_into_truths(t, x, u, p):
    y = np.array([x[0] > 0, x[1] > 0])
    y[0] = 2.5
    return 1.0 * y


# --- whole numbers and short floats ------------------------------------------------------------


def is_made_by_a_parameter(t, x, u, p):
    y = np.zeros(p["n"])
    y[1] = x[0]
    return [*y, len(np.ones((p["n"], 2))), p.get(f"k{p['n']}", 0.0)]


def shortens(t, x, u, p):
    return x.astype(np.float32)


def cuts_what_it_writes(t, x, u, p):
    y = np.zeros_like(x, dtype=int)
    y[0] = x[0]
    return y


def cuts_what_is_written_into_a_parameter(t, x, u, p):
    y = p["A"].copy()
    y[0] = 1.5 * x[0]
    return y


def is_cut_in_its_place(t, x, u, p):
    y = x.astype(int)
    y[0] = u[0]
    z = y.copy()
    z[1] = 3.7 * u[1]
    z += 1
    return [*y, *z]


# --- what Python asks ----------------------------------------------------------------------------


def is_divided_in_an_array(t, x, u, p):
    kept = np.zeros(2)
    kept[:] = [float(x[0]), float(x[1])]
    try:
        return [kept[0] / kept[1]]
    except ZeroDivisionError:
        return [99.0]


def is_printed(t, x, u, p):
    print("here")
    return x


def catches_where_python_divides(t, x, u, p):
    s, whole = math.sin(x[0]), math.floor(x[1])
    try:
        return [s * math.cos(u[0]) / s, 1.0 / float(s), 7 % whole, 7 // whole]
    except ZeroDivisionError:
        return [99.0, x[1], x[2], 1.0]


def catches_what_math_refuses(t, x, u, p):
    try:
        return [math.sqrt(x[0])]
    except ValueError:
        return [-1.0]


def catches_in_a_method(t, x, u, p):
    return [LEVER.root(x[0])]


def asks_a_text(t, x, u, p):
    return [RATIOS.get(f"{x[0]:.0f}", 2.0)]


def is_divided_by_numpy(t, x, u, p):
    try:
        return [np.array([1.0, 2.0])[0] / math.sin(x[0])]
    except ZeroDivisionError:
        return [99.0]


def catches_what_numpy_raises(t, x, u, p):
    with np.errstate(all="raise"):
        try:
            return [np.float64(1.0) / x[0]]
        except FloatingPointError:
            return [7.0]


def catches_a_singular_matrix(t, x, u, p):
    try:
        return np.linalg.solve(np.outer(u, u), u)
    except np.linalg.LinAlgError:
        return u


def puts_another_mask(t, x, u, p):
    y = np.zeros(3)
    y[x > -9] = x[x < 9]
    return y


def is_without_what_is_no_number(t, x, u, p):
    a = x[0] / x[1]
    return [a, max(float("nan"), x[0])]


# --- what is changed in place ---------------------------------------------------------------------


def is_numbers_are_overwritten(t, x, u, p):
    y, z, A, w = np.zeros(3), np.zeros(3), np.zeros((3, 3)), np.array([1.0, np.nan])
    y[0] = 1.0
    np.copyto(y, [1.0, 2.0, 3.0])
    z.put([1], [5.0])
    np.fill_diagonal(A, 2.0)
    np.add(y, 1.0, out=y)
    w[w > p["zero"]] *= 2.0
    return [*(y * x), *(z * x), *(A @ x), *w[:1]]


def is_parts_are_written(t, x, u, p):
    A, B, C = np.outer(x, u), np.outer(x, u), np.outer(x, x)
    rows, diagonal, d = np.broadcast_to(C, (2, 3, 3)), np.diag(C), np.diag(x)
    np.rot90(A)[0, 0] = 9.0
    np.moveaxis(B, 0, 1)[0, 1] = 8.0
    np.swapaxes(C, 0, 1)[1, 0] = x[0]
    np.atleast_3d(C)[1, 1, 0] = 7.0
    return [*A.ravel(), *B.ravel(), *C.ravel(), *rows.ravel(), *diagonal, *d.ravel()]


def is_copies_are_left_alone(t, x, u, p):
    A, b, c = np.outer(x, u), 2.0 * x, 3.0 * x
    flat, every_second = A.T.ravel(), b[::2].ravel()
    A[0, 0], b[0] = 9.0, 9.0
    plus, sums, product = +c, np.sum(c[None], axis=0), np.prod(c[None], axis=0)
    largest, chosen = np.maximum.reduce(c[None]), np.where(True, c, 0.0)
    for k, one in enumerate((plus, sums, product, largest, chosen)):
        one[0] = k
    return [*flat, *every_second, *c, *np.where(p["n"] == 3, 1.0, x)]


def is_whole_numbers_are_cut(t, x, u, p):
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


def is_kinds_of_numbers(t, x, u, p):
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


def is_methods_ask(t, x, u, p):
    return [ASKING.doubled(x[0]), ASKING.doubled(x), ASKING.one(x[0]), ASKING.matched(x[1])]


def is_functions_of_math(t, x, u, p):
    return [math.dist(x[:2], u), *[math.remainder(a, 2 * math.pi) for a in x]]


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


def is_limits_into_an_array(t, x, u, p):
    y, z, total = x.copy(), np.zeros(3), np.zeros(1)
    y.clip(-0.5, 0.5, out=y)
    x.cumsum(out=z)
    x.sum(out=total, axis=0, keepdims=True)
    return [*y, *z, *total, *np.maximum(x, 0.0, out=z)]


FUNCTIONS = {
    name.replace("_", " "): f
    for name, f in dict(globals()).items()
    if hasattr(f, "__code__") and next(iter(f.__code__.co_varnames), "") == "t"
}
