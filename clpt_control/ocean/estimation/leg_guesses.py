"""Guesses of what happened on the legs so far, each with the theta that it learned.

Each fix divides each guess (`hypotheses`) into three:

    right      least squares, and the next leg begins at the fix
    wrong      nothing is learned, and the leg goes on past the fix
    changed    the flow changed, or theta_hat was wrong: P + prior, then right

The density of a right fix is Student's t of two components around the forecast.  The two parts of
r^2, those of the fixes and of the scatter, have a factor each, c^2 = S/nu: nu counts the position
errors of the guess so far, each by the share of the part in its variance, S is the sum of their
squares, and both fade to 1.  Where a region is that of the prior, nu is one more.  So short legs
tell of the fixes, long ones of the scatter.  The factor of P is the mean by what the legs taught.
The density of a wrong fix is that of the centre of a normal distribution of 10 km, at any distance.
A flow above 5 m/s is impossible: a fix that needs it is wrong, or begins a leg.

Numbers are in units of the scenario.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from math import log, log1p, pi
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import brentq

from ...base.units import METRES
from ...paper.laws.fix_bound import LegRegressor, Limits, level_after
from ...paper.laws.memory_laws import least_squares_step
from ...paper.scenario.experiment import Scenario
from ..gliders.dives import FASTEST
from .fix_model import CHI_SQUARED, LEVEL
from .fix_settings import FixSettings
from .hypotheses import Branch, Hypotheses
from .leg_track import Leg, Turn

PRIOR_ERRORS = 1.0  # weight of r as it is set, in position errors on an axis
FADING = 0.97  # of the weight of a position error, at the next one
MOST_TURN = 8.0  # rad
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
    "and is not learned unless later legs agree",
    CHANGED: "the flow changed, or the estimate was wrong: learned anew",
}
AFTER_ALL = {
    RIGHT: "is right after all, and learned",
    WRONG: "is wrong after all, and not learned",
    CHANGED: "is right after all: the flow changed",
}


def _prior_errors() -> np.ndarray:
    return np.full(2, PRIOR_ERRORS)


@dataclass(frozen=True, eq=False)
class Guess:
    """Estimate of theta if each of the last fixes is as `fixes` says, the last one at the end.

    `leg` begins at the last fix that is not wrong; None before one. `prior` is the standard
    deviation of each parameter before any fix. Of each part of r^2 `squares` is S, `count` nu and
    `taught` the sum of |m|^2/r^2 by its share.
    `level` bounds tr(eta P^-1 eta^T), eta the error of theta (`paper.laws.fix_bound`).
    """

    leg: Leg | None
    theta: np.ndarray
    P: np.ndarray
    prior: np.ndarray
    squares: np.ndarray = field(default_factory=_prior_errors)
    count: np.ndarray = field(default_factory=_prior_errors)
    taught: np.ndarray = field(default_factory=lambda: np.full(2, 1e-300))
    fixes: tuple[str, ...] = ()
    level: float = 1.0

    @property
    def factors(self) -> np.ndarray:
        """Factor c^2 on each part of the noise, (2,)."""
        return self.squares / self.count

    @property
    def square(self) -> float:
        """Factor c^2 on P."""
        return float(self.taught @ self.factors / self.taught.sum())

    @cached_property
    def scaled(self) -> np.ndarray:
        """Covariance with c times the noise, and the prior as it was."""
        free = self.prior > 0
        sd = np.where(free, self.prior, 1.0)
        # of the prior's variance, the share that is left along each axis
        share, axes = np.linalg.eigh(self.P / np.outer(sd, sd))
        share = np.clip(share, 1e-300, 1.0)
        scaled = self.square * share / (self.square * share + 1 - share)
        return (axes * scaled) @ axes.T * np.outer(sd * free, sd * free)

    def errors(self, leg: "Regression") -> float:
        """Return nu: the mean of the noise's parts by their shares, and 1 by the prior's share."""
        parts = leg.noise * self.factors
        of_theta = self.scaled @ leg.m
        by_prior = np.sum((of_theta / np.maximum(self.prior, 1e-300)) ** 2)
        share = (by_prior + leg.bend**2) / (leg.m @ of_theta + leg.bend**2 + 1e-300)
        return float(parts @ self.count / parts.sum() + share)

    def after(self, fix: str, **changes: Any) -> "Guess":
        """Return the guess after one more fix."""
        return replace(self, fixes=(*self.fixes, fix)[-JUDGED:], **changes)


class Regression(NamedTuple):
    """Y = theta m + n over a leg: Y (2,), m (N,), duration, parts of r^2 and two added terms.

    `path` is m along the leg, as predicted with `theta`.
    """

    Y: np.ndarray
    m: np.ndarray
    duration: float
    noise: np.ndarray
    bend: float
    turn: Turn
    theta: np.ndarray
    path: LegRegressor | None = None

    def level(self, guess: Guess, P: np.ndarray, r: float, limits: Limits) -> float:
        """Return the level of a guess after the leg, learned with P and r."""
        assert self.path is not None
        off = np.linalg.norm(self.path.m @ (guess.theta - self.theta).T, axis=1)
        path = self.path._replace(drift=self.path.drift + off)
        error = float(np.linalg.norm(self.Y - guess.theta @ self.m))
        return level_after(guess.level, path, P, r, limits, error)

    def added(self, variance: float) -> float:
        """Return the variance of the turn, given m^T P m."""
        return (min(self.turn.likely, MOST_TURN) / 2) ** 2 * variance


class LegGuesses:
    """Branches of guesses by the law and the settings of a scenario."""

    def __init__(self, scenario: Scenario, settings: FixSettings) -> None:
        between_fixes = scenario.learning.row.between_fixes
        assert between_fixes is not None
        self.between_fixes = between_fixes
        self.settings = settings
        self.wild = (WILD / METRES[scenario.units.length]) ** 2
        self.prior = np.diag(settings.prior**2)

    @property
    def first(self) -> Hypotheses[Guess]:
        """The guess before any fix."""
        settings = self.settings
        return Hypotheses.of(Guess(None, settings.theta, self.prior, settings.prior))

    def variance(self, leg: Regression, guess: Guess, P: np.ndarray) -> float:
        """Return the variance of a position error on each axis, with P the covariance of theta."""
        of_theta = float(leg.m @ P @ leg.m)
        noise = leg.noise @ guess.factors + leg.bend**2
        return float(noise + of_theta + leg.added(of_theta))

    def covariance(self, guesses: Hypotheses[Guess]) -> np.ndarray:
        """Return the covariance of each row of theta, (N, N)."""
        theta, P = theta_of(guesses), np.zeros_like(self.prior)
        for weight, guess in zip(guesses.weights, guesses.states, strict=True):
            off = guess.theta - theta
            P += weight * (guess.scaled + off.T @ off / 2)
        return P

    def radius(self, guesses: Hypotheses[Guess], leg: Regression) -> float:
        """Return the radius of the region of a forecast."""
        theta = theta_of(guesses)
        variances = []
        for guess in guesses.states:
            off = (guess.theta - theta) @ leg.m
            variance = self.variance(leg, guess, guess.scaled)
            variances.append(variance + float(off @ off) / 2)
        counts = np.array([guess.errors(leg) for guess in guesses.states])
        return radius_of(guesses.weights, np.array(variances), counts)

    def branches(
        self, guess: Guess, leg: Regression | None, start: Leg
    ) -> Iterator[Branch]:
        """Yield what a fix may be: log odds, and the guess after it."""
        anywhere = -log(2 * pi * self.wild)
        if leg is None:
            yield RIGHT, anywhere, partial(guess.after, RIGHT, leg=start)
            wrong = anywhere + log(WRONG_SHARE)
            yield WRONG, wrong, partial(guess.after, WRONG, leg=None)
            return
        P = self.between_fixes(guess.P, leg.duration, self.settings.p)
        now = guess if P is guess.P else replace(guess, P=P)
        y = leg.Y - guess.theta @ leg.m
        square = float(y @ y)
        # a wrong fix lies about the forecast
        V = self.variance(leg, now, now.scaled)
        wrong = log(WRONG_SHARE) - log(2 * pi * (V + self.wild))
        yield WRONG, wrong, partial(guess.after, WRONG)
        fastest = FASTEST / self.settings.speed * leg.duration
        if float(np.hypot(*leg.Y)) > fastest + CHI_SQUARED * leg.noise.sum() ** 0.5:
            # the motion was not that, or the fix before is wrong
            begun = partial(guess.after, RIGHT, leg=start)
            yield RIGHT, log(CHANGED_SHARE) + anywhere, begun
            return
        nu = now.errors(leg)
        for fix, odds, P, variance in (
            (RIGHT, 0.0, now.P, V),
            (CHANGED, log(CHANGED_SHARE), now.P + self.prior, None),
        ):
            V = variance or self.variance(leg, guess, self.prior)
            density = -log(2 * pi * V) - (nu / 2 + 1) * log1p(square / (nu * V))
            learned = partial(self._learned, guess, leg, P, fix, start)
            yield fix, odds + density, learned

    def _learned(
        self, guess: Guess, leg: Regression, P: np.ndarray, fix: str, start: Leg
    ) -> Guess:
        """Return a guess after least squares."""
        y = leg.Y - guess.theta @ leg.m
        of_theta = float(leg.m @ P @ leg.m)
        total = float(leg.noise.sum())
        added = leg.added(of_theta)
        r = (total + leg.bend**2 + added) ** 0.5
        before = P
        change, P = least_squares_step(P, leg.m, y, r)
        # shares of the parts of the noise in the variance of the position error
        parts = guess.factors * leg.noise
        bend_and_theta = leg.bend**2 + guess.square * (added + of_theta)
        V = float(parts.sum()) + bend_and_theta
        shares = parts / V
        fading = FADING**shares
        return guess.after(
            fix,
            leg=start,
            theta=guess.theta + change,
            P=P,
            squares=_faded(guess.squares, fading)
            + shares * guess.factors * float(y @ y) / V,
            count=_faded(guess.count, fading) + 2 * shares,
            taught=guess.taught + leg.noise / total * float(leg.m @ leg.m) / r**2,
            level=np.inf
            if fix == CHANGED
            else leg.level(guess, before, r, self.settings.limits),
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


def _faded(sums: np.ndarray, fading: np.ndarray) -> np.ndarray:
    """Return sums over position errors at the next one: those of r as it is set remain."""
    return fading * sums + (1 - fading) * PRIOR_ERRORS


def theta_of(guesses: Hypotheses[Guess]) -> np.ndarray:
    """Return the mean of theta, (2, N)."""
    thetas = np.array([guess.theta for guess in guesses.states])
    return np.einsum("g,gak->ak", guesses.weights, thetas)


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
