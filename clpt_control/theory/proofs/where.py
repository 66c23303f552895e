"""Sets of states and bounds of inputs, given by `where=`; V' at the corners of a box of inputs.

V' that is affine in each input d, low <= d <= high, is a mean of its values at the corners:

    V' = sum of share V'(corner),    shares >= 0 with the sum 1

and at most that if it is convex.  So a bound of V' at each corner is one for every d(t) within the
bounds.  Sines, cosines, tanh and e^(-c t) are between numbers, as inputs are.
"""

from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from math import isinf, pi
from types import MappingProxyType
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, Mul, Rational, S, Symbol, exp, expand, oo

from ...base.arguments import check_known, finite
from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import rational
from ..algebra.facts import CLIP, RANGED, Sector, corners, interval
from ..algebra.texts import DIGITS, LARGEST, double
from .signal_functions import undefined_in
from .statements import Statement, joined, said

NOTHING = MappingProxyType[Any, Any]({})
MOST_TURNS = 360  # pi/360 is a share of pi
MOST_CORNERS = 64
ABOVE = 1e-6  # least value of a state above 0, at points
MOST = sympy.Integer(10) ** 100  # size of a bound


def rest_of(states: Sequence[Any], values: Mapping[str, float]) -> dict[Any, Expr]:
    """Return each state's value at a rest, a share of pi where a number is that."""
    rest_state = dict.fromkeys(states, S.Zero)
    names = {str(s): s for s in states}
    check_known("at", values, names)
    for name, value in values.items():
        finite(f"at: {name}", value)
        turns, number = (rational(float(value) / unit) for unit in (pi, 1))
        rest_state[names[name]] = turns * sympy.pi if turns.q <= MOST_TURNS else number
    return rest_state


def check_where(
    where: Container[str], names: Iterable[Any], what: str, cure: str
) -> None:
    """Refuse bounds of what has none."""
    for s in names:
        if str(s) in where:
            raise DiagramError(f"where: {s} {what}. {cure}")


