"""Steps of proofs, and proofs of statements.

A step is an identity or an inequality and the method by which it was established.  A proof is of a
statement as printed in the paper, of a law or of a team.  If the print is false, the proof has the
corrected statement; it always lists parts that are cited or not proved.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from traceback import format_exception_only
from typing import Any, Literal

from ...base.errors import ClptError, DiagramError
from ...engine.trace.arrays import Unread

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


@dataclass(frozen=True)
class Proof:
    """The outcome for a statement, a law or a team, and its steps.

    A theorem is ``"proved"``: by exact steps alone; ``"cited"``: some steps are cited;
    ``"corrected"``: false as printed, and another statement holds; ``"refuted"``: false as
    printed; ``"sampled"``: only seen at points; ``"failed"``: a step does not hold.
    A law or a team is ``"proved"``, ``"bounded"``, ``"open"`` or ``"refuted"``.
    """

    status: str
    claim: str  # a conclusion, or V' and the set that is reached; or the failure
    for_every_N: bool
    steps: tuple[Step, ...]
    cited: str = ""  # the part of the statement that depends on cited steps
    printed: str = ""  # a theorem as printed
    assumptions: tuple[str, ...] = ()
    corrected: str = ""  # the statement that holds if the print is false
    not_proved: tuple[str, ...] = ()

    @property
    def as_expected(self) -> bool:
        """Return whether the status is as the package claims; "corrected" of Theorem 3.1."""
        return self.status in ("proved", "cited", "corrected", "sampled", "bounded")

    @property
    def failed(self) -> tuple[Step, ...]:
        """The steps that do not hold."""
        return tuple(step for step in self.steps if not step.holds)


def theorem(
    printed: str,
    assumptions: tuple[str, ...],
    steps: Iterable[Step],
    conclusion: str,
    *,
    corrected: str | None = None,
    cited: str = "",
    not_proved: tuple[str, ...] = (),
) -> Proof:
    """Return the proof of a statement as printed; a correction, even "", means that it is false."""
    steps = tuple(steps)
    methods = {step.how for step in steps}
    is_false = corrected is not None
    if first_failure(steps) or (is_false and "counterexample" not in methods):
        status = "failed"
    elif is_false:
        status = "corrected" if corrected else "refuted"
    elif "exact" not in methods:
        status = "sampled"
    else:
        status = "cited" if "cited" in methods else "proved"
    return Proof(
        status,
        conclusion,
        exact_for_every_N(steps),
        steps,
        cited=cited,
        printed=printed,
        assumptions=assumptions,
        corrected=corrected or "",
        not_proved=not_proved,
    )


def where_all_hold(
    status: str, claim: str, steps: Iterable[Step], cited: str = ""
) -> Proof:
    """Return a proof with a status and a claim if every step holds; otherwise an open one."""
    steps = tuple(steps)
    if failed := first_failure(steps):
        return Proof("open", failed, False, steps, cited)
    return Proof(status, claim, exact_for_every_N(steps), steps, cited)


def exact_for_every_N(steps: Iterable[Step]) -> bool:
    """Return whether there are exact steps, and each holds for every N."""
    exact = [step for step in steps if step.how == "exact"]
    return bool(exact) and all(step.holds and step.every_N for step in exact)


def proof_or_failure(status: str, proof: Callable[[], Proof]) -> Proof:
    """Return a proof; if equations cannot be traced, a proof with a status and a failed step."""
    try:
        return proof()
    except (ClptError, Unread) as error:
        step = Step("the equations can be read", False, "exact", f"{error}")
        return Proof(status, f"{error}", False, (step,))


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
    claim: str, check: Callable[[], Any], how: How = "exact", every_N: bool = True
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
    return Step(claim, bool(holds), how, str(detail), every_N)


def counterexample(
    claim: str, run: Callable[[], Any], shows: Callable[[Any], bool], text: str
) -> Step:
    """Check that a computed case shows a claim; `text` is formatted with the case."""

    def check() -> tuple[bool, str]:
        case = run()
        return shows(case), text.format(case)

    return checked(claim, check, "counterexample")


def exact_step(
    cases: Iterable[Any], claim: str, check: Callable[[Any], bool | str]
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

    return checked(claim, holds, every_N=False)


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
    from sympy import Rational  # cached outcomes are read without SymPy

    numbers = getattr(expression, "atoms", lambda kind: ())(Rational)
    rounded = {n: n.n(6) for n in numbers if n.q > LARGEST_DENOMINATOR}
    text = str(expression.xreplace(rounded) if rounded else expression)
    return text if len(text) <= most else text[:most] + " ..."


def exact(claim: str, holds: bool, detail: str = "") -> Step:
    """Return an exact step for one N."""
    return Step(claim, holds, "exact", detail, False)


def cited(claim: str, source: str) -> Step:
    """Return a step that is taken from a source, not checked."""
    return Step(claim, True, "cited", source)
