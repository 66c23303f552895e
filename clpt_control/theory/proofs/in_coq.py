"""A proved verdict as a file of Coq: the loop, V, V' as a sum, and the verdict's sentence.

    V' = push - decay V - loss,    V and loss sums of terms that are not negative

The file begins with `Runs.v`, whose lemmas and tactics prove what is stated here; it holds for
every run on [0, T), T finite or infinite.  The last theorem is the sentence.
"""

import re
from collections.abc import Iterable
from itertools import count
from pathlib import Path
from typing import Any

import sympy
from sympy import Abs, Add, Expr, Mul, S, diff, expand

from ...engine.diagram.symbol_names import TIME
from ..algebra.facts import BOUNDED, IN_COQ, ODD, SIGN
from ..algebra.slopes import along
from .conclusions import CONCLUSIONS, REQUIREMENTS
from .coq_text import (
    BOX,
    DECAYS,
    FALLS,
    FILE,
    LEVELS,
    NEAR,
    REST,
    RUN,
    SPENT,
    SUMS,
    CoqPrinter,
    name_in_coq,
    sign_before,
    without_signs,
)
from .rate_as_sum import Case, NotASum, Term, is_above_zero, least, total
from .statements import whole

PRELUDE = Path(__file__).parents[1] / "coq" / "Runs.v"
STATEMENT = re.compile(r"^(?:Lemma|Theorem) ([\w']+) : (.*?)\.\nProof", re.M | re.S)
MOST_FORMS = 12  # that go to zero
MOST_OPERATIONS = 40  # of rates of them
ON = "forall t, on (T i) t ->"  # of a run i
# what the steps of a verdict show -> theorems that say it
THEOREMS = {
    "definite": "V_nonneg",
    "all": "stable",
    "falls": "V_falls",
    "loses": "spent",
    "limit": "limits",
    "rest": "rest",
    "still": "limits still",
    "pulled": "V_decays",
    "mean": "spent",
    "decays": "V_exponential",
    "region": "V_nonneg V_stays stable rest",
}
ALWAYS = (
    "V_rate",
    "V_exponential",
    "bound_",
    "lag_",
    "V_stays",
)  # beginnings of names of theorems
OUTSIDE = "outside V, bounded"  # condition of a verdict
# bounded where their arguments are
GROWING = Add, Mul, sympy.Pow, *({*IN_COQ} - {*BOUNDED, sympy.log})
UNDONE = {f: f"vanishes_of_{f.__name__.lower()}" for f in (Abs, *ODD)}


