"""A Lyapunov function of your own on any diagram: what V is, what V' is, and where it fails.

    V' = dV/dt + sum_i (dV/dx_i) f_i(t, x, u)

V and V' are exact, on the equations that run.  V >= 0 is shown by a sum of terms that are not
negative (`squares`), V' <= 0 by the signs of `proving`.  What is not shown is open; what is refuted
is refuted by a point, at which python-control itself gives the rates.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain
from typing import Any

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ..arguments import Seed, check_holds, numbers, public
from ..diagrams.on_symbols import TIME, Equations, called, readable_equations
from ..equations.block import Block
from ..equations.symbolic import expressions
from ..errors import DiagramError
from ..html import facts, fragment
from ..progress.interrupt import check
from .proving.array_loop import no_value
from .proving.proof import Step, checked, exact, first_failure, short
from .proving.signs import nonpositive, tidied, vanishes
from .proving.symbolic_loop import Point, numeric
from .proving.symbols import undefined
from .proving.words import along, degree, interval, is_input, meets_smoothly
from .squares import squares

LARGE = ("exp", "expm1", "sinh", "cosh")  # have a value wherever it is a number
SEARCHES, PER_SEARCH, ROUNDS, BEST = 20, 500, 15, 5
MOST_FACTORED = 40  # terms
SURE = 1e-7  # of the size of its terms: a sign that is no rounding
CLOSE = 1e-9


@dataclass(frozen=True)
class Lyapunov:
    """What is known of V along a diagram.

    Attributes
    ----------
    status : str
        ``"proved"``: V holds the states and V' <= 0. With what is beside it: ``"proved but for
        z"``, where V does not hold z, which may grow; ``"proved as long as z exists"``;
        ``"proved where d = 0"``, of an input that V' depends on; ``"proved between jumps"``.
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
        rows = [
            (one.claim, "holds" if one.holds else "not shown", one.how, one.detail)
            for one in self.steps
        ]
        head = ("claim", "", "how", "detail")
        return fragment("Lyapunov", f"{self.status}: {self.claim}", facts(rows, head))


def _watched(owner: str, kind: str, arguments: tuple) -> str | None:
    """Return where an operation has no value; a number that is too large has one."""
    said = no_value(owner, kind, arguments)
    return None if kind in LARGE else said


