"""Rates of a diagram that slides on one switch or several at once.

On k switches g_i = 0 the rates are the mean of those on their sides that stays on all of them:

    x' = f_0 + sum_i w_i (f_i - f_0),    g_i' = 0,    0 < w_i < 1

f_0 are the rates on one side of all switches, f_i those with switch i on its other side.  The k
linear equations for the shares w come apart into groups of switches that do not move each other.
The formula holds if the rates are affine in the sides; one guard ends the run where they are not.

Source: Filippov, A. F. (1988), Differential Equations with Discontinuous Righthand Sides, Kluwer,
section 4; Dieci, L., Lopez, L. (2011), Sliding motion on discontinuity surfaces of high
co-dimension, Numerische Mathematik 117.
"""

from math import prod
from typing import Any, NamedTuple

import numpy as np
from scipy.sparse.csgraph import connected_components

from ..codegen.switching_conditions import Port, change_with
from ..record.unread import Unread
from ..trace.arrays import operand
from ..trace.derivative import Direction
from ..trace.elementwise import spread
from ..trace.numpy_functions import solve

NEGLIGIBLE = 1e-6  # share of rates that counts as nothing
TINY = 1e-30
DRIFT = 10.0  # tolerances of a distance within which a run is on its switch
Slopes = dict[Port, Any]  # of states, by the port of their rates


class HeldSwitch(NamedTuple):
    """Decisions that change on one switch, and the one whose distance is its g."""

    decisions: tuple[int, ...]
    switch: int


def decisions_of(held: tuple[HeldSwitch, ...]) -> tuple[int, ...]:
    """Return the decisions that stay for as long as a run slides on switches."""
    return tuple(k for switch in held for k in switch.decisions)


def slide(record: Any, held: tuple[HeldSwitch, ...]) -> None:
    """Replace the rates of a `DiagramRecord` by those on switches.

    Each w and 1 - w become margins, and so does that the run stays on each switch, and that the
    other fixed decisions stay.
    """
    conditions = record.decisions
    # 1. rates on one side of all switches, and their changes on the other side of each
    fixed = decisions_of(held)
    rates = record.lock(fixed=fixed)
    changes = [_changes(record, rates, fixed, switch.decisions) for switch in held]
    # 2. shares of the other sides, with which no distance changes
    distances = [conditions.distance_of(switch.switch) for switch in held]
    base = {port: record.tape.value(port.ref) for port in rates}
    slopes = [_slope(record, distance, base, 1.0) for distance in distances]
    matrix = [
        [_slope(record, distance, change) for change in changes]
        for distance in distances
    ]
    shares = _shares(matrix, slopes)
    for share in shares:
        record.require(operand(share))
        record.require(operand(1.0 - share))
    every: Slopes = {}
    if len(changes) > 1:
        every = _changes(record, rates, fixed, fixed)
    # 3. the mean of the rates
    record.rates = []
    for port in rates:
        mean = spread(record.tape, base[port], port.shape)
        for share, change in zip(shares, changes, strict=True):
            if port in change:
                mean = mean + share * change[port]
        record.rates.append(port._replace(ref=operand(mean)))
    # 4. conditions of this motion
    _stay_on(record, distances)
    _stay_parallel(record, held, base)
    _stay_affine(record, every, changes)


def _changes(
    record: Any, rates: list[Port], fixed: tuple[int, ...], flipped: tuple[int, ...]
) -> Slopes:
    """Return the change of the rates if decisions flip, of the ports that change."""
    tape = record.tape
    changes: Slopes = {}
    flipped_rates = record.decisions.lock(record.rates, fixed, flipped)
    for port, other in zip(rates, flipped_rates, strict=True):
        if port.ref != other.ref:
            before = spread(tape, tape.value(port.ref), port.shape)
            behind = spread(tape, tape.value(other.ref), port.shape)
            changes[port] = behind - before
    return changes


def _shares(matrix: list[list[Any]], slopes: list[Any]) -> list[Any]:
    """Return the w of matrix w = -slopes, solved in groups that depend on each other."""
    count = len(slopes)
    shares: list[Any] = [0.0] * count
    coupled = [
        [not (isinstance(slope, float) and slope == 0.0) for slope in row]
        for row in matrix
    ]
    groups, group_of = connected_components(np.array(coupled))
    for group in range(groups):
        members = np.flatnonzero(group_of == group).tolist()
        if not any(coupled[i][j] for i in members for j in members):
            raise Unread("a switch that its rates do not move")
        if len(members) == 1:
            k = members[0]
            shares[k] = -slopes[k] / matrix[k][k]
            continue
        rows = [np.stack([matrix[i][j] for j in members]) for i in members]
        right = np.stack([-slopes[i] for i in members])
        solved = solve(np.stack(rows), right)
        for row, k in enumerate(members):
            shares[k] = solved[row]
    return shares


def _stay_on(record: Any, distances: list[Any]) -> None:
    """Require that distances stay 0: decisions that they depend on may move a switch."""
    rtol, atol = (record.load("P", record.decisions.tolerances + k, ()) for k in (0, 1))
    rtol, atol = record.tape.value(rtol), record.tape.value(atol)
    bound = change_with(record, lambda size: atol + rtol * size)
    for distance in distances:
        value = record.tape.value(distance)
        allowed = DRIFT * bound.of(value) + TINY
        record.require(operand(1.0 - np.fabs(value) / allowed))


def _stay_parallel(record: Any, held: tuple[HeldSwitch, ...], base: Slopes) -> None:
    """Require that the other distances of each switch do not change."""
    mean = {port: record.tape.value(port.ref) for port in record.rates}
    for switch in held:
        for decision in set(switch.decisions) - {switch.switch}:
            distance = record.decisions.distance_of(decision)
            moved = np.fabs(_slope(record, distance, mean, 1.0))
            scale = np.fabs(_slope(record, distance, base, 1.0))
            allowed = NEGLIGIBLE * scale + TINY
            record.require(operand(1.0 - moved / allowed))


def _stay_affine(record: Any, every: Slopes, changes: list[Slopes]) -> None:
    """Require that all sides together change the rates as they do one by one."""
    for port, change in every.items():
        single = [changes[port] for changes in changes if port in changes]
        if len(single) < 2:
            continue
        difference = change
        scale = np.fabs(change)
        for one in single:
            difference = difference - one
            scale = scale + np.fabs(one)
        moved = _total(record, port, np.fabs(difference))
        allowed = NEGLIGIBLE * _total(record, port, scale) + TINY
        record.require(operand(1.0 - moved / allowed))


def _total(record: Any, port: Port, array: Any) -> Any:
    """Return the sum of all elements of an array like a port."""
    ref = operand(array)
    for axis in reversed(range(len(port.shape))):
        at = axis, port.shape[axis], port.long[axis]
        ref = record.add("sum", (ref,), port.shape[:axis], at)
    return record.tape.value(ref)


def _slope(record: Any, distance: int, rates: Slopes, time: float = 0.0) -> Any:
    """Return the derivative of a distance along rates, and along time."""

    def slope_of(k: int) -> Any:
        _, _, shape, (array, begin) = record.entries[k]
        if array == "t":
            return time or None
        end = begin + prod(shape)
        for port, rate in rates.items() if array == "X" else ():
            if port.first <= begin and end <= port.first + prod(port.shape):
                ref = operand(rate)
                if type(ref) is float:
                    return rate
                return record.tape.value(record.part(ref, begin - port.first, shape))
        return None

    derivative = Direction(record.tape, slope_of)
    return derivative.of(record.tape.value(distance))
