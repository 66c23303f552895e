"""Certificates as data: polynomials with rational coefficients, which the checker reads.

    V' + decay V + losses - push = 0,    V and losses sums of weight b^T M b

`clpt_control/data/check_certificate.py` is the checker; docs/certificates.md has the format.
"""

import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import sympy
from sympy import Add, Expr, Mul, Pow, S
from sympy.core.function import AppliedUndef

from ...data import check_certificate as checker
from ...engine.diagram.symbol_names import TIME
from ..algebra.sums_of_squares import squares
from ..algebra.texts import short

SHOWN = {  # by a certificate with a conclusion, the strongest first: names of `REQUIREMENTS`
    "asymptotically stable": "definite all falls loses rest limit exists",
    "goes to zero": "definite falls loses limit exists",
    "ultimately bounded": "definite pulled exists",
    "stable": "definite all falls exists",
    "bounded in the mean": "definite mean exists",
    "square-integrable": "definite falls loses",
    "V does not increase": "definite falls",
    "V' is at most the push": "",
}
NOTHING_PROVED = "nothing is proved of V'"
CHECKED = ("N", "bounded inputs", "outside V", "outside V, bounded", "signs")


class NoCertificate(Exception):
    """A proof has no certificate; the message is the reason."""


class Term(NamedTuple):
    """A term weight factor b^T M b."""

    weight: Expr  # positive
    basis: Sequence[Expr]
    matrix: Any = ((1,),)  # M >= 0: numbers, or a name of `Case.semidefinite`
    factor: Expr = S.One  # not negative, by assumption

    def times(self, other: "Term") -> "Term":
        """Return the product of two terms, one of them with a basis of one element."""
        longer = max(self, other, key=lambda term: len(term.basis))
        basis = [a * b for a in self.basis for b in other.basis]
        return Term(
            self.weight * other.weight, basis, longer.matrix, self.factor * other.factor
        )


@dataclass
class Case:
    """Equations with V, and V' as a sum."""

    motion: dict[Any, Expr]
    fixed: set  # symbols of parameters
    V: list[Term]
    losses: list[Term]
    push: Expr = S.Zero
    decay: Expr = S.Zero
    semidefinite: Mapping[str, Any] = field(default_factory=dict)  # matrices of symbols
    functions: dict[Any, str] = field(default_factory=dict)  # of time -> kind
    conditions: list[str] = field(default_factory=list)

    def certificate(self) -> dict:
        """Return the certificate, with the strongest conclusion that the checker derives."""
        self.names, self.divisors = dict[Any, str](), dict[Expr, Any]()
        below = [s for s in self.fixed if s.is_negative]
        above = {s: sympy.Symbol(f"minus_{s}", positive=True) for s in below}
        self.turned = {s: -minus for s, minus in above.items()}
        self.fixed = self.fixed | {*above.values()}
        factors = [t.factor for t in (*self.V, *self.losses) if t.factor != 1]
        used = {t.matrix for t in (*self.V, *self.losses) if isinstance(t.matrix, str)}
        data = {
            "format": checker.FORMAT,
            "V": [*map(self.term, self.V)],
            "losses": [*map(self.term, self.losses)],
            "push": self.polynomial(self.push),
            "decay": [self.polynomial(self.decay)] if self.decay else [],
            "assumed": [*map(self.polynomial, dict.fromkeys(factors))],
            "semidefinite": {
                name: [
                    [*map(self.name, row)] for row in self.semidefinite[name].tolist()
                ]
                for name in sorted(used)
            },
        }
        data["rates"] = self.rates()
        kinds = {name: self.kind(atom) for atom, name in self.names.items()}
        for kind in checker.KINDS[1:]:
            data[kind] = [name for name, k in kinds.items() if k == kind]
        divisors = [
            f"{self.names[r]} = 1/({short(e)})" for e, r in self.divisors.items()
        ]
        turned = [f"{name} = -{s}" for s in below if (name := self.names.get(above[s]))]
        conditions = [*self.conditions, *divisors, *sorted(turned)]
        data["conditions"] = [ascii(condition)[1:-1] for condition in conditions]
        return strongest(data | {"conclusion": "V' is at most the push", "of": []})

    def rates(self) -> dict[str, list]:
        """Return the rates of states; an unknown rate of a state outside V is not written."""
        rates, in_V = {}, {*self.names}
        for s in [s for s in self.motion if s not in self.functions]:
            try:
                rates[s] = self.polynomial(self.motion[s])
            except NoCertificate:
                if s in in_V:
                    raise
                self.functions[s] = "signals"
        return {self.name(s): rate for s, rate in rates.items()}

    def term(self, term: Term) -> dict:
        """Return a term in JSON."""
        weights = [w for w in (term.weight, term.factor) if w != 1]
        is_name = isinstance(term.matrix, str)
        return {
            "weight": [*map(self.polynomial, weights)],
            "basis": [*map(self.polynomial, term.basis)],
            "matrix": term.matrix
            if is_name
            else [[*map(str, row)] for row in term.matrix],
        }

    def name(self, atom: Any) -> str:
        """Return the name of a symbol; no two symbols have the same."""
        if atom not in self.names:
            text = str(atom.func if isinstance(atom, AppliedUndef) else atom)
            text = ascii(text.lstrip("_").replace("/", "."))
            text = re.sub(r"[^\w.:\[\]]", "", text)
            text = text if checker.is_name(text) else f"s{text}"
            while text in self.names.values():
                text += "'"
            self.names[atom] = text
        return self.names[atom]

    def kind(self, atom: Any) -> str:
        """Return the kind of a symbol."""
        kinds = {**dict.fromkeys(self.motion, "rates"), **self.functions}
        of_parameter = "positive" if atom.is_positive else "constants"
        of_time = "inputs" if isinstance(atom, AppliedUndef) else "signals"
        return kinds.get(atom, of_parameter if atom in self.fixed else of_time)

    def polynomial(self, expression: Any) -> list:
        """Return an expression as a list of [coefficient, {symbol: power}]."""
        expression = sympy.sympify(expression).xreplace(self.turned)
        powers = [p for p in expression.atoms(Pow) if p.exp.is_negative]
        divisors = {p: self.reciprocal(p.base) ** -p.exp for p in powers}
        terms = []
        for term in Add.make_args(sympy.expand(expression.xreplace(divisors))):
            coefficient, product = term.as_coeff_Mul()
            factors = [f.as_base_exp() for f in Mul.make_args(product) if f != 1]
            for base, power in factors:
                is_symbol = (base.is_Symbol and base != TIME) or base.args == (TIME,)
                if not (is_symbol and power.is_Integer and coefficient.is_Rational):
                    raise NoCertificate(f"{short(base**power)} is no polynomial")
            powers_of = {self.name(base): int(power) for base, power in factors}
            terms += [[str(coefficient), powers_of]] if coefficient else []
        return terms

    def reciprocal(self, base: Expr) -> Expr:
        """Return 1/base; of what is no positive parameter it is a positive function of time."""
        if base in self.fixed and base.is_positive:
            return 1 / base
        total = squares(base, self.fixed) if base.is_Add else None
        is_masked = base.is_Symbol and base not in self.motion and base.is_positive
        if not is_masked and not (total and total.constant.is_positive):
            raise NoCertificate(
                f"{short(base)} divides, and is not known to be positive"
            )
        r = self.divisors.setdefault(base, sympy.Dummy(f"r_{len(self.divisors) + 1}"))
        self.functions[r] = "positive_inputs"
        return r


