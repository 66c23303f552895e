"""Checker of the certificates that `clpt prove --certificates FOLDER` writes.

    python check_certificate.py [-v] FILE...

It needs the Python standard library alone and computes in exact rational numbers.  One line is
printed for each file, and with -v its equations; the exit status is 1 if a file is rejected.  V' is
computed from V and the rates by the chain rule, and a certificate holds only if

    V' + decay V + losses - push = 0

V and the losses are sums of weight b^T M b with weight >= 0, M >= 0 and a list b of polynomials.  A
polynomial is a list of [coefficient, {symbol: power}].  docs/certificates.md has the format.
"""

import json
import math
import random
import re
import sys
from fractions import Fraction
from pathlib import Path

FORMAT = "clpt certificate 1"
ABOUT = ("goes to zero", "square-integrable", "bounded in the mean")  # forms of losses
KINDS = ("rates", "positive", "constants", "inputs", "positive_inputs", "signals")
TRIALS = 3000  # points at which the assumptions are tried
SIZES = [Fraction(10) ** n for n in range(-4, 4)]  # of symbols at these points


def need(holds, problem):
    """Reject a certificate unless a condition holds."""
    if not holds:
        raise ValueError(problem)


# --- format --------------------------------------------------------------------------------------


def text_like(pattern):
    """Return a test of texts."""
    return lambda value: isinstance(value, str) and re.fullmatch(pattern, value)


def list_of(is_element, least=0):
    """Return a test of lists."""
    return lambda value: (
        isinstance(value, list) and len(value) >= least and all(map(is_element, value))
    )


def map_of(is_value):
    """Return a test of objects that have a value for each name."""
    return lambda value: (
        isinstance(value, dict)
        and all(is_name(k) and is_value(v) for k, v in value.items())
    )


def is_power(value):
    """Return whether a value is a small integer other than 0."""
    return type(value) is int and 0 < abs(value) < 100


def is_monomial(value):
    """Return whether a value is [coefficient, {symbol: power}]."""
    is_pair = isinstance(value, list) and len(value) == 2
    return is_pair and is_number(value[0]) and is_powers(value[1])


def is_term(value):
    """Return whether a value is weight b^T M b."""
    return (
        isinstance(value, dict)
        and value.keys() == {"weight", "basis", "matrix"}
        and are_polynomials(value["weight"])
        and list_of(is_polynomial, 1)(value["basis"])
        and (is_name(value["matrix"]) or is_matrix(value["matrix"]))
    )


is_name = text_like(r"[A-Za-z_][A-Za-z0-9_.:\[\]']*")
is_number = text_like("-?[0-9]{1,4300}(/[0-9]{1,4300})?")
is_matrix = list_of(list_of(is_number))
is_powers = map_of(is_power)
is_polynomial = list_of(is_monomial)
are_polynomials = list_of(is_polynomial)
FIELDS = {
    "format": text_like(FORMAT),
    "rates": map_of(is_polynomial),
    **dict.fromkeys(KINDS[1:], list_of(is_name)),
    "V": list_of(is_term),
    "losses": list_of(is_term),
    "push": is_polynomial,
    "decay": are_polynomials,
    "semidefinite": map_of(list_of(list_of(is_name))),
    "assumed": are_polynomials,
    "conclusion": text_like("[ -~]+"),
    "of": are_polynomials,
    "conditions": list_of(text_like("[ -~]{1,1000}")),
}


def read_json(content):
    """Return the data of a text; reject a key that is given twice, and decimal numbers."""

    def without_twins(pairs):
        need(len({k for k, _ in pairs}) == len(pairs), "a key is given twice")
        return dict(pairs)

    def reject(number):
        raise ValueError(f"{number} is no integer")

    need(isinstance(content, str), "the text of the file is needed")
    return json.loads(
        content,
        object_pairs_hook=without_twins,
        parse_float=reject,
        parse_constant=reject,
    )


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
    products = [
        "-" * (c < 0) + "*".join([f"{abs(c)}"] * (abs(c) != 1 or not f) + f)
        for c, f in terms
    ]
    return " + ".join(products).replace("+ -", "- ") or "0"


