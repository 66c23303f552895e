"""Time repeated calls of small models and of tables: `python -m benchmarks.small_runs`.

For each: milliseconds of the first call, of a later one (the median), and how often python-control
takes as long, at rtol 1e-8.
"""

import argparse
import statistics
import time
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import control
import numpy as np

import clpt_control as clpt

REPEATED = 31  # calls
TOLERANCES = {"rtol": 1e-8, "atol": 1e-10}


class Case(NamedTuple):
    """A model and its run."""

    name: str
    system: Any
    times: np.ndarray
    inputs: Any
    start: list[float]


def pendulum(t, x, u, p):
    """Return the rates of a damped pendulum with a torque."""
    return [x[1], -9.81 * np.sin(x[0]) - 0.1 * x[1] + u[0]]


def predators(t, x, u, p):
    """Return the rates of Lotka and Volterra."""
    return [x[0] * (1.0 - 0.1 * x[1]), x[1] * (0.075 * x[0] - 1.5)]


def swing(t, x, u, p):
    """Return the rates of van der Pol."""
    return [x[1], (1.0 - x[0] ** 2) * x[1] - x[0]]


def tanks(t, x, u, p):
    """Return the rates of two tanks."""
    out = 0.3 * np.sqrt(np.maximum(x[0], 0.0))
    return [u[0] - out, out - 0.1 * x[1]]


def car(t, x, u, p):
    """Return the rates of a kinematic car."""
    return [np.cos(x[2]) * u[0], np.sin(x[2]) * u[0], u[0] / 3.0 * np.tan(u[1])]


def cruise(t, x, u, p):
    """Return the rate of a car's speed with friction and drag."""
    return [(u[0] - 10.0 * np.sign(x[0]) - 0.4 * x[0] * abs(x[0])) / 1000.0]


def lorenz(t, x, u, p):
    """Return the rates of Lorenz."""
    return [
        10.0 * (x[1] - x[0]),
        x[0] * (28.0 - x[2]) - x[1],
        x[0] * x[1] - 8.0 / 3.0 * x[2],
    ]


def limited(t, x, u, p):
    """Return the rates of an oscillator with a limited force."""
    return [x[1], -x[0] - 0.4 * x[1] + max(-1.0, min(1.0, u[0]))]


def loop() -> control.InterconnectedSystem:
    """Return a pendulum with a PI controller."""
    names = {"inputs": "u", "outputs": "y", "states": 2, "name": "plant"}
    plant = control.nlsys(pendulum, lambda t, x, u, p: [x[0]], **names)
    names = {"inputs": "e", "outputs": "u", "states": 1, "name": "pi"}
    pi = control.nlsys(
        lambda t, x, u, p: [u[0]], lambda t, x, u, p: 5 * u[0] + 2 * x[0], **names
    )
    error = control.summing_junction(["r", "-y"], "e", name="error")
    return control.interconnect(
        [plant, pi, error], inputs="r", outputs="y", name="loop"
    )


def models() -> Iterator[Case]:
    """Yield ten models of 1 to 4 states and 50 to 500 samples."""

    def case(
        rate: Callable, end: float, samples: int, inputs: Any, start: list[float]
    ) -> Case:
        times, n = np.linspace(0.0, end, samples), len(start)
        m = len(inputs) if isinstance(inputs, list) else 0 if inputs is None else 1
        made = control.nlsys(
            rate, None, inputs=m, outputs=n, states=n, name=rate.__name__
        )
        return Case(rate.__name__, made, times, inputs, start)

    yield case(pendulum, 10, 201, [0.5], [0.3, 0.0])
    yield case(predators, 15, 301, None, [10.0, 5.0])
    yield case(swing, 10, 101, None, [1.0, 0.0])
    yield case(tanks, 50, 101, [0.1], [1.0, 0.0])
    yield case(car, 5, 51, [5.0, 0.1], [0.0, 0.0, 0.0])
    yield case(cruise, 100, 101, [300.0], [20.0])
    yield case(lorenz, 5, 501, None, [1.0, 1.0, 1.0])
    yield case(limited, 10, 201, 2.0 * np.sin(np.linspace(0, 10, 201)), [0.0, 0.0])
    linear = control.ss(
        [[0, 1], [-2, -0.5]], [[0], [1]], [[1, 0]], [[0]], name="linear"
    )
    yield Case("linear", linear, np.linspace(0, 20, 201), 1.0, [0.0, 0.0])
    yield Case("loop", loop(), np.linspace(0, 10, 101), 1.0, [0.0, 0.0, 0.0])


def tables() -> Iterator[Case]:
    """Yield tables of 100 to 100,000 rows, over time and over a state."""
    for rows in (100, 1_000, 10_000, 100_000):
        noise = np.random.default_rng(0).normal(size=rows)
        ts, xs = np.linspace(0.0, 3600.0, rows), np.linspace(0.0, 1.0, rows)
        drive, decay = np.sin(ts / 50) + 0.2 * noise, xs + 0.2 * np.sin(3 * xs)

        def over_time(t, x, u, p, ts=ts, us=drive):
            return [(np.interp(t, ts, us) - x[0]) / 20]

        over_state = lambda t, x, u, p, xs=xs, ys=decay: [-np.interp(x[0], xs, ys)]  # noqa: E731
        for name, rate, end, samples, start in (
            ("time", over_time, 3600, 361, 0.0),
            ("a state", over_state, 5, 51, 1.0),
        ):
            made = control.nlsys(
                rate, None, inputs=0, outputs=1, states=1, name="table"
            )
            times = np.linspace(0, end, samples)
            yield Case(f"{rows:,} rows over {name}", made, times, None, [start])


def milliseconds(run: Callable[[], Any], times: int) -> float:
    """Return how long a call takes, in the median."""
    taken = []
    for _ in range(times):
        begin = time.perf_counter()
        run()
        taken.append(1e3 * (time.perf_counter() - begin))
    return statistics.median(taken)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.small_runs", description=__doc__
    )
    parser.add_argument("--quick", action="store_true", help="without python-control")
    quick = parser.parse_args().quick
    # the solver is compiled
    clpt.simulate(control.nlsys(swing, states=2, inputs=0), [0.0, 1.0])
    for title, cases in (("models", models()), ("tables", tables())):
        later = []
        print(f"{title:28}{'first ms':>10}{'later ms':>10}{'python-control':>16}")
        for case in cases:
            given = case.system, case.times, case.inputs, case.start
            run = partial(clpt.simulate, *given)
            first = milliseconds(run, 1)
            later.append(milliseconds(run, REPEATED))
            inputs = 0.0 if case.inputs is None else case.inputs
            theirs = partial(
                control.input_output_response, case.system, case.times, inputs
            )
            theirs = partial(theirs, case.start, solve_ivp_kwargs=TOLERANCES)
            ratio = "" if quick else f"{milliseconds(theirs, 1) / later[-1]:,.0f} times"
            print(
                f"{case.name:28}{first:10.1f}{later[-1]:10.2f}{ratio:>16}", flush=True
            )
        print(f"median {statistics.median(later):.2f} ms\n")


if __name__ == "__main__":
    main()
