"""Checker of the certificates that `clpt prove --certificates` writes.

    python check_certificate.py FILE...

It imports the Python standard library alone and computes in exact rational numbers.  One line is
printed for each file; the exit status is 1 if a file is rejected.  V' follows from V and the rates
by the chain rule, and a certificate is valid only if

    V' + decay V + losses - push = 0

V and the losses are sums of weight b^T M b with weight >= 0, M >= 0 and b a list of polynomials.
A polynomial is a list of [coefficient, {symbol: power}].  The format: docs/certificates.md.
"""

import json
import sys
from fractions import Fraction

FORMAT = "clpt certificate 1"
ABOUT = ("goes to zero", "square-integrable", "bounded in the mean")  # some of the losses' forms


def need(holds, problem):
    """Reject a certificate unless a condition holds."""
    if not holds:
        raise ValueError(problem)


def add(p, q, factor=1):
    """Return p + factor q, as {monomial: coefficient}; a monomial is ((symbol, power), ...)."""
    sums = {m: p.get(m, 0) + factor * q.get(m, 0) for m in {**p, **q}}
    return {m: c for m, c in sums.items() if c}


def multiply(p, q):
    """Return p q."""
    product = {}
    for a, c in p.items():
        for b, d in q.items():
            powers = dict(a)
            for s, n in b:
                powers[s] = powers.get(s, 0) + n
            m = tuple(sorted((s, n) for s, n in powers.items() if n))
            product = add(product, {m: c * d})
    return product


def along(p, rates):
    """Return the sum of dp/ds rates[s]: the time derivative of p."""
    total = {}
    for m, c in p.items():
        for s, n in m:
            slope = multiply({m: c * n}, {((s, -1),): 1})
            total = add(total, multiply(slope, rates.get(s, {})))
    return total


def replace(p, values):
    """Return p with polynomials in place of symbols."""
    total = {}
    for m, c in p.items():
        term = {(): c}
        for s, n in m:
            base = values.get(s, {((s, 1 if n > 0 else -1),): 1})
            for _ in range(abs(n)):
                term = multiply(term, base)
        total = add(total, term)
    return total


def names(p):
    """Return the symbols of a polynomial."""
    return {s for m in p for s, _ in m}


def at_zero(p):
    """Return a polynomial where the bounded forms #k are 0."""
    return {m: c for m, c in p.items() if not any("#" in s for s, _ in m)}


def is_definite(M):
    """Return whether D > 0 in M = L D L^T; reject a matrix with a negative D."""
    M, size = [list(map(Fraction, row)) for row in M], range(len(M))
    need(all(M[i][j] == M[j][i] for i in size for j in size), "a matrix is not symmetric")
    for k in size:
        need(M[k][k] > 0 or not any(M[k][k:]), "a matrix is not semidefinite")
        for i in size[k + 1 :] if M[k][k] else ():
            share = M[i][k] / M[k][k]
            M[i] = [a - share * b for a, b in zip(M[i], M[k])]
    return all(M[k][k] > 0 for k in size)


