"""Run a scenario or any diagram, exactly to every breakpoint.

A scenario gives an `xarray.Dataset` with CF attributes, from which the run can
be repeated; a diagram gives python-control's own `TimeResponseData`.
"""

from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from . import __version__
from .blocks.lyapunov import LyapunovParameters, lyapunov_candidate
from .diagram import closed_loop, initial_state
from .errors import SimulationError
from .native.integrate import Solution, integrate
from .native.sweep import Sweep
from .scenario import Scenario
from .scenario_file import scenario_to_text

if TYPE_CHECKING:
    import xarray

VARIABLES = {  # name -> (port, long name, unit of length or none, powers of 1/time)
    "position": ("x", "true position", 1, 0),
    "predicted_position": ("z", "predicted position", 1, 0),
    "clpe": ("e", "controlled Lagrangian prediction error", 1, 0),
    "reference": ("zc", "desired position", 1, 0),
    "feedback_gain": ("K", "adapted feedback gain", 0, 1),
    "feedforward_gain": ("Gamma", "adapted feedforward gain", 0, 1),
    "alpha": ("alpha", "adapted parameter alpha", 1, 1),
    "true_flow": ("flow_x", "true flow at the vehicle", 1, 1),
}


def simulate(
    system: "Scenario | control.NonlinearIOSystem",
    timepts: Sequence[float] | np.ndarray | None = None,
    inputs: Any = None,
    initial_state: Sequence[float] | np.ndarray | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Callable[[float], None] | None = None,
) -> Any:
    """Run a scenario, or any diagram of blocks.

    Parameters
    ----------
    system : Scenario or control.NonlinearIOSystem
        A scenario gives a Dataset, a diagram a TimeResponseData.
    timepts : array_like, optional
        Times of the samples, increasing; a scenario has its own
        (multiples of ``run.output_step``, and the end).
    inputs : array_like or callable, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a
        callable gives the inputs at any time.
    initial_state : array_like, optional
        State at ``timepts[0]``; zero for a diagram, the scenario's own else.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    rtol, atol : float, optional
        Tolerances; the scenario's own, or 1e-8 and 1e-10.
    progress : callable, optional
        Called with the time reached, after each step.

    Returns
    -------
    xarray.Dataset or control.TimeResponseData
        Samples at the times asked for; values at a jump are right limits.

    Raises
    ------
    SimulationError
        If the run cannot go on; block, signal and time are named.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> run = clpt.simulate(scenario)
    >>> float(run.clpe[-1, 0].round(3)), run.attrs["status"]
    (0.027, 'finished')
    """
    if isinstance(system, Scenario):
        if inputs is not None:
            raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
        return _simulate_scenario(system, timepts, initial_state, params, rtol, atol, progress)
    return _simulate_diagram(
        system, timepts, inputs, initial_state, params, rtol or 1e-8, atol or 1e-10, progress
    )


def sample_times(duration: float, step: float) -> np.ndarray:
    """Give the multiples of `step` up to `duration`, and `duration`.

    Examples
    --------
    >>> sample_times(1.0, 0.4)
    array([0. , 0.4, 0.8, 1. ])
    """
    times = step * np.arange(int(np.floor(duration / step * (1 + 1e-12))) + 1)
    times = times[times < duration * (1 - 1e-12)]
    return np.append(times, duration)


def _checked_times(timepts: Any) -> np.ndarray:
    times = np.atleast_1d(np.asarray(timepts, dtype=float))
    if times.ndim != 1 or len(times) < 2 or not np.all(np.diff(times) > 0):
        raise SimulationError("timepts: must be at least two increasing times")
    if not np.all(np.isfinite(times)):
        raise SimulationError("timepts: must be finite")
    return times


