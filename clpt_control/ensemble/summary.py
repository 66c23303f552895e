"""What is kept of each member.

    clpe_rms                rms of |e| over each full cycle of the waypoints
    clpe_rms_whole          the same over the whole run
    flow_parameter_error    max |estimate - theta| at the marks
    gain_error              max |gain - true gain| at the marks
    status, end             how the run ended and the last time it reached

All members of a chunk at once, from their states, which stand in the order
x, z, alpha, K, Gamma.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..scenario.experiment import Scenario
from .members import States
from .sampling import Sampling
from .vary import variable_values

AXES = {  # names of the dimensions of arrays; all others have one number per axis
    "basis.centers": ("basis", "axis"),
    "basis.widths": ("basis",),
    "basis.periods": ("basis",),
    "basis.phases": ("basis",),
    "flow.parameters": ("axis", "basis"),
    "model.parameters": ("axis", "basis"),
    "learning.parameters": ("axis", "basis"),
    "learning.theta_estimate": ("axis", "basis"),
    "reference.points": ("waypoint", "axis"),
}
STATUS = ("not_run", "finished", "step_too_small", "not_finite", "left_the_field", "too_many_steps")


class Variable(NamedTuple):
    """An array of the store, without its values."""

    dims: tuple[str, ...]
    shape: tuple[int, ...]
    dtype: str
    attrs: dict[str, Any]


def kept_variables(
    scenario: Scenario, sampling: Sampling, members: int, trajectories: bool
) -> dict[str, Variable]:
    """Return the arrays that a summary fills.

    Parameters
    ----------
    scenario : Scenario
        The base.
    sampling : Sampling
        Times.
    members : int
        How many.
    trajectories : bool
        Whether states are kept at the scenario's own samples.

    Returns
    -------
    dict
        Name -> Variable; the first dimension is the member.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.ensemble.sampling import sampling
    >>> scenario = clpt.paper_scenario()
    >>> times = sampling(scenario, 200, (0.0, 2000.0), False)
    >>> kept_variables(scenario, times, 7, False)["clpe_rms"].shape
    (7, 10)
    """
    length, rate = scenario.units.length, f"{scenario.units.time}-1"
    n, N = len(sampling.own), scenario.basis.N
    found: dict[str, Variable] = {}

    def keep(name: str, dims: str, sizes: tuple[int, ...], long_name: str, **attrs: Any) -> None:
        dtype = attrs.pop("dtype", "float64")
        attrs = {"long_name": long_name, **attrs}
        found[name] = Variable(("member", *dims.split()), (members, *sizes), dtype, attrs)

    cycles, marks = (len(sampling.starts) - 1,), (len(sampling.marks),)
    keep("clpe_rms", "cycle", cycles, "rms of the CLPE over a cycle", units=length)
    keep("clpe_rms_whole", "", (), "rms of the CLPE over the whole run", units=length)
    if scenario.flow.parameters is not None:
        keep(
            "flow_parameter_error",
            "mark",
            marks,
            "largest error of a flow parameter",
            units=f"{length} {rate}",
        )
    keep("gain_error", "mark", marks, "largest error of a gain", units=rate)
    keep(
        "status",
        "",
        (),
        "how the run ended",
        dtype="int8",
        flag_values=list(range(len(STATUS))),
        flag_meanings=" ".join(STATUS),
    )
    keep("end", "", (), "last sample reached", units=scenario.units.time)
    if trajectories:
        pair = (n, 2)
        keep("position", "time axis", pair, "true position", units=length)
        keep("predicted_position", "time axis", pair, "predicted position", units=length)
        if scenario.learning.law == "learned-flow":
            keep(
                "alpha",
                "time axis basis",
                (n, 2, N),
                "adapted parameter alpha",
                units=f"{length} {rate}",
            )
        keep("feedback_gain", "time axis", pair, "adapted feedback gain", units=rate)
        keep("feedforward_gain", "time axis", pair, "adapted feedforward gain", units=rate)
    return found


def dims_of(key: str, ndim: int) -> tuple[str, ...]:
    """Name the dimensions of a key's value.

    Examples
    --------
    >>> dims_of("flow.parameters", 2), dims_of("learning.gain", 0)
    (('axis', 'basis'), ())
    """
    return AXES.get(key, ("axis",)) if ndim else ()


def summarise_members(
    scenario: Scenario,
    sampling: Sampling,
    values: Mapping[str, np.ndarray],
    run: States,
    trajectories: bool = False,
) -> dict[str, np.ndarray]:
    """Summarise members from their states.

    Parameters
    ----------
    scenario : Scenario
        The base.
    sampling : Sampling
        The times of the states.
    values : mapping
        What varies, key -> array with a row for each member.
    run : States
        As `Ensemble.run` gives them.
    trajectories : bool, optional
        Whether to keep states at the scenario's own samples.

    Returns
    -------
    dict
        Name -> array, as `kept_variables` lists them; NaN after the end of a
        member that failed.
    """
    with np.errstate(all="ignore"):  # a member that failed may hold anything
        return _summaries(scenario, sampling, values, run, trajectories)


def _summaries(scenario, sampling, values, run, trajectories) -> dict[str, np.ndarray]:
    y, N = run.states, scenario.basis.N
    learned = scenario.learning.law == "learned-flow"
    alpha_end = 4 + 2 * N if learned else 4
    m = len(y)
    base = variable_values(scenario)

    def value(key: str) -> np.ndarray:
        return np.asarray(values.get(key, base[key]))

    fine = slice(None) if len(sampling.fine) == len(sampling.times) else sampling.fine
    squares = np.zeros((m, len(sampling.fine)))
    for i in range(2):
        squares += np.square(y[:, fine, i] - y[:, fine, 2 + i])
    spans = zip(sampling.starts[:-1], sampling.starts[1:], strict=True)
    means = [np.mean(squares[:, first:last], axis=1) for first, last in spans]
    kept = {
        "clpe_rms": np.sqrt(np.array(means).reshape(-1, m).T),
        "clpe_rms_whole": np.sqrt(np.mean(squares, axis=1)),
    }
    if scenario.flow.parameters is not None:
        estimate = -y[:, sampling.marks, 4:alpha_end]
        if not learned:
            estimate = value("learning.theta_estimate").reshape(-1, 1, 2 * N)
        error = np.abs(estimate - value("flow.parameters").reshape(-1, 1, 2 * N)).max(axis=2)
        alive = np.isfinite(y[:, sampling.marks, 0])
        kept["flow_parameter_error"] = np.where(alive, error, np.nan)
    gains = y[:, sampling.marks, alpha_end:]
    true = np.concatenate(
        [
            np.broadcast_to(value(f"vehicle.{name}").reshape(-1, 1, 2), (m, 1, 2))
            for name in ("feedback", "feedforward")
        ],
        axis=2,
    )
    kept["gain_error"] = np.abs(gains - true).max(axis=2)
    kept["status"] = run.status.astype("int8")
    kept["end"] = sampling.times[np.clip(run.reached - 1, 0, None)]
    if trajectories:
        own = y[:, sampling.own]
        n = own.shape[1]
        kept["position"], kept["predicted_position"] = own[..., :2], own[..., 2:4]
        if learned:
            kept["alpha"] = own[..., 4:alpha_end].reshape(m, n, 2, N)
        kept["feedback_gain"] = own[..., alpha_end : alpha_end + 2]
        kept["feedforward_gain"] = own[..., alpha_end + 2 :]
    return {name: np.ascontiguousarray(array) for name, array in kept.items()}
