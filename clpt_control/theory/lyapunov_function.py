"""A Lyapunov function of your own on any diagram: what V is, what V' is, and where it fails.

V and V' are exact, on the equations that run (`v_on_symbols`).  V >= 0 is shown by a sum of terms
that are not negative (`squares`), V' <= 0 by the signs of `proving`.  What is not shown is open;
what is refuted is refuted by a point.  Where no V is given, one is searched for (`searching`) and
checked as any other is.  In a region (`region`) V' < 0 is enough.

Points of wide ranges are drawn, and drawn again beside the best of them.  Whatever an expression
says, V' there is that along the rates that python-control itself gives.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import Any

import control
import numpy as np
import sympy

from ..arguments import Count, Seed, public
from ..engine.diagram.symbol_names import TIME
from ..errors import DiagramError
from .proving.proof import Step, checked, exact, first_failure, short, worked_out
from .proving.running_rate import SURE, PointSearch
from .proving.signs import tidied, vanishes
from .proving.symbolic_loop import Point
from .proving.verdict import Verdict
from .region import Region
from .searching import candidates
from .squares import states_beside
from .v_on_symbols import SystemWithV, of_signals

Failure = tuple[Point, float]  # a point, and what V', or what fails, is there


class FailureSearch(PointSearch):
    """Points at which a V fails, and V' of the running blocks at points."""

    def __init__(self, case: SystemWithV, seed: int):
        super().__init__(case.system, case.eq, case.V, case.name, case.rest or {}, seed)
        self.case = case

    def running(self, points: int, region: Region | None = None) -> Step:
        """Return the step that the running blocks give the same V', and V where it is an output."""

        def same() -> tuple[bool, str]:
            t, x, u = self.wide(points, region is not None)
            if region is not None:
                x = self.random.uniform(region.low, region.high, x.T.shape).T
            return self.compare((t, x, u), points)

        return checked("the running blocks give the same V'", same, "sampled", False)

    def rises_at(self) -> Failure | None:
        """Return a point at which the running blocks have V' > 0, and V' there."""
        if not self.case.depends_on():
            return self.rate_beside(sympy.S.Zero, (1,), (True, False))
        still = self.rate_beside(sympy.S.Zero, (1,), (True,))
        return still or self.rises_with_inputs()

    def rises_with_inputs(self) -> Failure | None:
        """Return a point at which inputs make V rise, however far off, and V' there."""
        nothing_held = np.zeros(len(self.states), dtype=bool)
        return next(self.rises_far_off(self.case.rate, nothing_held), None)

    def not_as_claimed(self) -> Failure | None:
        """Return a point at which V' of the running blocks is not as claimed, and V' there."""
        return self.rate_beside(self.case.claim, (1, -1), (False,))

    def rate_beside(
        self, claim: sympy.Expr, signs: tuple, stills: tuple
    ) -> Failure | None:
        """Return a point at which V' of the running blocks lies beside a claim, and V' there."""
        residual = tidied(self.case.rate - claim)
        for sign, still in product(signs, stills):
            for point in self.highest(sign * residual, still):
                (value,), (size,), _ = self.rates_at(point, point.x[None])
                right = self.value_at(claim, point)
                if sign * (value - right) > SURE * max(size, abs(right)):
                    return point, float(value)
        return None

    def no_least(self) -> Failure | None:
        """Return a point at which V is below its value at the rest, and by how much.

        Where no rest is given it is one whose multiples have a V that falls without end: there the
        part of V of highest degree is negative.
        """
        V, states = self.case.V, self.case.states
        if self.case.rest is not None:
            rise = V - V.xreplace(self.case.rest)
        elif V.is_polynomial(*states) and V.has(*states):
            far = sympy.Dummy()
            rise = sympy.Poly(V.xreplace({s: far * s for s in states}), far).LC()
        else:
            return None
        return self.where(rise, -1)

    def value_at(self, expression: sympy.Expr, point: Point) -> float:
        """Return an expression at a point."""
        at = self.known(np.array([point.t]), point.x[:, None], point.u[:, None])
        return float(self.numbers(expression).at(at, 1)[0, 0])

    def where(self, expression: sympy.Expr, sign: int) -> Failure | None:
        """Return a point at which an expression has a sign, and what it is there."""
        point = next(self.highest(sign * expression, True), None)
        return None if point is None else (point, self.value_at(expression, point))


def valued(case: SystemWithV) -> Step:
    """Return the step that V and the equations have a value everywhere."""
    claim = "V and the equations have a value everywhere"
    return exact(claim, not case.undefined, "".join(case.undefined[:1]))


