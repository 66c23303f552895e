"""Every function of `math` and of NumPy is read as it computes, or is not read."""

import math

import numpy as np
import pytest
from recorded import as_it_runs, recorded, static

from clpt_control.equations.arrays import Unread
from clpt_control.errors import BlockError

U = (0.8, 0.4, 2.0)
INTEGERS = {"bitwise_count", "gcd", "lcm", "left_shift", "right_shift", "ldexp", "frexp", "modf"}


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


MATH = list(calls(math, sorted(n for n in dir(math) if n[0] != "_" and callable(getattr(math, n)))))
UFUNCS = sorted(n for n in dir(np) if isinstance(getattr(np, n), np.ufunc) and n not in INTEGERS)
NOT_READ = {"nextafter", "ulp", "spacing", "gamma", "lgamma", "logaddexp2"}


@pytest.mark.parametrize("call", [*MATH, *calls(np, UFUNCS)])
def test_a_function_of_numbers_is_read_or_named(call):
    space = {"math": math, "numpy": np}
    exec(f"def f(t, x, u, p):\n    return {call} + 0.0 * u[0]", space)
    block, name = static(space["f"]), call.split("(")[0].split(".")[1]
    if name not in NOT_READ:
        as_it_runs(block, "output", 0.0, [], U)
        return
    with pytest.raises(Unread, match=r"f, line 2: "):
        block.array_record("output")


ARRAYS = """
    np.sum(u) ; np.prod(u) ; np.mean(u) ; np.max(u) ; np.min(u) ; np.ptp(u) ; np.var(u) ;
    np.std(u) ; np.dot(u, v) ; np.vdot(u, v) ; np.inner(u, v) ; u @ v ;
    np.outer(u, v)[1, 2] ; np.kron(u, v)[4] ; np.trace(np.outer(u, v)) ; np.linalg.norm(u) ;
    np.linalg.norm(u, 1) ; np.linalg.norm(u, np.inf) ;
    np.linalg.det(np.outer(u, v) + np.eye(3)) ;
    np.linalg.solve(np.outer(u, v) + np.eye(3), v)[1] ; np.linalg.inv(np.diag(u))[1, 1] ;
    np.linalg.solve(np.diag(u), [1.0, 2.0, 3.0])[2] ; np.einsum('i,i->', u, v) ;
    np.tensordot(u, v, 1) ; np.cross(u, v)[0] ; np.diff(u)[1] ; np.cumsum(u)[2] ;
    np.cumprod(u)[2] ; np.sort(u)[1] ; np.flip(u)[0] ; np.roll(u, 1)[0] ; np.tile(u, 2)[4] ;
    np.repeat(u, 2)[3] ; np.interp(u[0], [0.0, 1.0, 3.0], [1.0, -1.0, 5.0]) ;
    np.polyval([1.0, -2.0, 3.0], u[0]) ; np.select([u[0] > 1, u[0] > 0], [1.0, u[1]], 3.0) ;
    np.piecewise(u, [u < 1, u >= 1], [lambda a: a, lambda a: -a])[2] ; np.clip(u, 0.5, 1.0)[2] ;
    np.where(u > 0.5, u, v)[1] ; np.heaviside(u[0] - 1.0, 0.5) ; np.sinc(u[0]) ;
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
    np.unwrap(u)[1] ; np.sum(u, where=[True, False, True]) ; np.max(u, initial=0.9) ;
    np.min(u, where=u > 0.5, initial=5.0) ; np.prod(u, initial=2.0) ; np.flipud(u)[0] ;
    np.fliplr([u, v])[1, 0] ; np.hsplit(u, 3)[1][0] ; np.expand_dims(u, 0)[0, 2] ;
    np.moveaxis([u, v], 0, 1)[2, 0] ; np.transpose([u, v], (1, 0))[2, 1] ; u.argmax() + u[0] ;
    np.interp(u[0] - 0.5, [0.0, 1.0, 2.0], u, left=7.0, right=8.0) ;
    np.where([True, False, True], u, v)[1] ; np.where([u[0] > 0, u[1] > 0, False], u, v)[1] ;
    np.select([[u[0] > 1, u[1] > 0, True]], [u], -1.0)[1] ; np.ravel([u[0], u[1]])[1] ;
    np.mean(np.outer(u, v), axis=(0, 1)) ; np.array([0.0, 1.0]).searchsorted(u[0]) + u[1] ;
    u.repeat(2)[3] ; np.stack([u, v], axis=1)[2, 1] ; np.sum(u, dtype=float) ;
    np.ix_([0], [1])[0][0, 0] + u[0]
"""


@pytest.mark.parametrize("call", [call.strip() for call in ARRAYS.split(";")])
def test_a_function_of_arrays_is_read_as_it_computes(call):
    space = {"np": np}
    exec(f"def f(t, x, u, p):\n    u, v = u.u, p.v\n    return 1.0 * ({call})", space)
    block = static(space["f"], parameters={"v": np.array([0.5, -1.5, 2.0])})
    for u in (U, (2.0, 0.3, 0.7), (-0.4, 1.2, 0.1)):
        as_it_runs(block, "output", 0.0, [], u, 1e-13)


@pytest.mark.parametrize("name", ["sqrt", "log", "acos", "exp", "atanh", "log1p"])
def test_what_math_refuses_is_nan_or_infinite(name):
    """A function of `math` raises out of its range; its record is what NumPy's gives."""
    space = {"math": math}
    exec(f"def f(t, x, u, p):\n    return math.{name}(u[0])", space)
    block = static(space["f"])
    outside = {"exp": 1000.0, "acos": 3.0, "atanh": 1.0}.get(name, -1.0)
    assert not np.isfinite(recorded(block, "output", 0.0, [], [outside, 0.0, 0.0])[0])
    with pytest.raises((ArithmeticError, ValueError, BlockError)):
        getattr(math, name)(outside)


@pytest.mark.parametrize("equal_nan", [False, True])
def test_numbers_that_are_about_the_same_are_so_at_infinity_too(equal_nan):
    block = static(lambda t, x, u, p: np.isclose(u[:2], u[1:], equal_nan=equal_nan) * 1.0, 3, 2)
    for u in ([1.0, 1.0 + 1e-9, 1.1], [np.inf, np.inf, 1.0], [np.inf, -np.inf, np.nan]):
        as_it_runs(block, "output", 0.0, [], u)
    as_it_runs(block, "output", 0.0, [], [np.nan, np.nan, np.inf])