def _simulate_diagram(
    diagram, timepts, inputs, x0, params, rtol, atol, progress
) -> control.TimeResponseData:
    if timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    times = _checked_times(timepts)
    sweep = Sweep(diagram, params)
    u, kinks = _input_function(inputs, times, diagram.ninputs or 0)
    state = np.zeros(sweep.nstates) if x0 is None else np.broadcast_to(x0, sweep.nstates)
    solution = integrate(
        sweep, state, times, rtol=rtol, atol=atol, inputs=u, stops=kinks, progress=progress
    )
    signals = sample_signals(sweep, solution, u)
    outputs = sweep.wiring.output_map @ np.vstack(
        [signals.T, np.array([u(t) for t in solution.t]).reshape(len(solution.t), -1).T]
    )
    return control.TimeResponseData(
        solution.t,
        outputs,
        solution.x.T,
        np.array([u(t) for t in solution.t]).reshape(len(solution.t), -1).T,
        output_labels=diagram.output_labels,
        state_labels=diagram.state_labels,
        input_labels=diagram.input_labels,
        title=f"Response of {diagram.name}",
        sysname=diagram.name,
        issiso=False,
        success=True,
        message=solution.message,
    )


def _input_function(inputs: Any, times: np.ndarray, count: int):
    """Give u(t) and the times of its kinks."""
    if callable(inputs):
        return (lambda t: np.asarray(inputs(t), dtype=float)), None
    values = np.zeros(count) if inputs is None else np.asarray(inputs, dtype=float)
    if values.ndim <= 1 and not (count == 1 and values.shape == times.shape and len(times) > 1):
        try:
            held = np.broadcast_to(values, count)
        except ValueError:
            raise SimulationError(
                f"inputs: shape {values.shape} does not fit {count} inputs at {len(times)} times"
            ) from None
        return (lambda t: held), None
    values = np.atleast_2d(values)
    if values.shape != (count, len(times)):
        raise SimulationError(
            f"inputs: shape {values.shape} must be ({count}, {len(times)}): inputs x timepts"
        )
    if not np.all(np.isfinite(values)):
        raise SimulationError("inputs: must be finite; fill the gaps before the run")

    def straight(t: float) -> np.ndarray:
        k = int(np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2))
        share = (t - times[k]) / (times[k + 1] - times[k])
        return values[:, k] + share * (values[:, k + 1] - values[:, k])

    return straight, times


def sample_signals(sweep: Sweep, solution: Solution, u: Callable | None = None) -> np.ndarray:
    """Give all block outputs at a solution's times.

    Values at a jump are right limits.

    Parameters
    ----------
    sweep : Sweep
        The diagram.
    solution : Solution
        Times and states.
    u : callable, optional
        Inputs of the diagram as a function of time.

    Returns
    -------
    ndarray, shape (ntimes, nsignals)
        In the order of `Sweep.signals`.
    """
    times = solution.t
    signals = np.empty((len(times), len(sweep.signals)))
    jumps = sweep.breakpoints(times[0], times[-1])
    interval = np.searchsorted(jumps, times, side="right")
    for k, t in enumerate(times):
        if k == 0 or interval[k] != interval[k - 1]:
            sweep.enter(t)
        signals[k] = sweep.evaluate(t, solution.x[k], None if u is None else u(t))
    return signals


def _simulate_scenario(scenario, timepts, x0, params, rtol, atol, progress) -> "xarray.Dataset":
    run = scenario.run
    if timepts is None:
        times = sample_times(run.duration, run.output_step)
    else:
        times = _checked_times(timepts)
    diagram = closed_loop(scenario)
    sweep = Sweep(diagram, params)
    state = initial_state(scenario) if x0 is None else np.asarray(x0, dtype=float)
    solution = integrate(
        sweep,
        state,
        times if times[0] == 0 else np.concatenate([[0.0], times]),
        rtol=rtol or run.rtol,
        atol=atol or run.atol,
        progress=progress,
    )
    if times[0] != 0:
        solution.t, solution.x = solution.t[1:], solution.x[1:]
    return _dataset(scenario, diagram, sweep, solution, params)


