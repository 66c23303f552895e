"""Small smooth models: the compiled diagram and `simulate` beside heyoka and diffrax.

A model is one function of (f, x) that every engine traces, with f.sin and f.cos.  Each run has its
error at the end against SciPy's DOP853 at 1e-13.  "series" is the machine code of
``method="taylor"`` with arrays that are ready, as heyoka's; a compiled diagram also checks its
arguments.  The 1,000 runs of a model differ in their first state.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import control
import numpy as np
from scipy.integrate import solve_ivp

import clpt_control as clpt
from clpt_control.engine.solver.native_diagram import compile
from clpt_control.engine.solver.runner import RunOptions
from clpt_control.engine.solver.series_runs import SeriesArrays, series_of

from .engines import ENGINES, timed
from .measure import interleave

RTOL, ATOL = 1e-8, 1e-10
MEMBERS = 1000
Run = Callable[[], tuple[np.ndarray, float]]


class Model(NamedTuple):
    """Rates, start and end of a model, number of samples and tolerances."""

    name: str
    rates: Callable[[Any, Any], list]
    start: list[float]
    end: float
    samples: int = 2
    rtol: float = RTOL
    atol: float = ATOL

    @property
    def times(self) -> np.ndarray:
        """Times of the samples."""
        return np.linspace(0.0, self.end, self.samples)


def van_der_pol(f: Any, x: Any) -> list:
    """Return the rates of van der Pol."""
    return [x[1], (1.0 - x[0] * x[0]) * x[1] - x[0]]


def lorenz(f: Any, x: Any) -> list:
    """Return the rates of Lorenz."""
    return [
        10.0 * (x[1] - x[0]),
        x[0] * (28.0 - x[2]) - x[1],
        x[0] * x[1] - 8.0 / 3.0 * x[2],
    ]


def pendulum(f: Any, x: Any) -> list:
    """Return the rates of a damped pendulum."""
    return [x[1], -9.81 * f.sin(x[0]) - 0.1 * x[1]]


def two_bodies(f: Any, x: Any) -> list:
    """Return the rates of an orbit in the plane."""
    cube = (x[0] * x[0] + x[1] * x[1]) ** -1.5
    return [x[2], x[3], -x[0] * cube, -x[1] * cube]


def chemostat(f: Any, x: Any) -> list:
    """Return the rates of biomass, substrate and an inhibitor."""
    growth = 0.9 * x[1] / (0.3 + x[1] + 0.5 * x[1] * x[1])
    eaten = 0.2 * x[2] * x[0] / (1.0 + x[2])
    return [
        (growth - 0.3) * x[0],
        0.3 * (4.0 - x[1]) - 2.0 * growth * x[0],
        0.3 * (1.0 - x[2]) - eaten,
    ]


def double_pendulum(f: Any, x: Any) -> list:
    """Return the rates of two pendulums, one below the other."""
    g = 9.81
    cos, sin = f.cos(x[0] - x[1]), f.sin(x[0] - x[1])
    upper, lower = sin * x[2] * x[2], sin * x[3] * x[3]
    first, second = f.sin(x[0]), f.sin(x[1])
    inertia = 2.0 - cos * cos
    return [
        x[2],
        x[3],
        (g * second * cos - cos * upper - lower - 2.0 * g * first) / inertia,
        (2.0 * upper + cos * lower + 2.0 * g * (first * cos - second)) / inertia,
    ]


def pendulums(f: Any, x: Any) -> list:
    """Return the rates of 50 pendulums, each with a spring to the next."""
    angles = [0.0, *(x[k] for k in range(50)), 0.0]
    pulls = [angles[k] - 2.0 * angles[k + 1] + angles[k + 2] for k in range(50)]
    return [x[50 + k] for k in range(50)] + [pulls[k] - f.sin(x[k]) for k in range(50)]


LORENZ = Model("Lorenz, 3 states", lorenz, [1.0, 1.0, 1.0], 5.0)
ORBIT = Model("two bodies, e = 0.6", two_bodies, [0.4, 0.0, 0.0, 2.0], 20.0)
SMALL = (
    Model("van der Pol, 2 states", van_der_pol, [1.0, 0.0], 20.0),
    LORENZ,
    Model("pendulum, 2 states", pendulum, [1.0, 0.0], 20.0),
    ORBIT,
    Model("chemostat, 3 states", chemostat, [0.2, 3.0, 0.5], 40.0),
    Model("double pendulum", double_pendulum, [1.0, 0.5, 0.0, 0.0], 5.0),
)
LARGE = Model("pendulums, 100 states", pendulums, [1.0, *[0.0] * 99], 5.0)
MODELS = (
    *SMALL,
    LORENZ._replace(name="Lorenz, 501 samples", samples=501),
    ORBIT._replace(name="two bodies to 2000", end=2000.0, rtol=1e-15, atol=1e-16),
    LARGE,
)


def system(model: Model) -> control.NonlinearIOSystem:
    """Return a model of python-control."""
    return control.nlsys(
        lambda t, x, u, p: model.rates(np, x),
        inputs=0,
        states=[f"x{k}" for k in range(len(model.start))],
        name="model",
    )


def exact(model: Model, start: Any) -> np.ndarray:
    """Return the state at the end: of a long orbit by Kepler's equation, else by SciPy."""
    if model.rates is two_bodies and model.end > ORBIT.end:
        return kepler(model.end)
    rates = lambda t, x: model.rates(np, x)  # noqa: E731
    tight = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-14}
    return solve_ivp(rates, (0.0, model.end), start, **tight).y[:, -1]


