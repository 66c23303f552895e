"""Proofs of statements as printed in the paper, of laws and of the team.

If a print is false, the proof has the corrected statement; it always lists parts that are cited or
not proved.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from ...base.errors import ClptError
from ...engine.record.unread import Unread
from .conclusions import Condition, Judged, Status, concluded, for_sizes
from .steps import Step, first_failure


@dataclass(frozen=True)
class Proof(Judged):
    """The outcome for a statement, a law or a team, and its steps.

    A theorem is ``"proved"``: as printed, by exact steps alone, but for those that are `cited`;
    ``"refuted"``: a counterexample shows that it is false as printed, and `corrected` is what
    holds in its place; ``"open"``: a step does not hold.
    """

    cited: str = ""  # the part of the statement that depends on cited steps
    printed: str = ""  # a theorem as printed
    assumptions: tuple[str, ...] = ()
    corrected: str = ""  # the statement that holds if the print is false
    not_proved: tuple[str, ...] = ()

    @property
    def as_expected(self) -> bool:
        """Return whether it is proved, or false as printed and corrected, with every step."""
        is_settled = self.status == "proved" or bool(self.corrected)
        return is_settled and not self.failed


def theorem(
    printed: str,
    assumptions: tuple[str, ...],
    steps: Iterable[Step],
    claim: str,
    *,
    corrected: str = "",
    not_proved: tuple[str, ...] = (),
    **more: Any,
) -> Proof:
    """Return the proof of a statement as printed; a correction means that it is false."""
    steps = tuple(steps)
    methods = {step.how for step in steps}
    status: Status = "refuted" if corrected else "proved"
    needed = "counterexample" if corrected else "exact"
    if first_failure(steps) or needed not in methods:
        status = "open"
    return Proof(
        status,
        claim,
        steps=steps,
        for_every_N=exact_for_every_N(steps),
        printed=printed,
        assumptions=assumptions,
        corrected=corrected,
        not_proved=not_proved,
        **more,
    )


def where_all_hold(
    claim: str,
    steps: Iterable[Step],
    given: str,
    conditions: Any = (),
    sizes: Iterable[int] = (),
    **more: Any,
) -> Proof:
    """Return a proof with what follows from the steps if each holds; otherwise an open one.

    `sizes` are the numbers of functions of steps that are not for every N.
    """
    steps = tuple(steps)
    if failed := first_failure(steps):
        return Proof("open", failed, steps=steps)
    every_N = exact_for_every_N(steps)
    of_N = Condition("N", "every N") if every_N else for_sizes(sizes)
    return Proof(
        "proved",
        claim,
        conclusions=concluded(steps, given),
        conditions=(*conditions, of_N),
        steps=steps,
        for_every_N=every_N,
        **more,
    )


def exact_for_every_N(steps: Iterable[Step]) -> bool:
    """Return whether there are exact steps, and each holds for every N."""
    exact = [step for step in steps if step.how == "exact"]
    return bool(exact) and all(step.holds and step.every_N for step in exact)


def proof_or_failure(proof: Callable[[], Proof]) -> Proof:
    """Return a proof; if equations cannot be traced, an open one with a failed step."""
    try:
        return proof()
    except (ClptError, Unread) as error:
        step = Step("the equations can be read", False, "exact", f"{error}")
        return Proof("open", f"{error}", steps=(step,))
