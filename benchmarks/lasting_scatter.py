"""Coverage of the flow learned from fixes in seas whose scatter lasts.

`python -m benchmarks.lasting_scatter [--missions 60] [--basis uniform|local]` simulates missions of
a vehicle of 1 m/s in a flow theta phi with a scatter of Ornstein and Uhlenbeck, and prints for each
interval of fixes, size and time of the scatter:

    in        share of parameters within 1.645 standard errors, 0.9 if these are right
    rms, se   errors of the parameters and median standard error, m/s
    leg 1 ... share of fixes in the 90 % regions of their forecasts
    wide      median radius over the 0.9 quantile of the errors of forecasts
"""

import argparse
from typing import Any

import numpy as np

import clpt_control as clpt
from clpt_control.base.geodesy import place_from

SCATTER, FIX = 0.02, 10.0  # m/s, m: as the estimator assumes
LEGS = {10800.0: 24, 3600.0: 48, 600.0: 144}  # interval, s
SIZES, HOURS = (1.0, 5.0, 0.25), (0.0, 3.0, 12.0)
GROUPS = {"1": (0, 1), "2": (1, 2), "3": (2, 3), "4-6": (3, 6), "7-20": (6, 20)}
STEPS = 10  # of a leg
# centres and width, m; a width of None is a function that is the same everywhere
BASES = {
    "uniform": (np.zeros((1, 2)), None),
    "local": (np.array([[0.0, 0.0], [10e3, 0.0], [5e3, 9e3]]), 7e3),
}


def scenario_of(centers: np.ndarray, width: float | None) -> clpt.Scenario:
    """Return the scenario of the learner."""
    tables: dict[str, Any] = {
        "origin": None if width is None else (0.0, 0.0),
        "units": {"length": "km", "time": "h"},
        "basis": {
            "kernel": "gaussian",
            "centers": (centers / 1e3).tolist(),
            "widths": [1e5 if width is None else width / 1e3] * len(centers),
            "constituents": ["steady"] * len(centers),
        },
        "learning": {"law": "fix-regression"},
    }
    return clpt.Scenario(**tables)


def mission(
    draw: np.random.Generator,
    centers: np.ndarray,
    width: float | None,
    span: float,
    size: float,
    hours: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return theta (2, N), fixes (n + 1, 2) and ways through the water (n, STEPS, 2), m."""
    theta = draw.normal(0.0, 0.15, (2, len(centers)))
    S, step = SCATTER * size, span / STEPS
    q = np.exp(-step / (3600 * hours)) if hours else 0.0
    position, x = np.array([5e3, 3e3]), S * draw.normal(size=2)
    aim, ways = position, []
    fixes = [position + FIX * draw.normal(size=2)]
    for _ in range(LEGS[span]):
        way, of_leg = [], S * draw.normal(size=2)
        for _ in range(STEPS):
            while np.linalg.norm(aim - position) < 2 * step:
                aim = draw.uniform(-3e3, 13e3, 2)
            through = (aim - position) / np.linalg.norm(aim - position)
            x = q * x + S * np.sqrt(1 - q**2) * draw.normal(size=2)
            phi = np.ones(1)
            if width is not None:
                squares = np.sum((position - centers) ** 2, axis=1)
                phi = np.exp(-squares / (2 * width**2))
            way.append(step * through)
            drift = theta @ phi + (x if hours else of_leg)
            position = position + step * (through + drift)
        ways.append(way)
        fixes.append(position + FIX * draw.normal(size=2))
    return theta, np.array(fixes), np.array(ways)


def learned(
    scenario: clpt.Scenario, span: float, fixes: np.ndarray, ways: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return theta (2, N), standard errors (N,), errors and radii of forecasts (n, 2)."""
    estimator = clpt.currents.FlowEstimator(scenario)
    estimator.is_screened = False  # each position was measured
    time, forecasts = 1.7e9, []
    estimator.fix(time, *place_from(0.0, 0.0, *fixes[0]))
    for fix, way in zip(fixes[1:], ways, strict=True):
        for moved in way:
            time += span / STEPS
            estimator.move(time, *moved)
        result = estimator.fix(time, *place_from(0.0, 0.0, *fix))
        assert result.forecast is not None
        forecasts.append((result.error, result.forecast.radius))
    return estimator.flow_parameters, estimator.standard_error, np.array(forecasts)


def row(basis: str, span: float, size: float, hours: float, missions: int) -> str:
    """Return the figures of one kind of missions."""
    centers, width = BASES[basis]
    scenario, key = scenario_of(centers, width), (int(span), int(100 * size))
    off, errors, forecasts = [], [], []
    for number in range(missions):
        draw = np.random.default_rng([*key, int(hours), number])
        theta, *flown = mission(draw, centers, width, span, size, hours)
        found, error, forecast = learned(scenario, span, *flown)
        off.append(found - theta)
        errors.append(error)
        forecasts.append(forecast)
    inside = np.abs(off) <= 1.645 * np.array(errors)[:, None]
    distance, radius = np.moveaxis(np.array(forecasts), -1, 0)
    shares = [
        np.mean((distance <= radius)[:, start:stop]) for start, stop in GROUPS.values()
    ]
    wide = np.median(radius) / np.quantile(distance, 0.9)
    rms, se = np.sqrt(np.mean(np.square(off))), np.median(errors)
    figures = [np.mean(inside), rms, se, *shares, wide]
    digits = ["5.2f", "7.4f", "7.4f", *["5.2f"] * (len(shares) + 1)]
    numbers = [f"{x:{digit}}" for x, digit in zip(figures, digits, strict=True)]
    return " ".join([f"{span:6.0f} {size:5g} {hours:5g}", *numbers])


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--missions", type=int, default=60)
    parser.add_argument("--basis", choices=list(BASES), default="uniform")
    options = parser.parse_args()
    groups = " ".join(f"{name:>5}" for name in GROUPS)
    print(f"  fix/s  size hours    in     rms      se {groups}  wide")
    for span in LEGS:
        for size in SIZES:
            for hours in HOURS:
                print(
                    row(options.basis, span, size, hours, options.missions), flush=True
                )


if __name__ == "__main__":
    main()