def bracketed(texts):
    """Return texts as a list in brackets."""
    return f"[{', '.join(texts)}]"


def value_at(point, p):
    """Return the value of a polynomial."""
    return sum(c * math.prod(point[s] ** n for s, n in m) for m, c in p.items())


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
        need(isinstance(data, dict), "a certificate is an object")
        need(data.keys() == FIELDS.keys(), "its keys are not those of the format")
        for field, fits in FIELDS.items():
            need(fits(data[field]), f"{field} does not fit the format")
        self.symbols = [s for kind in KINDS for s in data[kind]]
        declared = [*self.symbols, *data["semidefinite"]]
        need(len({*declared}) == len(declared), "a symbol is declared twice")
        need(data["rates"], "it has no states")
        self.states, self.positive, constants, inputs, factors, signals = (
            {*data[kind]} for kind in KINDS
        )
        self.fixed, self.factors = self.positive | constants, self.positive | factors
        self.bounded, self.signals = self.fixed | inputs | factors, signals
        self.entries, self.used = data["semidefinite"], set()
        self.matrices = {name: self.matrix(M) for name, M in self.entries.items()}
        self.assumed = [*map(self.read, data["assumed"])]
        need(all(map(names, self.assumed)), "a number is assumed to be >= 0")
        self.rates = {s: self.read(p) for s, p in data["rates"].items()}
        V, self.forms = self.terms(data["V"])
        self.V, self.in_V = V, names(V) & self.states
        need(self.in_V, "no state is in V")
        in_time = names(V, *self.forms) - self.states - self.fixed
        need(not in_time, "V holds a function of time")
        losses, self.lost = self.terms(data["losses"])
        self.losses = losses
        self.push, self.decay = self.read(data["push"]), {}
        if data["decay"]:
            self.decay, pulls = self.weight(data["decay"])
            need(pulls, "the decay is not known to be positive")
        remainder = add(along(V, self.rates), multiply(self.decay, V))
        remainder = add(add(remainder, losses), self.push, -1)
        need(not remainder, "V' + decay V + losses - push is not 0")

    def read(self, terms):
        """Read a polynomial; only positive constants have negative powers."""
        for _, powers in terms:
            for s, n in powers.items():
                need(s in self.symbols, f"{s} is not declared")
                need(n > 0 or s in self.positive, f"{s} has the power {n}")
            self.used |= powers.keys()
        return combined((monomial(*powers.items()), Fraction(c)) for c, powers in terms)

    def matrix(self, rows):
        """Read a symmetric matrix of symbols; an inequality of one symbol is in `assumed`."""
        columns = [[*column] for column in zip(*rows, strict=True)]
        need(rows == columns, "a matrix is not symmetric")
        size, entries = len(rows), {s for row in rows for s in row}
        need(size > 1, "a matrix that is assumed to be >= 0 has a single entry")
        is_full = len(entries) == size * (size + 1) // 2
        need(is_full, "a matrix that is assumed to be >= 0 has equal entries")
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
                need({len(M)} == {*map(len, M)}, "a matrix is not square")
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

    def determined(self, forms, bounded):
        """Return unknown states as polynomials in the forms #k, and whether all can be 0.

        States are eliminated one by one.
        """
        values: dict = {}
        can_vanish, remaining = True, {f"#{k}": p for k, p in enumerate(forms)}
        while pivot := self.pivot(remaining, bounded):
            mark, s, value, vanishes = pivot
            del remaining[mark]
            remaining, values = (
                {k: replace(p, s, value) for k, p in old.items()}
                for old in (remaining, values)
            )
            values[s], can_vanish = value, can_vanish and vanishes
        return values, can_vanish and not any(map(at_zero, remaining.values()))

    def pivot(self, forms, bounded):
        """Return a form, a state that it determines, the state's value, and whether it can be 0."""
        for mark, p in forms.items():
            for s in sorted(names(p) & self.states - bounded):
                linear = {m: c for m, c in p.items() if s in dict(m)}
                remainder, (m, c) = add(p, linear, -1), next(iter(linear.items()))
                bound = {((mark, 1),): Fraction(1)}
                if len(linear) > 1 or not names(linear) - {s} <= self.positive:
                    continue
                if dict(m)[s] == 1:  # s = (#k - rest)/factor
                    share = {monomial(*((v, -n) for v, n in m if v != s)): 1 / c}
                    return mark, s, multiply(add(bound, remainder, -1), share), True
                if (
                    not names(remainder) & self.states - bounded
                ):  # c s^n + what is bounded
                    return mark, s, bound, not at_zero(remainder)
        return None

    def bounded_states(self):
        """Return the states that are bounded: by V, or stable and driven by what is bounded."""
        bounded: set = set()
        before = None
        while bounded != before:
            before = {*bounded}
            values, _ = self.determined(self.forms, bounded)
            bounded |= {
                s for s, p in values.items() if not names(p) & self.states - bounded
            }
            for s in self.states - bounded:
                linear = {m: c for m, c in self.rates[s].items() if s in dict(m)}
                pulls = linear and all(
                    c < 0 and dict(m)[s] == 1 for m, c in linear.items()
                )
                remainder = names(add(self.rates[s], linear, -1))
                if (
                    pulls
                    and names(linear) - {s} <= self.positive
                    and remainder <= bounded | self.bounded
                ):
                    bounded.add(s)
        return bounded

    def conclusions(self):
        """Return each conclusion that holds, and the forms that it is true of."""
        bounded = self.bounded_states()
        of_states = [q for q in self.lost if names(q) <= self.states | self.fixed]
        free, falls = self.states - bounded, not self.push
        degrees = [
            sum(n for s, n in m if s in free) for f in free for m in self.rates[f]
        ]
        exist = max(degrees, default=0) <= 1
        conclusions: dict = {"V' is at most the push": []}
        if falls:
            conclusions |= {"V does not increase": [], "square-integrable": of_states}
        elif exist and names(self.push) <= self.bounded | self.signals:
            conclusions["bounded in the mean"] = of_states
        if exist and self.decay and names(self.push) <= self.bounded:
            conclusions["ultimately bounded"] = []
        if exist and falls:
            conclusions["goes to zero"] = [
                q for q in of_states if self.is_calm(q, bounded)
            ]
            (equilibrium, has_rest), (end, has_end) = (
                self.determined(forms, set()) for forms in (self.forms, self.lost)
            )
            V = self.V
            for s, p in equilibrium.items():
                V = replace(V, s, at_zero(p))
            has_rest = has_rest and equilibrium.keys() == self.states and not V
            if has_rest and not self.signals:
                conclusions["stable"] = []
                points = [
                    {s: at_zero(p) for s, p in v.items()} for v in (equilibrium, end)
                ]
                if has_end and points[0] == points[1]:
                    conclusions["asymptotically stable"] = []
        return conclusions

    def is_calm(self, form, bounded):
        """Return whether a form has a bounded rate, so that it goes to zero (Barbalat)."""
        return names(along(form, self.rates)) <= bounded | self.bounded

    # --- printing --------------------------------------------------------------------------------

    def is_possible(self):
        """Return whether all assumptions hold at a point; matrices are diagonal at each trial."""
        signs = dict.fromkeys(names(*self.assumed), (-1, 0, 1))
        for rows in self.entries.values():
            signs |= {s: (0,) for row in rows for s in row}
        for rows in self.entries.values():
            signs |= {row[k]: (0, 1) for k, row in enumerate(rows)}
        draw = random.Random(0)
        for _ in range(TRIALS):
            point = {
                s: draw.choice(SIZES) * (s in self.factors or draw.choice(signs[s]))
                for s in sorted(signs)
            }
            values = [value_at(point, p) for p in self.assumed]
            if min(values, default=0) >= 0 and self.are_semidefinite(point):
                return True
        return False

    def are_semidefinite(self, point):
        """Return whether matrices of symbols are semidefinite at a point."""
        try:
            for M in self.matrices.values():
                is_definite([[value_at(point, p) for p in row] for row in M])
        except ValueError:
            return False
        return True

    def assumptions(self):
        """Return the assumptions as texts."""
        inputs = self.bounded - self.fixed - self.factors
        lists = [
            (self.positive, "> 0"),
            (self.factors - self.positive, "> 0 and bounded"),
            (inputs, "bounded"),
            (self.signals, "any functions of time"),
            (map(text, self.assumed), ">= 0"),
        ]
        listed = [(", ".join(sorted(items)), of) for items, of in lists]
        matrices = [
            f"{name} = {bracketed(map(bracketed, rows))} >= 0"
            for name, rows in self.entries.items()
        ]
        return [f"{items} {of}" for items, of in listed if items] + matrices

    def shown(self, claim, of, conditions):
        """Return a claim with all that it needs; reject a claim that does not follow."""
        conclusions, forms = self.conclusions(), [*map(self.read, of)]
        need(claim in conclusions, f"'{claim}' does not follow")
        need(
            all(p in conclusions[claim] for p in forms),
            f"'{claim}' does not follow of each form",
        )
        need(forms or claim not in ABOUT, f"'{claim}' is said of nothing")
        need(all(names(p) & self.states for p in forms), "a form has no state")
        need(self.used >= {*self.symbols} - self.states, "a symbol is not used")
        is_bound = self.losses or self.decay or not self.push
        need(is_bound, "V' is the push: nothing is shown")
        need(self.is_possible(), "no point is found where all assumptions hold")
        about = ", ".join(map(text, forms)) or f"V of {', '.join(sorted(self.in_V))}"
        by = " by the push" if claim == "bounded in the mean" else ""
        words = [f"{claim}{by} ({about})"]
        words += [f"push: {text(self.push)}"] if self.push else []
        words += [f"decay: {text(self.decay)}"] if self.decay else []
        facts, says = (
            "; ".join(self.assumptions()),
            ", ".join(map(json.dumps, conditions)),
        )
        words += [f"assumed: {facts}"] * bool(facts)
        return "; ".join([*words, *[f"says, not checked: {says}"] * bool(says)])

    def equations(self):
        """Return states, rates, V and what it loses as lines."""
        kinds = ("states", self.states), ("constants", self.fixed - self.positive)
        lines = [f"{kind}: {', '.join(sorted(symbols))}" for kind, symbols in kinds]
        lines += [f"rate of {s}: {text(p)}" for s, p in sorted(self.rates.items())]
        return [*lines, f"V: {text(self.V)}", f"losses: {text(self.losses)}"]


def checked(content, verbose=False):
    """Return what the text of a file shows; raise ValueError if it is rejected."""
    data = read_json(content)
    need(data, "it is empty")
    cases = data if isinstance(data, list) else [data]
    certificates = [*map(Certificate, cases)]
    shown = " | ".join(
        certificate.shown(case["conclusion"], case["of"], case["conditions"])
        for certificate, case in zip(certificates, cases, strict=True)
    )
    lines = [line for certificate in certificates for line in certificate.equations()]
    return "\n    ".join([shown, *lines * verbose])


def main(arguments):
    """Print a line for each file, and its equations with -v; return the exit status."""
    paths = [word for word in arguments if word not in ("-v", "--verbose")]
    failed = not paths
    for path in paths:
        try:
            content = Path(path).read_text("utf-8")
            result = f"checked: {checked(content, len(paths) < len(arguments))}"
        except Exception as error:  # a file of any content is rejected in one line
            failed, is_known = True, isinstance(error, (ValueError, OSError))
            reason = f"{error if is_known else f'malformed: {error!r}'}"
            result = f"rejected: {ascii(reason)[1:-1]}"
        file = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in path)
        print(f"{file}: {result}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
