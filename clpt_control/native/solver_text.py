"""The solver's own text, compiled together with a diagram's fused functions.

One workspace Z holds the state, the stages K_0 ... K_15 and the argument of a
stage behind each other, at places the compiler knows, so that sums over the
state become vector code.  `advance` goes on where it stopped: Python calls it
for some thousands of steps at a time and can be interrupted in between.
"""

import ast
import inspect
import re
from collections.abc import Callable

from ..blocks.words import WORDS
from .dormand_prince import dense_lines, error_lines, extra_lines, stage_lines, stage_times

RUNNING, FINISHED, TOO_SMALL, NOT_FINITE, LEFT, TOO_MANY = range(6)
MOST_STEPS = 5_000_000  # a member's; the paper's run takes 3,650

SOLVER = """
Y = 17 * NX
C = np.array({times})


@njit({options})
def far_derivative(t, X, P, T, W, D):
    derivative(t, X, P, T, W, D)


@njit({options})
def first_step(t, span, Z, P, T, W, rtol, atol):
    d0 = d1 = 0.0
    for i in range(NX):
        scale = atol + abs(Z[i]) * rtol
        d0 += (Z[i] / scale) ** 2
        d1 += (Z[NX + i] / scale) ** 2
    d0, d1 = math.sqrt(d0 / NX), math.sqrt(d1 / NX)
    h0 = 1e-6 if d0 < 1e-5 or d1 < 1e-5 else 0.01 * d0 / d1
    h0 = min(h0, span)
    for i in range(NX):
        Z[Y + i] = Z[i] + h0 * Z[NX + i]
    far_derivative(t + h0, Z[Y : Y + NX], P, T, W, Z[2 * NX : 3 * NX])
    d2 = 0.0
    for i in range(NX):
        d2 += ((Z[2 * NX + i] - Z[NX + i]) / (atol + abs(Z[i]) * rtol)) ** 2
    d2 = math.sqrt(d2 / NX) / h0
    h1 = max(1e-6, h0 * 1e-3) if d1 <= 1e-15 and d2 <= 1e-15 else (0.01 / max(d1, d2)) ** 0.125
    return min(100.0 * h0, h1, span)


@njit({options})
def interpolate(t_old, h, Z, P, T, W, F):
    for s in range(13, 16):
{extra}
        far_derivative(t_old + C[s] * h, Z[Y : Y + NX], P, T, W, Z[(s + 1) * NX : (s + 2) * NX])
    for i in range(NX):
        Z[Y + i] = Z[i] + h * ({new_state})
    for i in range(NX):
{dense}


@njit({options})
def interpolant(share, Z, F, out):
    for i in range(NX):
        y = 0.0
        for k in range(7):
            y += F[(6 - k) * NX + i]
            y *= share if k % 2 == 0 else 1.0 - share
        out[i] = y + Z[i]


@njit({options})
def inside(t, X, P, T, W):
    return margin(t, X, P, T, W)


@njit({options})
def advance(S, Z, P, T, W, F, edges, places, values, times, states, rtol, atol, budget, counts):
    # S: time, step, edge number, samples done, 1 where a new piece begins
    t, h_abs, edge, done, fresh = S[0], S[1], int(S[2]), int(S[3]), S[4] == 1.0
    status = 0
    steps = 0
    while status == 0 and steps < budget:
        end = edges[edge]
        if fresh:
            for j in range(len(places)):
                P[places[j]] = values[edge, j]
            prepare(P, T)
            far_derivative(t, Z[0:NX], P, T, W, Z[NX : 2 * NX])
            counts[1] += 1
            counts[2] += 1
            bad = 0.0
            for i in range(NX):
                bad += 0.0 * Z[NX + i] + 0.0 * Z[i]
            if bad != 0.0 or (GUARDED and inside(t, Z[0:NX], P, T, W) < -1e-9):
                status = 3 if bad != 0.0 else 4
                break
            h_abs = first_step(t, end - t, Z, P, T, W, rtol, atol)
            counts[1] += 1
            fresh = False
        smallest = 10.0 * abs(np.nextafter(t, np.inf) - t)
        h_abs = max(h_abs, smallest)
        rejected = False
        while True:
            if not h_abs >= smallest:
                status = 2
                break
            t_new = min(t + h_abs, end)
            h = t_new - t
            h_abs = h
            for s in range(1, 13):
{stages}
                derivative(t + C[s] * h, Z[Y : Y + NX], P, T, W, Z[(s + 1) * NX : (s + 2) * NX])
            counts[1] += 12
            sum5 = sum3 = 0.0
            for i in range(NX):
{errors}
                scale = atol + max(abs(Z[i]), abs(Z[Y + i])) * rtol
                sum5 += (e5 / scale) ** 2
                sum3 += (e3 / scale) ** 2
            if sum5 == 0.0 and sum3 == 0.0:
                error = 0.0
            else:
                error = h * sum5 / math.sqrt((sum5 + 0.01 * sum3) * NX)
            if error < 1.0:
                factor = 10.0 if error == 0.0 else min(10.0, 0.9 * error**-0.125)
                if rejected:
                    factor = min(1.0, factor)
                h_abs *= factor
                break
            h_abs *= max(0.2, 0.9 * error**-0.125) if error == error else 0.2
            rejected = True
            counts[3] += 1
        if status != 0:
            break
        wanted = done < len(times) and times[done] <= t_new
        if wanted or GUARDED:
            interpolate(t, h, Z, P, T, W, F)
            counts[1] += 3
        if GUARDED:
            for k in range(1, 17):
                interpolant(k / 16.0, Z, F, Z[2 * NX : 3 * NX])
                if inside(t + h * k / 16.0, Z[2 * NX : 3 * NX], P, T, W) < -1e-9:
                    status = 4
                    break
            if status != 0:
                break
        if wanted:
            while done < len(times) and times[done] <= t_new:
                if times[done] == t_new:
                    for i in range(NX):
                        states[done, i] = Z[Y + i]
                else:
                    interpolant((times[done] - t) / h, Z, F, states[done])
                done += 1
        for i in range(NX):
            Z[i] = Z[Y + i]
            Z[NX + i] = Z[13 * NX + i]
        t = t_new
        steps += 1
        counts[0] += 1
        if t == end:
            edge += 1
            fresh = True
            if edge == len(edges):
                status = 1
    S[0], S[1], S[2], S[3], S[4] = t, h_abs, edge, done, 1.0 if fresh else 0.0
    return status


@njit({options})
def many(first, last, X0, Ps, T, group, edges, nedges, places, values, times, out, status,
         reached, counts, rtol, atol):
    Z, F, W, S = np.zeros(18 * NX), np.zeros(7 * NX), np.zeros(NW), np.zeros(5)
    P = np.zeros(Ps.shape[1])
    for m in range(first, last):
        g = group[m]
        for j in range(len(P)):
            P[j] = Ps[m, j]
        for i in range(NX):
            Z[i] = X0[m, i]
            out[m, 0, i] = X0[m, i]
        S[0], S[1], S[2], S[3], S[4] = times[0], 0.0, 0.0, 1.0, 1.0
        status[m] = advance(S, Z, P, T, W, F, edges[g, : nedges[g]], places, values[g], times,
                            out[m], rtol, atol, {most}, counts[m])
        if status[m] == 0:
            status[m] = 5
        reached[m] = S[3]


@njit({options})
def many_rk4(first, last, X0, Ps, T, group, edges, nedges, places, values, times, out, status,
             reached, counts, step):
    # Runge and Kutta's classical method, steps no longer than `step`, stopping at every edge
    W, P = np.zeros(NW), np.zeros(Ps.shape[1])
    X, A, K, total = np.zeros(NX), np.zeros(NX), np.zeros(NX), np.zeros(NX)
    for m in range(first, last):
        g = group[m]
        for j in range(len(P)):
            P[j] = Ps[m, j]
        for i in range(NX):
            X[i] = X0[m, i]
            out[m, 0, i] = X[i]
        t, done, edge = times[0], 1, 0
        while done < len(times) and status[m] == 0:
            for j in range(len(places)):
                P[places[j]] = values[g, edge, j]
            prepare(P, T)
            counts[m, 2] += 1
            while done < len(times) and status[m] == 0:
                stop = min(times[done], edges[g, edge])
                steps = max(1, math.ceil((stop - t) / step * (1.0 - 1e-12)))
                h = (stop - t) / steps
                start = t
                for n in range(steps):
                    t = start + n * h
                    for i in range(NX):
                        A[i] = X[i]
                        total[i] = 0.0
                    for s in range(4):
                        part = 0.0 if s == 0 else (1.0 if s == 3 else 0.5)
                        derivative(t + part * h, A, P, T, W, K)
                        ahead = 1.0 if s == 2 else 0.5
                        weight = 1.0 if s == 0 or s == 3 else 2.0
                        for i in range(NX):
                            total[i] += weight * K[i]
                            A[i] = X[i] + ahead * h * K[i]
                    for i in range(NX):
                        X[i] += h / 6.0 * total[i]
                    if GUARDED and inside(t + h, X, P, T, W) < -1e-9:
                        status[m] = 4
                        break
                counts[m, 0] += steps
                counts[m, 1] += 4 * steps
                t = stop
                bad = 0.0
                for i in range(NX):
                    bad += 0.0 * X[i]
                if bad != 0.0:
                    status[m] = 3
                if status[m] == 0 and stop == times[done]:
                    for i in range(NX):
                        out[m, done, i] = X[i]
                    done += 1
                if t == edges[g, edge]:
                    edge += 1
                    break
        if status[m] == 0:
            status[m] = 1
        reached[m] = done


@njit({options})
def record(times, states, pieces, P, T, W, places, values, out):
    piece = -1
    for k in range(len(times)):
        if pieces[k] != piece:
            piece = pieces[k]
            for j in range(len(places)):
                P[places[j]] = values[piece, j]
            prepare(P, T)
        signals(times[k], states[k], P, T, W)
        for j in range(NW):
            out[k, j] = W[j]
"""

