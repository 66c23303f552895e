"""What a proof is made of: steps, and what they add up to.

A step is an identity or an inequality with how it was established.  A proof is of a statement as
printed in the paper, of a law or of a team; where the print is false it carries the corrected
statement, and it always says what was not proved and what is cited.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from traceback import format_exception_only
from typing import Any, Literal

from ...base.errors import ClptError, DiagramError
from ...engine.trace.arrays import Unread

LONG = 10**12  # denominators beyond are rounded where they are printed
How = Literal["exact", "enclosed", "counterexample", "sampled", "cited"]


@dataclass(frozen=True)
class Step:
    """One claim, and how it was established.

    ``"exact"``: derived by SymPy, without rounding; ``"enclosed"``: in each of some boxes, by
    numbers rounded outward; ``"counterexample"``: a case that was
    computed; ``"sampled"``: seen at random points; ``"cited"``: taken from a book, not checked.
    """

    claim: str  # the identity or inequality
    holds: bool
    how: How
    detail: str = ""  # what was computed, in a line; for a cited step the source
    every_N: bool = True  # whether it holds for every number of basis functions


@dataclass(frozen=True)
class Proof:
    """What is known of a statement, of a law or of a team, and the steps that show it.

    A theorem is ``"proved"``: by exact steps alone; ``"cited"``: some of them are cited;
    ``"corrected"``: false as printed, and another statement holds; ``"refuted"``: false as
    printed, no more; ``"sampled"``: only seen at points; ``"failed"``: a step does not hold.
    A law or a team is ``"proved"``, ``"bounded"``, ``"open"`` or ``"refuted"``.
    """

    status: str
    claim: str  # what holds: a conclusion, or V' and the set that is reached; or what failed
    for_every_N: bool
    steps: tuple[Step, ...]
    cited: str = ""  # the part of the statement that rests on cited steps
    printed: str = ""  # a theorem as printed
    assumptions: tuple[str, ...] = ()
    # what holds where the print does not: proved, but for what is cited
    corrected: str = ""
    not_proved: tuple[str, ...] = ()  # what is not shown here

    @property
    def holds(self) -> bool:
        """Whether it is what the package claims."""
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
    """Return the proof of a statement as printed; a correction, even "", says that it is false."""
    steps = tuple(steps)
    hows = {step.how for step in steps}
    if first_failure(steps) or (corrected is not None and "counterexample" not in hows):
        status = "failed"
    elif corrected is not None:
        status = "corrected" if corrected else "refuted"
    elif "exact" not in hows:
        status = "sampled"
    else:
        status = "cited" if "cited" in hows else "proved"
    more = (cited, printed, assumptions, corrected or "", not_proved)
    return Proof(status, conclusion, exact_for_every_N(steps), steps, *more)


def where_all_hold(
    status: str, claim: str, steps: Iterable[Step], cited: str = ""
) -> Proof:
    """Return a proof with this status and claim where every step holds; else an open one."""
    steps = tuple(steps)
    failed = first_failure(steps)
    known = ("open", failed) if failed else (status, claim)
    return Proof(*known, not failed and exact_for_every_N(steps), steps, cited)


def exact_for_every_N(steps: Iterable[Step]) -> bool:
    """Return whether there are exact steps, and each holds for every N."""
    exact = [step for step in steps if step.how == "exact"]
    return bool(exact) and all(step.holds and step.every_N for step in exact)


def proof_or_failure(status: str, proof: Callable[[], Proof]) -> Proof:
    """Return a proof, or one with this status and a failed step where equations cannot be read."""
    try:
        return proof()
    except (
        ClptError,
        Unread,
    ) as error:  # an equation so changed that it cannot be traced
        step = Step("the equations can be read", False, "exact", f"{error}")
        return Proof(status, f"{error}", False, (step,))


@contextmanager
def worked_out(name: str) -> Iterator[None]:
    """Raise a DiagramError with a sentence for whatever SymPy raises."""
    try:
        yield
    except ClptError:
        raise
    except Unread as error:
        raise DiagramError(f"{error}") from None
    except Exception as error:
        text = "".join(format_exception_only(error)).rpartition(
            f"{type(error).__module__}."
        )[2]
        cause = " ".join(text.split())  # in one line
        raise DiagramError(f"{name}: V' cannot be worked out: {cause}") from None


def checked(
    claim: str, check: Callable[[], Any], how: How = "exact", every_N: bool = True
) -> Step:
    """Return a step from a check that returns a truth, or (truth, detail).

    Equations that are refused in it are a step that does not hold, and says why; any other error is
    one of the package itself, and says nothing of the claim.
    """
    try:
        answer = check()
    except (ClptError, Unread) as error:
        return Step(claim, False, how, f"cannot be checked: {error}")
    truth, detail = answer if isinstance(answer, tuple) else (answer, "")
    return Step(claim, bool(truth), how, str(detail), every_N)


def counterexample(
    claim: str, run: Callable[[], Any], shows: Callable[[Any], bool], said: str
) -> Step:
    """Check that a case, which is computed, shows what is claimed; it is said with its numbers."""

    def check() -> tuple[bool, str]:
        found = run()
        return shows(found), said.format(found)

    return checked(claim, check, "counterexample")


def exact_step(
    cases: Iterable[Any], claim: str, check: Callable[[Any], bool | str]
) -> Step:
    """Check a claim for each number of functions.

    A check returns whether it holds; or what is wrong, and nothing where it holds.
    """

    def holds() -> tuple[bool, str]:
        for case in cases:
            answer = check(case)
            if answer is False or (answer and answer is not True):
                return False, f"N = {case.N}: {answer}" if answer else ""
        return True, ""

    return checked(claim, holds, every_N=False)


def first_failure(steps: Iterable[Step]) -> str:
    """Return the claim and the detail of the first step that does not hold, or nothing."""
    failed = (step for step in steps if not step.holds)
    return next((f"{one.claim} ({one.detail or 'not shown'})" for one in failed), "")


def short(expression: Any, most: int = 160) -> str:
    """Return an expression as text of a line; numbers of many digits are rounded."""
    from sympy import Rational  # what was proved before is read without SymPy

    known = getattr(expression, "atoms", lambda kind: ())(Rational)
    long = {one: one.n(6) for one in known if one.q > LONG}
    text = str(expression.xreplace(long) if long else expression)
    return text if len(text) <= most else text[:most] + " ..."


def exact(claim: str, holds: bool, detail: str = "") -> Step:
    """Return a step that SymPy showed for the N at hand, or did not."""
    return Step(claim, holds, "exact", detail, False)


def cited(claim: str, source: str) -> Step:
    """Return a step that is taken from a source, not checked here."""
    return Step(claim, True, "cited", source)
