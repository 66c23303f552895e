"""What a proof is made of: steps, and what they add up to.

A step is an identity or an inequality with how it was established.  A proof
judges the statement as printed in the paper; where the print is false it
carries the corrected statement, and it always says what was not proved.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

HOWS = ("symbolic", "definite form", "counterexample", "sampled")


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
        ``"symbolic"``, ``"definite form"``, ``"counterexample"`` or ``"sampled"``.
    detail : str
        What was computed, in a line.
    """

    claim: str
    holds: bool
    how: str
    detail: str = ""


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
        The statement that does hold, where the printed one does not.
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
        """Whether an identity for every N is among the steps and holds."""
        generic = [step for step in self.steps if "every N" in step.claim]
        return bool(generic) and all(step.holds for step in generic)

    @property
    def status(self) -> str:
        """``"proved"``, ``"corrected"``, ``"refuted"`` or ``"failed"``.

        ``"corrected"``: false as printed, and the corrected statement is
        proved; ``"refuted"``: false as printed, no more; ``"failed"``: a step
        does not hold, so nothing is concluded.
        """
        if not self.holds:
            return "failed"
        if not self.printed_holds:
            return "corrected" if self.corrected else "refuted"
        return "proved" if any(step.how != "sampled" for step in self.steps) else "sampled"


def checked(claim: str, how: str, check: Callable[[], Any]) -> Step:
    """Make a step of a check, failed where the check cannot be done.

    Parameters
    ----------
    claim : str
        What is claimed.
    how : str
        How it is established.
    check : callable
        Gives a truth, or (truth, detail).

    Returns
    -------
    Step
        An exception in the check is a step that does not hold, and says why.

    Examples
    --------
    >>> checked("one is one", "symbolic", lambda: 1 == 1).holds
    True
    """
    if how not in HOWS:
        raise ValueError(f"how = {how!r}: must be one of {', '.join(HOWS)}")
    try:
        found = check()
    except Exception as error:  # whatever a wrong equation raises, the claim is not shown
        return Step(claim, False, how, f"cannot be checked: {type(error).__name__}: {error}")
    truth, detail = found if isinstance(found, tuple) else (found, "")
    return Step(claim, bool(truth), how, str(detail))