class Where:
    """Sets that states do not leave, and bounds of inputs."""

    def __init__(
        self,
        given: Mapping[str, Sequence[float | None]] = NOTHING,
        states: Sequence[Any] = (),
        inputs: Sequence[Any] = (),
        V: Expr = S.Zero,
    ):
        self.kept = dict[Any, tuple]()  # state -> the ends of its set
        self.inside = dict[Any, Expr]()  # state -> what cannot leave its set
        self.squared = dict[Any, Expr]()  # state -> an end, and the square of a root
        self.roots = dict[
            Any, Expr
        ]()  # root -> the distance from an end, never negative
        self.box = dict[Any, tuple]()  # input -> its bounds
        self.values = dict[Any, Expr]()  # input -> its one value
        names = {f"{s}": s for s in states} | {f"{f.func}": f for f in inputs}
        check_known("where", given, names)
        for name, numbers in given.items():
            s = names[name]
            ends = [
                no_end if end is None or isinf(end) else rational(float(end))
                for end, no_end in zip(numbers, (-oo, oo), strict=False)
            ]
            finite = [end for end in ends if end.is_finite]
            is_input = s in inputs
            if is_input and V.has(s):
                raise DiagramError(
                    f"where: V depends on input {name}. Give a V of states"
                )
            is_set = len(numbers) == 2 and finite == sorted(finite)
            # squares of bounds are numbers
            sized = [end for end in finite if end == 0 or 1 / MOST <= abs(end) <= MOST]
            if not is_set or (is_input and not (finite == sized != [])):
                raise DiagramError(
                    f"where: the bounds of {name} are {tuple(numbers)}. Give two numbers, the "
                    "lower first, or None for one; of an input 0 or between 1e-100 and 1e100"
                )
            low, high = ends
            if is_input and low == high:
                self.values[s] = low
            elif is_input:
                self.box[s] = low, high
            else:
                self.kept[s] = low, high
                for end, sign in ((low, 1), (high, -1)):
                    if end.is_finite:
                        root = Dummy(name, real=True)
                        self.roots[root] = sign * (s - end)
                        self.squared.setdefault(s, end + sign * root**2)
            if not s.is_positive:
                self.inside[s] = _within(low, high)

    @property
    def above(self) -> list:
        """States that stay above 0, as their symbols are."""
        return [s for s in self.kept if s.is_positive]

    @property
    def ends(self) -> dict[Any, tuple]:
        """States and inputs with their ends, at points with a number above 0."""
        values = {d: (value, value) for d, value in self.values.items()}
        above = {s: (ABOVE, self.kept[s][1]) for s in self.above}
        return self.kept | above | self.box | values

    @property
    def bounded(self) -> list:
        """Inputs that have two bounds."""
        return [
            *self.values,
            *(d for d, (low, high) in self.box.items() if high - low < oo),
        ]

    def in_states(self, forms: Sequence[Expr]) -> list[Expr]:
        """Return forms without roots, and squares of products with them; [] for other forms."""
        of = {root: sympy.sqrt(distance) for root, distance in self.roots.items()}
        if any(f.is_Add and f.has(*of) for f in forms):
            return []
        return [f.xreplace(of) ** (2 if f.has(*of) else 1) for f in forms]

    def undefined(self, owner: str, kind: str, arguments: tuple) -> str | None:
        """Return where an operation has no value within the sets and the bounds."""
        given = map(sympy.sympify, arguments)
        inside = tuple(
            _within(*range_in(a, self.box))
            if a.has(*self.box) and self.is_of_inputs(a)
            else a.xreplace(self.inside)
            for a in given
        )
        return undefined_in(owner, kind, inside) and undefined_in(
            owner, kind, arguments
        )

    @property
    def sets(self) -> Statement:
        """The sets that states do not leave."""
        distances = ((e, ">" if e.is_positive else ">=") for e in self.roots.values())
        return joined(", ", (said("{} {} 0", *pair) for pair in distances))

    @property
    def bounds(self) -> Statement:
        """The bounds of inputs."""
        parts = [("", d, f" = {double(value)}") for d, value in self.values.items()]
        for d, (low, high) in self.box.items():
            least = f"{double(low)} <= " * (low != -oo)
            parts.append((least, d, f" <= {double(high)}" * (high != oo)))
        named = ((least, Symbol(f"{d.func}"), most) for least, d, most in parts)
        return joined(", ", (said("{}{}{}", *of_input) for of_input in named))

    def corners(self, rate: Expr, waves: bool = False) -> list[tuple]:
        """Return factors of the share of each corner of the box of inputs, and the rate there.

        There are none of too many inputs, or unless the rate is convex in each, or in its square:
        it is at most the mean of the rates at the corners, and that mean if it is affine.  Waves in
        the rate may be taken as inputs.
        """
        expanded, functions = expand(rate), list[Expr]()
        if waves and self.box:
            slopes = ((e, e.args[0] / TIME) for e in rate.atoms(exp))
            functions += rate.atoms(*RANGED)
            functions += (e for e, c in slopes if c.is_Rational and c.is_negative)
        for d in self.box:
            is_even = not expanded.xreplace({d**2: S.One}).has(d)
            functions.append(d**2 if is_even else d)
        names = {f: Dummy(real=True) for f in functions if expanded.has(f)}
        as_inputs = self.at_corners(expanded.xreplace(names), names)
        # a function of an input without an end may come near its own end, and not to it
        is_open = {*self.box} - {*self.bounded}
        if as_inputs or (is_open and not waves):
            return as_inputs
        return self.at_corners(*self.in_functions(expanded))

    def in_functions(self, expanded: Expr) -> tuple[Expr, dict]:
        """Return a rate with a symbol for each function of inputs, and these.

        Terms with the same states have one function, as 4 d - 4 d^2 of 4 d x - 4 d^2 x.
        """
        weights, functions = dict[Expr, Expr](), dict[Expr, Any]()
        for term in Add.make_args(expanded):
            own = Mul(*filter(self.is_of_inputs, Mul.make_args(term)))
            weights[term / own] = weights.get(term / own, S.Zero) + own
        for rest, weight in weights.items():
            number, function = weight.primitive()
            if not function.is_number:
                weights[rest] = number * functions.setdefault(
                    function, Dummy(real=True)
                )
        return Add(*(rest * weight for rest, weight in weights.items())), functions

    def at_corners(self, rate: Expr, names: Mapping[Any, Any]) -> list[tuple]:
        """Return a rate where the symbols of functions are at their ends, as `corners` does."""
        ends = {f: range_in(f, self.box) for f in names}
        is_open = any(high - low == oo for low, high in ends.values())
        if rate.has(*self.box) or is_open or 2 ** len(names) > MOST_CORNERS:
            return []

        def share(f: Expr, end: Expr) -> Expr:
            other = Add(*ends[f]) - end
            return expand((f - other) / (end - other))

        sectors = {s: Sector(S.One, *ends[f]) for f, s in names.items()}
        found = corners(rate, sectors).items()
        return [(tuple(map(share, names, chosen)), at) for chosen, at in found]

    def is_of_inputs(self, e: Expr) -> bool:
        """Return whether an expression holds inputs with bounds, and nothing else."""
        values = e.xreplace(dict.fromkeys(self.box, S.Half))
        return e.is_number or not values.free_symbols

    def largest(
        self, rate: Expr, never_positive: Callable[[Expr], bool]
    ) -> Expr | None:
        """Return V' at the corner where it is largest for all states, if there is one."""
        rates = [at for _, at in self.corners(rate)] if self.box else []
        largest = (e for e in rates if all(never_positive(o - e) for o in rates))
        return next(largest, None)


