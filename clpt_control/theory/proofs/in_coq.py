"""A proved verdict as a file of Coq: the loop, V, V' as a sum, and the verdict's sentence.

    V' = push - decay V - loss,    V and loss sums of terms that are not negative

The file begins with `Runs.v`, whose lemmas and tactics prove what is stated here; it holds for
every run on [0, T), T finite or infinite.  The last theorem is the sentence.
"""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import sympy
from sympy import Add, Expr, Mul, S

from ...engine.diagram.symbol_names import TIME
from ..algebra.slopes import along
from .conclusions import CONCLUSIONS, REQUIREMENTS
from .coq_text import CoqPrinter, name_in_coq, sign_before, without_signs
from .rate_as_sum import (
    RISING,
    Case,
    NotASum,
    Term,
    is_above_zero,
    with_symbols,
    without_calls,
)
from .steps import Step

PRELUDE = Path(__file__).parents[1] / "coq" / "Runs.v"
MOST_FORMS = 12  # that go to zero
MOST_OPERATIONS = 100  # of rates of them
ON = "forall t, on (T i) t ->"  # of a run i
# what the steps of a verdict show -> theorems that say it
THEOREMS = {
    "definite": "definite",
    "all": "stable",
    "falls": "falls",
    "loses": "spent",
    "limit": "zero",
    "rest": "states",
    "still": "zero rates",
    "pulled": "decays",
    "mean": "spent",
    "region": "level definite stays stable states",
}
OUTSIDE = "outside V, bounded"  # condition of a verdict
BETWEEN = sympy.sin, sympy.cos, sympy.tanh, sympy.atan  # two numbers
GROWING = (
    Add,
    Mul,
    sympy.Pow,
    sympy.exp,
    sympy.Abs,
    sympy.sinh,
    sympy.cosh,
)  # bounded with arguments
UNDONE = {f: f"vanishes_of_{f.__name__.lower()}" for f in (sympy.Abs, *RISING)}


