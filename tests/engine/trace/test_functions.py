"""Functions of NumPy, tables and special numbers are read as they run."""

import math
import re

import numpy as np
import pytest
from engine_runs import COMPOSED, IMPLEMENTED, TABLE, Unread, readings
from recorded_blocks import as_it_runs, recorded, static
from scipy import special

import clpt_control as clpt
from clpt_control import lookup

U = (0.8, 0.4, 2.0)
INTEGERS = {
    "bitwise_count",
    "gcd",
    "lcm",
    "left_shift",
    "right_shift",
    "ldexp",
    "frexp",
    "modf",
}


def calls(module, names):
    """Name the calls of a module's functions that are numbers."""
    for name in names:
        for count in (1, 2, 3) if module is math else (1, 2):
            arguments = ", ".join(f"u[{k}]" for k in range(count))
            call = f"{module.__name__}.{name}({arguments})"
            try:
                with np.errstate(all="ignore"):
                    value = eval(call, {"math": math, "numpy": np, "u": np.array(U)})
            except (TypeError, ValueError):
                continue
            if isinstance(value, float | int | np.floating):
                yield call


MATH = list(
    calls(
        math, sorted(n for n in dir(math) if n[0] != "_" and callable(getattr(math, n)))
    )
)
UFUNCS = sorted(
    n for n in dir(np) if isinstance(getattr(np, n), np.ufunc) and n not in INTEGERS
)
NOT_READ = {  # unless a row of the tables reads them
    "fma",
    "nextafter",
    "ulp",
    "spacing",
    "lgamma",
    "logaddexp2",
    "fmin",
    "fmax",
}


@pytest.mark.parametrize("call", [*MATH, *calls(np, UFUNCS)])
def test_a_function_of_numbers_is_read_or_named(call):
    space = {"math": math, "numpy": np}
    exec(f"def f(t, x, u, p):\n    return {call} + 0.0 * u[0]", space)
    block, name = static(space["f"]), call.split("(")[0].split(".")[1]
    if name not in NOT_READ - TABLE.keys() - COMPOSED.keys():
        as_it_runs(block, "output", 0.0, [], U)
        return
    with pytest.raises(Unread, match=r"f, line 2: "):
        block.array_record("output")


REFUSED = {  # each call, and the name in its sentence
    "np.nextafter(u[0], u[1])": "np.nextafter",
    "np.spacing(u[0])": "np.spacing",
    "np.quantile(u, 0.3)": "np.quantile",
    "np.percentile(u, 30, method='lower')": "np.percentile",
    "np.partition(u, 1)[0]": "np.partition",  # of NumPy's own code NaN has another place
    "np.argpartition(u, 1)[0]": "np.argpartition",
    "np.shares_memory(u, u)": "np.shares_memory",
    "np.may_share_memory(u, u)": "np.may_share_memory",
    "np.nanmax(u)": "np.nanmax",
    "np.add(u, 1.0, dtype=np.float32)[0]": "an operation in float32",
    "u.astype(np.float32)[0]": "a conversion to float32",
}


@pytest.mark.parametrize("call", REFUSED)
def test_a_function_that_is_not_traced_is_named_with_what_to_do(call):
    space = {"np": np}
    exec(f"def f(t, x, u, p):\n    u = u.u\n    return 1.0 * {call}", space)
    block = clpt.Block("b", output=space["f"], inputs={"u": 2}, outputs={"y": 1})
    said = f"f, line 3: {REFUSED[call]} of signals is not traced. Write its arithmetic, or call "
    with pytest.raises(clpt.BlockError, match=re.escape(said + "it before the run\n")):
        clpt.check(block)