def kepler(t: float, e: float = 0.6) -> np.ndarray:
    """Return place and velocity on an ellipse of half axis 1, from its least radius."""
    anomaly = t
    for _ in range(50):
        anomaly -= (anomaly - e * np.sin(anomaly) - t) / (1 - e * np.cos(anomaly))
    cos, sin, minor = np.cos(anomaly), np.sin(anomaly), np.sqrt(1 - e * e)
    rate = 1 / (1 - e * cos)
    return np.array([cos - e, minor * sin, -sin * rate, minor * cos * rate])


def compiled(model: Model) -> Run:
    """Prepare the compiled diagram."""
    native = compile(system(model))
    times, given = model.times, {"rtol": model.rtol, "atol": model.atol}
    run = lambda: native.run(model.start, times, **given).x[-1]  # noqa: E731
    return lambda: timed(run)


def by_series(model: Model) -> Run:
    """Prepare the machine code of Taylor series."""
    native = compile(system(model))
    times, start = model.times, np.array([model.start])
    code = series_of(native, model.rtol)
    segments = native.schedule(times)
    arrays = SeriesArrays(code, 1, start.size, len(times), segments)
    options = RunOptions(model.rtol, model.atol)
    runs = start, native.layout.P[None], times, segments, options

    def run() -> np.ndarray:
        arrays.begin(*runs)
        arrays.go()
        return arrays.samples[0, 0, -1].copy()

    return lambda: timed(run)


def simulated(model: Model) -> Run:
    """Prepare `simulate`."""
    made, times = system(model), model.times
    given = {"initial_state": model.start, "rtol": model.rtol, "atol": model.atol}
    run = lambda: clpt.simulate(made, times, **given).states.values[-1]  # noqa: E731
    return lambda: timed(run)


def by_heyoka(model: Model) -> Run:
    """Prepare Taylor series of heyoka."""
    import heyoka as hy

    states = hy.make_vars(*[f"s{k}" for k in range(len(model.start))])
    rates = [hy.expression(0.0) + rate for rate in model.rates(hy, states)]
    pairs = list(zip(states, rates, strict=True))
    compact = len(states) > 10
    solver = hy.taylor_adaptive(
        pairs, model.start, tol=model.rtol, compact_mode=compact
    )
    times = model.times

    def run() -> np.ndarray:
        solver.time, solver.state[:] = 0.0, model.start
        if len(times) > 2:
            return solver.propagate_grid(times)[-1][-1]
        solver.propagate_until(model.end)
        return solver.state.copy()

    return lambda: timed(run)


