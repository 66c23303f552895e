"""What a proof is made of: steps, and what they add up to.

A step is an identity or an inequality with how it was established.  A proof judges the
statement as printed in the paper; where the print is false it carries the corrected
statement, and it always says what was not proved and what is cited.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

HOWS = ("exact", "counterexample", "sampled", "cited")


@dataclass(frozen=True)
class Step:
    """One claim, and how it was established.

    Attributes
    ----------
    claim : str
        The identity or inequality.
    holds : bool
        Whether it was found to hold.
    how : str
        ``"exact"``: derived by SymPy, without rounding; ``"counterexample"``: a case
        that was computed; ``"sampled"``: seen at random points; ``"cited"``: taken from
        a book, not checked here.
    detail : str
        What was computed, in a line; for a cited step the source.
    every_N : bool
        Whether it holds for every number of basis functions.
    """

    claim: str
    holds: bool
    how: str
    detail: str = ""
    every_N: bool = True


@dataclass(frozen=True)
class Proof:
    """A theorem judged as printed.

    Attributes
    ----------
    theorem : str
        Its number in the paper.
    printed : str
        The statement as printed.
    assumptions : tuple of str
        What is assumed.
    steps : tuple of Step
        In order; all must hold for the status to count.
    printed_holds : bool
        Whether the printed statement is true once all steps hold.
    conclusion : str
        What follows.
    corrected : str
        The statement that does hold, where the printed one does not; the exact steps
        prove it, but for the part that `cited` names.
    cited : str
        The part of the statement that rests on cited steps.
    not_proved : tuple of str
        What is not shown here.
    """

    theorem: str
    printed: str
    assumptions: tuple[str, ...]
    steps: tuple[Step, ...]
    printed_holds: bool
    conclusion: str
    corrected: str = ""
    cited: str = ""
    not_proved: tuple[str, ...] = field(default=())

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
        ``"corrected"``: false as printed, and another statement holds; ``"refuted"``:
        false as printed, no more; ``"sampled"``: only seen at points; ``"failed"``: a
        step does not hold, so nothing is concluded.
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
    """Make a step of a check, failed where the check cannot be done.

    Parameters
    ----------
    claim : str
        What is claimed.
    how : str
        How it is established.
    check : callable
        Gives a truth, or (truth, detail).
    every_N : bool, optional
        Whether the check covers every number of basis functions.

    Returns
    -------
    Step
        An exception in the check is a step that does not hold, and says why.

    Raises
    ------
    ValueError
        If there is no such way to establish a claim.

    Examples
    --------
    >>> checked("one is one", "exact", lambda: 1 == 1).holds
    True
    """
    if how not in HOWS:
        raise ValueError(f"how = {how!r}: must be one of {', '.join(HOWS)}")
    try:
        found = check()
    except Exception as error:  # whatever a wrong equation raises, the claim is not shown
        return Step(claim, False, how, f"cannot be checked: {type(error).__name__}: {error}")
    truth, detail = found if isinstance(found, tuple) else (found, "")
    return Step(claim, bool(truth), how, str(detail), every_N)


def cited(claim: str, source: str) -> Step:
    """Return a step that is taken from a source, not checked here.

    Examples
    --------
    >>> cited("a lemma", "a book, 1996").how
    'cited'
    """
    return Step(claim, True, "cited", source)