ARRAYS = """
    np.sum(u) ; np.prod(u) ; np.mean(u) ; np.max(u) ; np.min(u) ; np.ptp(u) ;
    np.ptp([np.sin(k + u) for k in range(12)], axis=0)[1] ;
    np.clip([u[0], -u[1]], [0.0, -0.1], [u[1], 1.0])[1] ; np.maximum([u[0], v[1]], 0.5)[1] ;
    np.sin([u[0], 1.0])[0] ; np.arctan2([u[0], u[1]], (u[2], -1.0))[1] ;
    np.abs([[-u[0]], [1.0]])[0, 0] ;
    np.where(np.logical_and([u[0] > 0.5, u[1] > 0.5], True), 1.0, u[2])[1] ;
    np.var(u) ; np.std(u) ; np.var(np.outer(u, v), axis=1, ddof=1)[2] ; np.gradient(u)[1] ;
    np.gradient(u, 0.5)[2] ; np.gradient(np.outer(u, v), 0.1, axis=0)[1, 2] ;
    np.linalg.det(np.outer(u, v) + np.eye(3)) ; np.linalg.det(np.array([[0.0, u[0]], [v[0], 1]])) ;
    np.linalg.det(np.outer(u, u)) ; np.dot(u, v) ; np.vdot(u, v) ; np.inner(u, v) ; u @ v ;
    np.outer(u, v)[1, 2] ; np.kron(u, v)[4] ; np.trace(np.outer(u, v)) ; np.linalg.norm(u) ;
    np.linalg.norm(u, 1) ; np.linalg.norm(u, np.inf) ;
    np.linalg.solve(np.outer(u, v) + np.eye(3), v)[1] ; np.linalg.inv(np.diag(u))[1, 1] ;
    np.linalg.solve(np.diag(u), [1.0, 2.0, 3.0])[2] ; np.einsum('i,i->', u, v) ;
    np.tensordot(u, v, 1) ; np.cross(u, v)[0] ; np.diff(u)[1] ; np.cumsum(u)[2] ;
    np.cumprod(u)[2] ; np.flip(u)[0] ; np.roll(u, 1)[0] ; np.tile(u, 2)[4] ;
    np.repeat(u, 2)[3] ; np.interp(u[0], [0.0, 1.0, 3.0], [1.0, -1.0, 5.0]) ;
    np.polyval([1.0, -2.0, 3.0], u[0]) ; np.select([u[0] > 1, u[0] > 0], [1.0, u[1]], 3.0) ;
    np.piecewise(u, [u < 1, u >= 1], [lambda a: a, lambda a: -a])[2] ; np.clip(u, 0.5, 1.0)[2] ;
    np.where(u > 0.5, u, v)[1] ; np.heaviside(u[0] - 1.0, 0.5) ; np.sinc(u[0]) ;
    np.sinc(u)[1] ; np.sinc(np.outer(u, [0.0, 1.0]))[1, 0] ;
    np.hypot(*u[:2]) ; np.concatenate([u, v])[4] ; np.hstack([u, 1.0])[3] ;
    np.vstack([u, v])[1, 0] ; np.column_stack([u, v])[2, 1] ; np.stack([u, v], axis=1)[2, 1] ;
    np.block([u, v])[3] ; np.append(u, 4.0)[3] ; np.insert(u, 1, 4.0)[1] ; np.squeeze(u[:1]) ;
    np.atleast_2d(u)[0, 2] ; np.full(3, u[0])[1] ;
    np.full_like(u, 2.0)[0] ; np.zeros_like(u)[1] + u[0] ; np.any(u > 1) * 2.0 ;
    np.all(u > 1) * 2.0 + u[0] ; len(u) * u[0] ; np.array([u, v]).T[1, 0] ;
    np.reshape(np.outer(u, v), 9)[5] ; np.swapaxes([u, v], 0, 1)[1, 0] ;
    np.count_nonzero(u > 0.5) + u[0] ; np.argmax(u) + u[0] ; np.nan_to_num(u)[1] ;
    np.triu([u, v])[0, 1] ; np.linalg.multi_dot([u, np.eye(3), v]) ; np.average(u, weights=v) ;
    np.convolve(u, v)[2] ; np.trapezoid(u, [0.0, 1.0, 3.0]) ; np.round(u[2], 1) ;
    np.unwrap(u)[1] ; np.max(u, initial=0.9) ;
    np.min(u, initial=0.5) ; np.prod(u, initial=2.0) ; np.flipud(u)[0] ;
    np.fliplr([u, v])[1, 0] ; np.hsplit(u, 3)[1][0] ; np.expand_dims(u, 0)[0, 2] ;
    np.moveaxis([u, v], 0, 1)[2, 0] ; np.transpose([u, v], (1, 0))[2, 1] ; u.argmax() + u[0] ;
    np.sort(u)[1] ; np.sort(np.outer(u, v)[0])[::-1][1] ; np.median(u) ; np.median([u, v]) ;
    np.argmin([u, v]) + u[0] ; np.argmax(u > 0.5) + u[0] ; u[np.argmin(u)] ;
    np.argmax(np.outer(u, v), axis=1)[2] ;
    np.interp(u[0] - 0.5, [0.0, 1.0, 2.0], u, left=7.0, right=8.0) ;
    np.where([True, False, True], u, v)[1] ; np.where([u[0] > 0, u[1] > 0, False], u, v)[1] ;
    np.select([[u[0] > 1, u[1] > 0, True]], [u], -1.0)[1] ; np.ravel([u[0], u[1]])[1] ;
    np.mean(np.outer(u, v), axis=(0, 1)) ; np.array([0.0, 1.0]).searchsorted(u[0]) + u[1] ;
    u.repeat(2)[3] ; np.stack([u, v], axis=1)[2, 1] ; np.sum(u, dtype=float) ;
    np.atleast_1d(u[0], u[1])[1][0] ; np.atleast_2d(u[:1], 7.0)[1][0, 0] + u[0] ;
    np.ix_([0], [1])[0][0, 0] + u[0] ; np.isclose(u, [0.8, np.inf, np.nan])[0] ;
    np.isclose(u / 0.0, [np.inf, -np.inf, np.nan])[0] ; np.allclose(u[0], 0.8 + 1e-9) ;
    np.kron(np.outer(u, v), np.eye(3))[4, 7] ; np.kron(np.outer(u, v), np.outer(v, u))[2, 7] ;
    np.vdot(np.outer(u, v), np.outer(v, v)) ; np.any(u[0]) ; np.all(u[:1]) ; any([u[1]]) ;
    np.dot(np.outer(u, v), CUBE)[2, 1, 2] ; np.dot(u[0] * CUBE, CUBE)[1, 2, 0, 1] ;
    lookup(v[::-2], u[0]) ; lookup(u[1:], u[0]) ; lookup(v, np.floor(u + 0.7))[2] ;
    np.dot(u, CUBE)[1, 0] ; math.prod(np.outer(u, v))[1] ;
    np.take(u, np.array([4, -8]), mode="wrap")[1] ; np.take(u, [-2, 7], mode="clip")[0] ;
    math.modf(-1.7 * u[0])[0] ; np.modf(3.0 * u)[1][2] ; np.logaddexp(u, 800.0 * v)[1] ;
    special.gamma(u)[0] ; math.isclose(u[0], 0.8, rel_tol=1e-3) + u[1] ;
    np.linalg.norm(np.outer(v, v) + 1.0, 2) * u[0] ; np.gradient(np.outer(v, v))[0][1, 2] + u[0] ;
    np.searchsorted([0.0, 1.0], u[0]) ; np.digitize(u, [0.0, 1.0])[1] ; np.ones_like(u)[1] + u[0] ;
    np.diagonal(np.outer(u, v))[1] ; np.broadcast_to(u, (2, 3))[1, 2] ; np.rot90([u, v])[0, 1] ;
    np.rollaxis(np.outer(u, v), 1)[2, 0] ; np.atleast_3d(u)[0, 1, 0] ; np.split(u, 3)[1][0] ;
    np.array_split(u, 2)[1][0] ; np.vsplit(np.outer(u, v), 3)[1][0, 2] ; np.real(u)[1] ;
    np.dsplit(u[0] * CUBE, 3)[1][1, 2, 0] ; np.imag(u)[1] + u[0] ; np.isreal(u)[1] + u[0] ;
    np.ndim(u) * u[0] ; np.iscomplexobj(u) + u[0] ; np.isrealobj(u) + u[0] ; np.amax(u) ;
    np.amin(u) ; np.around(10 * u)[1] ; np.fix(3.0 * u)[2] ; np.copy(u)[1] ; np.shape(u)[0] * u[0] ;
    np.empty_like(u)[:0].sum() + u[0] ; np.size(u) * u[0] ;
    np.sort(np.outer(v, v), axis=0)[0, 1] + u[0] ; np.median(np.outer(v, v), axis=1)[2] * u[0]
"""
CUBE = np.random.default_rng(5).normal(size=(2, 3, 3))