def strongest(data: dict) -> dict:
    """Return a certificate with the strongest conclusion that the checker derives from it."""
    try:
        certificate = checker.Certificate(data)
        conclusions = certificate.conclusions()
        forms = [p for term in data["losses"] for p in term["basis"]]
        about = {
            name: [p for p in forms if certificate.read(p) in stated]
            for name, stated in conclusions.items()
        }
        claims = (
            c
            for c in SHOWN
            if c in conclusions and (about[c] or c not in checker.ABOUT)
        )
        conclusion = next(claims)
        data = data | {"conclusion": conclusion, "of": about[conclusion]}
        for s in sorted(certificate.states - certificate.in_V):
            data = without_rate(data, s)
        checker.checked(json.dumps(data))
    except ValueError as error:
        raise NoCertificate(f"{error}") from None
    return data


def without_rate(data: dict, s: str) -> dict:
    """Return a certificate without the rate of a state, unless its conclusion needs the rate."""
    rates = {name: rate for name, rate in data["rates"].items() if name != s}
    less = data | {"rates": rates, "signals": [*data["signals"], s]}
    certificate = checker.Certificate(less)
    conclusions, of = certificate.conclusions(), map(certificate.read, data["of"])
    claim = data["conclusion"]
    if claim not in conclusions or not all(p in conclusions[claim] for p in of):
        return data
    kinds = checker.KINDS[1:]
    return less | {k: [v for v in less[k] if v in certificate.used] for k in kinds}


def written(
    ways: Iterable[Callable[[], Case]], conditions: Iterable[Any]
) -> tuple[dict | None, str]:
    """Return the first certificate of several ways to write V', or the first way's failure."""
    reasons = [NOTHING_PROVED]
    for make_case in ways:
        try:
            case = make_case()
            case.conditions += [f"{c}" for c in conditions if c.name not in CHECKED]
            return case.certificate(), ""
        except NoCertificate as reason:
            reasons.insert(-1, f"{reason}")
    return None, reasons[0]