class File:
    """The file of a verdict whose V' is a sum."""

    def __init__(self, case: Case, verdict: Any):
        self.verdict, self.case = verdict, case
        self.fixed, self.motion = case.fixed, case.motion
        values = case.V, case.rate, case.push, case.decay, *self.motion.values()
        symbols = sympy.Tuple(*values).free_symbols | {*self.motion}
        self.parameters = sorted(symbols & self.fixed, key=str)
        self.inputs = sorted(symbols - self.fixed - {*self.motion, TIME}, key=str)
        self.signals = [*self.motion, *self.inputs]
        named = [*self.parameters, *self.signals]
        self.name = {s: name_in_coq(s.name)[0][2:] for s in named}
        if len({*self.name.values(), "t"}) <= len(named):
            raise NotASum("two of its symbols have one name, or one is t")
        self.text = CoqPrinter(self.signals, "i t").doprint
        self.lines = list[str]()
        self.statements = dict[str, str]()  # name -> statement
        self.conditions = {c.name: c for c in verdict.conditions}
        if "rounding" in self.conditions:
            raise NotASum("V' is known to the rounding of numbers only")
        is_bounded = "bounded inputs" in self.conditions and case.falls
        self.bounded = {s for s in self.inputs if is_bounded or s in case.box}
        self.off = {s: s - case.rest.get(s, 0) for s in self.motion}  # from the rest
        self.zero = dict[Expr, str]()  # form that goes to zero -> its lemma
        self.is_stable = False
        self.runs()
        self.sums()
        if case.falls:
            self.exponential()
            self.stability()
            self.bounds()
            self.limits()

    # --- text -----------------------------------------------------------------------------------

    def __str__(self) -> str:
        shown = " ".join(THEOREMS.get(tag, "") for tag in self.needed).split()
        names = [n for n in self.statements if n in shown or n.startswith(ALWAYS)]
        stated = " /\\\n  ".join(f"({self.statements[name]})" for name in names)
        return FILE.format(
            prelude=PRELUDE.read_text("utf-8"),
            lines="\n".join(self.lines),
            comment="\n   ".join(self.comment()),
            stated=stated,
            proof="".join(f"split; [exact {name}|]. " for name in names[:-1])
            + f"exact {names[-1]}.",
        )

    @property
    def needed(self) -> frozenset[str]:
        """Names of what the conclusion requires."""
        return CONCLUSIONS[self.verdict.conclusion].requires

    @property
    def missing(self) -> set[str]:
        """Names of what the conclusion requires and no theorem says."""
        known = self.statements.keys()
        shown = (tag for tag, names in THEOREMS.items() if known >= {*names.split()})
        by_rates = {"rates"} & self.shown if not self.is_at_rest else set[str]()
        return by_rates | self.needed.difference(shown, ["jumps"])  # no loop has jumps

    @property
    def shown(self) -> set[str]:
        """Names of what the steps of the verdict show."""
        return {*" ".join(step.shows for step in self.verdict.steps).split()}

    def comment(self) -> Iterable[str]:
        """Yield what the last theorem states, and what the verdict says beyond it."""
        yield f"The verdict: {without_signs(whole(self.verdict.statement))}."
        yield "The theorem holds for every run on [0, T), T finite or infinite."
        yield from (f"{s} stands for {e}." for s, e in self.case.given.items())
        if self.case.below is not None:
            yield f"A run begins where V < {self.case.below}."
        beyond = [REQUIREMENTS[tag] for tag in REQUIREMENTS if tag in self.missing]
        if self.missing & {"limit", "rates"}:
            *_, last = (s.claim for s in self.verdict.steps if "limit" in s.shows)
            beyond += [f"{whole(self.verdict.of)} to zero", whole(last)]
        if OUTSIDE in self.conditions and not self.bounded >= {*self.motion}:
            beyond.append(whole(self.conditions[OUTSIDE].statement))
        yield from (f"Not in it, and shown by clpt-control: {text}." for text in beyond)
        if "N" in self.conditions:
            yield "The number N of functions is that of this file."
        if assumed := [self.name[s] for s in self.inputs if s in self.bounded]:
            yield f"Assumed to be bounded, with the names of the file: {', '.join(assumed)}."
        if "a_run" not in self.statements:
            yield "It is not shown here that there is a run."

    def function(self, form: Expr) -> str:
        """Return a form of a run as a function of time."""
        if form in self.signals:
            return f"(r_{self.name[form]} i)"
        return f"(fun t => {self.text(form)})"

    def write(self, text: str) -> None:
        """Write text; its lemmas are hints for those that follow."""
        found = dict(STATEMENT.findall(text))
        self.statements |= found
        self.lines += [text, f"#[local] Hint Resolve {' '.join(found)} : clpt."]

    def lemma(self, name: str, claim: str, proof: str) -> None:
        """Write a lemma on every run i."""
        self.write(f"Lemma {name} : forall i, {claim}.\nProof. intros i. {proof}. Qed.")

    def vanish(self, name: str, forms: Iterable[Expr]) -> None:
        """Write the theorem that forms go to zero, as is known of their parts."""
        claims = (f"vanishes (T i) {self.function(form)}" for form in forms)
        self.lemma(name, " /\\ ".join(claims), "repeat apply conj; van")

    # --- the loop -------------------------------------------------------------------------------

    def runs(self) -> None:
        """Write the parameters, and a run as a record."""
        for p in self.parameters:
            name, sign = self.name[p], sign_before(p)
            hypothesis = f" Hypothesis P_{name} : {sign} r_{name}." * bool(sign)
            self.lines.append(f"Variable r_{name} : R.{hypothesis}")
        factors = dict.fromkeys(term.factor for term in self.case.losses)
        assumed = (f for f in factors if f.free_symbols and self.is_fixed(f))
        for k, factor in enumerate(assumed):
            self.lines.append(f"Hypothesis A_{k} : 0 <= {self.text(factor)}.")
        at_t = CoqPrinter(self.signals).doprint
        fields = {"T": "Rbar"} | {f"r_{self.name[s]}": "R -> R" for s in self.signals}
        facts = {}
        for s in self.signals:
            name = self.name[s]
            if s in self.motion:
                rate = at_t(self.motion[s])
                facts[f"H_{name}"] = f"follows T r_{name} (fun t => {rate})"
            elif sign_before(s):
                facts[f"P_{name}"] = f"forall t, {sign_before(s)} r_{name} t"
            if s in self.case.box:
                low, high = map(at_t, self.case.box[s])
                facts[f"B_{name}"] = (
                    f"forall t, on T t -> {low} <= r_{name} t <= {high}"
                )
            elif s in self.bounded:
                facts[f"B_{name}"] = f"bounded T r_{name}"
        if self.case.below is not None:
            V = CoqPrinter(self.signals, "0").doprint(self.case.V)
            facts["begins"] = f"{V} < {at_t(self.case.below)}"
        record = ";\n  ".join(map(" : ".join, (fields | facts).items()))
        self.lines.append(RUN.format(fields=record, facts=" ".join(facts)))
        for d in filter(self.case.box.__contains__, self.inputs):
            low, high = self.case.box[d]
            shares = (expand(e / (high - low)) for e in (d - low, high - d))
            self.write(BOX.format(*map(self.text, shares), name=self.name[d]))
        rest = self.still()
        if all(sympy.simplify(r.xreplace(rest)) == 0 for r in self.motion.values()):
            values = " ".join(f"(fun _ => {at_t(rest[s])})" for s in self.signals)
            self.write(REST.format(values=values, holes="_ " * len(facts)))

    def still(self) -> dict[Any, Expr]:
        """Return values of signals, those of a rest if rates are linear about the origin."""
        values = {s: S.One * bool(sign_before(s)) for s in self.signals}
        values |= {**self.case.rest}
        for d, (low, high) in self.case.box.items():
            values[d] = min(max(S.Zero, low), high)
        rates = sympy.Matrix([*self.motion.values()])
        slopes = rates.jacobian([*self.motion]).xreplace(values)
        if self.case.box and slopes.det().is_nonzero:
            step = slopes.inv() * rates.xreplace(values)
            if self.is_fixed(step):
                values |= {
                    s: values[s] - e for s, e in zip(self.motion, step, strict=True)
                }
        return values

    def is_fixed(self, e: Expr) -> bool:
        """Return whether an expression is one of parameters alone."""
        return e.free_symbols <= self.fixed

    def sums(self) -> None:
        """Write V, V' and V' as a sum; what follows from the sum alone."""
        case, text = self.case, self.text
        push, decay, parts = text(case.push), text(case.decay), total(case.terms, text)
        pull = f"{push} - ({decay}) * V i t " * (not case.falls)
        self.write(
            SUMS.format(
                V=parts if case.V.has(Abs) else text(case.V),
                loss=total(case.losses, text),
                rate=text(case.rate),
                fall=f"{pull}- loss i t",
                parts=parts,
            )
        )
        if case.below is not None:
            self.level()
        self.lemma("loss_nonneg", f"{ON} 0 <= loss i t", "nonneg_loss loss")
        by_level = LEVELS if "input bounds" in self.conditions else DECAYS
        by_sum = FALLS if case.falls else by_level if case.decay != 0 else SPENT
        level, rate = text(case.push / (case.decay or 1)), text(case.rate)
        self.write(by_sum.format(push=push, decay=decay, level=level, rate=rate))

    def level(self) -> None:
        """Write that V stays below the level where it begins."""
        below = self.case.below
        level, room = self.text(below), self.text(expand(below - self.case.V))
        is_whole = below == sympy.Rational(f"{self.verdict.level:.4g}")
        name = "V_stays" if is_whole else "V_stays_in_part"
        proof = f"stays_of ({level}) (V_sum i) (begins i) V loss (fun t => {room})"
        self.lemma(name, f"{ON} V i t < {level}", proof)
        self.lemma("room", f"{ON} 0 <= {room}", f"room_of ({name} i) V")

    def exponential(self) -> None:
        """Write that V falls exponentially, if each of its forms is lost."""
        losses = [t for t in reversed(self.case.losses) if least(t.factor) > 0]
        lost = {(t.form, t.shape): t for t in losses if t.form != 1}
        rates = []
        for term in self.case.terms:
            loss = lost.get((term.form, term.shape))
            if loss is None or term.factor != 1:
                return
            low = f" * ({self.text(least(loss.factor))})" * (loss.factor != 1)
            share = f"c * ({self.text(term.weight)}) <= {self.text(loss.weight)}"
            rates.append(f"{share}{low} -> ")
        claim = f"forall c, 0 < c -> {''.join(rates)}\n  {ON} V i t <= V i 0 * exp (- c * t)"
        proof = "exponential_of (V_sum i) (V_parts i) loss"
        self.lemma("V_exponential", claim, proof)

    def is_shape(self, term: Term) -> bool:
        """Return whether a term is a positive multiple of a shape of its form."""
        return term.factor == 1 and not self.is_fixed(term.form)

    # --- stability ------------------------------------------------------------------------------

    def stability(self) -> None:
        """Write that V is small on runs that begin near the rest, if its forms are zero there."""
        terms = self.case.terms
        rest = {s: s - off for s, off in self.off.items()}
        forms = [term.form for term in terms if self.is_shape(term)]
        is_plain = {*self.off.values()} >= {*forms} or not any(rest.values())
        is_least = all(form.xreplace(rest) == 0 for form in forms)
        self.is_stable = is_plain and is_least and len(forms) == len(terms)
        if self.is_stable:
            at_0 = CoqPrinter(self.signals, "i 0").doprint
            offs = map(at_0, self.off.values())
            near = " /\\ ".join(f"Rabs ({off}) < d" for off in offs)
            self.lines.append(NEAR.format(near=near, V=total(terms, at_0)))

    def small(self, name: str, forms: Iterable[Expr], proof: str) -> None:
        """Write that forms stay small on every run that begins near the rest."""
        texts = (f"small run near now (fun i t => {self.text(form)})" for form in forms)
        claim = " /\\ ".join(texts)
        self.write(f"Lemma {name} : {claim}.\nProof. {proof}. Qed.")

    # --- what V bounds --------------------------------------------------------------------------

    def bounds(self) -> None:
        """Write what V bounds: its terms, forms, and states by them."""
        forms = []
        for k, term in enumerate(self.case.terms):
            if not self.is_shape(term):
                continue
            claim = f"{ON} {term.text(self.text)} <= V i 0"
            self.lemma(f"bound_{k}", claim, "bound_of (V_falls i) (V_parts i)")
            if not term.is_periodic:
                claim = f"bounded (T i) {self.function(term.form)}"
                proof = f"bounded_by_shape (bound_{k} i) {term.function}"
                self.lemma(f"form_{k}", claim, proof)
                forms.append(term.form)
                if self.is_stable:
                    proof = f"small_by_shape small_V bound_{k} {term.function}"
                    self.small(f"near_{k}", [term.form], proof)
        for _ in self.motion:
            self.states_in(forms)
            self.is_stable &= self.bounded >= {*self.motion}  # without lags
            self.lags()
        if self.is_stable:
            self.small("stable", self.off.values(), "repeat split; leaf")

    def states_in(self, forms: Iterable[Expr]) -> None:
        """Write that states are bounded, as forms are."""
        while found := self.solved(forms, self.bounded, self.is_bounded):
            s, form, value = found
            self.bounded |= {s, self.off[s]}
            if self.is_stable and form != self.off[s]:
                proof = f"small_as near_le (fun i t => {value})"
                self.small(f"small_r_{self.name[s]}", [self.off[s]], proof)
            if form != s:
                value += f" + ({self.text(s - self.off[s])})" * (self.off[s] != s)
                proof = f"bounded_as (fun t => {value})"
                claim = f"bounded (T i) {self.function(s)}"
                self.lemma(f"bounded_r_{self.name[s]}", claim, proof)

    def solved(self, forms: Iterable[Expr], known: Any, is_known: Any) -> Any:
        """Return a state, a form, and its distance from the rest by the form and what is known."""
        for form in forms:
            for s in sorted(form.free_symbols & {*self.motion}, key=str):
                slope, off = diff(form, s), self.off[s]
                rest = expand(form - slope * off)
                is_linear = self.is_fixed(slope) and slope.is_nonzero
                if off not in known and is_linear and is_known(rest):
                    less = f" - ({self.text(rest)})" * (rest != 0)
                    text = f"({self.text(1 / slope)}) * (({self.text(form)}){less})"
                    return s, form, text
        return None

    def lags(self) -> None:
        """Write that states with x' = -k x + u are bounded, as u is."""
        for s, rate in self.motion.items():
            pull = -diff(rate, s)
            rest = expand(rate + pull * s)
            is_lag = pull.is_positive and self.is_fixed(pull)
            if s not in self.bounded and is_lag and self.is_bounded(rest):
                name = self.name[s]
                proof = (
                    f"apply (bounded_lag _ ({self.text(pull)}) _ (fun t => {self.text(rest)})); "
                    "[positive|rate_of|bnd]"
                )
                self.lemma(f"lag_r_{name}", f"bounded (T i) (r_{name} i)", proof)
                self.bounded.add(s)

    def is_bounded(self, e: Expr) -> bool:
        """Return whether an expression is made of what is known to be bounded."""
        if self.is_fixed(e) or e in self.bounded or isinstance(e, (*BOUNDED, SIGN)):
            return True
        if e.is_Pow and e.exp.is_negative:
            return is_above_zero(e.base, self.fixed)
        return isinstance(e, GROWING) and all(map(self.is_bounded, e.args))

    def is_steady(self, e: Expr) -> bool:
        """Return whether an expression and its rate are bounded, so that it is Lipschitz."""
        moves = e.free_symbols <= self.fixed | {TIME, *self.motion}
        return moves and self.is_bounded(e) and self.is_bounded(self.rate_of(e))

    def rate_of(self, e: Expr) -> Expr:
        """Return the rate of an expression along a run."""
        return along(e, {TIME: S.One, **self.motion})

    # --- what goes to zero ----------------------------------------------------------------------

    def limits(self) -> None:
        """Write what goes to zero: what V loses, the rates of that, and states by them."""
        for k, term in enumerate(self.case.losses):
            if not self.is_steady(term.value):
                continue
            part = term.text(self.text)
            proof = "lost_from (V_sum i) (V_nonneg i) loss"
            self.lemma(f"lost_{k}", f"vanishes (T i) (fun t => {part})", proof)
            if self.is_shape(term) and not term.is_periodic:
                self.goes_to_zero(term.form, f"zero_of (lost_{k} i) {term.function}")
            else:
                self.factor_to_zero(term.value, part)
        if self.needed & {"rest", "still"} or "rates" in self.shown:
            self.next_rates()
        if self.is_at_rest:
            self.vanish("rest", self.off.values())
        if self.zero and all(map(self.is_zero, self.case.lost)):
            self.vanish("limits", self.zero)
        rates = [expand(rate) for rate in self.motion.values()]
        if all(map(self.is_zero, rates)):
            self.vanish("still", rates)

    @property
    def is_at_rest(self) -> bool:
        """True if all states are known to come to the rest."""
        return self.zero.keys() >= {*self.off.values()}

    def goes_to_zero(self, form: Expr, proof: str) -> None:
        """Write that a form goes to zero, and states that it gives."""
        if form in self.zero or len(self.zero) > MOST_FORMS:
            return
        self.zero[form] = name = f"zero_{len(self.zero)}"
        self.lemma(name, f"vanishes (T i) {self.function(form)}", proof)
        if found := self.solved(self.zero, self.zero, self.is_zero):
            s, _, value = found
            self.goes_to_zero(self.off[s], f"vanishes_as (fun t => {value})")

    def factor_to_zero(self, e: Expr, text: str) -> None:
        """Write that the one factor goes to zero that may do so of what goes to zero, `text`."""
        powers = (factor.as_base_exp() for factor in Mul.make_args(sympy.factor(e)))
        kept = [pair for pair in powers if not is_above_zero(pair[0], self.fixed)]
        if len(kept) != 1 or self.is_fixed(kept[0][0]):
            return
        ((base, power),) = kept
        share = sympy.cancel(base**power / sympy.factor(e))
        if not (power.is_Integer and power.is_positive and self.is_bounded(share)):
            return
        undo = f"apply {UNDONE[base.func]}. " if base.func in UNDONE else ""
        form = base.args[0] if undo else base
        proof = f"{undo}apply (vanishes_root _ {power - 1}). "
        self.goes_to_zero(
            form, f"{proof}vanishes_as (fun t => ({self.text(share)}) * ({text}))"
        )

    def next_rates(self) -> None:
        """Write that rates of what goes to zero do so (Barbalat again), and what they give."""
        for k in count():
            if self.is_at_rest or k == len(self.zero):
                return
            form, name = [*self.zero.items()][k]
            rate = expand(self.rate_of(form))
            if rate.count_ops() > MOST_OPERATIONS or not self.is_steady(rate):
                continue
            text = self.text(rate)
            claim = f"vanishes (T i) (fun t => {text})"
            self.lemma(f"rate_{k}", claim, f"next_of ({name} i)")
            at_rest = {s: s - off for s, off in self.off.items() if off in self.zero}
            kept = expand(rate.xreplace(at_rest))
            gone = expand(rate - kept)
            if kept != 0 and self.is_zero(gone):
                self.factor_to_zero(kept, f"({text}) - ({self.text(gone)})")

    def is_zero(self, e: Expr) -> bool:
        """Return whether each term of an expression has a factor that goes to zero."""
        return e in self.zero or all(
            term == 0
            or (self.is_bounded(term) and any(map(self._fades, Mul.make_args(term))))
            for term in Add.make_args(expand(e))
        )

    def _fades(self, factor: Expr) -> bool:
        base, power = factor.as_base_exp()
        if base.func in (sympy.sin, *ODD) and base not in self.zero:
            base = base.args[0]
        return base in self.zero and bool(power.is_positive)
