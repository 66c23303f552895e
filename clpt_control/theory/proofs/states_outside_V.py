"""States that V does not contain: do they exist for all times, and stay bounded?

Where V does not rise, each form of V is bounded: a linear form in one state bounds that state.
States that no form bounds are judged by their rates.  Linear ones with a Hurwitz matrix stay
bounded; with rates that grow at most linearly in them they exist for all times (Gronwall's lemma);
s' = 1 + s^2 escapes at t = pi/2.  Inputs are bounded.
"""

from collections.abc import Mapping
from itertools import zip_longest
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from .facts import degree, is_input
from .steps import How, Step, exact
from .sums_of_squares import squares

ANGLES = (sympy.sin, sympy.cos)


def states_outside_V(
    forms: list[sympy.Expr], substitutions: Mapping[Any, sympy.Expr], eq: Equations
) -> tuple[str, Step]:
    """Return what a status adds of the states that V does not contain, and the step.

    `known` is what symbols of the equations are.
    """
    still = {
        f: sympy.Dummy(real=True) for port in eq.inputs.values() for f in port.flat
    }
    motion = {
        s: rate.xreplace(substitutions).xreplace(still) for s, rate in eq.motion.items()
    }
    intervals = {p.interval for p in eq.parameters.values() if "interval" in p._fields}
    fixed = set(eq.values) - intervals
    forms = _bounded_forms([form.xreplace(still) for form in forms], motion, fixed)
    bounded, free = _bounded_states(forms, motion, fixed)
    if not free:
        return "", exact("V holds every state", True)
    names = _names(eq, free)
    rates = [motion[s].xreplace(bounded) for s in free]
    jumps = [
        after.xreplace(substitutions).xreplace(bounded)
        for change in eq.jumps.values()
        for s, after in change.items()
        if s in free and after != s
    ]
    # nothing is known of an opaque source, not even that it has a value at all times
    functions = sympy.Tuple(*rates).atoms(AppliedUndef)
    sources = sorted({str(f.func) for f in functions if is_input(f)})
    verb = "are" if sources[1:] else "is"
    condition = f", if {' and '.join(sources)} {verb} bounded" if sources else ""
    how: How = "sampled" if sources else "exact"
    if not jumps and _is_linear_and_stable(rates, free, fixed, intervals):
        driven = (
            " and bounded inputs" if sympy.Tuple(*rates).has(*still.values()) else ""
        )
        claim = f"{names}: linear and stable, driven by what V holds{driven}{condition}"
        return "", Step(claim, True, how, every_N=False)
    # a rate as it is or expanded, which hides roots
    written = [(rate, sympy.expand(rate)) for rate in rates] + [(j,) for j in jumps]
    if all(
        min(degree(f, free.__contains__) for f in forms_of_rate) <= 1
        for forms_of_rate in written
    ):
        claim = f"{names}: not held by V, may grow, and exist for all t{condition}"
        return f"but for {names}", Step(claim, True, how, every_N=False)
    claim = f"{names}: not held by V, exist for all t"
    return f"as long as {names} exist", exact(claim, False, "not shown")


def _bounded_forms(forms: list, motion: dict, fixed: set) -> list[sympy.Expr]:
    """Return forms that are bounded, of those that V contains, and the forms in them.

    A sine of half an angle bounds the angle up to whole turns, which is all that counts where
    nothing else depends on it.  A form that grows with time bounds nothing.
    """
    expressions = (*motion.values(), *forms)
    turns = {call for e in expressions for call in e.atoms(*ANGLES)}
    # functions of angles that whole turns leave as they are, as th**2 is none
    periodic = {
        call: sympy.Dummy()
        for call in turns
        if not any(sympy.diff(call.args[0], s).free_symbols - fixed for s in motion)
    }
    without_angles = [e.xreplace(periodic) for e in expressions]
    bounded = []
    for form in forms:
        inner = form.as_coeff_Mul()[1]
        if isinstance(inner, sympy.sin):
            states = inner.free_symbols - fixed
            is_read = any(e.has(*states) for e in without_angles)
            form = sympy.S.Zero if is_read else inner.args[0]
        if degree(form, lambda s: s == TIME) == 0:
            bounded.append(form)
    sums = filter(None, (squares(form, fixed) for form in bounded))
    return bounded + [form for total in sums for form in total.forms]


def _bounded_states(
    forms: list, motion: dict, fixed: set
) -> tuple[dict[Any, sympy.Expr], list]:
    """Return states as what bounds them, in the free states, and the free states.

    A form in one state bounds it; where each form has several states, the state that moves most
    simply is free, and the forms bound the others.
    """
    remaining, bounded, free = list(motion), dict[Any, Any](), list[Any]()
    while remaining:
        solved = (_state_of(form.xreplace(bounded), remaining, fixed) for form in forms)
        state = next(filter(None, solved), None)
        if state is not None:
            bounded |= state
            remaining = [s for s in remaining if s not in state]
            continue
        free.append(_simplest(remaining, free, motion, fixed))
        remaining.remove(free[-1])
    return bounded, free


def _simplest(remaining: list, free: list, motion: dict, fixed: set) -> Any:
    """Return the state that moves most simply, of those that are left."""
    is_state = {*remaining, *free}.__contains__

    def order(s: Any) -> tuple:
        varies = bool(sympy.diff(motion[s], s).free_symbols - fixed)
        return varies, degree(motion[s], is_state)

    return min(remaining, key=order)


def _state_of(
    form: sympy.Expr, remaining: list, fixed: set
) -> dict[Any, sympy.Expr] | None:
    """Return the single state of a form, if it has one, in terms of bounded symbols."""
    states = [s for s in remaining if form.has(s)]
    if len(states) != 1 or not form.is_polynomial(*states):
        return None
    (s,), bound = states, sympy.Dummy("bound", real=True)
    leading, *coefficients = sympy.Poly(form, s).all_coeffs()
    if not leading.is_nonzero or leading.free_symbols - fixed:
        return None
    if len(coefficients) == 1:
        return {s: (bound - coefficients[0]) / leading}
    # of higher degree it bounds s where nothing else in it moves freely
    moving = form.free_symbols - fixed - {s}
    return {s: bound} if all(isinstance(o, sympy.Dummy) for o in moving) else None


def _names(eq: Equations, free: list) -> str:
    """Return the names of free states: a port where all of it is free."""
    names = []
    for port, symbols in eq.states.items():
        members = [s for s in symbols.flat if s in free]
        is_whole = len(members) == symbols.size
        names += [port] if is_whole else [str(s) for s in members]
    # a state that is no output has the name block:state
    return ", ".join(name.rpartition(":")[2] for name in names)


def _is_linear_and_stable(rates: list, free: list, fixed: set, intervals: set) -> bool:
    """Return whether rates are linear in the free states, with a Hurwitz matrix."""
    expanded = sympy.Matrix([sympy.expand(rate) for rate in rates])
    J = expanded.jacobian(free)
    remainder = expanded - J * sympy.Matrix(free)
    varies = remainder.has(TIME, *intervals, *free)
    return not (varies or J.free_symbols - fixed) and hurwitz(J)


def hurwitz(A: sympy.Matrix) -> bool:
    """Return whether all eigenvalues have a negative real part, by Routh's table, exactly."""
    row, next_row = (A.charpoly().all_coeffs()[k::2] for k in (0, 1))
    while next_row and next_row[0].is_positive:
        share = row[0] / next_row[0]
        pairs = zip_longest(row[1:], next_row[1:], fillvalue=0)
        row, next_row = next_row, [sympy.cancel(a - share * b) for a, b in pairs]
    return not next_row
