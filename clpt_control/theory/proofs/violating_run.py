"""Search for a run that violates a specification: corners of the sets, random members, descent."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from ...base.arguments import numbers
from ...base.errors import SimulationError
from ...simulation.enclosures import end_of, holds_pair, is_labelled, is_pair
from ...simulation.prepared_runs import Samples
from .specification import Specification, named

CORNERS = 32
MOST_RUNS = 80
MOST_ENDED = 3  # runs that end before the last time


class Members:
    """Members of the sets of inputs, states and parameters, by shares from 0 to 1 of each pair.

    Along some `times` an input with one pair changes once, as its third share says when.
    """

    def __init__(self, given: Mapping[str, Any], times: np.ndarray | None = None):
        self.given, self.times = given, times
        self.member(np.zeros(0))

    def member(self, shares: np.ndarray) -> dict[str, Any]:
        """Return arguments of `simulate`; shares that are missing are 0."""
        left = [*shares]
        self.count = 0

        def share() -> float:
            self.count += 1
            return left.pop(0) if left else 0.0

        return {
            name: self._of(name, value, share) for name, value in self.given.items()
        }

    def _of(self, name: str, value: Any, share: Callable[[], float]) -> Any:
        if is_pair(value):
            if any(map(is_labelled, value)):  # an end, whole, with its labels
                return end_of(name, value, bool(share() > 0.5))
            low, high = (numbers(name, end) for end in value)
            if name == "inputs" and self.times is not None and not low.ndim:
                levels, when = [share(), share()], 0.1 + 0.8 * share()
                is_last = np.arange(len(self.times)) > when * len(self.times)
                steps = np.take(levels, is_last.astype(int))
                return np.clip(low + steps * (high - low), low, high)
            at = np.array([share() for _ in range(low.size)]).reshape(low.shape)
            return np.clip(low + at * (high - low), low, high)[()]
        if isinstance(value, list):
            return [self._of(name, one, share) for one in value]
        if isinstance(value, Mapping):
            return {key: self._of(name, one, share) for key, one in value.items()}
        # pairs within tables and other containers
        return end_of(name, value, bool(share() > 0.5)) if holds_pair(value) else value

    def corners(self, rng: np.random.Generator) -> Iterator[np.ndarray]:
        """Yield the middle, corners, and random members."""
        yield np.full(self.count, 0.5)
        if self.count:
            codes = np.arange(2 ** min(self.count, 5))[:, None] >> np.arange(self.count)
            corners = (codes & 1).astype(float)
            if self.count > 5:
                corners = rng.integers(0, 2, (CORNERS, self.count)).astype(float)
            yield from corners[:CORNERS]
            yield from rng.uniform(0.0, 1.0, (8, self.count))


class Search:
    """Search for a run with a margin below 0."""

    def __init__(
        self,
        run: Callable[..., Any],
        specs: list[Specification],
        members: Members,
        *of: Any,
    ):
        """Take a function that returns runs, and what `margins_along` takes of these."""
        self.run, self.specs, self.members, self.of = run, specs, members, of
        self.best = np.inf, np.zeros(0), 0.0  # least margin, shares, and time
        self.runs = self.ended = 0
        self.without: dict[str, None] = {}  # sentences on what has no margin

    def at(self, shares: np.ndarray) -> float:
        """Return the least margin of the run of a member; NaN margins are not seen."""
        member = self.members.member(shares)
        self.runs += 1
        try:
            run = self.run(**member)
        except SimulationError as error:
            self.ended += 1
            self.without.setdefault(f"a run ends: {error}")
            return np.inf
        margins = [margins_along(spec, run, *self.of) for spec in self.specs]
        for spec, margin in zip(self.specs, margins, strict=True):
            if np.any(unknown := np.isnan(margin)):
                t = self.of[0][np.argmax(unknown)]
                self.without.setdefault(
                    f"the margin of {spec.claim} has no value at t = {t:.9g} of a run"
                )
        lows = [np.nanmin(m, initial=np.inf) for m in margins]
        least = float(min(lows))
        if least < self.best[0]:
            row = np.nan_to_num(margins[int(np.argmin(lows))], nan=np.inf)
            self.best = least, shares, float(self.of[0][int(np.argmin(row))])
        return least

    def __call__(self, rng: np.random.Generator) -> None:
        """Try corners and random members, then go down from the best, share by share."""
        for shares in self.members.corners(rng):
            if self.at(shares) < 0.0 or self.ended > MOST_ENDED:
                return
        step = 0.5 if np.isfinite(self.best[0]) else 0.0
        while self.members.count and step > 0.01 and self.runs < MOST_RUNS:
            least, at, _ = self.best
            for k in rng.permutation(self.members.count):
                for sign in (-1.0, 1.0):
                    moved = at.copy()
                    moved[k] = np.clip(moved[k] + sign * step, 0.0, 1.0)
                    if moved[k] != at[k] and self.at(moved) < 0.0:
                        return
            if self.best[0] >= least:
                step *= 0.5


def margins_along(
    spec: Specification, run: Any, times: np.ndarray, labels: Sequence[list[str]]
) -> np.ndarray:
    """Return the margin of a run along its times, infinite before the specification begins.

    A run has samples, and `labels` of its outputs and states; or, in discrete time, its Dataset.
    """
    signals: dict[str, Any] = {}
    if isinstance(run, Samples):
        for of, values in zip(labels, (run.outputs, run.states), strict=True):
            named(of, values.T, signals)
    else:
        for name, values in run.data_vars.items():
            if name != "states":
                columns = values.transpose("time", ...).values.reshape(len(times), -1).T
                named([f"{name}[{k}]" for k in range(len(columns))], columns, signals)
        named(run.state.values.tolist(), run.states.values.T, signals)
    with np.errstate(all="ignore"):
        value = spec.of({**signals, "t": times})
    value = np.broadcast_to(np.asarray(value, float), times.shape)
    return np.where(times >= spec.begin, value, np.inf)
