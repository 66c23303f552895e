"""A user's V on a diagram: the signs of V', the forms that V' loses, and points that refute V.

    V' = dV/dt + sum_i (dV/dx_i) f_i(t, x, u)

The equations are those that run; parameters are symbols of the signs that they have, or their
numbers where that shows more.  In discrete time V' stands for V(x+) - V(x).
"""

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import replace
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np
import sympy
from sympy import Add, Dummy, Expr, S, Symbol, expand

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME, Names, NamesWithNumbers, element_name
from ...engine.diagram.symbolic_equations import Equations, on_symbols
from ...engine.diagram.wiring import wiring_of
from ...engine.record.symbolic import rational
from ..algebra.decide import (
    in_one_piece,
    never_positive,
    without_choices,
    without_fading,
)
from ..algebra.decided import decided
from ..algebra.exact import (
    as_factors,
    divides_by_sum,
    factored,
    normal_form,
    terms_of,
    too_small,
    vanishes,
    without_rounding,
)
from ..algebra.facts import has_time, is_continuous
from ..algebra.slopes import along, meets_smoothly, slope_in
from ..algebra.sums_of_squares import squares
from ..algebra.texts import double
from .answers import Definite, Fall, Refutation
from .between import as_relation, assume
from .conclusions import Condition, Status
from .judge import LyapunovCandidate, Verdict, asked
from .losses import decay_and_end, excess_over, forms_lost, lost_slowly
from .point_search import Failure, PointSearch
from .pushed_claims import mean_of
from .rate_as_sum import Ways, of_system
from .relations import Relations, divides, errors_of, forks, written
from .same_as_running import compare
from .signal_functions import expression_of, undefined_in
from .statements import Statement, joined, said
from .steps import Step, checked, exact
from .symbolic_loop import place_of, refuse_no_rates
from .ultimate_bounds import bound_of_V
from .where import NOTHING, Where, check_where, rest_of

MOST_IN_PRODUCT = 1000  # terms of a fraction that is factored