def range_in(function: Expr, box: Mapping[Any, tuple]) -> tuple:
    """Return numbers between which a function of inputs is; sharp ones of a fraction of one."""
    if function in box:
        return box[function]
    inputs = [d for d in box if function.has(d)]
    of_one = len(inputs) == 1
    found = _range_of_fraction(function, inputs[0], box) if of_one else None
    if found is None:
        parts = {a: _within(*range_in(a, box)) for a in function.args if a.has(*inputs)}
        found = interval(function.xreplace(parts))
    return _rounded(found[0], -1), _rounded(found[1], 1)


def _rounded(end: Expr, side: int) -> Expr:
    """Return a rational number beyond an end, or the end if it is one."""
    if end.is_Rational or end.is_infinite:
        return end
    number = Rational(f"{end.n(DIGITS)}")
    return number + side * abs(number) / LARGEST


def _range_of_fraction(
    function: Expr, d: Any, box: Mapping[Any, tuple]
) -> tuple | None:
    """Return the least and the largest value of a fraction of an input, if that is one."""
    (low, high), s = box[d], Dummy(real=True)
    of_s = function.xreplace({d: s})
    if high - low == oo or not of_s.is_rational_function(s):
        return None
    over, under = (sympy.Poly(e, s) for e in of_s.diff(s).together().as_numer_denom())
    below = interval(under.as_expr().xreplace({s: _within(low, high)}))[0]
    if not (below.is_positive and all(c.is_Rational for c in over.all_coeffs())):
        return None
    turns = [] if over.is_ground else [r for r in over.real_roots() if low < r < high]
    values = [of_s.xreplace({s: at}) for at in (low, high, *turns)]
    return sympy.Min(*values), sympy.Max(*values)


def _within(low: Expr, high: Expr) -> Expr:
    """Return any number between two ends."""
    share = Dummy(nonnegative=True)
    if -low == high == oo:
        return Dummy(real=True)
    if -low == oo:
        return high - share
    return low + (share if high == oo else CLIP(share, 0, 1) * (high - low))
