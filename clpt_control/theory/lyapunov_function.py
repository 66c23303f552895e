"""A Lyapunov function of your own on any diagram: what V is, what V' is, and where it fails.

V and V' are exact, on the equations that run (`own_v`).  V >= 0 is shown by a sum of terms that are
not negative (`squares`), V' <= 0 by the signs of `proving`.  What is not shown is open; what is
refuted is refuted by a point, at which python-control itself gives the rates (`points`).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import control
import sympy

from ..arguments import Count, Seed, public
from ..diagrams.on_symbols import TIME
from ..html import fragment
from .own_v import OwnV, missing
from .points import Found, Points
from .proving.proof import Step, as_html, exact, first_failure, short, worked_out
from .proving.signs import tidied, vanishes
from .proving.symbolic_loop import Point
from .squares import beside


@dataclass(frozen=True)
class Lyapunov:
    """What is known of V along a diagram.

    Attributes
    ----------
    status : str
        ``"proved"``: V holds the states and V' <= 0. With what is beside it: ``"proved but for
        z"``, where V does not hold z, which may grow; ``"proved as long as z exists"``;
        ``"proved near the rest"``, where V is bounded; ``"proved where d = 0"``, of an input that
        V' depends on; ``"proved between jumps"``.
        ``"refuted"``: there is a `point` at which V' > 0, V' is not as claimed, or V is no least
        value. ``"open"``: none of these is known.
    claim : str
        What is shown of V', or where it fails.
    V, rate : sympy.Expr
        V, and V' in the diagram's own signals.
    where : str
        Where V' <= 0, if that is one condition.
    inputs : tuple of str
        Inputs that V' depends on.
    steps : tuple of Step
        What was tried, and how.
    point : Point or None
        Of a refutation: ``system.dynamics(*point)``.
    value : float or None
        What V', or what fails, is there.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> lag = clpt.Block("lag", update=lambda t, x, u, p: {"y": -p.k * x.y}, states={"y": 1},
    ...                  parameters={"k": 2.0})
    >>> found = clpt.theory.lyapunov(lag, lambda s: s.y**2 / 2)
    >>> found.status, found.rate
    ('proved', -k*y**2)
    """

    status: str
    claim: str
    V: sympy.Expr
    rate: sympy.Expr
    where: str = ""
    inputs: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    point: Point | None = None
    value: float | None = None

    def __repr__(self) -> str:
        return f"<Lyapunov {self.status}: {self.claim}>"

    def _repr_html_(self) -> str:
        return fragment("Lyapunov", f"{self.status}: {self.claim}", as_html(self.steps))


def _judged(own: OwnV, seen: Points, count: int) -> Lyapunov:
    """Put the answers together."""
    (V,) = own.shown([own.V])
    said = own.eq.undefined or missing(own.V)
    valued = exact("V and the equations have a value everywhere", not said, "".join(said[:1]))
    definite, forms = own.definite()
    steps, where, zero = [valued, definite], "", {}
    identity = own.claim is None or _as_claimed(own, steps)
    falls = own.never_positive(own.rate)
    inputs = own.depends_on()
    if not falls and inputs:
        zero = {f: sympy.Integer(0) for f in own.inputs if str(f.func) in inputs}
        zero |= {sympy.Derivative(f, TIME): sympy.Integer(0) for f in zero}
        zero = zero if own.never_positive(own.rate.xreplace(zero)) else {}
    rate = own.readable_rate()
    at = f" where {' = '.join(inputs)} = 0" if zero else ""
    steps.append(exact(f"V' = {short(rate)} <= 0{at}", falls or bool(zero)))

    def made(status: str, claim: str, found: Found | tuple[None, None] = (None, None)) -> Lyapunov:
        return Lyapunov(status, claim, V, rate, where, tuple(inputs), tuple(steps), *found)

    below = "V falls without end" if own.rest is None else "V is below its value at rest"
    tried = [] if falls or zero else [("V' > 0", seen.rises_at)]
    tried += [] if identity else [("V' is not as claimed", seen.not_as_claimed)]
    tried += [] if definite.holds else [(below, seen.no_least)]
    for fails, look in tried:
        found = look()
        steps.append(Step(f"{fails} at a point", found is not None, "counterexample", "", False))
        if found is not None:
            where = own.where() if fails == "V' > 0" else ""
            only = f"; V' <= 0 where {where}" if where else ""
            claim = f"V' = {short(rate)}; {fails}: {found[1]:.3g} at `point`{only}"
            return made("refuted", claim, found)
    if not all(step.holds for step in steps):
        return made("open", f"V' = {short(rate)}; {first_failure(steps)}")
    apart, others = NEAR if forms is None else beside(forms, own.eq)
    steps += [running := seen.running(count), others]
    jump, rise = _across_jumps(own, seen, near=forms is None)
    steps += [jump] if own.eq.jumps else []
    if rise is not None:
        return made("refuted at a jump", jump.claim, rise)
    if not running.holds:
        return made("open", first_failure(steps))
    status = " ".join(filter(None, ["proved" + at, apart, "" if jump.holds else "between jumps"]))
    valued_too = ", with the parameters as they are" if own.valued or own.eq.pinned else ""
    return made(status, f"V' = {short(rate)} <= 0{at}{valued_too}; {definite.claim}")


def _as_claimed(own: OwnV, steps: list[Step]) -> bool:
    """Return whether V' is what is claimed, and add the step."""
    rest = tidied(own.rate - own.claim)
    identity = vanishes(rest)
    if not identity and vanishes(tidied(rest.xreplace(own.eq.values))):
        identity = own.valued = True
    left = "" if identity else f"left over: {short(rest)}"
    steps.append(exact(f"V' = {short(own.shown([own.claim])[0])}", identity, left))
    return identity


