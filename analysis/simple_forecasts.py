"""Forecasts of a dive's current by simple rules, next to the replay's estimator.

The current of a past dive is its position error over its duration.  Each rule forecasts the
current of the next dive from those of all earlier dives; the ratio is the rms position error
after the third dive over that of the rule "previous dive".  Duration and dead reckoning of the
dive are taken as known, as `clpt replay` does one dive ahead.

Rules: running mean; exponential smoothing with weight 0.5; tides alone (mean and M2 by least
squares with priors of 0.3 and 0.1 m/s); a single Gaussian process with a steady current, a slow
one (Matern 3/2, 2 days), scatter and M2 (C. E. Rasmussen, C. K. I. Williams, "Gaussian Processes
for Machine Learning", 2006, section 2.2).

    python -m analysis.simple_forecasts [FILES and FOLDERS, a vehicle each...] [--out FOLDER]
"""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from clpt_control.gliders import Dive, read_dives, sample_dives
from clpt_control.replay import replay_dives

from .study import make_folder

DAY, M2 = 86400.0, 2 * np.pi / 44714.0  # s, rad/s
FIRST = 3  # dives before the first forecast that counts
STEADY, TIDE, SLOW, SCATTER = 0.3, 0.1, 0.1, 0.02  # m/s

Rule = Callable[[np.ndarray, np.ndarray, float], np.ndarray]  # times, currents, time


def previous_dive(times: np.ndarray, currents: np.ndarray, time: float) -> np.ndarray:
    """Return the current of the previous dive."""
    return currents[-1]


def running_mean(times: np.ndarray, currents: np.ndarray, time: float) -> np.ndarray:
    """Return the mean of all earlier dives."""
    return currents.mean(axis=0)


def exponential_smoothing(
    times: np.ndarray, currents: np.ndarray, time: float
) -> np.ndarray:
    """Return the mean of earlier dives, each weighted half as much as the next one."""
    weight = 0.5 ** np.arange(len(currents))[::-1]
    return weight @ currents / weight.sum()


def by_covariance(covariance: Callable[[np.ndarray], np.ndarray]) -> Rule:
    """Return the Gaussian-process regression with a covariance of lags, (m/s)^2."""

    def forecast(times: np.ndarray, currents: np.ndarray, time: float) -> np.ndarray:
        K = covariance(times[:, None] - times) + SCATTER**2 * np.eye(len(times))
        return covariance(time - times) @ np.linalg.solve(K, currents)

    return forecast


def tides(lag: np.ndarray) -> np.ndarray:
    """Return the covariance of a steady current and an M2 tide."""
    return STEADY**2 + TIDE**2 * np.cos(M2 * lag)


def slow_and_tides(lag: np.ndarray) -> np.ndarray:
    """Return the covariance of a steady current, a slow current and an M2 tide."""
    v = np.sqrt(3) * np.abs(lag) / (2 * DAY)
    return tides(lag) + SLOW**2 * (1 + v) * np.exp(-v)


RULES: dict[str, Rule] = {
    "previous dive": previous_dive,
    "running mean": running_mean,
    "exponential smoothing": exponential_smoothing,
    "tides alone": by_covariance(tides),
    "small Gaussian process": by_covariance(slow_and_tides),
}


def errors(dives: list[Dive]) -> dict[str, float]:
    """Return the rms position error (m) after the third dive of each rule and of the replay.

    All use the dives of the replay, in which wild fixes are replaced.
    """
    steps = replay_dives(dives).steps
    dives = [step.dive for step in steps]
    times = np.array([(dive.t_gps2 + dive.t_gpse) / 2 for dive in dives])
    durations = np.array([dive.duration for dive in dives])
    misses = np.array([(dive.miss_east, dive.miss_north) for dive in dives])
    currents = misses / durations[:, None]
    found = {}
    for name, rule in RULES.items():
        off = [
            np.hypot(*(rule(times[:k], currents[:k], times[k]) - currents[k]))
            for k in range(FIRST, len(dives))
        ]
        found[name] = float(np.sqrt(np.mean((np.array(off) * durations[FIRST:]) ** 2)))
    clpe = np.array([step.clpe["adaptive"] for step in steps[FIRST:]])
    found["replay"] = float(np.sqrt(np.mean(clpe**2)))
    return found


def main(
    files: Annotated[list[Path] | None, typer.Argument()] = None,
    out: Path = Path("simple_forecasts"),
) -> None:
    """Print the table of ratios to the previous dive's current, and write it."""
    records = {str(path.name): read_dives(path)[0] for path in files or ()}
    records = records or {"SG542": sample_dives()}
    names = [*list(RULES)[1:], "replay"]
    lines = [
        f"| vehicle | dives | {' | '.join(names)} |",
        "|---" * (len(names) + 2) + "|",
    ]
    ratios = []
    for vehicle, dives in records.items():
        found = errors(dives)
        ratios.append([found[name] / found["previous dive"] for name in names])
        cells = " | ".join(f"{ratio:.2f}" for ratio in ratios[-1])
        lines.append(f"| {vehicle} | {len(dives)} | {cells} |")
    means = " | ".join(f"{x:.2f}" for x in np.exp(np.log(ratios).mean(axis=0)))
    lines.append(f"| geometric mean | | {means} |")
    text = "\n".join(lines) + "\n"
    (make_folder(out) / "simple_forecasts.md").write_text(text, "utf-8")
    print(text)


if __name__ == "__main__":
    typer.run(main)
