"""Steps of proofs: an identity or an inequality, and the method by which it was established."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import wraps
from traceback import format_exception_only
from typing import Any, Literal

from ...base.errors import ClptError, DiagramError
from ...engine.record.unread import Unread, line_of
from .statements import said

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
    needed: bool = True  # by the conclusion; others say how far it reaches


@contextmanager
def worked_out(name: str) -> Iterator[None]:
    """Raise a DiagramError that reports any other error as a fault of this package."""
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
        raise DiagramError(
            f"{name}: a fault of clpt-control stopped the proof: {cause}. "
            "Report the traceback, which the error has as its __cause__"
        ) from error


def of_user(name: str, function: Any) -> Any:
    """Return a function of the user whose errors name their line in it."""

    @wraps(function)
    def call(*arguments: Any) -> Any:
        try:
            return function(*arguments)
        except (ClptError, Unread):
            raise
        except Exception as error:
            raise DiagramError(f"{name}: {line_of(function, error)}") from error

    return call if callable(function) else function


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
    detail = detail if isinstance(detail, str) else f"{detail}"
    return Step(claim, bool(holds), how, detail, every_N, shows)


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
                    return False, said(f"N = {case.N}: {{}}", result)
            elif not result:
                return False, ""
        return True, ""

    return checked(said(claim), holds, every_N=False, shows=shows)


def first_failure(steps: Iterable[Step]) -> str:
    """Return the claim and the detail of the first step that does not hold, or ""."""
    for step in steps:
        if not step.holds:
            if step.detail:
                return said("{} ({})", step.claim, step.detail)
            return said("not shown: {}", step.claim)
    return ""


def exact(claim: str, holds: bool, detail: str = "", shows: str = "") -> Step:
    """Return an exact step for one N."""
    return Step(claim, holds, "exact", detail, False, shows)