def snapped(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression with 2/3 for 0.6666666666666666, which a V may mean."""

    def near(q: sympy.Rational) -> sympy.Rational:
        own = Fraction(q.p, q.q)
        simple = own.limit_denominator(10_000)
        return sympy.Rational(simple) if abs(simple - own) <= abs(own) * Fraction(1, 2**50) else q

    return expression.xreplace({q: near(q) for q in expression.atoms(sympy.Rational)})


class _Case:
    """A diagram with its V, and what is asked of them."""

    def __init__(self, system: Any, V: Any, claim: Any, at: Any, seed: int):
        self.system, self.random = system, np.random.default_rng(seed)
        self.eq: Equations = readable_equations(system, watch=_watched)
        if self.eq.discrete:
            raise DiagramError(f"{system.name}: is of discrete time, in which nothing has a rate")
        self.states, self.fixed = [*self.eq.motion], set(self.eq.values)
        self.inputs = [s for own in self.eq.inputs.values() for s in own.flat]
        self.V, labels = (
            snapped(self.expression(V)),
            {V, f"{V}[0]"} if isinstance(V, str) else set(),
        )
        self.name = next((one for one in system.output_labels if one in labels), "")
        self.claim = None if claim is None else snapped(self.expression(claim))
        self.rate = along(self.V, {TIME: sympy.Integer(1), **self.eq.motion})
        self.rest = None if at is None else self.place(at)
        self.valued = False  # whether the parameters' own values are used

    def expression(self, given: Any) -> sympy.Expr:
        """Return a name, a function of signals or an expression in states and inputs."""
        if callable(given) and not isinstance(given, sympy.Basic):
            named = {name.replace(".", "_"): own for name, own in self.eq.named.items()}
            named = {
                name: own
                for name, own in named.items()
                if name.isidentifier() and not hasattr(np.ndarray, name)
            }
            ports = {name: own.shape for name, own in named.items()}
            made = Block(
                "V", output=lambda t, x, u, p: {"V": given(u)}, inputs=ports, outputs={"V": 1}
            )
            (found,) = expressions(made, "output", lambda at, shape, index: named[at[1]][index])
        else:
            found = sympy.sympify(self.eq[given] if isinstance(given, str) else given)
        if not isinstance(found, sympy.Expr):
            raise DiagramError(f"{self.system.name}: {short(given, 60)} is no single number")
        known = {s.name: s for s in (TIME, *self.states, *self.fixed)}
        known |= {str(f.func): f for f in self.inputs}
        for s in found.free_symbols - {TIME, *self.states, *self.fixed}:
            if s.name not in known:
                raise DiagramError(
                    f"{self.system.name}: has no {s}; it has {', '.join(map(str, known))}"
                )
            found = found.subs(s, known[s.name])
        return found

    def place(self, at: Mapping[str, float] | Sequence[float]) -> dict[Any, sympy.Expr]:
        """Return each state's value at a rest, pi where a number is that."""
        if not isinstance(at, Mapping):
            own = numbers("at", at, len(self.states))
            at = dict(zip(map(str, self.states), own, strict=True))
        found = dict.fromkeys(self.states, sympy.Integer(0))
        names = {str(s): s for s in self.states}
        check_holds("at", names, at, f"states are {', '.join(names)}")
        for name, value in at.items():
            found[names[name]] = sympy.nsimplify(float(value), [sympy.pi])
        return found

    # --- V --------------------------------------------------------------------------------

    def held(self) -> tuple[Step, list[sympy.Expr]]:
        """Return the step that V is positive definite, and the forms that it holds."""
        words = [f for f in self.V.atoms(AppliedUndef) if not is_input(f)]
        if self.V.has(sympy.atan2) or (words and not meets_smoothly(self.V)):
            return exact("V is positive definite", False, "V may jump or bend"), []
        moved = {s: s + v for s, v in (self.rest or {}).items()}
        back = {s: s - v for s, v in (self.rest or {}).items()}
        for at in ({}, self.eq.values):
            V = self.V.xreplace(at).xreplace({s: v.xreplace(at) for s, v in moved.items()})
            found = squares(V, self.fixed)
            zero = dict.fromkeys(self.states, 0)
            if found and self.rest is not None:
                found = found if all(vanishes(f.subs(zero)) for f in found.forms) else None
            if found and found.forms:
                forms = [f.xreplace(back) for f in found.forms]
                said = ", ".join(dict.fromkeys(map(str, self.shown(forms))))
                self.valued |= bool(at)
                return exact(f"V is positive definite in {said}", True), forms
            own = [s for s in self.states if V.has(s)]
            if len(own) < len(self.states):
                continue
            H, slopes = sympy.hessian(V, own).subs(zero), [sympy.diff(V, s).subs(zero) for s in own]
            finite = not any(one.has(sympy.zoo, sympy.nan, sympy.oo) for one in (H, *slopes))
            still = finite and all(map(vanishes, slopes)) and not H.free_symbols - self.fixed
            if still and H.is_positive_definite:
                return exact("V is positive definite near the rest", True), []
        return exact("V is positive definite", False, "not shown"), []

    def shown(self, found: list[sympy.Expr]) -> list[sympy.Expr]:
        """Return expressions in the diagram's own signals, with squares completed or factored."""
        names: dict[sympy.Expr, sympy.Expr] = {}
        for port, own in self.eq.signals.items():
            for index, value in np.ndenumerate(own):
                value = sympy.expand(value)
                if value.is_Add:
                    symbol = sympy.Symbol(called(port, own.shape, index), real=True)
                    names |= {value: symbol, sympy.expand(-value): -symbol}

        def named(e: sympy.Expr) -> sympy.Expr:
            return e.replace(lambda one: one.is_Add, lambda one: names.get(sympy.expand(one), one))

        return [named(e) for e in found]

    # --- V' -------------------------------------------------------------------------------

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive, for t >= 0."""
        expression, later = tidied(expression), {TIME: sympy.Dummy("t", nonnegative=True)}
        for at in ({}, self.eq.values):
            one = tidied(expression.xreplace(at))
            if not self.positive_somewhere(one) and self.below_zero(one.xreplace(later)):
                self.valued |= bool(at)
                return True
        return False

    def positive_somewhere(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is positive at a random point: no proof is tried then."""
        try:
            function, symbols = numeric(expression)
        except DiagramError:
            return False
        drawn = self.random.standard_normal((len(symbols), PER_SEARCH))
        drawn *= 10.0 ** self.random.uniform(-1, 1, (1, PER_SEARCH))
        for own, s in zip(drawn, symbols, strict=True):
            if s.is_nonnegative or s.is_nonpositive or s == TIME:
                own[:] = np.abs(own) * (-1 if s.is_nonpositive else 1)
        with np.errstate(all="ignore"):
            found = np.broadcast_to(function(*drawn), PER_SEARCH)
        found = found[np.isfinite(found)]
        return bool(found.size and found.max() > SURE * np.abs(found).max())

    def below_zero(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive, as it stands."""
        own = squares(-expression, self.fixed)
        if vanishes(expression) or (own and own.constant.is_nonnegative):
            return True
        if interval(factored(expression))[1].is_nonpositive:
            return True
        return nonpositive(expression, expression.free_symbols - self.fixed, {})

    def readable_rate(self) -> sympy.Expr:
        """Return V' factored, or as a sum of squares, whichever is shorter, in signals."""
        rate = tidied(self.rate.xreplace(self.eq.values if self.valued else {}))
        own = squares(-rate, self.fixed)
        ways = [rate, factored(rate)]
        if own and not own.constant.free_symbols - self.fixed:
            ways.append(sympy.Add(*(-sympy.factor(term) for term in own.terms)) - own.constant)
        return min(self.shown(ways), key=sympy.count_ops)

    def where(self) -> str:
        """Return the one condition under which V' <= 0, or nothing."""
        if len(sympy.Add.make_args(tidied(self.rate))) > MOST_FACTORED:
            return ""
        try:
            parts = sympy.fraction(sympy.together(-tidied(self.rate)))
            factors = [one for part in parts for one in sympy.factor_list(part)[1]]
        except sympy.PolynomialError:
            return ""
        unknown = sympy.Mul(*(f for f, n in factors if n % 2 and not f.is_nonnegative))
        sign = sympy.factor(-tidied(self.rate) / unknown)
        unknown, sign = (-unknown, -sign) if sign.is_nonpositive else (unknown, sign)
        known = sign.is_nonnegative and unknown.free_symbols - self.fixed
        return f"{self.shown([unknown])[0]} >= 0" if known else ""

    def depends_on(self) -> list[str]:
        """Return the inputs that V' depends on."""
        rate = tidied(self.rate.xreplace(self.eq.values if self.valued else {}))
        return [str(f.func) for f in self.inputs if rate.has(f)]

    # --- states that V does not hold ------------------------------------------------------

    def beside(self, forms: list[sympy.Expr]) -> tuple[str, Step]:
        """Return what is to be said of states that V does not hold, and the step.

        A form in one state holds it; where each has several, the one that moves most simply is
        not held, and the forms hold the others beside it.
        """
        forms = [f.args[0] if isinstance(f, sympy.sin) else f for f in forms]  # up to whole turns
        left, at, free = list(self.states), dict[Any, Any](), list[Any]()
        while left:
            one = next(filter(None, (self.held_by(f.xreplace(at), left) for f in forms)), None)
            if one is not None:
                at |= one
                left = [s for s in left if s not in one]
            else:
                known = left + free
                free.append(min(left, key=partial(self.moves, among=known)))
                left.remove(free[-1])
        names = ", ".join(map(str, free))
        if not free:
            return "", exact("V holds every state", True)
        rates = sympy.Matrix([sympy.expand(self.eq.motion[s].xreplace(at)) for s in free])
        J = rates.jacobian(free)
        rest = (rates - J * sympy.Matrix(free)).subs(dict.fromkeys(rates.atoms(AppliedUndef), 0))
        own = J.xreplace(self.eq.values)
        if own.is_Matrix and not own.free_symbols and not rest.has(TIME, *free):
            poles = np.linalg.eigvals(np.array(own, dtype=float))
            if np.all(poles.real < 0):
                return "", exact(f"{names}: linear and stable, driven by what V holds", True)
        if all(degree(rate, free.__contains__) <= 1 for rate in rates):
            said = exact(f"{names}: not held by V, may grow, and exist for all t", True)
            return f"but for {names}", said
        faster = exact(f"{names}: not held by V, exist for all t", False, "not shown")
        return f"as long as {names} exist", faster

    def moves(self, s: Any, among: list[Any]) -> tuple[bool, float]:
        """Return how a state moves: whether its slope in itself varies, and its degree."""
        rate = self.eq.motion[s]
        varies = bool(sympy.diff(rate, s).free_symbols - self.fixed)
        return varies, degree(rate, among.__contains__)

    def held_by(self, form: sympy.Expr, left: list[Any]) -> dict[Any, sympy.Expr] | None:
        """Return the one state of these that a form holds, as an expression of the others."""
        own = [s for s in left if form.has(s)]
        if len(own) != 1 or not form.is_polynomial(*own):
            return None
        (s,), held = own, sympy.Dummy("held", real=True)
        a, *rest = sympy.Poly(form, s).all_coeffs()
        if vanishes(a) or a.free_symbols - self.fixed:
            return None
        if len(rest) > 1:  # of higher degree it holds s where nothing else in it moves freely
            return None if form.free_symbols & {*self.states} - {s} else {s: held}
        return {s: (held - rest[0]) / a}

    # --- points ---------------------------------------------------------------------------

    def numeric(self, expression: sympy.Expr) -> Callable[..., np.ndarray]:
        """Return an expression as a function of times, states and inputs, a column each."""
        function, symbols = numeric(expression.xreplace(self.eq.values))
        if unknown := set(symbols) - {TIME, *self.states, *self.inputs}:
            raise DiagramError(f"{unknown.pop()} has no number")

        def at(t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
            known = dict(zip([TIME, *self.states, *self.inputs], [t, *x, *u], strict=True))
            with np.errstate(all="ignore"):
                found = np.asarray(function(*(known[s] for s in symbols)), dtype=float)
            return np.broadcast_to(found, t.shape)

        return at

    @cached_property
    def place_of_rest(self) -> np.ndarray:
        """The rest as numbers, 0 where none is given."""
        given = self.rest or dict.fromkeys(self.states, sympy.Integer(0))
        return np.array([float(given[s].subs(self.eq.values)) for s in self.states])

    def draw(self, count: int, still: bool, size: Any = None) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero."""
        n, m, random = len(self.states), len(self.inputs), self.random
        wide = 10.0 ** random.uniform(-2.5, 2.0, (2, count)) if size is None else size
        x = random.standard_normal((n, count)) * wide[0] * (random.random((n, count)) > 0.15)
        u = random.standard_normal((m, count)) * wide[1] * (not still)
        if self.rest is not None:
            x += self.place_of_rest[:, None]
        late = 10.0 ** (3 * random.random(count) * (random.random(count) < 0.3))
        return random.uniform(0, 20, count) * late * (random.random(count) > 0.1), x, u

    def highest(self, expression: sympy.Expr, still: bool) -> Iterator[Point]:
        """Yield points at which an expression is positive, beside the size of its terms."""
        parts = sympy.Add.make_args(sympy.expand(expression))
        try:
            value, *sizes = map(self.numeric, (expression, *parts))
        except DiagramError:  # what has no numbers, such as a source of time
            return
        for _ in range(SEARCHES):
            check()
            at, near = self.draw(PER_SEARCH, still), 1.0
            for _ in range(ROUNDS):
                with np.errstate(all="ignore"):
                    found = value(*at) / sum(np.abs(size(*at)) for size in sizes)
                found = np.where(np.isfinite(found), found, -np.inf)
                best = np.argsort(-found)[:BEST]
                if found[best[0]] > SURE:
                    t, x, u = (one[..., best[0]] for one in at)
                    yield Point(float(t), np.array(x), np.array(u), {})
                    break
                keep, near = np.resize(best, PER_SEARCH), 0.7 * near
                at = tuple(self.beside_of(one[..., keep], near) for one in at)
                at = np.abs(at[0]), at[1], at[2] * (not still)

    def beside_of(self, values: np.ndarray, near: float) -> np.ndarray:
        """Return numbers beside these, the first as they are."""
        size = near * (np.abs(values) + 0.1 * np.max(np.abs(values), axis=0, initial=0.0) + 1e-3)
        step = size * self.random.standard_normal(values.shape)
        return values + step * (np.arange(values.shape[-1]) >= BEST)

    def running(self, points: int) -> Step:
        """Return the step that the running blocks give the same V', and V."""

        def same() -> tuple[bool, str]:
            seen, wanted, V = list[float](), self.numeric(self.rate), self.numeric(self.V)
            t, x, u = self.draw(points, False)
            for k, (right, held) in enumerate(zip(wanted(t, x, u), V(t, x, u), strict=True)):
                value, size = self.rate_at(Point(t[k], x[:, k], u[:, k], {}))
                off = [abs(value - right) / max(size, abs(right), 1e-300)]
                if self.name:
                    made = np.ravel(self.system.output(t[k], x[:, k], u[:, k]))
                    given = made[self.system.output_labels.index(self.name)]
                    off.append(abs(given - held) / max(abs(held), abs(given), 1e-300))
                seen += [max(off)] if np.all(np.isfinite(off)) else []
            said = f"{len(seen)} points, largest difference {max(seen, default=np.inf):.0e}"
            return len(seen) > points / 10 and max(seen) <= CLOSE, said

        return checked("the running blocks give the same V'", "sampled", same, False)

    @cached_property
    def slopes(self) -> list[Callable[..., np.ndarray]]:
        """dV/dt and dV/dx, as functions."""
        return [self.numeric(sympy.diff(self.V, s)) for s in (TIME, *self.states)]

    def rate_at(self, point: Point) -> tuple[float, float]:
        """Return V' along the rates that python-control gives, and the size of its terms."""
        rates = np.ravel(self.system.dynamics(point.t, point.x, point.u))
        terms = np.array([slope(*columns(point))[0] for slope in self.slopes]) * [1.0, *rates]
        return float(terms.sum()), float(np.abs(terms).sum())

    def rises_at(self) -> tuple[Point, float] | None:
        """Return a point at which the running blocks have V' > 0, and V' there."""
        rate = tidied(self.rate)
        for still in (True, False)[: 1 if self.depends_on() else 2]:
            for point in self.highest(rate, still):
                value, size = self.rate_at(point)
                if value > SURE * size:
                    return point, value
        return None

    def not_as_claimed(self) -> tuple[Point, float] | None:
        """Return a point at which V' of the running blocks is not as claimed, and V' there."""
        rest, claimed = tidied(self.rate - self.claim), self.numeric(self.claim)
        for point in chain(self.highest(rest, False), self.highest(-rest, False)):
            value, size = self.rate_at(point)
            right = claimed(*columns(point))[0]
            if abs(value - right) > SURE * max(size, abs(right)):
                return point, value
        return None

    def no_least(self) -> tuple[Point, float] | None:
        """Return a point of a ray along which V only falls below that of the rest."""
        V, zero = self.numeric(self.V), np.zeros(1)
        n, m = len(self.states), len(self.inputs)
        rest = self.place_of_rest
        least = V(zero, rest[:, None], np.zeros((m, 1)))[0] if self.rest is not None else 0.0
        scales = (1.0, 0.1, 0.01) if self.rest is not None else (1.0, 10.0, 100.0, 1000.0)
        for _ in range(SEARCHES):
            ways = self.random.standard_normal((n, PER_SEARCH)) * 0.5
            u, t = np.zeros((m, PER_SEARCH)), np.zeros(PER_SEARCH)
            values = np.array([V(t, rest[:, None] + k * ways, u) - least for k in scales])
            falls = np.all(values < 0, axis=0) & np.all(np.isfinite(values), axis=0)
            if self.rest is None:
                falls &= np.all(np.diff(values, axis=0) < 0, axis=0)
            for k in np.flatnonzero(falls)[:1]:
                return Point(0.0, rest + ways[:, k], u[:, k], {}), float(values[0, k])
        return None

    # --- the verdict ----------------------------------------------------------------------

    def judged(self, points: int) -> Lyapunov:
        """Put the answers together."""
        eq = self.eq
        (V,) = self.shown([self.V])
        said = eq.undefined or missing(self.V)
        valued = exact("V and the equations have a value everywhere", not said, "".join(said[:1]))
        definite, forms = self.held()
        steps, where, zero = [valued, definite], "", {}
        identity = True
        if self.claim is not None:
            rest = tidied(self.rate - self.claim)
            identity = vanishes(rest)
            if not identity and vanishes(tidied(rest.xreplace(eq.values))):
                identity = self.valued = True
            left = "" if identity else f"left over: {short(rest)}"
            (wanted,) = self.shown([self.claim])
            steps.append(exact(f"V' = {short(wanted)}", identity, left))
        falls = self.never_positive(self.rate)
        inputs = self.depends_on()
        if not falls and inputs:
            zero = {f: sympy.Integer(0) for f in self.inputs if str(f.func) in inputs}
            zero |= {sympy.Derivative(f, TIME): sympy.Integer(0) for f in zero}
            zero = zero if self.never_positive(self.rate.xreplace(zero)) else {}
        rate = self.readable_rate()
        at = f" where {' = '.join(inputs)} = 0" if zero else ""
        steps.append(exact(f"V' = {short(rate)} <= 0{at}", falls or bool(zero)))

        def made(status: str, claim: str, **more: Any) -> Lyapunov:
            return Lyapunov(status, claim, V, rate, where, tuple(inputs), tuple(steps), **more)

        tried = [] if falls or zero else [("V' > 0", self.rises_at)]
        tried += [] if identity else [("V' is not as claimed", self.not_as_claimed)]
        tried += [] if definite.holds else [("V is below its value at rest", self.no_least)]
        for fails, look in tried:
            found = look()
            steps.append(
                Step(f"{fails} at a point", found is not None, "counterexample", "", False)
            )
            if found is not None:
                where = self.where() if fails == "V' > 0" else ""
                only = f"; V' <= 0 where {where}" if where else ""
                claim = f"V' = {short(rate)}; {fails}: {found[1]:.3g} at `point`{only}"
                return made("refuted", claim, point=found[0], value=found[1])
        if not all(step.holds for step in steps):
            return made("open", f"V' = {short(rate)}; {first_failure(steps)}")
        apart, beside = self.beside(forms) if forms else ("", NEAR)
        steps += [self.running(points), beside]
        jump, rise = self.across_jumps()
        steps += [jump] if eq.jumps else []
        if rise is not None:
            return made("refuted at a jump", jump.claim, point=rise[0], value=rise[1])
        if not steps[len(steps) - 2 - bool(eq.jumps)].holds:
            return made("open", first_failure(steps))
        status = " ".join(
            filter(None, ["proved" + at, apart, "" if jump.holds else "between jumps"])
        )
        own = ", with the parameters as they are" if self.valued or eq.pinned else ""
        return made(status, f"V' = {short(rate)} <= 0{at}{own}; {definite.claim}")

    def across_jumps(self) -> tuple[Step, tuple[Point, float] | None]:
        """Return the step that V rises at no jump, and a point at which it does."""
        claim = f"V does not rise where states of {' and '.join(self.eq.jumps)} jump"
        for after in self.eq.jumps_at_once():
            rise = tidied(self.V.xreplace(after) - self.V)
            if not self.never_positive(rise):
                point = next(self.highest(rise, True), None)
                if point is None:
                    return exact(claim, False, "not shown"), None
                value = float(self.numeric(rise)(*columns(point))[0])
                return exact(f"V rises by {value:.3g} at a jump", False), (point, value)
        return exact(claim, True), None


def factored(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression factored, or as it is where that takes long."""
    long = len(sympy.Add.make_args(expression)) > MOST_FACTORED
    return expression if long else sympy.factor(expression)


def columns(point: Point) -> tuple:
    """Return one point as columns of times, states and inputs."""
    return np.array([point.t]), point.x[:, None], point.u[:, None]


NEAR = exact("V holds every state near the rest", True)


def missing(V: sympy.Expr) -> list[str]:
    """Return where V may have no value, in sentences."""
    found = []
    for one in sympy.preorder_traversal(V):
        if one.is_Pow and not (one.exp.is_Integer and one.exp.is_nonnegative):
            below = one.exp.is_Integer or one.exp.could_extract_minus_sign()
            found += [undefined("div", (1, one.base)) if below else undefined("pow", one.args)]
        elif isinstance(one, sympy.log | sympy.tan | sympy.asin | sympy.acos | sympy.atanh):
            found.append(undefined(type(one).__name__, one.args))
    return [f"V {one}" for one in found if one]


@public
def lyapunov(
    system: control.NonlinearIOSystem,
    V: str | Callable | sympy.Expr,
    claim: str | Callable | sympy.Expr | float | None = None,
    at: Mapping[str, float] | Sequence[float] | None = None,
    points: int = 200,
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
    >>> import clpt_control as clpt
    >>> def swing(t, x, u, p):
    ...     return {"theta": x.omega, "omega": -p.g * np.sin(x.theta) - p.b * x.omega}
    >>> pendulum = clpt.Block("rod", update=swing, states={"theta": 1, "omega": 1},
    ...                       parameters={"g": 9.8, "b": 0.1})
    >>> energy = lambda s: s.omega**2 / 2 + s.g * (1 - np.cos(s.theta))
    >>> clpt.theory.lyapunov(pendulum, energy).rate
    -b*omega**2
    """
    return _Case(system, V, claim, at, seed).judged(points)