@pytest.mark.parametrize("call", [call.strip() for call in ARRAYS.split(";")])
def test_a_function_of_arrays_is_read_as_it_computes(call):
    space = {"np": np, "math": math, "special": special, "CUBE": CUBE, "lookup": lookup}
    exec(f"def f(t, x, u, p):\n    u, v = u.u, p.v\n    return 1.0 * ({call})", space)
    block = static(space["f"], parameters={"v": np.array([0.5, -1.5, 2.0])})
    for u in (U, (2.0, 0.3, 0.7), (-0.4, 1.2, 0.1)):
        as_it_runs(block, "output", 0.0, [], u, 1e-13)


def test_each_function_of_the_tables_is_called():
    names = [
        f"{function.__module__.replace('numpy', 'np')}.{function.__name__}("
        for function in IMPLEMENTED
    ]
    calls = ARRAYS + "".join(REFUSED)
    assert [name for name in names if name not in calls] == []


def longest_served(t, x, u, p):
    served = np.zeros(3)
    served[np.argmax(u)] = 1.0
    return served


def test_what_argmax_counts_with_is_a_place_of_its_row():
    block = static(longest_served, outputs=3)
    as_it_runs(block, "output", 0.0, [], (0.2, 1.5, -0.3))
    kinds = [one.kind for one in block.array_record("output").operations]
    assert kinds.count("eq") == 2  # no fourth place was requested, nor one from the end


def looked_up(t, x, u, p):
    return lookup(p.values, u[0])


