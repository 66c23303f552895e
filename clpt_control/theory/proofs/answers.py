"""Answers to the questions of `judge`: each with its step, and what later questions read of it."""

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from sympy import Expr, S

from .conclusions import Condition
from .steps import Step, first_failure
from .symbolic_loop import Point


class Definite(NamedTuple):
    """V is positive definite in forms."""

    step: Step
    forms: Sequence[Expr] = ()  # that V bounds
    least: Mapping[Any, Expr] | None = None  # the one point at which V is least
    is_steady: bool = (
        False  # V is between two functions of its states, zero at that point
    )
    exist: Set[Any] = frozenset()  # states that exist for all times, however they grow
    off_zero: Set[Any] = frozenset()  # states above 0 that V keeps away from it
    most_lost: str = "V(0)"  # what V may lose at most, as text
    is_convex: bool = False  # V is least where its slopes are 0


@dataclass
class Fall:
    """Claims on V': it falls, and loses squares of forms; or V is bounded."""

    steps: list[Step]
    claim: str = ""  # V' <= -e^T KD e
    losses: Sequence[Expr] = ()  # forms of which V' loses multiples of squares
    bound: str = ""  # what is lost, as text: e^T KD e
    of: str = ""  # what goes to zero, as text: CLPE goes
    level: Any = None
    decay: Expr | None = None  # that V stays below
    zeroed: Mapping[Any, Any] = field(default_factory=dict)  # inputs that are 0
    conditions: list[Condition] = field(default_factory=list)
    rate: Expr | None = None  # V' as it was judged
    residual: Expr = S.Zero  # of a law: V' less its fall
    slow: Sequence[Expr] = ()  # forms of W, of V' <= -f(t) W, int f dt = oo

    @property
    def holds(self) -> bool:
        """True if each step holds."""
        return not first_failure(self.steps)


class Jumps(NamedTuple):
    """V rises at no jump, or by how much it may."""

    step: Step
    rise: Expr = S.Zero


class Refutation(NamedTuple):
    """A point at which the running blocks show that V fails."""

    claim: str
    step: Step
    point: Point
    value: float | None
    after: Point | None = None
