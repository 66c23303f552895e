"""Coefficients of Taylor series on balls: the loop over orders and operations, as machine code.

    C[s, k, e], R[s, k, e]   centre and radius of coefficient k of value s; e = 0 is the
                             value itself, e > 0 its derivative along direction e
    whole[i], real[i]        operation i, a `operations.Recurrence`
    states[j]                values of state j and of its rate
    still[s]                 1 if the value does not change in time

Each radius takes in a bound of the rounding errors of its centre: half a unit in the last place of
each result on the way (Higham 2002, section 3.3).  Radii are rounded up by a factor, and numbers
that underflow are covered by `TINY`.

Numba compiles this page (`make solver`), so it is plain loops over arrays.
"""

from typing import Any

# columns of `whole`; no value is -1
RESULT, LEFT, RIGHT, U, V, FIRST, LAST, DIVISOR, WEIGHTED = range(9)
# columns of `real`
OF_LEFT, OF_RIGHT, SIGN, FACTOR = range(4)
HALF_UNIT = 2.0**-53
# of a radius, for the rounding of radii up to order 60
GROWTH = 1.0 + 2.0**-43
INFINITE = float("inf")
TINY = 2.0**-500  # more than underflow; its square is still a number


def coefficients(
    C: Any,
    R: Any,
    whole: Any,
    real: Any,
    states: Any,
    still: Any,
    begin: int,
    end: int,
    first_order: int,
    last_order: int,
    first_column: int,
    last_column: int,
) -> int:
    """Compute coefficients of some operations; the last order above 0 is that of states alone."""
    for k in range(first_order, last_order + 1):
        # 1. states, from the coefficients of their rates
        if k > 0:
            for j in range(len(states)):
                x, rate = states[j, 0], states[j, 1]
                for e in range(first_column, last_column):
                    c = C[rate, k - 1, e] / k
                    C[x, k, e] = c
                    r = R[rate, k - 1, e] / k + HALF_UNIT * abs(c)
                    R[x, k, e] = r * GROWTH + TINY
            if k == last_order:
                break
        # 2. operations
        for i in range(begin, end):
            result = whole[i, RESULT]
            if k > 0 and still[result] == 1:
                continue
            left, right = whole[i, LEFT], whole[i, RIGHT]
            u, v = whole[i, U], whole[i, V]
            weighted = whole[i, WEIGHTED]
            first, last = whole[i, FIRST], k - whole[i, LAST]
            if u >= 0:
                if still[u] == 1:
                    last = min(last, 0)
                if still[v] == 1:
                    first = max(first, k)
            for e in range(first_column, last_column):
                c = 0.0
                r = 0.0
                rounded = 0.0  # sum of the results on the way
                if left >= 0:
                    c = real[i, OF_LEFT] * C[left, k, e]
                    r = abs(real[i, OF_LEFT]) * R[left, k, e]
                    rounded = abs(c) if abs(real[i, OF_LEFT]) != 1.0 else 0.0
                if right >= 0:
                    term = real[i, OF_RIGHT] * C[right, k, e]
                    c = c + term
                    r = r + abs(real[i, OF_RIGHT]) * R[right, k, e]
                    rounded = rounded + abs(term) + abs(c)
                if weighted == 1 and k == 0:
                    # the derivative of a function, whose value is known
                    first, last = 0, 0
                if u >= 0:
                    total = 0.0
                    for j in range(first, last + 1):
                        weight = 1.0
                        if weighted == 1 and k > 0:
                            weight = float(j)
                        for half in range(2):
                            if half == 0 and weighted == 1 and k == 0:
                                continue
                            if half == 0:
                                a, b = 0, e
                            elif e > 0:
                                a, b = e, 0
                            else:
                                continue
                            p = weight * C[u, j, a]
                            p_r = weight * R[u, j, a]
                            q = C[v, k - j, b]
                            q_r = R[v, k - j, b]
                            term = p * q
                            total = total + term
                            r = r + (abs(p) * q_r + p_r * (abs(q) + q_r))
                            rounded = (
                                rounded + (1.0 + weighted) * abs(term) + abs(total)
                            )
                    c = c + real[i, SIGN] * total
                    rounded = rounded + abs(c)
                    if u == v and k == 0 and e == 0 and last == 0 and weighted == 0:
                        # the square of a number is not below 0
                        q, q_r = abs(C[u, 0, 0]), R[u, 0, 0]
                        if q < q_r:
                            c = 0.5 * (q + q_r) * (q + q_r)
                            r = c
                            rounded = 4.0 * c
                        else:
                            c = q * q + q_r * q_r
                            r = 2.0 * q * q_r
                            rounded = 3.0 * c
                if weighted == 1 and k > 1:
                    c = c / k
                    r = r / k
                    rounded = rounded / k + abs(c)
                divisor = whole[i, DIVISOR]
                if divisor >= 0:
                    factor = real[i, FACTOR]
                    if e > 0 and not (k == 0 and divisor == result):
                        p, p_r = C[result, k, 0], R[result, k, 0]
                        q, q_r = (factor * C[divisor, 0, e], factor * R[divisor, 0, e])
                        term = p * q
                        c = c - term
                        r = r + (abs(p) * q_r + p_r * (abs(q) + q_r))
                        rounded = rounded + abs(term) + abs(c)
                    r = r + HALF_UNIT * rounded + TINY
                    d, d_r = factor * C[divisor, 0, 0], factor * R[divisor, 0, 0]
                    c = c / d
                    room = abs(d) - d_r
                    r = (r + abs(c) * d_r) / room if room > 0.0 else INFINITE
                    rounded = abs(c)
                C[result, k, e] = c
                R[result, k, e] = (r + HALF_UNIT * rounded) * GROWTH + TINY
    return 0
