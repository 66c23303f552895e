"""Functions that ask, write and keep as careless ones do; each once gave another number."""

import math
import warnings
from collections.abc import Iterable, Sized

import numpy as np
from scipy.interpolate import (
    CubicSpline,
    LinearNDInterpolator,
    RegularGridInterpolator,
    interp1d,
)

RATIOS = {0: 4.0, 1: 2.0}
with warnings.catch_warnings(action="ignore"):
    SQUARE = np.asmatrix([[1.0, 2.0], [3.0, 4.0]])
SPLINE = CubicSpline([-1.0, 0.0, 0.5, 2.0], [0.0, 1.0, -1.0, 2.0])
SLOPE = SPLINE.derivative()
NEAREST = interp1d(
    [0.0, 1.0, 2.0], [1.0, 3.0, 2.0], "nearest", fill_value="extrapolate"
)
TRACK = CubicSpline(
    [-1.0, 0.0, 0.5, 2.0], [[0.0, 1.0], [1.0, 3.0], [-1.0, 2.0], [0.0, 1.0]]
)
LAP = CubicSpline(
    [0.0, 1.0, 1.5, 3.0], [[0.0, 1.0], [1, 3], [-1, 2], [0, 1]], bc_type="periodic"
)
GRID = [-1.0, 0.0, 0.5, 2.0], [-0.5, 1.0, 1.5]
HEIGHTS = np.random.default_rng(0).standard_normal((4, 3))
CHART = RegularGridInterpolator(GRID, HEIGHTS, bounds_error=False, fill_value=None)
COAST = RegularGridInterpolator(GRID, HEIGHTS, bounds_error=False, fill_value=-7.0)
COLUMN = RegularGridInterpolator(
    [[0.0, 1.0], [-1.0, 1.0], [0.0, 3.0]],
    np.arange(8.0).reshape(2, 2, 2) ** 2,
    "linear",
    False,
)
SCATTERED = LinearNDInterpolator(
    [[0, 0], [1, 0], [0, 1], [1, 1], [0.4, 0.6]], [0.0, 1, 2, 5, 3]
)
PLACES = [[0, 0], [10, 0], [0, 0.1], [10, 0.1], [4, 0.06]]
RESCALED = LinearNDInterpolator(PLACES, [0.0, 1, 2, 5, 3], rescale=True)
FLAT = LinearNDInterpolator(PLACES, [0.0, 1, 2, 5, 3], fill_value=-7.0)
FILLED = interp1d(
    [0, 1], [[0, 1], [2, 3]], axis=0, bounds_error=False, fill_value=[7.0, 9.0]
)
ACROSS = CubicSpline([-1.0, 0.0, 1.0], [[0.0, 1.0, 3.0], [2, 0, 1]], axis=1)
STEPPED = RegularGridInterpolator(GRID, HEIGHTS, "nearest", bounds_error=False)


class Lever:
    """Remembers in attributes."""

    def arm(self, a):
        return math.sin(a)

    def tried(self, run, otherwise=9.0):
        return tried(run, otherwise)


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


# --- whole numbers and short floats ------------------------------------------------------------


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


def catches_what_numpy_raises(t, x, u, p):
    with np.errstate(all="raise"):
        try:
            return [np.float64(1.0) / x[0]]
        except FloatingPointError:
            return [7.0]


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


def changes_a_shape(t, x, u, p):
    y = np.outer(x, u)
    y.shape = (2, 3)
    return y @ x


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


# --- in a line -----------------------------------------------------------------------------------


def put(y, place, value):
    """An array in which one place is written, in its own kind of numbers."""
    y[place] = value
    return y


def beside(number, cut):
    """An array of 0 and a number, into which another is written: cut, if both were whole."""
    return put(np.array([0, number]), 0, cut)


def tried(run, otherwise=99.0):
    """Return what a function gives, or another number where it raises."""
    try:
        return run()
    except (ArithmeticError, ValueError, IndexError, np.linalg.LinAlgError):
        return otherwise


def changed(a, u):
    """Return what each name of a number, or of an array without axes, holds where one changes."""
    b = c = a
    b += u[0]
    c *= u[1]
    return [a * 1.0, b * 1.0, c * 1.0]