def _proved(case: SystemWithV, search: FailureSearch, count: int) -> Verdict:
    """Return what is shown of a V, or where that ends."""
    V = case.in_signals(case.V)
    definite, forms = case.definite()
    falls, inputs = case.falls() or case.is_claim_proved(), case.depends_on()
    zero: dict[Any, Any] = {}
    if not falls and inputs:
        zero = {f: sympy.S.Zero for f in case.inputs if str(f.func) in inputs}
        zero |= {sympy.Derivative(f, TIME): sympy.S.Zero for f in zero}
        zero = zero if case.never_positive(case.rate.xreplace(zero)) else {}
    rate = case.readable_rate()
    at = f" where {' = '.join(inputs)} = 0" if zero else ""
    steps = [
        valued(case),
        definite,
        exact(f"V' = {short(rate)} <= 0{at}", falls or bool(zero)),
    ]
    if case.claim is not None:
        residual = tidied(case.rate - case.claim)
        left = "" if vanishes(residual) else f"left over: {short(residual)}"
        steps.append(
            exact(f"V' = {short(case.in_signals(case.claim))}", not left, left)
        )

    def result(
        status: str, claim: str, at: Failure | tuple[None, None] = (None, None)
    ) -> Verdict:
        return Verdict(status, claim, V, rate, tuple(inputs), tuple(steps), *at)

    if failed := first_failure(steps):
        return result("open", f"V' = {short(rate)}; {failed}")
    apart, others = states_beside(forms, case.eq)
    steps += [running := search.running(count), others]
    jump, rise = _at_jumps(case, search)
    steps += [jump] if case.eq.jumps else []
    if rise is not None:
        return result("refuted at a jump", jump.claim, rise)
    if not running.holds:
        return result("open", first_failure(steps))
    status = " ".join(
        filter(None, ["proved" + at, apart, "" if jump.holds else "between jumps"])
    )
    return result(
        status, f"V' = {short(rate)} <= 0{at}{case.as_they_are}; {definite.claim}"
    )


def _refuted(case: SystemWithV, search: FailureSearch, found: Verdict) -> Verdict:
    """Return what is found of a V, refuted by a point where it is open and there is one."""
    _, definite, falls, *claimed = found.steps
    below = (
        "V falls without end" if case.rest is None else "V is below its value at rest"
    )
    tried = [
        ("V' > 0", search.rises_at, falls.holds),
        (
            "V' is not as claimed",
            search.not_as_claimed,
            case.claim is None or claimed[0].holds,
        ),
        (below, search.no_least, definite.holds),
    ]
    rate, steps = case.readable_rate(), found.steps
    for fails, look, holds in tried:
        if holds:
            continue
        at = look()
        steps += (
            Step(f"{fails} at a point", at is not None, "counterexample", "", False),
        )
        if at is not None:
            claim = f"V' = {short(rate)}; {fails}: {at[1]:.3g} at `point`"
            of = replace(found, status="refuted", claim=claim, rate=rate, steps=steps)
            return replace(of, V=case.in_signals(case.V), point=at[0], value=at[1])
    return replace(found, steps=steps)


def _refuted_by_inputs(search: FailureSearch, found: Verdict) -> Verdict:
    """Return what is found of a V, refuted where inputs raise it however far from the rest."""
    failure = search.rises_with_inputs()
    if failure is None:
        return found
    inputs = ", ".join(found.inputs)
    claim = f"V' > 0: {failure[1]:.3g} at `point`, and 10 and 100 times as far off"
    step = Step(f"{inputs} raises V however large it is", True, "counterexample")
    return replace(
        found,
        status="refuted",
        claim=f"{claim}; {found.status.removeprefix('proved ')} V' <= 0",
        steps=(*found.steps, replace(step, every_N=False)),
        point=failure[0],
        value=failure[1],
    )


def _at_jumps(case: SystemWithV, search: FailureSearch) -> tuple[Step, Failure | None]:
    """Return the step that V rises at no jump, and a point at which it does."""
    claim = f"V does not rise where states of {' and '.join(case.eq.jumps)} jump"
    for after in case.eq.jumps_at_once():
        rise = tidied(case.V.xreplace(after) - case.V)
        if not case.never_positive(rise):
            at_times = rise.has(TIME, *case.intervals)  # at few of which it jumps
            found = None if at_times else search.where(rise, 1)
            outcome = claim if found is None else f"V rises by {found[1]:.3g} at a jump"
            return exact(outcome, False, "" if found else "not shown"), found
    return exact(claim, True), None


def _in_region(
    case: SystemWithV, search: FailureSearch, within: Any, count: int
) -> Verdict:
    """Return in which part of a box V' < 0, with inputs of 0."""
    region = Region(case, within)
    level = region.level()
    less = f" - {short(region.least)}" if region.least else ""
    inputs = [str(f.func) for f in case.inputs]
    at = f" where {' = '.join(inputs)} = 0" if inputs else ""
    below = f"where V{less} < {level:g} in the box" if level else "near the rest"
    claim = f"V' < 0 {below}, but at the rest{case.as_they_are}"
    steps = (
        valued(case),
        Step(claim, level > 0.0, "enclosed"),
        search.running(count, region),
    )
    failed, V, rate = (
        first_failure(steps),
        case.in_signals(case.V),
        case.readable_rate(),
    )
    if failed:
        return Verdict("open", f"V' = {short(rate)}; {failed}", V, rate, steps=steps)
    claim += ": what begins there comes to rest"
    status = f"proved in a region{at}"
    return Verdict(status, claim, V, rate, tuple(inputs), steps, level=level)


