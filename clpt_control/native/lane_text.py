"""The solver's text for eight runs at once, one to a lane.

Every lane has its own run, time, step and piece; a lane whose run has ended
takes the next.  Nothing is summed across lanes, so a run gives the same bits in
any lane, beside any neighbours.  Where one lane enters a new piece, or wants
output within a step, all lanes compute and the others keep what they had.
"""

from .dormand_prince import dense_lines, error_lines, extra_lines, stage_lines, stage_times

HEADER = '''"""Made by clpt-control; read by the compiler, not to be edited."""

import math

import numpy as np
from numba import njit

from clpt_control.native.lanes import (
    clip, floor, fma, lane_get, lane_vector, lookup, maximum, minimum, power, select, sign, splat,
    where,
)

NX = {nx}
NW = {nw}
'''

SOLVER = """
Y = 17 * NX
C = np.array({times})


@njit({options})
def far_derivative(t, X, P, T, W, D):
    derivative(t, X, P, T, W, D)


@njit({options})
def begin(t, span, Z, P, T, W, rtol, atol):
    # the rate goes to row 2, the argument of a stage is scratch; gives the first step
    prepare(P, T)
    far_derivative(t, Z[0:NX], P, T, W, Z[2 * NX : 3 * NX])
    d0 = splat(0.0)
    d1 = splat(0.0)
    for i in range(NX):
        scale = atol + abs(Z[i]) * rtol
        a = Z[i] / scale
        b = Z[2 * NX + i] / scale
        d0 = d0 + a * a
        d1 = d1 + b * b
    d0 = math.sqrt(d0 / NX)
    d1 = math.sqrt(d1 / NX)
    h0 = where(minimum(d0, d1) < 1e-5, splat(1e-6), 0.01 * d0 / d1)
    h0 = minimum(h0, span)
    for i in range(NX):
        Z[Y + i] = Z[i] + h0 * Z[2 * NX + i]
    far_derivative(t + h0, Z[Y : Y + NX], P, T, W, Z[3 * NX : 4 * NX])
    d2 = splat(0.0)
    for i in range(NX):
        a = (Z[3 * NX + i] - Z[2 * NX + i]) / (atol + abs(Z[i]) * rtol)
        d2 = d2 + a * a
    d2 = math.sqrt(d2 / NX) / h0
    most = maximum(d1, d2)
    h1 = where(most <= 1e-15, maximum(splat(1e-6), h0 * 1e-3), power(0.01 / most, splat(0.125)))
    return minimum(minimum(100.0 * h0, h1), span)


@njit({options})
def interpolate(t_old, h, Z, P, T, W, F):
    for s in range(13, 16):
{extra}
        far_derivative(t_old + C[s] * h, Z[Y : Y + NX], P, T, W, Z[(s + 1) * NX : (s + 2) * NX])
    for i in range(NX):
        Z[Y + i] = fma(h, {new_state}, Z[i])
    for i in range(NX):
{dense}


@njit({options})
def many(first, last, X0, Ps, T, group, edges, nedges, places, values, times, out, status,
         reached, counts, rtol, atol, Zs, Pl, Ws, Fs, number):
    Z, P, W, F = lane_vector(Zs), lane_vector(Pl), lane_vector(Ws), lane_vector(Fs)
    member, edge, done = np.full(8, -1), np.zeros(8, np.int64), np.zeros(8, np.int64)
    # rows of number: t, h_abs, end, 1 where fresh, 1 where the last try was rejected, accepted
    coming = first
    active = 0
    for k in range(8):
        for r in range(6):
            number[r, k] = 0.0
        for i in range(NX):
            Zs[i, k] = 0.0
            Zs[NX + i, k] = 0.0
        if coming >= last:
            for j in range(Ps.shape[1]):
                Pl[j, k] = Ps[first, j]
            for i in range(NX):
                Zs[i, k] = X0[first, i]
            number[2, k] = 1.0
    N6 = lane_vector(number)
    for k in range(8):
        if coming < last:
            active += 1
            m = coming
            coming += 1
            member[k], edge[k], done[k] = m, 0, 1
            for j in range(Ps.shape[1]):
                Pl[j, k] = Ps[m, j]
            for j in range(len(places)):
                Pl[places[j], k] = values[group[m], 0, j]
            for i in range(NX):
                Zs[i, k] = X0[m, i]
                out[m, 0, i] = X0[m, i]
            number[0, k], number[2, k], number[3, k] = times[0], edges[group[m], 0], 1.0
            number[4, k] = 0.0
    while active > 0:
        fresh_any = False
        for k in range(8):
            fresh_any = fresh_any or (number[3, k] == 1.0)
        if fresh_any:
            h1 = begin(N6[0], N6[2] - N6[0], Z, P, T, W, rtol, atol)
            fresh = N6[3] > 0.5
            N6[1] = select(fresh, h1, N6[1])
            for i in range(NX):
                Z[NX + i] = select(fresh, Z[2 * NX + i], Z[NX + i])
            for k in range(8):
                if number[3, k] == 1.0 and member[k] >= 0:
                    m = member[k]
                    counts[m, 1] += 2
                    counts[m, 2] += 1
                    bad = 0.0
                    for i in range(NX):
                        bad += 0.0 * Zs[NX + i, k] + 0.0 * Zs[i, k]
                    if bad != 0.0:
                        status[m] = 3
                number[3, k] = 0.0
        t = N6[0]
        end = N6[2]
        h_abs = N6[1]
        smallest = 2.3e-15 * abs(t) + 1e-300
        rejected = N6[4]
        failing = where(h_abs < smallest, rejected, splat(0.0))
        failing = where(h_abs == h_abs, failing, splat(1.0))
        h_abs = maximum(h_abs, smallest)
        t_new = minimum(t + h_abs, end)
        h = t_new - t
        for s in range(1, 13):
{stages}
            derivative(t + C[s] * h, Z[Y : Y + NX], P, T, W, Z[(s + 1) * NX : (s + 2) * NX])
        sum5 = splat(0.0)
        sum3 = splat(0.0)
        for i in range(NX):
{errors}
            scale = atol + maximum(abs(Z[i]), abs(Z[Y + i])) * rtol
            e5 = e5 / scale
            e3 = e3 / scale
            sum5 = sum5 + e5 * e5
            sum3 = sum3 + e3 * e3
        error = h * sum5 / math.sqrt((sum5 + 0.01 * sum3) * NX)
        error = where(sum5 + sum3 == 0.0, splat(0.0), error)
        good = error < 1.0
        factor = 0.9 * power(maximum(error, splat(1e-30)), splat(-0.125))
        factor = where(error == error, factor, splat(0.2))
        grow = minimum(splat(10.0), factor)
        grow = where(rejected > 0.5, minimum(splat(1.0), grow), grow)
        shrink = maximum(splat(0.2), factor)
        N6[1] = select(good, h * grow, h * shrink)
        N6[4] = select(good, splat(0.0), splat(1.0))
        N6[5] = select(good, splat(1.0), splat(0.0))
        wanted = False
        for k in range(8):
            m = member[k]
            if m < 0:
                continue
            counts[m, 1] += 12
            if number[5, k] == 0.0:
                counts[m, 3] += 1
            elif done[k] < len(times) and times[done[k]] <= lane_get(t_new, k):
                wanted = True
        if wanted:
            interpolate(t, h, Z, P, T, W, F)
            for k in range(8):
                m = member[k]
                if m < 0 or number[5, k] == 0.0:
                    continue
                t0, h0, t1 = lane_get(t, k), lane_get(h, k), lane_get(t_new, k)
                if done[k] < len(times) and times[done[k]] <= t1:
                    counts[m, 1] += 3
                while done[k] < len(times) and times[done[k]] <= t1:
                    d = done[k]
                    if times[d] == t1:
                        for i in range(NX):
                            out[m, d, i] = Zs[Y + i, k]
                    else:
                        share = (times[d] - t0) / h0
                        for i in range(NX):
                            y = 0.0
                            for r in range(7):
                                y += Fs[(6 - r) * NX + i, k]
                                y *= share if r % 2 == 0 else 1.0 - share
                            out[m, d, i] = y + Zs[i, k]
                    done[k] += 1
        for i in range(NX):
            Z[i] = select(good, Z[Y + i], Z[i])
            Z[NX + i] = select(good, Z[13 * NX + i], Z[NX + i])
        N6[0] = select(good, t_new, t)
        for k in range(8):
            m = member[k]
            if m < 0:
                number[0, k], number[1, k], number[4, k] = 0.0, 0.5, 0.0
                for i in range(NX):
                    Zs[i, k] = X0[first, i]
                continue
            if lane_get(failing, k) > 0.5 and status[m] == 0:
                status[m] = 2
            if counts[m, 0] + counts[m, 3] >= {most} and status[m] == 0:
                status[m] = 5
            if number[5, k] == 1.0 and status[m] == 0:
                counts[m, 0] += 1
                if number[0, k] == number[2, k]:
                    edge[k] += 1
                    g = group[m]
                    if edge[k] == nedges[g]:
                        status[m] = 1
                    else:
                        number[2, k], number[3, k] = edges[g, edge[k]], 1.0
                        for j in range(len(places)):
                            Pl[places[j], k] = values[g, edge[k], j]
            if status[m] != 0:
                reached[m] = done[k]
                member[k] = -1
                active -= 1
                if coming < last:
                    active += 1
                    m = coming
                    coming += 1
                    member[k], edge[k], done[k] = m, 0, 1
                    for j in range(Ps.shape[1]):
                        Pl[j, k] = Ps[m, j]
                    for j in range(len(places)):
                        Pl[places[j], k] = values[group[m], 0, j]
                    for i in range(NX):
                        Zs[i, k] = X0[m, i]
                        out[m, 0, i] = X0[m, i]
                    number[0, k], number[2, k], number[3, k] = times[0], edges[group[m], 0], 1.0
                    number[1, k], number[4, k] = 0.0, 0.0

@njit({options})
def many_rk4(first, last, X0, Ps, T, edges, places, values, times, out, status, reached, counts,
             step, Zs, Pl, Ws):
    # Runge and Kutta's classical method; all members follow one schedule
    Z, P, W = lane_vector(Zs), lane_vector(Pl), lane_vector(Ws)
    X, A, K, total = Z[0:NX], Z[NX : 2 * NX], Z[2 * NX : 3 * NX], Z[3 * NX : 4 * NX]
    for base in range(first, last, 8):
        for k in range(8):
            m = min(base + k, last - 1)
            for j in range(Ps.shape[1]):
                Pl[j, k] = Ps[m, j]
            for i in range(NX):
                Zs[i, k] = X0[m, i]
                out[m, 0, i] = X0[m, i]
        t, done, edge, steps_done, pieces = times[0], 1, 0, 0, 0
        while done < len(times):
            for j in range(len(places)):
                for k in range(8):
                    Pl[places[j], k] = values[edge, j]
            prepare(P, T)
            pieces += 1
            while done < len(times):
                stop = min(times[done], edges[edge])
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
                        derivative(splat(t + part * h), A, P, T, W, K)
                        ahead = h if s == 2 else 0.5 * h
                        weight = h / 6.0 if s == 0 or s == 3 else h / 3.0
                        for i in range(NX):
                            total[i] = fma(K[i], weight, total[i])
                            A[i] = fma(K[i], ahead, X[i])
                    for i in range(NX):
                        X[i] = X[i] + total[i]
                steps_done += steps
                t = stop
                if stop == times[done]:
                    for k in range(8):
                        if base + k < last:
                            for i in range(NX):
                                out[base + k, done, i] = Zs[i, k]
                    done += 1
                if t == edges[edge]:
                    edge += 1
                    break
        for k in range(8):
            m = base + k
            if m < last:
                counts[m, 0], counts[m, 1], counts[m, 2] = steps_done, 4 * steps_done, pieces
                bad = 0.0
                for i in range(NX):
                    bad += 0.0 * Zs[i, k]
                status[m] = 1 if bad == 0.0 else 3
                reached[m] = len(times)
"""

