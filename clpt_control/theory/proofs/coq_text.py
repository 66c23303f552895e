"""Expressions of a record as text of Coq, and the parts of a file of a verdict.

A name of a record has the prefix `r_`: no keyword of Coq and no name of the fixed files begins so.

    x_1              r_x_1 t                   a signal at time t
    alpha_1[k]       r_alpha_1 k t             its element along an axis of N functions
    Q_1_2[1]         r_Q_1_2'1 t               its element along an axis of known length
    adaptation.leak  r_adaptation'leak         a parameter
    Sum(f[k1], k1)   sum N (fun k1 => ...)
"""

import re
from collections.abc import Iterable
from typing import Any, NoReturn

import sympy
from sympy import S
from sympy.printing.str import StrPrinter

from ...base.errors import DiagramError
from ...engine.diagram.typesetting import in_ascii
from ..algebra.facts import FACTS

FUNCTIONS = {name: fact.coq for name, fact in FACTS.items() if fact.coq}
KNOWN = sympy.Symbol, sympy.Number, sympy.Add, sympy.Mul, sympy.Pow, sympy.Function
WORD = r"[A-Za-z_]\w*"
NAME = re.compile(rf"{WORD}([.:]{WORD})*(\[\w+(,\w+)*\])*", re.ASCII).fullmatch

# --- files of verdicts, by parts ---

FILE = """\
{prelude}
Section Loop.
{lines}
(* {comment} *)
Theorem verdict :
  {stated}.
Proof. {proof} Qed.
End Loop.
Print Assumptions verdict.
"""
RUN = """\
(* a run on [0, T) *)
Record run := Run {{
  {fields} }}.
#[local] Hint Resolve {facts} : clpt."""
REST = """\
(* a run exists: the rest *)
Lemma a_run : exists i, T i = p_infty.
Proof. unshelve eexists (Run p_infty {values} {holes}); [at_rest..|reflexivity]. Qed."""
SUMS = """\
Definition V (i : run) (t : R) := {V}.
Definition loss (i : run) (t : R) := {loss}.
Lemma V_rate : forall i, follows (T i) (V i) (fun t => {rate}).
Proof. intros i. unfold V. rate_of. Qed.
Lemma V_sum : forall i, follows (T i) (V i) (fun t => {fall}).
Proof. intros i. sum_of (V_rate i) V loss. Qed.
Lemma V_parts : forall i, forall t, on (T i) t -> V i t = {parts}.
Proof. intros i. parts_of V. Qed.
Lemma V_nonneg : forall i, forall t, on (T i) t -> 0 <= V i t.
Proof. intros i. nonneg_of (V_parts i). Qed."""
FALLS = """\
Lemma V_falls : forall i, forall s t, 0 <= s <= t -> on (T i) t -> V i t <= V i s.
Proof. intros i. falls_of (V_sum i) (loss_nonneg i). Qed.
Lemma spent : forall i, forall L, follows (T i) L (loss i) ->
  forall t, on (T i) t -> L t - L 0 <= V i 0.
Proof. intros i. spent_of (V_sum i) (V_nonneg i) (loss_nonneg i). Qed."""
DECAYS = """\
Lemma V_decays : forall i, forall c, (forall t, on (T i) t -> {push} <= c) ->
  forall t, on (T i) t -> V i t <= c / ({decay}) + (V i 0 - c / ({decay})) * exp (- ({decay}) * t).
Proof. intros i. decays_of ({decay}) (V_sum i) (V_nonneg i) (loss_nonneg i). Qed."""
LEVELS = """\
Lemma bound_rate : forall i, forall t, on (T i) t -> {rate} <= {push} - ({decay}) * V i t.
Proof. intros i. pulled_of (loss_nonneg i) V loss. Qed.
Lemma V_decays : forall i, forall t, on (T i) t ->
  V i t <= {level} + (V i 0 - ({level})) * exp (- ({decay}) * t).
Proof. intros i. level_of ({push}) (V_sum i) (loss_nonneg i). Qed.
Lemma V_stays_below : forall i, forall t, on (T i) t -> V i t <= Rmax (V i 0) ({level}).
Proof. intros i. below_level ({decay}) (V_decays i). Qed.
Lemma V_stays_near : forall i, T i = p_infty -> forall c, {level} < c ->
  exists s, forall t, s <= t -> V i t < c.
Proof. intros i. near_level ({decay}) (V i) (V_decays i). Qed."""
SPENT = """\
Lemma spent : forall i, forall L P, follows (T i) L (loss i) ->
  follows (T i) P (fun t => {push}) ->
  forall t, on (T i) t -> L t - L 0 <= V i 0 + (P t - P 0).
Proof. intros i. mean_of (V_sum i) (V_nonneg i) (loss_nonneg i). Qed."""
BOX = """\
Lemma bounded_r_{name} : forall i, bounded (T i) (r_{name} i).
Proof. intros i. exact (bounded_between _ _ _ _ (B_{name} i)). Qed.
Lemma above_r_{name} : forall i, forall t, on (T i) t -> 0 <= {}.
Proof. intros i. between_of (B_{name} i). Qed.
Lemma below_r_{name} : forall i, forall t, on (T i) t -> 0 <= {}.
Proof. intros i. between_of (B_{name} i). Qed."""
NEAR = """\
Definition near (d : R) (i : run) := {near}.
Definition now (i : run) (t : R) := on (T i) t.
Lemma near_le d e i : d <= e -> near d i -> near e i.
Proof. near_of near. Qed.
#[local] Hint Resolve near_le : clpt.
#[local] Hint Extern 1 (small run near now _) => solve [start_of near] : clpt.
Lemma small_V : small run near now (fun i t => V i 0).
Proof. small_V_of near_le V_parts (fun i (t : R) => {V}). Qed."""