def by_diffrax(model: Model, starts: np.ndarray | None = None) -> Run:
    """Prepare Dopri8 of diffrax, of one run or of one for each start."""
    import diffrax
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)

    def one(start):
        return diffrax.diffeqsolve(
            diffrax.ODETerm(lambda t, x, _: jnp.stack(model.rates(jnp, x))),
            diffrax.Dopri8(),
            0.0,
            model.end,
            None,
            start,
            saveat=diffrax.SaveAt(t1=True),
            stepsize_controller=diffrax.PIDController(rtol=RTOL, atol=ATOL),
            max_steps=None,
        ).ys[0]

    begin = jnp.asarray(np.array(model.start) if starts is None else starts)
    function = jax.jit(one if starts is None else jax.vmap(one))
    return lambda: timed(lambda: np.asarray(function(begin)))


def ensemble(model: Model, first: np.ndarray) -> Run:
    """Prepare `run_ensemble` over the first state."""
    made, vary = system(model), {"x0": first.tolist()}
    given = {"timepts": [0.0, model.end], "initial_state": model.start}
    finals = [f"x{k}_final" for k in range(len(model.start))]

    def run() -> np.ndarray:
        data = clpt.run_ensemble(made, vary, **given, rtol=RTOL, atol=ATOL)
        return np.column_stack([data[name].values for name in finals])

    return lambda: timed(run)


def in_lanes(model: Model, first: np.ndarray, method: str = "auto") -> Run:
    """Prepare members of the compiled diagram in SIMD lanes."""
    from clpt_control.ensemble.members import Ensemble
    from clpt_control.ensemble.sampled_parameters import read_vary
    from clpt_control.ensemble.varied_diagram import VariedDiagram

    times = np.array([0.0, model.end])
    varied = VariedDiagram(
        system(model),
        [read_vary("x0=0:1")],
        times,
        initial_state=model.start,
        rtol=RTOL,
        atol=ATOL,
        method=method,
    )
    many = Ensemble(varied, ["x0"])
    members = many.members({"x0": first})
    return lambda: timed(lambda: many.run(members, times).states[:, -1])


def cases() -> Iterator[tuple[str, np.ndarray, dict[str, Callable[[], Run]]]]:
    """Yield the name of each row, its exact end, and what prepares each engine."""
    for model in MODELS:
        prepare = {
            "native": compiled,
            "taylor": by_series,
            "simulate": simulated,
            "heyoka": by_heyoka,
            "diffrax": by_diffrax,
        }
        if model is LARGE:  # a series of 100 states is refused
            del prepare["taylor"]
        if model not in (*SMALL, LARGE):
            del prepare["diffrax"]
        runs = {name: partial(made, model) for name, made in prepare.items()}
        yield model.name, exact(model, model.start), runs
    for model in SMALL:
        first = np.linspace(0.95, 1.05, MEMBERS) * model.start[0]
        starts = np.tile(model.start, (MEMBERS, 1))
        starts[:, 0] = first
        runs = {
            "native": partial(in_lanes, model, first),
            "taylor": partial(in_lanes, model, first, "taylor"),
        }
        if model is LORENZ:
            runs |= {
                "simulate": partial(ensemble, model, first),
                "diffrax": partial(by_diffrax, model, starts),
            }
        ends = np.array([exact(model, start) for start in starts[:: MEMBERS // 20]])
        yield f"{model.name.partition(',')[0]}, {MEMBERS:,} runs", ends, runs


def measure(chosen: list[str], rounds: int, budget: float, say: Callable) -> list[dict]:
    """Time each row's engines in turn; return model, engine, seconds and error of each."""
    rows = []
    if "native" in chosen:  # which has two methods
        chosen = [*chosen, "taylor"]
    for model, ends, prepare in cases():
        runs, errors = {}, {}
        for name in [name for name in prepare if name in chosen]:
            say(f"{model}: {ENGINES[name].title if name in ENGINES else name}")
            run = prepare[name]()
            found = run()[0]
            found = found[:: len(found) // len(ends)] if ends.ndim == 2 else found
            errors[name] = float(np.max(np.abs(found - ends)))
            runs[name] = lambda run=run: run()[1]
        for name, figures in interleave(runs, rounds, budget, say).items():
            own = {"model": model, "engine": name, "error": errors[name]}
            rows.append(own | figures)
    return rows
