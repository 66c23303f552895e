"""Checker of the certificates that `clpt prove --certificates FOLDER` writes.

    python check_certificate.py FILE...

It needs the Python standard library alone and computes in exact rational numbers.  One line is
printed for each file; the exit status is 1 if a file is rejected.  V' is computed from V and the
rates by the chain rule, and a certificate holds only if

    V' + decay V + losses - push = 0

V and the losses are sums of weight b^T M b with weight >= 0, M >= 0 and a list b of polynomials.  A
polynomial is a list of [coefficient, {symbol: power}].  docs/certificates.md has the format.
"""

import json
import sys
from fractions import Fraction
from pathlib import Path

FORMAT = "clpt certificate 1"
ABOUT = ("goes to zero", "square-integrable", "bounded in the mean")  # forms of losses
KINDS = ("rates", "positive", "constants", "inputs", "positive_inputs", "signals")


def need(holds, problem):
    """Reject a certificate unless a condition holds."""
    if not holds:
        raise ValueError(problem)


# --- polynomials: {((symbol, power), ...): coefficient} ------------------------------------------


def combined(pairs):
    """Return the sum of coefficients of equal monomials."""
    p: dict = {}
    for m, c in pairs:
        p[m] = p.get(m, 0) + c
    return {m: c for m, c in p.items() if c}


def add(p, q, factor=1):
    """Return p + factor q."""
    return combined([*p.items(), *((m, factor * c) for m, c in q.items())])


def monomial(*factors):
    """Return a product of powers."""
    powers = combined(factors)
    return tuple(sorted(powers.items()))


def multiply(p, q):
    """Return p q."""
    return combined(
        (monomial(*a, *b), c * d) for a, c in p.items() for b, d in q.items()
    )


def along(p, rates):
    """Return p', the sum of dp/ds rates[s]."""
    terms = [(monomial(*m, (s, -1)), c * n, s) for m, c in p.items() for s, n in m]
    products = (multiply({m: c}, rates.get(s, {})) for m, c, s in terms)
    return combined(term for product in products for term in product.items())


def replace(p, s, value):
    """Return p with a polynomial in place of a symbol."""
    total: dict = {}
    for m, c in p.items():
        term = {tuple(f for f in m if f[0] != s): c}
        for _ in range(dict(m).get(s, 0)):
            term = multiply(term, value)
        total = add(total, term)
    return total


def names(*polynomials):
    """Return the symbols of polynomials."""
    return {s for p in polynomials for m in p for s, _ in m}


def at_zero(p):
    """Return p where the bounded forms #k are 0."""
    return {m: c for m, c in p.items() if not any("#" in s for s, _ in m)}


def text(p):
    """Return a polynomial as text."""
    terms = ((c, [s if n == 1 else f"{s}^{n}" for s, n in m]) for m, c in p.items())
    products = ["*".join([f"{c}"] * (c != 1 or not f) + f) for c, f in terms]
    return " + ".join(products).replace("-1*", "-").replace("+ -", "- ")


def is_definite(M):
    """Return whether D > 0 in M = L D L^T; reject a matrix with a negative D."""
    M, size = [list(map(Fraction, row)) for row in M], range(len(M))
    need(
        all(M[i][j] == M[j][i] for i in size for j in size), "a matrix is not symmetric"
    )
    for k in size:
        need(M[k][k] > 0 or not any(M[k][k:]), "a matrix is not semidefinite")
        for i in size[k + 1 :] if M[k][k] else ():
            share = M[i][k] / M[k][k]
            M[i] = [a - share * b for a, b in zip(M[i], M[k], strict=True)]
    return all(M[k][k] > 0 for k in size)


# --- certificates --------------------------------------------------------------------------------