def _best_candidate(
    system: control.NonlinearIOSystem, at: Any, judged: Callable[[sympy.Expr], Verdict]
) -> Verdict:
    """Return the best of the functions that are searched for."""
    best, case = None, SystemWithV(system, sympy.S.Zero, None, at)
    for V in candidates(case):
        found = judged(V)
        if found.status == "proved" or found.level:
            return found
        if best is None and found.status.startswith("proved"):
            best = found
    inputs = ", ".join(str(f.func) for f in case.inputs)
    still = f", with {inputs} = 0," if inputs else ""
    none = f"no V was found{still} that is proved: give one, or a rest (at=) to search about"
    return best or Verdict("open", none, None, None)


@public
def lyapunov(
    system: control.NonlinearIOSystem,
    V: str | Callable | sympy.Expr | None = None,
    claim: str | Callable | sympy.Expr | float | None = None,
    at: Mapping[str, float] | None = None,
    points: Count = 200,
    seed: Seed = 0,
    within: Mapping[str, Sequence[float]] | None = None,
) -> Verdict:
    """Judge a Lyapunov function of your own on any diagram.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A diagram, a block or a system of python-control.
    V : str, callable or sympy.Expr, optional
        The name of an output; a function of signals, ``lambda s: s.e**2 / 2``, in NumPy, which may
        ask for parameters and the time ``s.t`` too; or an expression in the symbols of
        `clpt.equations`.  By default V is searched for, of squares, products of two states, and
        integrals of functions of one state: `status` is then ``"open"`` where none that is found
        is proved.
    claim : str, callable, sympy.Expr or float, optional
        What V' is said to be, ``lambda s: -s.am * s.e**2``; that V' <= 0 is judged in any case.
    at : mapping, optional
        The rest state, ``{"theta": np.pi}``, other states 0: where V is to be least. By default V
        may be least anywhere, and is searched for about 0.
    points : int, optional
        Random points at which the running blocks are asked.
    seed : int, optional
        Of the random points.
    within : mapping, optional
        The ends of each state, ``{"theta": (-1, 1), "omega": (-2, 2)}``: where V' < 0 in this box,
        and from where every run comes to rest, inputs 0. For few states, some four.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, or with where it is, ``"proved in a region"``; ``"refuted"`` at a
        `point`, or ``"open"``; `rate`, V' in your own signals, exact.

    Raises
    ------
    DiagramError
        If the diagram cannot be read, is of discrete time, V is no number of it, or is to be
        searched for about what is no rest, of more than 16 states, or with a claim.

    Examples
    --------
    >>> import numpy as np
    >>> import clpt_control as clpt
    >>> def swing(t, x, u, p):
    ...     return {"theta": x.omega, "omega": -p.g * np.sin(x.theta) - p.b * x.omega}
    >>> pendulum = clpt.Block("rod", update=swing, states={"theta": 1, "omega": 1},
    ...                       parameters={"g": 9.8, "b": 0.1})
    >>> energy = lambda s: s.omega**2 / 2 + s.g * (1 - np.cos(s.theta))
    >>> clpt.theory.lyapunov(pendulum, energy).rate
    -b*omega**2
    >>> clpt.theory.lyapunov(pendulum).V
    omega**2/2 - 49*cos(theta)/5 + 49/5
    """

    def judged(V: Any) -> Verdict:
        case = SystemWithV(system, V, claim, at, bool(within))
        search = FailureSearch(case, seed)
        if within:
            return _in_region(case, search, within, points)
        found = _proved(case, search, points)
        if found.status != "proved" and case.eq.values:
            valued = SystemWithV(system, V, claim, at, numbers=True)
            of_values = _proved(valued, FailureSearch(valued, seed), points)
            if of_values.status == "proved" or not found.status.startswith("proved"):
                found = of_values
        if found.status.startswith("proved where"):
            return found if is_searched else _refuted_by_inputs(search, found)
        return (
            found
            if found.status.startswith("proved")
            else _refuted(case, search, found)
        )

    if claim is not None and (V is None or within):
        why = "in a box V' < 0 is judged" if within else "it is of a V that is given"
        raise DiagramError(f"{system.name}: leave the claim out: {why}")
    with worked_out(system.name):
        is_searched = V is None
        V, claim = of_signals(system, V), of_signals(system, claim)
        return _best_candidate(system, at, judged) if V is None else judged(V)
