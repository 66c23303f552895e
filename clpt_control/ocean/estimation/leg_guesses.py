"""Guesses of what happened on the legs so far, each with the theta that it learned.

Each fix divides each guess (`hypotheses`) into three:

    right      least squares, and the next leg begins at the fix
    wrong      nothing is learned, and the leg goes on past the fix
    changed    the flow changed, or theta_hat was wrong: P + prior, then right

The density of a right fix is that of the kinds of seas (`lasting_scatter`).
The density of a wrong fix is that of the centre of a normal distribution of 10 km, at any distance.
A flow above 5 m/s is impossible: a fix that needs it is wrong, or begins a leg.

Numbers are in units of the scenario.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from math import log, pi
from typing import Any

import numpy as np
from scipy.optimize import brentq

from ...base.units import METRES
from ...paper.laws.fix_bound import Limits, level_after
from ...paper.laws.memory_laws import least_squares_step
from ...paper.scenario.experiment import Scenario
from ..gliders.dives import FASTEST
from .fix_model import CHI_SQUARED, LEVEL
from .fix_settings import FixSettings
from .hypotheses import Branch, Hypotheses
from .lasting_scatter import Expected, Known, Scatter
from .leg_track import Leg, Regression

# shares: of fixes that are wrong, of legs before which the flow changed
WRONG_SHARE, CHANGED_SHARE = 0.02, 0.0002
WILD = 10e3  # m, standard deviation of wrong fixes
KEPT = 5  # guesses
RIGHT, WRONG, CHANGED = "right", "wrong", "changed"  # what a fix is
JUDGED = 4  # last fixes that later ones may judge again
WALKS = "kalman-flow"  # law of a flow that changes
REMARKS = {
    RIGHT: "",
    WRONG: "the fix lies outside the region of its forecast: it is in doubt, or the estimate is, "
    "and is hardly learned unless later legs agree",
    CHANGED: "the flow changed, or the estimate was wrong: learned anew",
}
AFTER_ALL = {
    RIGHT: "is right after all, and learned",
    WRONG: "is wrong after all, and not learned",
    CHANGED: "is right after all: the flow changed",
}


@dataclass(frozen=True, eq=False)
class Guess:
    """Estimate of theta if each of the last fixes is as `fixes` says, the last one at the end.

    `leg` begins at the last fix that is not wrong; None before one.
    `level` bounds tr(eta P^-1 eta^T), eta the error of theta (`paper.laws.fix_bound`).
    """

    leg: Leg | None
    theta: np.ndarray
    P: np.ndarray
    scatter: Scatter
    fixes: tuple[str, ...] = ()
    level: float = 1.0

    @cached_property
    def known(self) -> Known:
        """P by the kinds of seas."""
        return self.scatter.known(self.P)

    def level_after(
        self, leg: Regression, P: np.ndarray, r: float, limits: Limits
    ) -> float:
        """Return the level after a leg that is learned with P and r."""
        assert leg.path is not None
        off = np.linalg.norm(leg.path.m @ (self.theta - leg.theta).T, axis=1)
        path = leg.path._replace(drift=leg.path.drift + off)
        error = float(np.linalg.norm(leg.Y - self.theta @ leg.m))
        return level_after(self.level, path, P, r, limits, error)

    def begun(self, leg: Leg) -> "Guess":
        """Return the guess with a leg that begins at a fix of its own."""
        scatter = self.scatter._replace(error=0.0, de=0.0, ee=0.0)
        return self.after(RIGHT, leg=leg, scatter=scatter)

    def after(self, fix: str, **changes: Any) -> "Guess":
        """Return the guess after one more fix."""
        return replace(self, fixes=(*self.fixes, fix)[-JUDGED:], **changes)


class LegGuesses:
    """Branches of guesses by the law and the settings of a scenario."""

    def __init__(self, scenario: Scenario, settings: FixSettings) -> None:
        between_fixes = scenario.learning.row.between_fixes
        assert between_fixes is not None
        self.between_fixes = between_fixes
        self.settings = settings
        self.wild = (WILD / METRES[scenario.units.length]) ** 2
        self.prior = np.diag(settings.prior**2)
        self.unlearned = Known(np.ones(len(self.prior)), np.diag(settings.prior))

    @property
    def first(self) -> Hypotheses[Guess]:
        """The guess before any fix."""
        theta, scatter = self.settings.theta, Scatter.of(self.settings)
        return Hypotheses.of(Guess(None, theta, self.prior, scatter))

    def covariance(self, guesses: Hypotheses[Guess]) -> np.ndarray:
        """Return the covariance of each row of theta, (N, N)."""
        theta, P = theta_of(guesses), np.zeros_like(self.prior)
        for weight, guess in zip(guesses.weights, guesses.states, strict=True):
            off, (left, axes) = guess.theta - theta, guess.known
            mean = np.tensordot(guess.scatter.weights, left)
            P += weight * ((axes * mean) @ axes.T + off.T @ off / 2)
        return P

    def region(
        self, guesses: Hypotheses[Guess], leg: Regression
    ) -> tuple[np.ndarray, float]:
        """Return the place of a fix beside theta m, (2,), and the radius of its region."""
        found = [
            guess.scatter.expected(leg, guess.known, 0.0) for guess in guesses.states
        ]
        off = (thetas_of(guesses) - theta_of(guesses)) @ leg.m
        mean = off[:, None, None] - np.array([one.off for one in found])
        kinds = np.array([guess.scatter.weights for guess in guesses.states])
        weights = guesses.weights[:, None, None] * kinds
        place = np.tensordot(weights, mean, 3)
        V = np.array([one.V for one in found]) + np.mean((mean - place) ** 2, axis=-1)
        nu = np.array([one.nu for one in found])
        return place, radius_of(weights.ravel(), V.ravel(), nu.ravel())

    def branches(
        self, guess: Guess, leg: Regression | None, start: Leg
    ) -> Iterator[Branch]:
        """Yield what a fix may be: log odds, and the guess after it."""
        anywhere = -log(2 * pi * self.wild)
        if leg is None:
            yield RIGHT, anywhere, partial(guess.begun, start)
            wrong = anywhere + log(WRONG_SHARE)
            yield WRONG, wrong, partial(guess.after, WRONG, leg=None)
            return
        P = self.between_fixes(guess.P, leg.duration, self.settings.p)
        now = guess if P is guess.P else replace(guess, P=P)
        y = leg.Y - guess.theta @ leg.m
        right = now.scatter.expected(leg, now.known, y)
        # a wrong fix lies about the forecast
        V = float(np.sum(now.scatter.weights * right.V))
        wrong = log(WRONG_SHARE) - log(2 * pi * (V + self.wild))
        yield WRONG, wrong, partial(guess.after, WRONG)
        fastest = FASTEST / self.settings.speed * leg.duration
        if float(np.hypot(*leg.Y)) > fastest + CHI_SQUARED * leg.noise.sum() ** 0.5:
            # the motion was not that, or the fix before is wrong
            begun = partial(guess.begun, start)
            yield RIGHT, log(CHANGED_SHARE) + anywhere, begun
            return
        anew = guess.scatter._replace(middle=-np.inf)
        changed = anew.expected(leg, self.unlearned, y)
        for fix, odds, P, found in (
            (RIGHT, 0.0, now.P, right),
            (CHANGED, log(CHANGED_SHARE), now.P + self.prior, changed),
        ):
            learned = partial(self._learned, guess, leg, P, fix, start, found)
            yield fix, odds + found.density, learned

    def _learned(
        self,
        guess: Guess,
        leg: Regression,
        P: np.ndarray,
        fix: str,
        start: Leg,
        found: Expected,
    ) -> Guess:
        """Return a guess after least squares."""
        y = leg.Y - guess.theta @ leg.m
        added = leg.added * float(leg.m @ P @ leg.m)
        r = (float(leg.noise.sum()) + leg.bend**2 + added) ** 0.5
        change, after = least_squares_step(P, leg.m, y, r)
        return guess.after(
            fix,
            leg=start,
            theta=guess.theta + change,
            P=after,
            scatter=found.learned(leg, change, r),
            level=np.inf
            if fix == CHANGED
            else guess.level_after(leg, P, r, self.settings.limits),
        )


def remarks(
    guesses: Hypotheses[Guess], told: list[str], law: str
) -> tuple[list[str], str]:
    """Return the likeliest kinds of the last fixes, and a remark on each that was not told so."""
    count = min(len(told) + 1, JUDGED)
    kinds = []
    for back in range(count, 0, -1):
        chances = guesses.chances(lambda guess, back=back: guess.fixes[-back])  # type: ignore[misc]
        kinds.append(next(iter(chances)))
    texts = [REMARKS[kinds[-1]]]
    changed = kinds[-1] == CHANGED
    for back in range(1, count):
        kind, was = kinds[-1 - back], told[-back]
        if kind != was:
            texts.append(f"the fix {back} before it {AFTER_ALL[kind]}")
            changed |= kind == CHANGED
    if changed and law != WALKS:
        texts.append(f"take law {WALKS} for a flow that changes")
    return kinds, "; ".join(filter(None, texts))


def thetas_of(guesses: Hypotheses[Guess]) -> np.ndarray:
    """Return theta of each guess, (G, 2, N)."""
    return np.array([guess.theta for guess in guesses.states])


def theta_of(guesses: Hypotheses[Guess]) -> np.ndarray:
    """Return the mean of theta, (2, N)."""
    return np.einsum("g,gak->ak", guesses.weights, thetas_of(guesses))


def radius_of(weights: np.ndarray, variances: np.ndarray, counts: np.ndarray) -> float:
    """Return the radius of the circle that has `LEVEL` of a mixture of Student's t.

    >>> round(radius_of(np.ones(1), np.ones(1), np.full(1, 1e9)) ** 2, 3)  # chi-squared
    4.605
    """
    high = 10 * float(np.sqrt(CHI_SQUARED * variances.max()))

    def beyond(radius: float) -> float:
        outside = (1 + radius**2 / (counts * variances)) ** (-counts / 2)
        return float(weights @ outside) - (1 - LEVEL)

    return float(brentq(beyond, 0.0, high, xtol=1e-12 * high))