WITHOUT_AXES = """
    np.where(x[0] > 0, x[0], 3.0) ; np.where(x[0] > 0, 1.0, 3.0) ; np.array(x[0]) ; np.sum(x) ;
    np.full((), x[0]) ; np.zeros_like(x[0]) ; np.copy(x[0]) ; x[:1].reshape(()) * np.ones(()) ;
    np.squeeze(2.0 * x[:1]) ; (2.0 * x)[0, ...] ; np.where(x[0] > 0, x[0], 1.0).astype(float) ;
    x[0] ; np.dot(x, x) ; np.clip(x[0], 0.0, 1.0)
"""
COUNTED = """
    int(x[0]) ; 1 - round(x[0]) ; math.floor(x[0]) % 3 ; abs(np.int64(x[0])) ;
    divmod(int(x[0]), 2)[0] ; math.prod([int(x[0]), int(x[1])]) ; sum(int(one) for one in x) ;
    np.sum([int(x[0]), int(x[1])]) ; np.max([int(x[0]), 1]) ; np.sum(np.array([*x]) > 0.0) ;
    np.array([int(x[0]), 3])[1] + np.array([int(x[0]), 3])[0] ; float(int(x[0])) ;
    np.float64(int(x[0])) ; np.fabs(int(x[0])) ; math.pow(int(x[0]), 2) ; (3 + int(x[0])) ** -1 ;
    round(x[0], 0)
"""  # whole numbers, and what is none though it is made of them
AS_PYTHON_HAS_THEM = """
    x[0] * (p["n"] & 1) ; x[0] * ~p["short"] ; np.array([x[0] > 0, x[1] > 0]) ;
    [(x[0] > 0) * (x[1] > 0) * u[0], 1.0 * np.maximum(x[0] > 0, x[1] > 0)] ;
    [np.sum(np.where(x > 0.5, u[0] > 0, True)), np.sum(np.where(x > 0, True, False))] ;
    np.sum(np.where(x > 0, False, np.where(x > 0.5, u[0] > 0, True))) ;
    [*put(np.zeros(p["n"]), 1, x[0]), len(np.ones((p["n"], 2))), p.get(f"k{p['n']}", 0.0)] ;
    print("here") or x ; [x[0] / x[1], max(float("nan"), x[0])] ;
    np.where((x > 0) ^ (x < 1) | ~(x > -1) & (u[0] > 0), 1.0, 0.0) ;
    [*np.cumsum(x > 0), np.sum(x > 0), sum([x[0] > 0, x[1] > 0]), np.prod(x > 0)] ;
    [*(p["A"] // 2 * x[1]), p["n"] // 2 * x[0], p["n"] ** -1] ; np.argsort(x) ; np.array([1, 2]) ;
    [*(p["short"] + p["short"]), p["f"] * 3, p["f"] * x[0]] ; np.full(3, x[0], int) ;
    [hasattr(x, "__len__"), hasattr(x[0], "__len__"), type(x) is np.ndarray] ;
    [isinstance(x, Iterable | Sized), isinstance(x[0], Sized), isinstance(x[0], int | list)] ;
    [isinstance(p["n"], int), isinstance(p["n"], float), isinstance(p["k"], float)] ;
    [isinstance(int(x[0]), int), isinstance(np.int64(x[0]), int), type(round(x[0])) is int] ;
    [type(p["n"]) is int, type(2) is int, isinstance(np.where(x[0] > 0, 1.0, 2.0), np.ndarray)] ;
    [ASKING.doubled(x[0]), ASKING.doubled(x), ASKING.one(x[0]), ASKING.matched(x[1])] ;
    [*np.r_[x, 1.0, u[:1]], *np.c_[x, x[::-1]].ravel()] ; np.maximum.reduce([x[0], u[0], x[2]]) ;
    [*np.add.accumulate(x), *np.sum(np.outer(x, x), axis=1, keepdims=True).ravel()] ;
    math.hypot(1e200 * x[0], 1.0, 2.0) / 1e200 ; [math.remainder(a, 2 * math.pi) for a in x] ;
    [np.copysign(1.0, np.round(0.3 * x[0])), math.copysign(1.0, round(0.3 * x[0]))] ;
    [LEVER.arm(x[0]), math.dist(x[:2], u)] ; [*SPLINE(x), *SLOPE(x)] ;
    [*TRACK(t), *TRACK(x).ravel(), NEAREST(x[0])] ; [*SPLINE(x, 1), *FILLED(x[0])] ;
    ACROSS(x).ravel() ; x[0] * len(np.shape(SCATTERED(x[0], u[0]))) ;
    [*CHART(x[:2]), CHART((x[1], u[0])), *CHART([[x[0], x[1]], [x[2], u[1]]])] ;
    CHART([[[x[0], x[1]], [x[2], u[1]]], [[u[0], x[1]], [x[1], x[2]]]])[1] ;
    tried(lambda: np.array([1.0, 2.0])[0] / math.sin(x[0])) ;
    [*COAST((x, x[::-1])), COLUMN([x[0], u[1], x[1]])[0]] ;
    [SCATTERED(x[0], u[0]), SCATTERED(x[:2])[0], FLAT(5.0 + x[0], 0.1 * abs(u[0]))] ;
    tried(lambda: math.sqrt(x[0])) ; LEVER.tried(lambda: math.sqrt(x[0])) ;
    tried(lambda: 1.0 / math.sin(x[0])) ; tried(lambda: 7 % math.floor(x[1])) ;
    tried(lambda: 7 // math.floor(x[1])) ; tried(lambda: p["k"] / p["zero"] * x[0]) ;
    tried(lambda: math.exp(1000.0 * x[0])) ; tried(lambda: math.log(x[1])) ;
    tried(lambda: math.acos(x[0])) ; tried(lambda: math.atanh(x[1]))
"""
WOULD_BE_OTHERS = """
    1.0 * put(np.array([x[0] > 0, x[1] > 0]), 0, 2.5) ; put(np.zeros_like(x, dtype=int), 0, x[0]) ;
    put(p["A"].copy(), 0, 1.5 * x[0]) ; put(np.zeros(3), x > -9, x[x < 9]) ;
    put(np.asarray(ASKING.table), 0, x[0]) * 0.0 + ASKING.table ;
    [y := np.zeros(3), np.add.at(y, [0, 0], 1.0), y * x][2] ;
    [y := np.array([3.0, 1.0, 2.0]), y.partition(1), y * x][2] ;
    STEPPED(x[:2]) ; RESCALED(x[0], u[0]) ; LAP(t + x[0]) ;
    np.searchsorted([2.0, 1.0, 0.0], x) ; np.interp(x[0], [2.0, 1.0, 0.0], [5.0, 0.0, 1.0]) ;
    np.einsum("ii->i", np.outer(x, x)) ; np.max(np.outer(x, u), 0, np.zeros(2)) ;
    np.clip(x, -0.5, 0.5, where=x > 0.0, out=x.copy()) ; np.mean(x, where=[True, True, False]) ;
    round(p["k"], 1) * x[0] ; round(float(u[1]), 1) ; np.sum(x[x > 0]) ; len(set(x)) ;
    np.array([x[0] > 0, x[1] > 0]) + np.array([True, False]) ; np.dot(x > 0, x > -1) ;
    np.where(x[0] > 0, x[1] > 0, True) + np.where(x[1] > 0, True, False) ; np.exp(x[0] > 0) ;
    [x.sum(dtype=np.float32), np.mean(x, dtype=np.float16)] ; (100 * x).astype(np.int8) ;
    x.astype(np.float32) ; int(x[0]) & 1 ; np.vectorize(lambda v: 1 if v > 0 else 0.5 * v)(x) ;
    beside(max(int(x[0]), u[0]), u[1]) ; type(max(0, x[0])) is int ;
    1.0 if ~(float(x[0]) > 0) else 2.0 ; 1.0 if int(x[0]) in {0, 1} else 0.0 ;
    np.outer(x, u).T.ravel(order="K") ; np.asarray(SQUARE * np.diag(u)).ravel() ;
    tried(lambda: u[int(x[0])]) ; tried(lambda: np.linalg.solve(np.outer(u, u), u)[0]) ;
    np.roots(x)[0].real ; 1.0 * np.shares_memory(u, u) ; 1.0 * np.ix_(u > 0)[0][0] ;
    1.0 * np.deg2rad(u > 0)[0] ; np.gradient(np.outer(u, u))[0][0, 0] ;
    np.sort(np.outer(u, x), 0)[0] ;
    np.gradient(x, x + 9.0)[0] ; np.median(np.outer(u, x), 0) ; np.sum(u, where=[True, False]) ;
    np.linalg.cholesky(np.outer(u, u) + np.eye(2))[0, 1] ;
    RATIOS.get(f"{x[0]:.0f}", 2.0) ; RATIOS.get(int(x[0]), 9.0)
"""
PARAMS = {
    "n": 3,
    "A": np.array([3, -3]),
    "f": np.float32(0.1),
    "short": np.uint8([200, 3]),
}
PARAMS |= {"zero": 0.0, "k": 1.15}


def in_lines(text, form="{}"):
    """Return the function of each expression of a text."""
    space = globals() | {"Iterable": Iterable, "Sized": Sized}
    calls = [call.strip() for call in text.split(";")]
    return {
        call: eval(f"lambda t, x, u, p: {form.format(call)}", space) for call in calls
    }


READ = in_lines(COUNTED, "beside({}, u[1])") | in_lines(WITHOUT_AXES, "changed({}, u)")
READ |= in_lines(AS_PYTHON_HAS_THEM)
READ |= {name: f for name, f in FUNCTIONS.items() if name.startswith("is ")}
REFUSED = in_lines(WOULD_BE_OTHERS)
REFUSED |= {name: f for name, f in FUNCTIONS.items() if name not in READ}
