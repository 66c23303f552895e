"""Steps of proofs: an identity or an inequality, and the method by which it was established."""

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from traceback import format_exception_only
from typing import Any, Literal

from ...base.errors import ClptError, DiagramError
from ...base.units import at_least, at_most
from ...engine.record.unread import Unread

LARGEST_DENOMINATOR = 10**12  # larger ones are rounded in texts
How = Literal["exact", "enclosed", "counterexample", "sampled", "cited"]


@dataclass(frozen=True)
class Step:
    """A claim and the method by which it was established.

    ``"exact"``: derived by SymPy, without rounding; ``"enclosed"``: by interval arithmetic in each
    box of a region; ``"counterexample"``: a computed case; ``"sampled"``: seen at random points;
    ``"cited"``: taken from a book, not checked.
    """

    claim: str  # the identity or inequality
    holds: bool
    how: How
    detail: str = ""  # the result in a line; of a cited step the source
    every_N: bool = True  # whether it holds for every number of basis functions
    shows: str = ""  # of what conclusions require: names of `verdict.CONCLUSIONS`


@contextmanager
def worked_out(name: str) -> Iterator[None]:
    """Raise a DiagramError with a sentence for any error of SymPy."""
    try:
        yield
    except ClptError:
        raise
    except Unread as error:
        raise DiagramError(f"{error}") from None
    except Exception as error:
        text = "".join(format_exception_only(error))
        text = text.rpartition(f"{type(error).__module__}.")[2]
        cause = " ".join(text.split())  # in one line
        raise DiagramError(f"{name}: V' cannot be computed: {cause}") from None


def checked(
    claim: str,
    check: Callable[[], Any],
    how: How = "exact",
    every_N: bool = True,
    shows: str = "",
) -> Step:
    """Return a step from a check that returns a truth value, or (truth value, detail).

    If the check rejects equations, the step does not hold and has the reason as its detail.  Any
    other error is a defect of the package, and is raised.
    """
    try:
        result = check()
    except (ClptError, Unread) as error:
        return Step(claim, False, how, f"cannot be checked: {error}")
    holds, detail = result if isinstance(result, tuple) else (result, "")
    return Step(claim, bool(holds), how, str(detail), every_N, shows)


def counterexample(
    claim: str, run: Callable[[], Any], shows: Callable[[Any], bool], text: str
) -> Step:
    """Check that a computed case shows a claim; `text` is formatted with the case."""

    def check() -> tuple[bool, str]:
        case = run()
        return shows(case), text.format(case)

    return checked(claim, check, "counterexample")


def exact_step(
    cases: Iterable[Any],
    claim: str,
    check: Callable[[Any], bool | str],
    shows: str = "",
) -> Step:
    """Check a claim for each number of functions.

    A check returns a truth value, or a text: the problem, "" if the claim holds.
    """

    def holds() -> tuple[bool, str]:
        for case in cases:
            result = check(case)
            if isinstance(result, str):
                if result:
                    return False, f"N = {case.N}: {result}"
            elif not result:
                return False, ""
        return True, ""

    return checked(claim, holds, every_N=False, shows=shows)


def first_failure(steps: Iterable[Step]) -> str:
    """Return the claim and the detail of the first step that does not hold, or ""."""
    for step in steps:
        if not step.holds:
            if step.detail:
                return f"{step.claim} ({step.detail})"
            return f"not shown: {step.claim}"
    return ""


def short(expression: Any, most: int = 160) -> str:
    """Return an expression as text of a line; numbers of many digits are rounded."""
    from sympy import Dummy, Rational  # cached outcomes are read without SymPy

    atoms = getattr(expression, "atoms", lambda *kinds: ())(Rational, Dummy)
    numbers = {n: n.n(6) for n in atoms if n.is_Rational and n.q > LARGEST_DENOMINATOR}
    text = str(expression.xreplace(numbers) if numbers else expression)
    for symbol in atoms:
        text = (
            text if symbol.is_Rational else text.replace(f"_{symbol.name}", symbol.name)
        )
    return text if len(text) <= most else text[:most] + " ..."


def bound_text(bound: Any, up: bool = True) -> str:
    """Return a bound as text: its numbers are rounded outward, equal factors written once.

    >>> import sympy
    >>> a, b, k = sympy.symbols("a b k", positive=True)
    >>> bound_text(a**2 / 3 + b**2 / 3 + a / (7 * k))
    '0.1429*a/k + 0.3334*(a**2 + b**2)'
    """
    import sympy

    def rounded(e: Any, up: bool) -> Any:
        """Return an expression of positive symbols with its numbers rounded."""
        if e.is_Rational or e.is_Float:
            text = (at_most if up else at_least)(float(e), 4)
            return e if e.is_Integer else sympy.Float(text, 4)
        if e.is_Pow:
            return sympy.Pow(rounded(e.base, up != e.exp.is_negative), e.exp)
        coefficient, rest = e.as_coeff_Mul()
        if coefficient != 1:
            up_rest = up != bool(coefficient.is_negative)
            return rounded(coefficient, up) * rounded(rest, up_rest)
        return e.func(*(rounded(part, up) for part in e.args)) if e.args else e

    def grouped(e: Any) -> Any:
        """Return a sum with terms of one factor in brackets."""
        if not e.args:
            return e
        if not e.is_Add:
            return e.func(*map(grouped, e.args))
        groups: dict[Any, list] = {}
        for term in e.args:
            coefficient, rest = term.as_coeff_Mul()
            groups.setdefault(coefficient, []).append(rest)
        sums = [
            sympy.Mul(c, sympy.Add(*g), evaluate=len(g) == 1) for c, g in groups.items()
        ]
        return sympy.Add(*sums, evaluate=False)

    bound = sympy.sympify(bound)
    text = str(grouped(rounded(bound, up)))
    return re.sub(r"(\.\d*?[1-9])0+\b|\.0+\b", r"\1", text)  # 0.3750, 2.0


def exact(claim: str, holds: bool, detail: str = "", shows: str = "") -> Step:
    """Return an exact step for one N."""
    return Step(claim, holds, "exact", detail, False, shows)


def cited(claim: str, source: str) -> Step:
    """Return a step that is taken from a source, not checked."""
    return Step(claim, True, "cited", source)