def name_in_coq(name: str) -> tuple[str, list[str]]:
    """Return the name of a signal or a parameter in Coq, and its indices along axes of N."""
    plain = in_ascii(name)
    if not NAME(plain):
        raise DiagramError(f"{name}: is no name in Coq. Use letters, digits and _")
    base, *indices = re.findall(r"[^\[\],]+", plain)
    fixed = "".join(f"'{index}" for index in indices if index.isdigit())
    text = base.replace(":", "''").replace(".", "'")
    return f"r_{text}{fixed}", [index for index in indices if not index.isdigit()]


def sign_before(s: Any) -> str:
    """Return the sign that a symbol is assumed to have, as text before it."""
    if s.is_positive or s.is_negative:
        return "0 <" if s.is_positive else "0 >"
    return "0 <=" if s.is_nonnegative else ""


def without_signs(text: str) -> str:
    """Return a text without signs of comments and strings of Coq."""
    return text.replace("*)", "* )").replace("(*", "( *").replace('"', "'")


class CoqPrinter(StrPrinter):
    """Printer of expressions; signals, which depend on time, have the argument `at`."""

    printmethod = "_coq"  # no method of expressions: all methods are here

    def __init__(self, signals: Iterable[Any], at: str = "t"):
        super().__init__()
        self.at = at
        self.signals = {name_in_coq(symbol.name)[0] for symbol in signals}

    def _print(self, expression: Any, **options: Any) -> str:
        if isinstance(expression, KNOWN):
            return super()._print(expression, **options)
        self._refuse(expression)

    def _refuse(self, expression: Any) -> NoReturn:
        known = ", ".join(["sqrt", *FUNCTIONS])
        raise DiagramError(
            f"{expression}: has no form in Coq here. Use sums, products, whole powers, {known}"
        )

    def _print_Symbol(self, symbol: Any) -> str:
        if symbol.name == "t":
            return "t"
        name, indices = name_in_coq(symbol.name)
        words = [name, *indices, *[self.at][: name in self.signals]]
        return f"({' '.join(words)})" if words[1:] else name

    _print_Dummy = _print_Symbol

    def _print_SUM(self, atom: Any) -> str:
        summand, index, size = atom.args
        if size.name != "N":
            raise DiagramError(f"{size}: is a size beside N. Give its number")
        return f"(sum N (fun {index.name} => {self._print(summand)}))"

    def _print_Function(self, call: Any) -> str:
        if call.func.__name__ not in FUNCTIONS:
            self._refuse(call)
        arguments = "".join(f" ({self._print(argument)})" for argument in call.args)
        return f"({FUNCTIONS[call.func.__name__]}{arguments})"

    def _print_Pow(self, power: Any, rational: bool = False) -> str:
        is_whole = power.exp.is_Integer and power.exp.is_positive
        if is_whole or power.exp in (-1, S.Half, -S.Half):
            return super()._print_Pow(power).replace("**", "^")
        if power.exp.is_Integer:
            return f"(1/({self._print(1 / power)}))"
        self._refuse(power)