NEAR = "near the rest", exact("V holds every state near the rest", True)


def _across_jumps(own: OwnV, seen: Points, near: bool) -> tuple[Step, Found | None]:
    """Return the step that V rises at no jump, and a point at which it does."""
    claim = f"V does not rise where states of {' and '.join(own.eq.jumps)} jump"
    for after in own.eq.jumps_at_once():
        rise = tidied(own.V.xreplace(after) - own.V)
        if near:  # it may jump to where V says nothing
            return exact(claim, False, "not shown"), None
        if not own.never_positive(rise):
            found = seen.rises_after(rise)
            said = claim if found is None else f"V rises by {found[1]:.3g} at a jump"
            return exact(said, False, "" if found else "not shown"), found
    return exact(claim, True), None


@public
def lyapunov(
    system: control.NonlinearIOSystem,
    V: str | Callable | sympy.Expr,
    claim: str | Callable | sympy.Expr | float | None = None,
    at: Mapping[str, float] | Sequence[float] | None = None,
    points: Count = 200,
    seed: Seed = 0,
) -> Lyapunov:
    """Judge a Lyapunov function of your own on any diagram.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A diagram, a block or a system of python-control.
    V : str, callable or sympy.Expr
        The name of an output; a function of signals, ``lambda s: s.e**2 / 2``, in NumPy, which may
        ask for parameters too; or an expression in the symbols of `clpt.equations`.
    claim : str, callable or sympy.Expr, optional
        What V' is said to be, ``lambda s: -s.am * s.e**2``; that V' <= 0 is judged in any case.
    at : mapping or array_like, optional
        The rest state, ``{"theta": np.pi}``, other states 0: where V is to be least. By default V
        may be least anywhere.
    points : int, optional
        Random points at which the running blocks are asked.
    seed : int, optional
        Of the random points.

    Returns
    -------
    Lyapunov
        `status`: ``"proved"``, ``"refuted"`` at a `point`, or ``"open"``; `rate`, V' in your own
        signals, exact.

    Raises
    ------
    DiagramError
        If the diagram cannot be read, is of discrete time, or V is no number of it.

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
    """
    with worked_out(system.name):
        own = OwnV(system, V, claim, at)
        return _judged(own, Points(own, seed), points)