class SystemCandidate(LyapunovCandidate):
    """A diagram with a V of the user, as `lyapunov` reads it.

    In: the diagram, V, and what else the user gives.  Parameters are symbols, or numbers but for
    `symbols`; `unsigned` ones may be any real number; each of `margins` is positive.
    """

    sizes = ""  # numbers of functions for which V' is as shown: N = 2
    disturbances: Sequence[Any] = ()  # inputs with a bound, which has their name
    KD: Mapping[Any, Any] = NOTHING  # e of a law -> its gain
    are_numbers = False  # whether the verdict is of the parameters' values
    is_rounded = False  # whether terms of V, V' or rates are left out as rounding

    def __init__(
        self,
        system: Any,
        V: Any,
        claim: Any,
        rest: Mapping[str, float] | None,
        points: int = 1,
        seed: int = 0,
        numbers: bool = False,
        where: Mapping[str, Sequence[float | None]] = NOTHING,
        unsigned: Set[str] = frozenset(),
        symbols: Set[str] = frozenset(),
        margins: Sequence[Expr] = (),
        keeps: Callable | None = None,
        above: Set[str] = frozenset(),
        is_pushed: bool = False,
    ):
        self.system, self.points, self.seed = system, points, seed
        self.is_pushed = is_pushed  # whether inputs that raise V are judged, not zero
        self.chosen = {"unsigned": unsigned, "symbols": symbols, "above": above}
        names = NamesWithNumbers if numbers else Names
        self.eq = self._equations(names)
        self.fixed = {*self.eq.values}
        written = self._equations(Names) if numbers else self.eq
        self.parameters = {
            s: n for s, n in written.values.items() if f"{s}" not in symbols
        }
        given = self.parameters.items() if numbers else ()
        values = {s: rational(float(number)) for s, number in given}
        rates = self.eq.motion.items()
        self.motion = {
            s: self._as_it_runs(rate, written.motion[s], values) for s, rate in rates
        }
        refuse_no_rates(self.eq, self.motion)
        self.states = [*self.motion]
        self.inputs = [s for port in self.eq.inputs.values() for s in port.flat]
        labels = {V, f"{V}[0]"} if isinstance(V, str) else set()
        outputs = system.output_labels
        self.output = next((name for name in outputs if name in labels), "")
        self.claim = (
            None if claim is None else expression_of(self.eq, claim, "claim")[0]
        )
        V_of_states, undefined = expression_of(self.eq, V)
        written_V = expression_of(written, V)[0] if numbers else V_of_states
        self.V = self._as_it_runs(V_of_states, written_V, values)
        undefined += self._leave_out(keeps)
        self.undefined = [*self.eq.undefined, *undefined]
        self.given: dict[Any, Expr] = {}  # margin -> what it stands for
        self.level_values = self.eq.values
        self.are_numbers |= bool(self.eq.pinned or (numbers and self.eq.fields))
        relation = f"is given by a relation, {self.relations.text!s}"
        check_where(
            where, self.relations.solved, relation, "Give bounds of other states"
        )
        check_where(where, self.parameters, "is a parameter", "Make it an input")
        if self.V.is_number and self.V:
            raise DiagramError(
                f"{system.name}: V = {self.V}: has no state. Give one: lambda s: s.x**2"
            )
        self.where = Where(where, self.states, self.inputs, self.V)
        if where and self.eq.undefined:
            limited = self._equations(names, self.where.undefined)
            self.undefined = [*limited.undefined, *undefined]
        self.write(lambda e: e.xreplace(self.where.values))
        self.margins = list[Expr]()  # conditions between parameters
        for margin in margins:
            assume(self, margin)
        self.rate = self._rate_of_V()
        self.readable: dict[Any, Expr] = {}  # V' -> V' in the user's signals
        self.rest = None if rest is None else rest_of(self.states, rest)
        # where V is to be least, as text
        self.place = place_of(self.eq, self.rest) if self.rest else ""

    def _leave_out(self, keeps: Callable | None) -> list[str]:
        """Leave out the states that relations give; return where these may have no value."""
        self.relations, self.whole_V = Relations(self.eq, self.motion), self.V
        without_value = self.relations.read(keeps) if keeps else []
        solved = self.relations.solved
        self.motion = {s: r for s, r in self.motion.items() if s not in solved}
        self.write(self.relations.of)
        self.is_whole = not solved
        self.eq, self.states = self.relations.reduced(), [*self.motion]
        return without_value

    def write(self, as_it_is: Callable[[Expr], Expr]) -> None:
        """Write V, the claim and the rates of states in another way."""
        self.motion = {s: as_it_is(rate) for s, rate in self.motion.items()}
        self.V, self.claim = as_it_is(self.V), self.claim and as_it_is(self.claim)

    def kept(self, definite: Definite, fall: Fall) -> list[Step]:
        """Return the steps that the relations and the sets of states are kept."""
        motion = self.moving(definite, fall.zeroed)
        steps = self.relations.steps(self.never_positive, motion)
        self.driving = motion.driving - fall.zeroed.keys()
        by_V = definite.off_zero if fall.holds else frozenset()
        are_kept = all(self._keeps(end, by_V) for end in self.where.roots.values())
        return (
            steps if are_kept else [exact(said("{} is kept", self.where.sets), False)]
        )

    def _equations(self, names: type[Names], watch: Any = undefined_in) -> Equations:
        """Return the equations of the diagram, parameters named as asked."""
        named = type("Chosen", (names,), self.chosen)
        return on_symbols(self.system, named, watch=watch, with_samples=True)

    def _as_it_runs(self, e: Expr, written: Expr, values: dict[Any, Any]) -> Expr:
        """Return an expression without terms that are zero to rounding, or too small to run.

        It is `written` with parameters as symbols: of their numbers, `values`, SymPy leaves no
        sums.
        """
        e, written = decided(e), decided(written)
        small = {} if values else too_small(written, self.eq.values)
        self.are_numbers |= bool(small)
        rounded = without_rounding(written.xreplace(small), values)
        of_numbers = rounded.xreplace(values)
        if rounded == written or vanishes(of_numbers - e):
            return e
        self.is_rounded = True
        return of_numbers

    def _keeps(self, margin: Expr, by_V: Set[Any] = frozenset()) -> bool:
        """Return whether a margin of a state stays above 0, by its rate there and at jumps.

        States that V, or their rates, keep away from 0 are given as `by_V`.
        """
        (s,) = margin.free_symbols
        rate, jumps, is_open = self.motion[s], self.eq.jumps.values(), s.is_positive
        nexts = [{s: rate}] if self.eq.discrete else jumps
        after = [margin.xreplace(change) for change in nexts]
        if not all(
            e.is_positive if is_open else self.never_positive(-e) for e in after
        ):
            return False
        # states above 0 stay there by a rate that is Lipschitz at 0 too
        closed = {a: Dummy(nonnegative=True) for a in self.where.above}
        at_0, slope = rate.xreplace(closed), sympy.diff(margin, s)
        at_end = (slope * rate).xreplace({s: s - margin / slope})
        is_lipschitz = not (forks(at_0, self.fixed) or (closed and divides(at_0)))
        return (
            self.eq.discrete
            or margin in by_V
            or (is_lipschitz and self.never_positive(-at_end))
        )

    def kept_signs(self) -> dict[str, tuple]:
        """Return states of V', but not of V, that stay at 0 or above if they begin so."""
        states = [s for s in self.states if self.rate.has(s) and not self.V.has(s)]
        return {str(s): (0, None) for s in states if self._keeps(s)}

    def _rate_of_V(self) -> Expr:
        """Return V', or in discrete time by how much V changes from one time to the next."""
        if self.eq.discrete:
            if self.V.has(TIME, *self.inputs):
                raise DiagramError(
                    f"{self.system.name}: is of discrete time; give a V of its states alone"
                )
            exact_rate = self.V.xreplace(dict(self.motion)) - self.V
        else:
            exact_rate = along(self.V, {TIME: sympy.Integer(1), **self.motion})
        rate = without_rounding(exact_rate)
        self.is_rounded |= rate != exact_rate
        if self.eq.discrete:
            return rate
        is_smooth = meets_smoothly(self.V) and all(
            map(is_continuous, self.motion.values())
        )
        return (is_smooth and in_one_piece(rate)) or rate

    @cached_property
    def errors(self) -> Any:
        """States in errors of V, and what these are."""
        total = squares(self.V, self.fixed)
        return errors_of(self, total.forms if total else ())

    def depends_on(self, rate: Expr) -> list[str]:
        """Return the inputs that V' depends on."""
        rate = normal_form(rate)
        return [str(f.func) for f in self.inputs if rate.has(f)]

    @property
    def origin(self) -> Mapping[Any, Expr]:
        """The rest, or 0 for each state."""
        return self.rest or dict.fromkeys(self.states, S.Zero)

    @cached_property
    def search(self) -> PointSearch:
        """Random points about the rest."""
        return PointSearch(
            self.system,
            self.eq,
            self.whole_V,
            self.output,
            self.origin,
            self.seed,
            self.where.ends,
            self.relations.solved,
        )

    def same_as_running(self, restrict: Callable[[tuple], tuple] = tuple, /) -> Step:
        """Return the step that the running blocks have the same V and rates at random points."""
        return checked(
            "the running blocks give the same V'",
            lambda: compare(
                self.search, restrict(self.search.wide(self.points)), self.points
            ),
            "sampled",
            False,
            "running",
        )

    # --- in the user's signals ------------------------------------------------------------------

    @cached_property
    def sums(self) -> Mapping[Expr, Expr]:
        """Each signal that is a sum: the sum -> its symbol."""
        names: dict[Expr, Expr] = {}
        for port, symbols in self.eq.signals.items():
            for index, value in np.ndenumerate(symbols):
                total = expand(value)
                if total.is_Add and port != "V":
                    name = element_name(port, symbols.shape, index)
                    symbol = Symbol(name, real=True)
                    names |= {total: symbol, expand(-total): -symbol}
        return names

    def in_signals(self, e: Expr) -> Expr:
        """Return an expression in the diagram's own signals, each signal in place of its sum."""
        return e.xreplace(self.given).replace(
            lambda term: term.is_Add, lambda term: self.sums.get(expand(term), term)
        )

    def text(self, expression: Expr) -> Statement:
        """Return an expression in the diagram's own signals."""
        return said("{}", self.in_signals(expression))

    def with_rate(self, claim: str) -> str:
        """Return V' and a claim in a line."""
        return said("V' = {}; {}", self.readable_rate(self.rate), claim)

    def readable_rate(self, rate: Expr) -> Expr:
        """Return V' factored, or as a sum of squares, whichever is shorter, in signals."""
        if rate not in self.readable:
            forms = map(self.in_signals, written(self, rate.xreplace(self.given)))
            self.readable[rate] = min(forms, key=sympy.count_ops)
        return self.readable[rate]

    # --- points at which it fails --------------------------------------------------------------

    def refuted(
        self, definite: Definite, fall: Fall
    ) -> tuple[Refutation | None, list[Step]]:
        """Return a point at which V' > 0, or above what is claimed, or V is no least value."""
        searches = list[Step]()
        if self.relations.broken():
            return None, searches
        below = (
            f"V is below its value at {self.place}"
            if self.place
            else "V falls without end"
        )
        over = "V' > 0" if self.claim is None else "V' is above the claim"
        for fails, find, holds in (
            (over, self._rises, fall.steps[0].holds),
            (below, self._no_least, definite.step.holds),
        ):
            if holds:
                continue
            failure = find()
            found = failure is not None
            claim = f"{fails} at a point"
            step = Step(claim, found, "counterexample", "", False, needed=found)
            if failure is not None:
                claim = self.with_rate(f"{fails}: {failure[1]:.3g} at `point`")
                return Refutation(claim, step, *failure), searches
            searches.append(step)
        return None, searches

    def refuted_by_inputs(self) -> Refutation | None:
        """Return a point at which inputs raise V, however far from the rest."""
        failure = self.search.rises_far_off(self.rate)
        if failure is None:
            return None
        names = [*map(Symbol, self.depends_on(self.rate))]
        raises = said("V rises however large it is, by {}", joined(", ", names))
        step = Step(raises, True, "counterexample")
        claim = f"V' > 0: {failure[1]:.3g} at `point`, and 10 and 100 times as far off"
        claim = said("{}; where {} = 0 V' <= 0", claim, joined(" = ", names))
        return Refutation(claim, step, *failure)

    def refuted_at_jump(self, rise: Expr) -> Refutation | None:
        """Return a point at which V rises at a jump, if jumps do not depend on time."""
        # it jumps at few times, and points have inputs of any size
        if rise.has(TIME, *self.intervals, *self.where.box):
            return None
        failure = self.search.sign_at(rise, 1)
        if failure is None:
            return None
        claim = f"V rises by {failure[1]:.3g} at a jump"
        return Refutation(claim, exact(claim, False), *failure)

    def _rises(self) -> Failure | None:
        """Return a point at which V' is above 0, or above the claim."""
        rate, zero = normal_form(self.rate), S.Zero
        if rate.has(*self.where.box):  # points have inputs of any size
            return None
        if self.claim is not None:
            return self.search.rate_above(rate, self.claim, still=False)
        still = self.search.rate_above(rate, zero, still=True)
        if still is not None:
            return still
        if self.depends_on(rate):
            return self.search.rises_far_off(self.rate)
        return self.search.rate_above(rate, zero, still=False)

    def _no_least(self) -> Failure | None:
        """Return a point at which V is below its value at the rest, or falls without end."""
        return self.search.below_rest(self.V, self.states, self.rest)

    # --- the questions --------------------------------------------------------------------------

    def falls(self, definite: Definite) -> Fall:
        """Return what is shown of V' <= 0, where inputs that it depends on are 0 if need be."""
        steps, bound = list[Step](), self.rate
        claim = said("V' = {}", self.readable_rate(self.rate))
        if self.claim is not None:
            bound, claim = self.claim, said("V' <= {}", self.text(self.claim))
            holds = self.never_positive(excess := excess_over(self.rate, bound))
            detail = "" if holds else said("left over: {}", excess)
            steps.append(exact(claim, holds, detail, "claimed"))
            if not holds:
                return Fall(steps, claim)
        most = self.where.largest(bound, self.never_positive)
        if most is not None:
            bound, claim = most, said("V' <= {}", self.text(factored(most)))
        inputs = [] if self.where.box else self.depends_on(bound)
        zeroed = dict[Any, Any]()
        falling = self.falling(bound)
        if falling is None and inputs and not self.is_pushed:
            zeroed = {f: S.Zero for f in self.inputs if str(f.func) in inputs}
            zeroed |= {sympy.Derivative(f, TIME): S.Zero for f in zeroed}
            still = bound.xreplace(zeroed)
            if not vanishes(still) and self.never_positive(still):
                before = said("V' =")
                if self.claim is not None:
                    before = said("{} as claimed, V' <=", claim)
                falling = still
                claim = said("{} {}", before, self.readable_rate(still))
        if falling is None:
            return Fall([*steps, exact("V' <= 0", False)], claim)
        where = joined(" = ", map(Symbol, inputs if zeroed else ()))
        where = where and said(" where {} = 0", where)
        bound = falling.xreplace(zeroed)
        form, states = normal_form(bound), {*self.states}
        lower = without_choices(form, states)
        if lower is None:
            lower = without_fading(form, states) or form
        if lower != form:
            bound, claim = lower, said("V' <= {}", self.text(factored(lower)))
        motion = self.moving(definite, zeroed)
        motion.outside()
        bounded = {s for s in self.states if not motion.not_bounded(s)}
        bounded -= {*self.where.above} - definite.off_zero  # which may come near 0
        losses = forms_lost(self, bound, bounded)
        if not claim.endswith("= 0"):
            claim = said("{} <= 0", claim)
        decay, time = decay_and_end(self, bound)
        if time is not None:
            claim = said("{}, V is 0 after the time {}", claim, time)
        shows = "falls" + " loses" * bool(losses) + " rest" * (time is not None)
        shows += " decays" * (decay is not None)
        steps.append(exact(said("{}{}", claim, where), True, "", shows))
        return Fall(
            steps,
            claim,
            losses,
            self.text(-self.readable_rate(bound)),
            slow=[] if losses else lost_slowly(self, bound),
            zeroed=zeroed,
            rate=falling if self.claim is None and most is None else None,
            conditions=self.conditions(inputs if zeroed else []),
            decay=decay,
        )

    def bounds(self, definite: Definite, fall: Fall) -> Fall:
        """Return the bound of a V' that pulls V back but for a constant."""
        *claimed, _ = fall.steps
        if self.claim is not None and not claimed:
            return fall
        bound = bound_of_V(self, definite) or mean_of(self, definite)
        conditions = self.conditions([])
        if bound is None:
            return replace(fall, steps=claimed or fall.steps, conditions=conditions)
        both_claims = joined(", and ", [fall.claim] * bool(claimed) + [bound.claim])
        conditions = [*bound.conditions, *conditions]
        steps = [*claimed, *bound.steps]
        return replace(bound, steps=steps, claim=both_claims, conditions=conditions)

    def conditions(self, zeroed: list[str]) -> list[Condition]:
        """Return where V' is as shown."""
        nodes = wiring_of(self.system).nodes
        stand_ins = [*filter(None, (node.system.approximation for node in nodes))]
        # inputs within bounds are not taken as zero
        rate = self.rate.xreplace(dict.fromkeys(self.where.box, Dummy()))
        texts = (
            ("zero inputs", joined(" = ", map(Symbol, zeroed))),
            ("approximation", ", ".join(stand_ins)),
            ("between", joined(", ", map(as_relation, self.margins))),
            ("start", self.where.sets),
            ("input bounds", self.where.bounds),
            ("start", self.relations.text),
        )
        conditions = [Condition("t >= 0")] * has_time(self.V, rate)
        conditions += [Condition("steps")] * bool(self.eq.discrete)
        conditions += [Condition(name, text) for name, text in texts if text]
        conditions += [Condition("rounding")] * self.is_rounded
        values = ((s, double(n)) for s, n in self.parameters.items())
        listed = joined(", ", (said("{} = {}", *pair) for pair in values))
        return conditions + [Condition("values", listed)] * self.are_numbers

    def ends_at(self, low: np.ndarray, high: np.ndarray) -> list[dict]:
        """Return the rests between states, to one of which every run comes; [] if not known."""
        answers = asked(self)
        if answers.verdict.implies("asymptotically stable"):
            return [dict(answers.definite.least or {})]
        if not (answers.verdict.implies("comes to rest") and answers.ends):
            return []
        rests = [case.rests(low, high) for case in answers.ends.cases]
        return [*chain(*rests)] if all(rests) else []

    def ways(self, definite: Definite, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a file of Coq."""
        # a file has the rates of all states
        return of_system(self, definite, fall) if self.is_whole else []

    # --- V' -------------------------------------------------------------------------------------

    def falling(self, bound: Expr) -> Expr | None:
        """Return V' or a bound as it is never positive: as it is, reduced, or by states."""
        terms = Add.make_args(bound)
        if all(bool(term.is_nonpositive) for term in terms):
            return bound
        if terms_of(bound) <= MOST_IN_PRODUCT and divides_by_sum(bound):
            product = as_factors(normal_form(bound))
            if never_positive(product, self.fixed):
                return product
        by_parameters = self.claim is not None and never_positive(bound, self.fixed)
        if self.never_positive(bound) or by_parameters:
            return bound
        by_state = self.claim is None and not self.eq.discrete
        return bound if by_state and self._falls_by_state() else None

    def _falls_by_state(self) -> bool:
        """Return whether V' falls without the terms of rates that go down V, as friction does.

        They are -dV/dx_i times what is not negative.  The other terms may cancel, as forces that do
        no work do.
        """

        def goes_down(rate: Expr, slope: Expr) -> bool:
            return self.never_positive(sympy.cancel(rate / slope))

        remaining = list[Expr]()
        for s, rate in {TIME: S.One, **self.motion}.items():
            slope = normal_form(slope_in(self.V, s))
            if slope == 0 or goes_down(rate, slope):
                continue
            terms = Add.make_args(rate)
            undecided = [g for g in terms if g == rate or not goes_down(g, slope)]
            remaining += [slope * term for term in undecided]
        return self.never_positive(Add(*remaining))

    def verdict(self, status: Status, claim: str, fall: Fall, **fields: Any) -> Verdict:
        """Return a verdict on V, in the diagram's own signals."""
        claim = self.with_rate(claim) if status == "open" else claim
        of_proof = (fall.rate or self.rate).xreplace(fall.zeroed)
        rate = of_proof if status == "proved" else self.rate
        V, rate = self.in_signals(self.V), self.readable_rate(rate)
        inputs = tuple(self.depends_on(self.rate))
        fields |= {"claimed": self.claim, "equations": self.relations.eq}
        return Verdict(status, claim, V=V, rate=rate, inputs=inputs, **fields)