OPTIONS = 'cache=True, nogil=True, error_model="numpy"'


def lane_module_text(fused_source: str, nx: int, nw: int) -> str:
    """Give the text of the module that runs eight members at once.

    Parameters
    ----------
    fused_source : str
        The functions derivative, signals and margin; derivative is used.
    nx, nw : int
        Numbers of states and signals.

    Returns
    -------
    str
        A whole module with the function `many`.
    """
    from .dormand_prince import coefficients, weighted_sum
    from .solver_text import MOST_STEPS

    parts = fused_source.split("\n\ndef ")
    prepare = next(part for part in parts if part.startswith("prepare("))
    derivative = f"@njit({OPTIONS}, forceinline=True)\n{parts[0]}"
    functions = f"{derivative}\n\n\n@njit({OPTIONS})\ndef {prepare}"
    solver = SOLVER.format(
        options=OPTIONS,
        most=MOST_STEPS,
        times=stage_times(),
        stages=stage_lines(" " * 12, True),
        extra=extra_lines(" " * 8, True),
        errors=error_lines(" " * 12, True),
        dense=dense_lines(" " * 8, True),
        new_state=weighted_sum(coefficients().B, True),
    )
    return f"{HEADER.format(nx=nx, nw=nw)}\n\n{functions}\n\n{solver}"