class File:
    """The file of a verdict whose V' is a sum."""

    def __init__(self, case: Case, verdict: Any):
        self.verdict, self.case = verdict, case = verdict, with_symbols(case)
        self.fixed, self.motion = case.fixed, case.motion
        shown = (case.V, case.rate, case.push, *self.motion.values())
        values = (term.value for term in (*case.terms, *case.losses))
        symbols = sympy.Tuple(*shown, *values).free_symbols | {*self.motion}
        self.parameters = sorted(symbols & self.fixed, key=str)
        self.inputs = sorted(symbols - self.fixed - {*self.motion, TIME}, key=str)
        self.signals = [*self.motion, *self.inputs]
        named = [*self.parameters, *self.signals]
        self.name = {s: name_in_coq(s.name)[0][2:] for s in named}
        if len({*self.name.values(), "t"}) <= len(named):
            raise NotASum("two of its symbols have one name, or one is t")
        self.text = CoqPrinter(self.signals, "i t").doprint
        self.lines = list[str]()
        self.claims = dict[str, list[tuple[str, str]]]()
        self.conditions = {c.name: c for c in verdict.conditions}
        if "rounding" in self.conditions:
            raise NotASum("V' is known to the rounding of numbers only")
        is_bounded = "bounded inputs" in self.conditions and case.push == 0
        self.bounded = {*self.inputs} if is_bounded else set[Any]()
        moves = sympy.Tuple(*case.rest.values()).has(TIME)
        self.rest = {} if moves else {**case.rest}
        self.off = {s: s - self.rest.get(s, 0) for s in self.motion}  # from the rest
        self.zero = dict[Expr, str]()  # form that goes to zero -> its theorem
        self.by_forms = list[Any]()  # states that forms of V give
        self.steady = set[Any]()
        self.runs()
        self.sums()
        if case.push == 0:
            self.bounds()
            self.limits()
            self.stability()

    # --- text -----------------------------------------------------------------------------------

    def __str__(self) -> str:
        shown = " ".join(THEOREMS[tag] for tag in THEOREMS if tag in self.needed)
        if OUTSIDE in self.conditions:
            shown += " outside"
        claims = [*self.claims["rate"]]
        for theorem in dict.fromkeys(shown.split()):
            claims += self.claims.get(theorem, [])
        stated = " /\\\n  ".join(f"({claim})" for _, claim in claims)
        proof = "".join(f"split; [exact {name}|]. " for name, _ in claims[:-1])
        comment = "\n   ".join(self.comment())
        return "\n".join(
            (
                PRELUDE.read_text("utf-8"),
                *self.lines,
                f"(* {comment} *)",
                f"Theorem verdict :\n  {stated}.",
                f"Proof. {proof}exact {claims[-1][0]}. Qed.",
                "End Loop.",
                "Print Assumptions verdict.\n",
            )
        )

    @property
    def needed(self) -> frozenset[str]:
        """Names of what the conclusion requires."""
        return CONCLUSIONS[self.verdict.conclusion].requires

    def beyond(self) -> tuple[Step, ...]:
        """Return the steps by which the verdict is stronger than the last theorem."""
        missing = self.missing
        return tuple(s for s in self.verdict.steps if missing & {*s.shows.split()})

    @property
    def missing(self) -> set[str]:
        """Names of what the conclusion requires and no theorem says."""
        shown = (
            tag
            for tag, names in THEOREMS.items()
            if self.claims.keys() >= {*names.split()}
        )
        return {*self.needed}.difference(shown, ["jumps"])  # a loop without jumps

    def comment(self) -> Iterable[str]:
        """Yield what the last theorem states, and what the verdict says beyond it."""
        yield f"The verdict: {without_signs(self.verdict.sentence)}."
        yield "The theorem holds for every run on [0, T), T finite or infinite."
        if self.case.below is not None:
            yield f"A run begins where V < {self.case.below}."
        for tag in REQUIREMENTS:
            if tag in self.missing:
                yield f"Not in it, and shown by clpt-control: {REQUIREMENTS[tag]}."
        if OUTSIDE in self.conditions and not self.bounded >= {*self.motion}:
            yield f"Not in it, and shown by clpt-control: {self.conditions[OUTSIDE]}."
        if "N" in self.conditions:
            yield "The number N of functions is that of this file."
        if assumed := [self.name[s] for s in self.inputs if s in self.bounded]:
            yield f"Assumed to be bounded, with the names of the file: {', '.join(assumed)}."
        if "a_run" not in self.claims:
            yield "It is not shown here that there is a run."

    def function(self, form: Expr) -> str:
        """Return a form of a run as a function of time."""
        is_signal = form in self.signals
        return (
            f"(r_{self.name[form]} i)" if is_signal else f"(fun t => {self.text(form)})"
        )

    def total(self, terms: Iterable[Term]) -> str:
        """Return a sum of terms."""
        return " + ".join(term.text(self.text) for term in terms) or "0"

    def lemma(self, name: str, claim: str, proof: str, hint: bool = True) -> None:
        """Write a lemma on every run i."""
        self.lines.append(
            f"Lemma {name} : forall i, {claim}.\nProof. intros i. {proof}. Qed."
        )
        if hint:
            self.lines.append(f"#[local] Hint Resolve {name} : clpt.")

    def theorem(self, group: str, name: str, claim: str, proof: str) -> None:
        """Write a theorem on every run i that the last theorem may state."""
        self.lemma(name, claim, proof)
        self.claims.setdefault(group, []).append((name, f"forall i, {claim}"))

    # --- the loop -------------------------------------------------------------------------------

    def runs(self) -> None:
        """Write the parameters, and a run as a record."""
        self.lines.append("Section Loop.")
        for p in self.parameters:
            name, sign = self.name[p], sign_before(p)
            hypothesis = f" Hypothesis P_{name} : {sign} r_{name}." * bool(sign)
            self.lines.append(f"Variable r_{name} : R.{hypothesis}")
        factors = dict.fromkeys(term.factor for term in self.case.losses)
        assumed = [
            f for f in factors if f.free_symbols and f.free_symbols <= self.fixed
        ]
        for k, factor in enumerate(assumed):
            self.lines.append(f"Hypothesis A_{k} : 0 <= {self.text(factor)}.")
        at_t = CoqPrinter(self.signals).doprint
        fields = ["T : Rbar"] + [f"r_{self.name[s]} : R -> R" for s in self.signals]
        facts = {}
        for s, rate in self.motion.items():
            name = self.name[s]
            facts[f"H_{name}"] = f"follows T r_{name} (fun t => {at_t(rate)})"
        for s in self.inputs:
            name = self.name[s]
            if s in self.bounded:
                facts[f"B_{name}"] = f"bounded T r_{name}"
            if sign_before(s):
                facts[f"P_{name}"] = f"forall t, {sign_before(s)} r_{name} t"
        if self.case.below is not None:
            V = CoqPrinter(self.signals, "0").doprint(self.case.V)
            facts["begins"] = f"{V} < {at_t(self.case.below)}"
        fields += [f"{name} : {fact}" for name, fact in facts.items()]
        listed = ";\n  ".join(fields)
        self.lines.append(
            f"(* a run on [0, T) *)\nRecord run := Run {{\n  {listed} }}."
        )
        self.lines.append(f"#[local] Hint Resolve {' '.join(facts)} : clpt.")
        rest = {s: S.One * bool(sign_before(s)) for s in self.signals}
        rest |= self.rest
        if all(sympy.simplify(r.xreplace(rest)) == 0 for r in self.motion.values()):
            values = " ".join(f"(fun _ => {at_t(rest[s])})" for s in self.signals)
            holes = "_ " * len(facts)
            self.lines.append(
                "(* a run exists: the rest *)\nLemma a_run : exists i, T i = p_infty.\n"
                f"Proof. unshelve eexists (Run p_infty {values} {holes}); "
                "[at_rest..|reflexivity]. Qed."
            )
            self.claims["a_run"] = []

    def sums(self) -> None:
        """Write V, V' and V' as a sum; what follows from the sum alone."""
        case, text = self.case, self.text
        fall = f"{text(case.push)} - ({text(case.decay)}) * V i t - loss i t"
        if case.push == 0:
            fall = "- loss i t"
        V = self.total(case.terms) if case.V.has(sympy.Abs) else text(case.V)
        self.lines += [
            f"Definition V (i : run) (t : R) := {V}.",
            f"Definition loss (i : run) (t : R) := {self.total(case.losses)}.",
        ]
        claim = f"follows (T i) (V i) (fun t => {text(case.rate)})"
        self.theorem("rate", "V_rate", claim, "unfold V. rate_of")
        self.lemma(
            "V_sum",
            f"follows (T i) (V i) (fun t => {fall})",
            "sum_of (V_rate i) V loss",
        )
        self.lemma(
            "V_parts", f"{ON} V i t = {self.total(case.terms)}", "parts_of V", False
        )
        claim = f"{ON} 0 <= V i t"
        self.theorem("definite", "V_nonneg", claim, "nonneg_of (V_parts i)")
        if case.below is not None:
            self.level()
        self.lemma("loss_nonneg", f"{ON} 0 <= loss i t", "nonneg_loss loss")
        known = "(V_sum i) (V_nonneg i) (loss_nonneg i)"
        if case.push == 0:
            claim = "forall s t, 0 <= s <= t -> on (T i) t -> V i t <= V i s"
            self.theorem(
                "falls", "V_falls", claim, "falls_of (V_sum i) (loss_nonneg i)"
            )
            spent = f"forall L, follows (T i) L (loss i) -> {ON} L t - L 0 <= V i 0"
            self.theorem("spent", "spent", spent, f"spent_of {known}")
            self.exponential()
        elif case.decay != 0:
            decay = text(case.decay)
            claim = (
                f"forall c, (forall t, on (T i) t -> {text(case.push)} <= c) ->\n  {ON} "
                f"V i t <= c / ({decay}) + (V i 0 - c / ({decay})) * exp (- ({decay}) * t)"
            )
            self.theorem("decays", "V_decays", claim, f"decays_of ({decay}) {known}")
        else:
            claim = (
                "forall L P, follows (T i) L (loss i) ->\n"
                f"  follows (T i) P (fun t => {text(case.push)}) ->\n"
                f"  {ON} L t - L 0 <= V i 0 + (P t - P 0)"
            )
            self.theorem("spent", "spent", claim, f"mean_of {known}")

    def level(self) -> None:
        """Write that V stays below the level where it begins."""
        level = self.text(self.case.below)
        room = self.text(sympy.expand(self.case.below - self.case.V))
        claim = f"{ON} V i t < {level}"
        proof = f"stays_of ({level}) (V_sum i) (begins i) V loss (fun t => {room})"
        self.theorem("stays", "V_stays", claim, proof)
        if self.case.below == sympy.Rational(f"{self.verdict.level:.4g}"):
            self.claims["level"] = []  # that of the verdict, not part of it
        claim = f"{ON} 0 <= {room}"
        self.lemma("room", claim, "room_of (V_stays i) V")

    def exponential(self) -> None:
        """Write that V falls exponentially, if each of its forms is lost."""
        losses = filter(self.is_shape, reversed(self.case.losses))
        lost = {(t.form, t.shape): t.weight for t in losses}
        pairs = [(t.weight, lost.get((t.form, t.shape))) for t in self.case.terms]
        if not pairs or any(weight is None for _, weight in pairs):
            return
        rates = [f"c * ({self.text(a)}) <= {self.text(b)} -> " for a, b in pairs]
        claim = f"forall c, 0 < c -> {''.join(rates)}\n  {ON} V i t <= V i 0 * exp (- c * t)"
        proof = "exponential_of (V_sum i) (V_parts i) loss"
        self.theorem("exponential", "V_exponential", claim, proof)

    def is_shape(self, term: Term) -> bool:
        """Return whether a term is a positive multiple of a shape of its form."""
        return term.factor == 1 and bool(term.form.free_symbols - self.fixed)

    # --- what V bounds --------------------------------------------------------------------------

    def bounds(self) -> None:
        """Write what V bounds: its terms, forms, and states by them."""
        forms = dict[Expr, str]()
        for k, term in enumerate(self.case.terms):
            if not self.is_shape(term):
                continue
            claim = f"forall t, on (T i) t -> {term.text(self.text)} <= V i 0"
            self.theorem(
                "definite", f"bound_{k}", claim, "bound_of (V_falls i) (V_parts i)"
            )
            if "cos {" not in term.shape:
                claim = f"bounded (T i) {self.function(term.form)}"
                self.lemma(
                    f"form_{k}",
                    claim,
                    f"bounded_by_shape (bound_{k} i) {term.function}",
                )
                forms.setdefault(term.form, f"{k}")
        for _ in self.motion:
            self.states_in(forms)
            self.lags()
        for s, rate in self.motion.items():
            if self.is_bounded(rate):
                name = self.name[s]
                proof = f"eapply Lipschitz_rate; [exact (H_{name} i)|bnd]"
                self.lemma(f"moves_{name}", f"Lipschitz (T i) (r_{name} i)", proof)
                self.steady.add(s)

    def states_in(self, forms: Iterable[Expr]) -> None:
        """Write that states are bounded, as forms are."""
        while found := next(self.solved(forms, self.bounded, self.is_bounded), None):
            s, form, value = found
            self.by_forms.append((s, form, value))
            self.bounded |= {s, self.off[s]}
            if form != s:
                value += f" + ({self.text(s - self.off[s])})" * (self.off[s] != s)
                claim = f"bounded (T i) {self.function(s)}"
                proof = f"bounded_as (fun t => {value})"
                self.lemma(f"bounded_{self.name[s]}", claim, proof)

    def solved(self, forms: Iterable[Expr], known: Any, is_known: Any) -> Any:
        """Yield distances of states from the rest that forms give by what is known."""
        for form in forms:
            for s in sorted(form.free_symbols & {*self.motion}, key=str):
                slope, off = sympy.diff(form, s), self.off[s]
                rest = sympy.expand(form - slope * off)
                is_fixed = slope.free_symbols <= self.fixed and slope.is_nonzero
                if off not in known and is_fixed and is_known(rest):
                    less = f" - ({self.text(rest)})" * (rest != 0)
                    text = f"({self.text(1 / slope)}) * (({self.text(form)}){less})"
                    yield s, form, text

    def lags(self) -> None:
        """Write that states with x' = -k x + u are bounded, as u is."""
        for s in self.motion:
            rate = self.motion[s]
            pull = -sympy.diff(rate, s)
            rest = sympy.expand(rate + pull * s)
            is_lag = pull.is_positive and pull.free_symbols <= self.fixed
            if s not in self.bounded and is_lag and self.is_bounded(rest):
                name = self.name[s]
                proof = (
                    f"apply (bounded_lag _ ({self.text(pull)}) _ (fun t => {self.text(rest)})); "
                    "[positive|rate_of|bnd]"
                )
                claim = f"bounded (T i) (r_{name} i)"
                self.theorem("outside", f"bounded_{name}", claim, proof)
                self.bounded.add(s)

    def is_bounded(self, e: Expr) -> bool:
        """Return whether an expression is made of what is known to be bounded."""
        if not e.free_symbols - self.fixed or e in self.bounded:
            return True
        if isinstance(e, BETWEEN):
            return True
        if e.is_Pow and e.exp.is_negative:
            return is_above_zero(e.base, self.fixed)
        return isinstance(e, GROWING) and all(map(self.is_bounded, e.args))

    def is_steady(self, e: Expr) -> bool:
        """Return whether an expression is Lipschitz in time by its form."""
        inner = e.free_symbols - self.fixed
        return inner <= self.steady and self.is_bounded(e)

    # --- what goes to zero ----------------------------------------------------------------------

    def limits(self) -> None:
        """Write what goes to zero: what V loses, the rates of that, and states by them."""
        for k, term in enumerate(self.case.losses):
            if not self.is_steady(term.value):
                continue
            part = term.text(self.text)
            self.lemma(
                f"part_{k}", f"{ON} - loss i t <= - {part}", "part_of loss", False
            )
            proof = f"lost_of (V_sum i) (V_nonneg i) (part_{k} i)"
            self.lemma(f"lost_{k}", f"vanishes (T i) (fun t => {part})", proof)
            if self.is_shape(term) and "cos {" not in term.shape:
                self.goes_to_zero(term.form, f"zero_of (lost_{k} i) {term.function}")
            else:
                self.factor_to_zero(term.value, part)
        if self.needed & {"rest", "still"}:
            self.next_rates()
        if self.zero.keys() >= {*self.off.values()}:
            names = [self.zero[off] for off in self.off.values()]
            claims = dict(self.claims["zero"])
            self.claims["states"] = [(name, claims[name]) for name in names]
        is_global = self.case.below is None
        lost = self.verdict.ways.args[1].losses if is_global else ()
        if not all(map(self.is_zero, map(without_calls, lost))):
            self.claims.pop("zero", None)
        if all(map(self.is_zero, self.motion.values())):
            for s, rate in self.motion.items():
                claim = f"vanishes (T i) (fun t => {self.text(sympy.expand(rate))})"
                self.theorem("rates", f"still_{self.name[s]}", claim, "van")

    def goes_to_zero(self, form: Expr, proof: str) -> None:
        """Write that a form goes to zero, and states that it gives."""
        if form in self.zero or len(self.zero) > MOST_FORMS:
            return
        name = f"zero_{len(self.zero)}"
        self.theorem("zero", name, f"vanishes (T i) {self.function(form)}", proof)
        self.zero[form] = name
        for s, _, value in self.solved([*self.zero], self.zero, self.is_zero):
            self.goes_to_zero(self.off[s], f"vanishes_as (fun t => {value})")
            break

    def factor_to_zero(self, e: Expr, text: str) -> None:
        """Write that the one factor goes to zero that may do so of what goes to zero, `text`."""
        kept = []
        for factor in Mul.make_args(sympy.factor(e)):
            base, power = factor.as_base_exp()
            if is_above_zero(base, self.fixed):
                continue
            if not factor.free_symbols - self.fixed:
                return
            kept.append((base, power))
        if len(kept) != 1 or not (kept[0][1].is_Integer and kept[0][1].is_positive):
            return
        ((base, power),) = kept
        share = sympy.cancel(base**power / sympy.factor(e))
        if not self.is_bounded(share):
            return
        undo = f"apply {UNDONE[base.func]}. " if base.func in UNDONE else ""
        form = base.args[0] if undo else base
        proof = f"{undo}apply (vanishes_root _ {power - 1}). "
        self.goes_to_zero(
            form, f"{proof}vanishes_as (fun t => ({self.text(share)}) * ({text}))"
        )

    def next_rates(self) -> None:
        """Write that rates of what goes to zero do so (Barbalat again), and what they give."""
        done = set[Expr]()
        while forms := [form for form in self.zero if form not in done]:
            if self.zero.keys() >= {*self.off.values()}:
                return
            done.add(forms[0])
            rate = sympy.expand(along(forms[0], self.motion))
            if rate.count_ops() > MOST_OPERATIONS or not self.is_steady(rate):
                continue
            text = self.text(rate)
            claim = f"vanishes (T i) (fun t => {text})"
            self.lemma(f"rate_{len(done)}", claim, f"next_of ({self.zero[forms[0]]} i)")
            at_rest = {s: s - off for s, off in self.off.items() if off in self.zero}
            kept = sympy.expand(rate.xreplace(at_rest))
            gone = sympy.expand(rate - kept)
            if kept != 0 and self.is_zero(gone):
                self.factor_to_zero(kept, f"({text}) - ({self.text(gone)})")

    def is_zero(self, e: Expr) -> bool:
        """Return whether each term of an expression has a factor that goes to zero."""
        return e in self.zero or all(
            term == 0
            or (self.is_bounded(term) and any(map(self._fades, Mul.make_args(term))))
            for term in Add.make_args(sympy.expand(e))
        )

    def _fades(self, factor: Expr) -> bool:
        base, power = factor.as_base_exp()
        if isinstance(base, (sympy.sin, sympy.tanh)):
            base = base if base in self.zero else base.args[0]
        return base in self.zero and bool(power.is_positive)

    # --- stability ------------------------------------------------------------------------------

    def stability(self) -> None:
        """Write that runs that begin near the rest stay near."""
        case, small = self.case, "small run near now"
        rest = {s: s - off for s, off in self.off.items()}
        forms = [term.form for term in case.terms if self.is_shape(term)]
        is_least = all(form.xreplace(rest) == 0 for form in forms)
        is_plain = all(off == s for s, off in self.off.items())
        is_plain = is_plain or {*self.off.values()} >= {*forms}
        is_all = {s for s, *_ in self.by_forms} == {*self.motion}
        if not (is_least and is_plain and is_all and len(forms) == len(case.terms)):
            return
        texts = {self.name[s]: self.text(off) for s, off in self.off.items()}
        starts = {name: text.replace(" i t", " i 0") for name, text in texts.items()}
        near = " /\\ ".join(f"Rabs ({text}) < d" for text in starts.values())
        self.lines += [
            f"Definition near (d : R) (i : run) := {near}.",
            "Definition now (i : run) (t : R) := on (T i) t.",
            "Lemma near_le d e i : d <= e -> near d i -> near e i.\nProof. near_of near. Qed.",
            "#[local] Hint Resolve near_le : clpt.",
        ]
        for name, text in starts.items():
            claim = f"{small} (fun i t => {text})"
            self._small(f"start_{name}", claim, "start_of near")
        at_0 = self.total(case.terms).replace(" i t", " i 0")
        proof = f"small_V_of near_le V_parts (fun i (t : R) => {at_0})"
        self._small("small_V", f"{small} (fun i t => V i 0)", proof)
        for k, term in enumerate(case.terms):
            if "cos {" not in term.shape:
                claim = f"{small} (fun i t => {self.text(term.form)})"
                proof = f"small_by_shape small_V bound_{k} {term.function}"
                self._small(f"near_{k}", claim, proof)
        for s, form, value in self.by_forms:
            if form != self.off[s]:
                claim = f"{small} (fun i t => {texts[self.name[s]]})"
                proof = f"small_as near_le (fun i t => {value})"
                self._small(f"small_{self.name[s]}", claim, proof)
        claim = " /\\ ".join(f"{small} (fun i t => {text})" for text in texts.values())
        self.lines.append(f"Theorem stable : {claim}.\nProof. repeat split; leaf. Qed.")
        self.claims["stable"] = [("stable", claim)]

    def _small(self, name: str, claim: str, proof: str) -> None:
        self.lines.append(f"Lemma {name} : {claim}.\nProof. {proof}. Qed.")
        self.lines.append(f"#[local] Hint Resolve {name} : clpt.")