def _dataset(scenario, diagram, sweep, solution, params) -> "xarray.Dataset":
    import xarray

    units, N, n = scenario.units, scenario.basis.N, len(solution.t)
    signals = sample_signals(sweep, solution)
    column = {label: k for k, label in enumerate(diagram.output_labels)}
    data: dict[str, Any] = {}
    for name, (port, long_name, lengths, rates) in VARIABLES.items():
        size = 2 * N if port == "alpha" else 2
        values = signals[:, [column[f"{port}[{k}]"] for k in range(size)]]
        unit = " ".join([units.length] * lengths + [f"{units.time}-1"] * rates)
        dims: tuple[str, ...] = ("time", "axis")
        if port == "alpha":
            values, dims = values.reshape(n, 2, N), ("time", "axis", "basis")
        data[name] = (dims, values, {"long_name": long_name, "units": unit})
    alpha = data["alpha"][1]
    estimate = 0.0 - alpha  # without -0
    if scenario.learning.law == "known-flow":
        estimate = np.broadcast_to(np.array(scenario.learning.theta_estimate), alpha.shape).copy()
    speed = {"units": f"{units.length} {units.time}-1"}
    data["flow_parameters_estimate"] = (
        ("time", "axis", "basis"),
        estimate,
        {"long_name": "estimate of the flow parameters theta", **speed},
    )
    if scenario.flow.parameters is not None:
        true = np.array(scenario.flow.parameters)
        data["flow_parameters"] = (
            ("axis", "basis"), true, {"long_name": "true flow parameters theta", **speed},
        )  # fmt: skip
        data["lyapunov"] = (
            ("time",),
            _lyapunov(scenario, data),
            {"long_name": "Lyapunov candidate V", "units": f"{units.length}2"},
        )
    return xarray.Dataset(
        data,
        {
            "time": ("time", solution.t, {"long_name": "time since the start of the run",
                                          "units": units.time, "axis": "T"}),
            "axis": ("axis", [1, 2], {"long_name": "axis of the plane, x1 and x2"}),
            "basis": ("basis", np.arange(1, N + 1), {"long_name": "flow basis function"}),
        },
        {
            "Conventions": "CF-1.11",
            "title": scenario.title,
            "source": f"clpt-control {__version__}",
            "references": "Cho, Zhang, Edwards (2016), Adaptive learning for controlled "
                          "Lagrangian particle tracking, OCEANS 2016 MTS/IEEE Monterey",
            "scenario": scenario_to_text(scenario),
            "parameters_changed": str(dict(params or {})),
            "software": ", ".join(f"{name} {version(name)}" for name in
                                  ("clpt-control", "control", "numpy", "scipy")),
            "status": solution.status,
            "message": solution.message,
            **{f"solver_{name}": value for name, value in solution.statistics.items()},
        },
    ).assign_coords().pipe(_with_folder, scenario)  # fmt: skip


def _with_folder(run: "xarray.Dataset", scenario: Scenario) -> "xarray.Dataset":
    run.encoding["folder"] = str(scenario._folder)
    return run


def _lyapunov(scenario: Scenario, data: dict[str, Any]) -> np.ndarray:
    """V of Eq. (17) or (24) along the run."""
    block = lyapunov_candidate(
        scenario.learning.law,
        LyapunovParameters(
            scenario.basis.N,
            scenario.learning.gain,
            np.array(scenario.flow.parameters),
            np.array(scenario.vehicle.feedback),
            np.array(scenario.vehicle.feedforward),
        ),
    )
    ports = [data[name][1] for name in ("clpe", "alpha", "feedback_gain", "feedforward_gain")]
    inputs = np.column_stack([values.reshape(len(values), -1) for values in ports])
    V = np.empty(len(inputs))
    for k, u in enumerate(inputs):
        block.output_function(0.0, np.zeros(0), u, block.parameters, V[k : k + 1])
    return V
