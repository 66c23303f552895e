"""What a proof is made of: steps, and what they add up to.

A step is an identity or an inequality with how it was established.  A proof judges the
statement as printed in the paper; where the print is false it carries the corrected
statement, and it always says what was not proved and what is cited.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

HOWS = ("exact", "counterexample", "sampled", "cited")


@dataclass(frozen=True)
class Step:
    """One claim, and how it was established.

    ``"exact"``: derived by SymPy, without rounding; ``"counterexample"``: a case that was
    computed; ``"sampled"``: seen at random points; ``"cited"``: taken from a book, not checked.
    """

    claim: str  # the identity or inequality
    holds: bool
    how: str  # one of HOWS
    detail: str = ""  # what was computed, in a line; for a cited step the source
    every_N: bool = True  # whether it holds for every number of basis functions


@dataclass(frozen=True)
class Proof:
    """A theorem judged as printed."""

    theorem: str  # its number in the paper
    printed: str  # the statement as printed
    assumptions: tuple[str, ...]
    steps: tuple[Step, ...]  # in order; all must hold for the status to count
    printed_holds: bool  # whether the printed statement is true once all steps hold
    conclusion: str
    corrected: str = ""  # what holds where the print does not: proved, but for what is cited
    cited: str = ""  # the part of the statement that rests on cited steps
    not_proved: tuple[str, ...] = ()  # what is not shown here

    @property
    def holds(self) -> bool:
        """Whether every step holds."""
        return all(step.holds for step in self.steps)

    @property
    def failed(self) -> tuple[Step, ...]:
        """The steps that do not hold."""
        return tuple(step for step in self.steps if not step.holds)

    @property
    def for_every_N(self) -> bool:
        """Whether every exact step holds for every N."""
        exact = [step for step in self.steps if step.how == "exact"]
        return bool(exact) and all(step.holds and step.every_N for step in exact)

    @property
    def status(self) -> str:
        """What the steps add up to.

        ``"proved"``: by exact steps alone; ``"cited"``: some of them are cited;
        ``"corrected"``: false as printed, and another statement holds; ``"refuted"``: false as
        printed, no more; ``"sampled"``: only seen at points; ``"failed"``: a step does not hold.
        """
        if not self.holds:
            return "failed"
        if not self.printed_holds:
            refuted = any(step.how == "counterexample" for step in self.steps)
            return "failed" if not refuted else "corrected" if self.corrected else "refuted"
        if not any(step.how == "exact" for step in self.steps):
            return "sampled"
        return "cited" if any(step.how == "cited" for step in self.steps) else "proved"


def checked(claim: str, how: str, check: Callable[[], Any], every_N: bool = True) -> Step:
    """Return a step from a check that returns a truth, or (truth, detail).

    An exception in the check is a step that does not hold, and says why.
    """
    if how not in HOWS:
        raise ValueError(f"how = {how!r}: must be one of {', '.join(HOWS)}")
    try:
        found = check()
    except Exception as error:  # whatever a wrong equation raises, the claim is not shown
        return Step(claim, False, how, f"cannot be checked: {type(error).__name__}: {error}")
    truth, detail = found if isinstance(found, tuple) else (found, "")
    return Step(claim, bool(truth), how, str(detail), every_N)


def first_failure(steps: Iterable[Step]) -> str:
    """Return what the first step that does not hold claims, and its detail, or nothing."""
    return next((f"{step.claim} ({step.detail})" for step in steps if not step.holds), "")


def judged(theorem: str, proof: Callable[[], Proof]) -> Proof:
    """Return a proof; one whose parts cannot be read has a failed step."""
    try:
        return proof()
    except Exception as error:  # an equation so changed that it cannot be traced
        step = Step("the equations can be read", False, "exact", f"{error}")
        return Proof(theorem, "", (), (step,), False, "nothing")


def short(expression: Any, most: int = 160) -> str:
    """Return an expression as text of a line."""
    text = str(expression)
    return text if len(text) <= most else text[:most] + " ..."


def cited(claim: str, source: str) -> Step:
    """Return a step that is taken from a source, not checked here."""
    return Step(claim, True, "cited", source)