class Certificate:
    """Equations and assumptions of a certificate; it holds if it can be made."""

    def __init__(self, data):
        need(data["format"] == FORMAT, f"its format is not '{FORMAT}'")
        self.symbols = [s for kind in KINDS for s in data[kind]]
        need(len({*self.symbols}) == len(self.symbols), "a symbol is declared twice")
        need("#" not in "".join(self.symbols), "a symbol has a # in its name")
        self.states, self.positive, constants, inputs, factors, signals = (
            {*data[kind]} for kind in KINDS
        )
        self.fixed, self.factors = self.positive | constants, self.positive | factors
        self.bounded, self.signals = self.fixed | inputs | factors, signals
        self.matrices = {
            name: self.matrix(M) for name, M in data["semidefinite"].items()
        }
        self.assumed = [*map(self.read, data["assumed"])]
        self.rates = {s: self.read(p) for s, p in data["rates"].items()}
        V, self.forms = self.terms(data["V"])
        need(names(V) <= self.states | self.fixed, "V holds a function of time")
        losses, self.lost = self.terms(data["losses"])
        self.push, self.decay = self.read(data["push"]), {}
        if data["decay"]:
            self.decay, pulls = self.weight(data["decay"])
            need(pulls, "the decay is not known to be positive")
        left = add(along(V, self.rates), multiply(self.decay, V))
        left = add(add(left, losses), self.push, -1)
        need(not left, "V' + decay V + losses - push is not 0")

    def read(self, terms):
        """Read a polynomial; only positive constants have negative powers."""
        for _, powers in terms:
            for s, n in powers.items():
                need(s in self.symbols, f"{s} is not declared")
                need(
                    type(n) is int and (n > 0 or s in self.positive),
                    f"{s} has the power {n}",
                )
        return combined((monomial(*powers.items()), Fraction(c)) for c, powers in terms)

    def matrix(self, rows):
        """Read a symmetric matrix of symbols."""
        columns = [[*column] for column in zip(*rows, strict=True)]
        need(rows == columns, "a matrix is not symmetric")
        return [[self.read([[1, {s: 1}]]) for s in row] for row in rows]

    def weight(self, factors):
        """Return a product that is not negative, and whether it is a positive constant."""
        product, is_constant = {(): Fraction(1)}, True
        for p in map(self.read, factors):
            is_positive = p and names(p) <= self.factors and min(p.values()) > 0
            need(is_positive or p in self.assumed, f"weight {text(p)} may be negative")
            is_constant = is_constant and is_positive and names(p) <= self.positive
            product = multiply(product, p)
        return product, is_constant

    def terms(self, data):
        """Return a sum of terms, and the forms that are bounded where the sum is bounded."""
        total: dict = {}
        forms: list = []
        for term in data:
            weight, is_strict = self.weight(term["weight"])
            M, basis = term["matrix"], [*map(self.read, term["basis"])]
            if isinstance(M, str):
                M, is_strict = self.matrices[M], False
            else:
                is_strict = is_definite(M) and is_strict
                M = [[{(): Fraction(c)} for c in row] for row in M]
            need(
                {len(M), *map(len, M)} == {len(basis)},
                "a matrix does not fit its basis",
            )
            for row, p in zip(M, basis, strict=True):
                for entry, q in zip(row, basis, strict=True):
                    total = add(
                        total, multiply(multiply(weight, entry), multiply(p, q))
                    )
            forms += basis if is_strict else []
        return total, forms

    # --- conclusions -----------------------------------------------------------------------------

    def determined(self, forms, known):
        """Return unknown states as polynomials in the forms #k, and whether all can be 0.

        States are eliminated one by one.
        """
        values: dict = {}
        can_vanish, left = True, {f"#{k}": p for k, p in enumerate(forms)}
        while pivot := self.pivot(left, known):
            mark, s, value, vanishes = pivot
            del left[mark]
            left, values = (
                {k: replace(p, s, value) for k, p in old.items()}
                for old in (left, values)
            )
            values[s], can_vanish = value, can_vanish and vanishes
        return values, can_vanish and not any(map(at_zero, left.values()))

    def pivot(self, left, known):
        """Return a form, a state that it determines, the state's value, and whether it can be 0."""
        for mark, p in left.items():
            for s in sorted(names(p) & self.states - known):
                own = {m: c for m, c in p.items() if s in dict(m)}
                rest, (m, c) = add(p, own, -1), next(iter(own.items()))
                bound = {((mark, 1),): Fraction(1)}
                if len(own) > 1 or not names(own) - {s} <= self.positive:
                    continue
                if dict(m)[s] == 1:  # s = (#k - rest)/factor
                    share = {monomial(*((v, -n) for v, n in m if v != s)): 1 / c}
                    return mark, s, multiply(add(bound, rest, -1), share), True
                if not names(rest) & self.states - known:  # c s^n + what is bounded
                    return mark, s, bound, not at_zero(rest)
        return None

    def bounded_states(self):
        """Return the states that are bounded: by V, or stable and driven by what is bounded."""
        known: set = set()
        before = None
        while known != before:
            before = {*known}
            values, _ = self.determined(self.forms, known)
            known |= {
                s for s, p in values.items() if not names(p) & self.states - known
            }
            for s in self.states - known:
                own = {m: c for m, c in self.rates[s].items() if s in dict(m)}
                pulls = own and all(c < 0 and dict(m)[s] == 1 for m, c in own.items())
                rest = names(add(self.rates[s], own, -1))
                if (
                    pulls
                    and names(own) - {s} <= self.positive
                    and rest <= known | self.bounded
                ):
                    known.add(s)
        return known

    def conclusions(self):
        """Return each conclusion that holds, and the forms that it is true of."""
        known = self.bounded_states()
        of_states = [q for q in self.lost if names(q) <= self.states | self.fixed]
        free, falls = self.states - known, not self.push
        degrees = [
            sum(n for s, n in m if s in free) for f in free for m in self.rates[f]
        ]
        exist = max(degrees, default=0) <= 1
        found: dict = {"V' is at most the push": []}
        if falls:
            found |= {"V does not increase": [], "square-integrable": of_states}
        elif exist and names(self.push) <= self.bounded | self.signals:
            found["bounded in the mean"] = of_states
        if exist and self.decay and names(self.push) <= self.bounded:
            found["ultimately bounded"] = []
        if exist and falls:
            found["goes to zero"] = [q for q in of_states if self.is_calm(q, known)]
            (rest, has_rest), (end, has_end) = (
                self.determined(forms, set()) for forms in (self.forms, self.lost)
            )
            if has_rest and rest.keys() == self.states and not self.signals:
                found["stable"] = []
                points = [{s: at_zero(p) for s, p in v.items()} for v in (rest, end)]
                if has_end and points[0] == points[1]:
                    found["asymptotically stable"] = []
        return found

    def is_calm(self, form, known):
        """Return whether a form has a bounded rate, so that it goes to zero (Barbalat)."""
        return names(along(form, self.rates)) <= known | self.bounded

    def assumptions(self):
        """Return the assumptions as texts."""
        lists = [
            (self.positive, "> 0"),
            (self.bounded - self.fixed, "bounded"),
            (self.signals, "any functions of time"),
            (self.matrices, ">= 0"),
            (map(text, self.assumed), ">= 0"),
        ]
        listed = [(", ".join(sorted(items)), of) for items, of in lists]
        return [f"{items} {of}" for items, of in listed if items]


def checked(data):
    """Return what a certificate shows, or each of a list; raise ValueError if it is rejected."""
    if isinstance(data, list):
        need(data, "it is empty")
        return " | ".join(map(checked, data))
    certificate = Certificate(data)
    found, claim = certificate.conclusions(), data["conclusion"]
    need(claim in found, f"'{claim}' does not follow")
    of = [certificate.read(p) for p in data["of"]]
    need(all(p in found[claim] for p in of), f"'{claim}' does not follow of each form")
    need(of or claim not in ABOUT, f"'{claim}' is said of nothing")
    shown = f"{claim} ({', '.join(map(text, of))})" if of else claim
    return "; ".join([shown, *map(str, data["conditions"]), *certificate.assumptions()])


def main(paths):
    """Print a line for each file; return the exit status."""
    failed = not paths
    for path in paths:
        try:
            data = json.loads(Path(path).read_text("utf-8"))
            print(f"{path}: checked: {checked(data)}")
        except Exception as error:  # a file of any content is rejected in one line
            failed, is_known = True, isinstance(error, (ValueError, OSError))
            print(f"{path}: rejected: {error if is_known else f'malformed: {error!r}'}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
