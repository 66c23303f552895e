"""Hypotheses of which fixes are wrong and when the flow changed, weighed by later fixes.

A new observation divides each hypothesis into branches, such as a right fix and a wrong one. The
log odds of a branch are those of its hypothesis, its prior odds and the logarithm of the density of
the observation. The likeliest branches remain, so that later observations decide (multiple
hypothesis tracking: D. B. Reid, "An algorithm for tracking multiple targets", IEEE Trans. Automatic
Control 24, 843-854, 1979).
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, TypeVar

import numpy as np
from scipy.special import softmax

State = TypeVar("State")
# kind of a branch, log odds over its hypothesis, and the function that computes its state
Branch = tuple[str, float, Callable[[], State]]


@dataclass(frozen=True)
class Hypotheses(Generic[State]):
    """States with their log odds, the likeliest first.

    >>> tossed = Hypotheses.of("fair").divided(lambda state: [("", 0.0, lambda: state)], 1)
    >>> tossed.states, tossed.weights.tolist()
    (('fair',), [1.0])
    """

    states: tuple[State, ...]
    log_odds: tuple[float, ...]

    @classmethod
    def of(cls, state: State) -> "Hypotheses[State]":
        """Return a single hypothesis."""
        return cls((state,), (0.0,))

    @cached_property
    def weights(self) -> np.ndarray:
        """Probabilities of the states."""
        return softmax(self.log_odds)

    def chances(self, value_of: Callable[[State], Any]) -> dict[Any, float]:
        """Return the probability of each value that the states have, the likeliest first."""
        chances: dict[Any, float] = {}
        for state, weight in zip(self.states, self.weights.tolist(), strict=True):
            value = value_of(state)
            chances[value] = chances.get(value, 0.0) + weight
        return dict(sorted(chances.items(), key=lambda item: -item[1]))

    def where(self, holds: Callable[[State], bool]) -> "Hypotheses[State]":
        """Return the hypotheses of which a statement holds, which one does at least."""
        kept = [
            (state, odds)
            for state, odds in zip(self.states, self.log_odds, strict=True)
            if holds(state)
        ]
        return Hypotheses(*map(tuple, zip(*kept, strict=True)))

    def divided(
        self, branches_of: Callable[[State], Iterable[Branch]], kept: int
    ) -> "Hypotheses[State]":
        """Return the likeliest branches, at least one of each kind, and compute their states."""
        branches = [
            (kind, odds + gained, make)
            for state, odds in zip(self.states, self.log_odds, strict=True)
            for kind, gained, make in branches_of(state)
        ]
        branches.sort(key=lambda branch: -branch[1])
        kinds = [kind for kind, _, _ in branches]
        is_first = [kind not in kinds[:number] for number, kind in enumerate(kinds)]
        # the likeliest of each kind, so that none is lost before the next observation
        order = sorted(range(len(branches)), key=lambda number: not is_first[number])
        likeliest = [branches[number] for number in sorted(order[:kept])]
        best = likeliest[0][1]
        return Hypotheses(
            tuple(make() for _, _, make in likeliest),
            tuple(odds - best for _, odds, _ in likeliest),
        )