HEADER = '''"""Made by clpt-control; read by the compiler, not to be edited."""

import math

import numpy as np
from numba import njit

from clpt_control.native.elementary import cos, exp, sin

NX = {nx}
NW = {nw}
GUARDED = {guarded}

'''

OPTIONS = 'cache=True, nogil=True, error_model="numpy", fastmath={"contract"}'

SUMS = OPTIONS.replace('"contract"', '"contract", "reassoc"')  # sums over functions as vectors


def _compiled_word(word: Callable) -> str:
    """Give the text of a word without its docstring."""
    tree = ast.parse(inspect.getsource(word)).body[0]
    assert isinstance(tree, ast.FunctionDef)
    tree.body = tree.body[1:]
    return f"@njit({OPTIONS})\n{ast.unparse(tree)}"


def module_text(fused_source: str, nx: int, nw: int, guarded: bool, method: str = "dop853") -> str:
    """Give the text of the module that is compiled.

    Parameters
    ----------
    fused_source : str
        The functions derivative, signals and margin.
    nx, nw : int
        Numbers of states and signals.
    guarded : bool
        Whether guards are watched.
    method : str, optional
        ``"dop853"``, or ``"vern7"`` with `advance` alone.

    Returns
    -------
    str
        A whole module; its functions `advance` and `record` are called.
    """
    from .dormand_prince import coefficients, weighted_sum

    words = "\n\n".join(_compiled_word(word) for word in WORDS.values())
    header = HEADER.format(nx=nx, nw=nw, guarded=guarded, options=OPTIONS)
    vector_ready = re.sub(r"math\.(exp|cos|sin)\(", r"\1(", fused_source)
    functions = vector_ready.replace(
        "def derivative(", f"@njit({SUMS}, forceinline=True)\ndef derivative("
    )
    for name in ("signals", "margin", "prepare"):
        functions = functions.replace(f"def {name}(", f"@njit({SUMS})\ndef {name}(")
    solver = SOLVER.format(
        options=OPTIONS,
        most=MOST_STEPS,
        times=stage_times(),
        stages=stage_lines(" " * 16),
        extra=extra_lines(" " * 8),
        errors=error_lines(" " * 16),
        dense=dense_lines(" " * 8),
        new_state=weighted_sum(coefficients().B),
    )
    if method == "vern7":
        from .verner import advance_text

        start = solver.split("def interpolate(")[0].rsplit("@njit", 1)[0]
        start = start.replace("** 0.125", "** (1.0 / 7.0)")
        solver = f"{start}\n{advance_text(OPTIONS)}"
    return f"{header}\n\n{words}\n\n{functions}\n\n{solver}"