@pytest.mark.parametrize("size", [1, 4, 9])
def test_lookup_reads_whole_places_and_is_nan_outside(size):
    table = np.random.default_rng(size).normal(size=size)
    block = static(looked_up, 1, parameters={"values": table})
    for index in range(-size, size):
        for away in (0.0, 0.5 if index >= 0 else -0.5):  # towards zero
            found = as_it_runs(block, "output", 0.0, [], [index + away])
            assert found == [table[index]]
    for index in (size, -size - 1, math.inf, -math.inf, math.nan, 1e300):
        assert math.isnan(recorded(block, "output", 0.0, [], [index])[0])


def test_a_table_is_one_operation_whatever_its_length():
    block = static(looked_up, 1, parameters={"values": np.arange(200_000.0)})
    assert len(block.array_record("output").operations) < 6
    assert recorded(block, "output", 0.0, [], [150.5]) == [150.0]


def sums(t, x, u, p):
    own, kept = [float(one) for one in u], np.zeros(3)
    kept[:] = [own[0], 1.0, own[2]]
    return [
        *(sum(own), sum(own, 0.5), sum([math.fabs(u[0]), 1.0, -math.fabs(u[0])])),
        *(sum([2.0 * own[0], 1, -2.0 * own[0]]), sum(max(one, -2e16) for one in own)),
        *(sum(u), sum([own[0], u[1], own[2]]), sum([own[0], own[1], u[2]]), sum(kept)),
        sum(max(one, 0) for one in u),
    ]


@pytest.mark.parametrize(
    "u",
    [(1e16, 1.0, -1e16), (1e16, 3.0, -1e16), (1.0, 1e16, -1e16), (1e305, 2.0, -1e305)],
)
def test_sums_are_pythons_also_where_it_makes_up_for_rounding(u):
    as_it_runs(static(sums, outputs=10), "output", 0.0, [], u, tolerance=0.0)


# --- what a record holds -------------------------------------------------------------------------


def test_a_matrix_times_a_vector_is_a_sum_whatever_its_size():
    for n in (3, 40, 400):
        block = static(
            lambda t, x, u, p: p.A @ u,
            n,
            n,
            parameters={"A": np.ones((n, n))},
            shapes={},
        )
        kinds = [
            operation.kind for operation in block.array_record("output").operations
        ]
        assert (kinds.count("sum"), len(kinds) < 8) == (1, True)


SPECIAL = {  # -> what Python says, worked out by hand
    "a - a of infinity": (lambda t, x, u, p: u[0] - u[0], [math.inf, 0.0, 0.0], math.nan),
    "0 times infinity": (lambda t, x, u, p: 0.0 * u[0], [math.inf, 0.0, 0.0], math.nan),
    "NaN by x == x": (lambda t, x, u, p: np.where(u[0] == u[0], 1.0, 2.0), [math.nan, 0, 0], 2.0),
    "NaN by x != x": (lambda t, x, u, p: 1.0 if u[0] != u[0] else 2.0, [math.nan, 0, 0], 1.0),
    "a zero's sign": (lambda t, x, u, p: np.arctan2(0.0 * u[0], -1.0), [-2.0, 0, 0], -math.pi),
    "a root of math": (lambda t, x, u, p: math.sqrt(u[0]) if u[1] else 1.0, [-1, 1.0, 0], math.nan),
    "-0.0 is not 0.0": (lambda t, x, u, p: 1.0 / (-0.0 * abs(u[0])), [1.0, 0, 0], -math.inf),
}  # fmt: skip


@pytest.mark.parametrize("case", SPECIAL)
def test_special_numbers_are_the_authors(case):
    function, u, wanted = SPECIAL[case]
    with np.errstate(all="ignore"):
        found = as_it_runs(static(function), "output", 0.0, [], u)
    np.testing.assert_array_equal(found, [wanted])


def test_an_argument_that_is_a_place_is_not_the_constant_of_that_number():
    def of(constant):
        chosen = lambda t, x, u, p: np.where(u[0] > 0.0, constant(u), 3.0)  # noqa: E731
        return static(chosen).array_record("output")

    records = [of(lambda u, c=c: c) for c in (0.0, -0.0, 1.0, 2.0)]
    assert len({*records, of(lambda u: u[0])}) == 5
    assert of(lambda u: 1.0) == records[2]


def test_a_number_that_equals_the_place_of_a_value_is_not_it():
    block = static(
        lambda t, x, u, p: 1.0 if u.b > 0 else u.a, {"a": (), "b": ()}, {"y": ()}
    )
    for b in (-1.0, 1.0):
        asked = [ask(0.0, [], [5.0, b])[1] for ask in readings(block).values()]
        assert asked == [1.0 if b > 0 else 5.0] * len(asked)