class Certificate:
    """Equations and assumptions of a certificate, and what follows from them."""

    def __init__(self, data):
        need(data["format"] == FORMAT, f"its format is not '{FORMAT}'")
        kinds = "rates", "positive", "constants", "inputs", "positive_inputs", "signals"
        symbols = [s for kind in kinds for s in data[kind]]
        need(len({*symbols}) == len(symbols), "a symbol is declared twice")
        need(not any("#" in s for s in symbols), "a symbol has a # in its name")
        self.symbols, self.states = {*symbols}, {*data["rates"]}
        self.positive, self.signals = {*data["positive"]}, {*data["signals"]}
        self.factors = self.positive | {*data["positive_inputs"]}
        self.constants = self.positive | {*data["constants"]}
        self.known = self.constants | self.factors | {*data["inputs"]}
        self.assumed = [self.read(p) for p in data["assumed"]]
        self.semidefinite = data["semidefinite"]
        self.rates = {s: self.read(p) for s, p in data["rates"].items()}
        V, self.forms = self.terms(data["V"])
        need(names(V) <= self.states | self.constants, "V holds a function of time")
        losses, self.lost = self.terms(data["losses"])
        decay, self.is_pulled = self.weight(data["decay"]) if data["decay"] else ({}, False)
        self.push = self.read(data["push"])
        left = add(add(along(V, self.rates), multiply(decay, V)), add(losses, self.push, -1))
        need(not left, "V' + decay V + losses - push is not 0")

    def read(self, terms):
        """Read a polynomial; only positive constants have negative powers."""
        p = {}
        for c, powers in terms:
            for s, n in powers.items():
                need(s in self.symbols, f"{s} is not declared")
                need(type(n) is int and (n > 0 or s in self.positive), f"{s} has the power {n}")
            m = tuple(sorted((s, n) for s, n in powers.items() if n))
            p = add(p, {m: Fraction(c)})
        return p

    def weight(self, factors):
        """Return a product that is not negative, and whether it is a positive constant."""
        product, is_constant = {(): Fraction(1)}, True
        for p in map(self.read, factors):
            is_positive = p and names(p) <= self.factors and all(c > 0 for c in p.values())
            need(is_positive or p in self.assumed, "a weight is not known to be positive")
            is_constant = is_constant and is_positive and names(p) <= self.positive
            product = multiply(product, p)
        return product, is_constant

    def terms(self, data):
        """Return a sum of terms, and the forms that are bounded where the sum is bounded."""
        total, forms = {}, []
        for term in data:
            weight, is_definite_term = self.weight(term["weight"])
            M, basis = term["matrix"], [self.read(p) for p in term["basis"]]
            if isinstance(M, str):
                M, is_definite_term = self.semidefinite[M], False
                need(all(M[i][j] == M[j][i] for i in range(len(M)) for j in range(len(M))), "a matrix is not symmetric")
                M = [[{((s, 1),): 1} for s in row] for row in M]
            else:
                is_definite_term = is_definite(M) and is_definite_term
                M = [[{(): Fraction(c)} for c in row] for row in M]
            need(len(M) == len(basis) and {len(row) for row in M} == {len(M)}, "a matrix does not fit")
            for row, p in zip(M, basis):
                for entry, q in zip(row, basis):
                    total = add(total, multiply(multiply(weight, entry), multiply(p, q)))
            forms += basis if is_definite_term else []
        return total, forms

    def determined(self, forms, known):
        """Return unknown states by what bounds them, and whether all forms can be 0 at once.

        States are eliminated one by one from form = #k, a bounded number.
        """
        values, can_vanish, left = {}, True, {f"#{k}": form for k, form in enumerate(forms)}
        while pivot := self.pivot(left, values, known):
            mark, s, value, vanishes = pivot
            del left[mark]
            values = {v: replace(p, {s: value}) for v, p in values.items()} | {s: value}
            can_vanish = can_vanish and vanishes
        return values, can_vanish and not any(at_zero(replace(p, values)) for p in left.values())

    def pivot(self, left, values, known):
        """Return a form, a state that it determines, the state's value, and whether it can be 0."""
        for mark, form in left.items():
            p, bound = replace(form, values), {((mark, 1),): Fraction(1)}
            for s in sorted(names(p) & self.states - known):
                own = {m: c for m, c in p.items() if s in dict(m)}
                rest = add(p, own, -1)
                if len(own) > 1 or not names(own) - {s} <= self.positive:
                    continue
                [(m, c)] = own.items()
                if dict(m)[s] == 1:  # s = (#k - rest)/factor
                    share = {tuple((v, -n) for v, n in m if v != s): 1 / c}
                    return mark, s, multiply(add(bound, rest, -1), share), True
                if not names(rest) & self.states - known:  # c s^n + what is bounded
                    return mark, s, bound, not at_zero(rest)
        return None

    def bounded(self):
        """Return the states that are bounded: by V, or stable and driven by what is bounded."""
        known, before = set(), None
        while known != before:
            before = {*known}
            values, _ = self.determined(self.forms, known)
            known |= {s for s, p in values.items() if not names(p) & self.states - known}
            for s in self.states - known:
                own = {m: c for m, c in self.rates[s].items() if s in dict(m)}
                pulls = all(c < 0 and dict(m)[s] == 1 for m, c in own.items())
                is_linear = own and pulls and names(own) - {s} <= self.positive
                if is_linear and names(add(self.rates[s], own, -1)) <= known | self.known:
                    known.add(s)
        return known

    def conclusions(self):
        """Return each conclusion that holds, and the forms that it is true of."""
        bounded = self.bounded()
        free = self.states - bounded
        degrees = [sum(n for s, n in m if s in free) for f in free for m in self.rates[f]]
        exist, falls = max(degrees, default=0) <= 1, not self.push
        found = {"V' is at most the push": []}
        if falls:
            found |= {"V does not increase": [], "square-integrable": self.lost}
        elif exist and names(self.push) <= self.known | self.signals:
            found["bounded in the mean"] = self.lost
        if exist and self.is_pulled and names(self.push) <= self.known:
            found["ultimately bounded"] = []
        if falls and exist:
            calm = self.known | bounded
            fixed = self.states | self.constants
            found["goes to zero"] = [
                q for q in self.lost if names(q) <= fixed and names(along(q, self.rates)) <= calm
            ]
            rest, has_rest = self.determined(self.forms, set())
            ends, has_end = self.determined(self.lost, set())
            if has_rest and rest.keys() == self.states and not self.signals:
                found["stable"] = []
                points = [{s: at_zero(p) for s, p in v.items()} for v in (rest, ends)]
                if has_end and points[0] == points[1]:
                    found["asymptotically stable"] = []
        return found


def checked(data):
    """Return what is shown by a certificate, or by each of a list; raise ValueError if nothing is."""
    if isinstance(data, list):
        need(data, "it is empty")
        return " | ".join(map(checked, data))
    certificate = Certificate(data)
    found, claim = certificate.conclusions(), data["conclusion"]
    need(claim in found, f"'{claim}' does not follow")
    about = [certificate.read(p) for p in data["of"]]
    need(all(p in found[claim] for p in about), f"'{claim}' does not follow of each form")
    need(about or claim not in ABOUT, f"'{claim}' is said of nothing")
    return ", ".join([claim, *map(str, data["conditions"])])


def main(paths):
    """Print a line for each file; return the exit status."""
    failed = not paths
    for path in paths:
        try:
            with open(path, encoding="utf-8") as file:
                print(f"{path}: checked: {checked(json.load(file))}")
        except Exception as error:  # whatever a file holds, it is rejected in one line
            failed = True
            known = isinstance(error, (ValueError, OSError))
            print(f"{path}: rejected: {error if known else f'malformed: {error!r}'}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
