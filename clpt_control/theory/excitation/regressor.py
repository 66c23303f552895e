"""Joint regressor along a trajectory, Eq. (31), at Gauss-Legendre nodes.

    w = [phi(x), z_i, zc_i],    axis i = 1, 2                                Eq. (31)
    [e_i, eta_i]' = A_i(t) [e_i, eta_i],    A_i = [[-k, w^T], [-gamma w, 0]],    k = KD_i
    eta_i = [theta_i + alpha_i, K_i - KD_i, GammaD_i - Gamma_i]              Eq. (28)

A scenario is simulated at the nodes.  A recorded run is interpolated by splines of degree 5
between the switches of the waypoint; zc and the tides are those of the scenario.  On the paper's
scenario, started true, samples each 1 s give the eigenvalues of the Gramian within 0.2 %, samples
each 0.2 s within 1e-6.

`signal_regressor` is for any signals of any run, joined by straight lines between the samples; the
trapezoidal rule integrates their products.  W of an error system is a function of time, computed
at nodes of pieces that are divided until the transition matrix settles.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from scipy.interpolate import interp1d

from ...base.errors import ArgumentError, DataError, ScenarioError
from ...base.run_attributes import beyond_scenario
from ...engine.model.block import Block, evaluate
from ...engine.model.declaration import multiples
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import check_run, unknown_parts
from ...paper.scenario.team import Team, system_of_run
from ...simulation.comparison import ports_along, signals_of
from ...simulation.integrate import simulate
from .transitions import FEW, gauss, settled

if TYPE_CHECKING:
    import xarray

    from .error_system import ErrorSystem

DEGREE = 5
REGRESSOR_BLOCKS = {"reference", "basis_x"}  # whose outputs w contains
POSITION = "position"
PREDICTED = "predicted_position"
Source = Union[Scenario, Team, "xarray.Dataset"]


def system_of(source: Source) -> Scenario | Team:
    """Return a scenario or team, or that of a recorded run."""
    if isinstance(source, Scenario | Team):
        return source
    system = system_of_run(source)
    check_run(source, system, "time", POSITION, PREDICTED)
    if unknown := REGRESSOR_BLOCKS & unknown_parts(source):
        raise DataError(
            f"the run was made with a {unknown.pop()} that its scenario does not have, so the "
            "regressor along it is not known. Give a run of the scenario's own"
        )
    return system


def members_of(system: Scenario | Team) -> Mapping[str, Scenario]:
    """Return the scenario of each vehicle by name, "" for a single vehicle."""
    return {"": system} if isinstance(system, Scenario) else system.members


def span_of(source: Source) -> tuple[float, float]:
    """Return the start and end of a run."""
    if isinstance(source, Scenario | Team):
        return 0.0, float(source.run.duration)
    if source.sizes.get("time", 0) < 2:
        raise DataError("the dataset is not a run: it needs two times or more")
    return float(source.time[0]), float(source.time[-1])


def positions_between(
    t: np.ndarray, x: np.ndarray, dwell: float, times: np.ndarray
) -> np.ndarray:
    """Return positions x (nt, 2), sampled at t, at times (pieces, nodes) -> (pieces, nodes, 2).

    Each piece lies within one dwell; one spline joins the samples of a dwell.
    """
    from scipy.interpolate import make_interp_spline

    dwells = np.floor(times.mean(1) / dwell).astype(int)
    positions = np.empty((*times.shape, 2))
    tolerance = 1e-9 * dwell
    for j in np.unique(dwells):
        begin = np.searchsorted(t, j * dwell - tolerance)
        end = np.searchsorted(t, (j + 1) * dwell + tolerance)
        if end - begin < 2:  # fewer samples than switches
            end = 1 + int(np.clip(np.searchsorted(t, (j + 0.5) * dwell), 1, len(t) - 1))
            begin = end - 2
        degree = min(DEGREE, end - begin - 1)
        degree -= 1 - degree % 2
        spline = make_interp_spline(t[begin:end], x[begin:end], degree)
        positions[dwells == j] = spline(times[dwells == j])
    return positions


NODES = 16  # Gauss-Legendre nodes of a piece: exact to degree 31
NODE, WEIGHT, COEFFICIENTS, _ = gauss(NODES)
MAX_PIECES = 1e6
SHORTEST = 1e-9  # window, share of the run
ROUGH = 9e-7  # last Legendre coefficients of a piece, share of the largest w
REFINEMENTS = 5
TRANSIENT = 10.0  # longest piece in time constants 1/KD


@dataclass(frozen=True)
class Regressor:
    """Signals of one or more Gramians at the nodes of a quadrature."""

    names: dict[str, list[str]]  # Gramian, such as an axis -> names of its n parameters
    time_unit: str
    trajectory: str  # its description; w contains z, which depends on the learner
    cuts: np.ndarray  # (pieces + 1,), units.time; every switch is a cut
    weights: np.ndarray  # (pieces, nodes)
    w: np.ndarray  # shape (Gramians, pieces, nodes, n); [phi, z_i, zc_i] of each axis
    run_length: float
    scenario: Any = None  # law of the joint regressor, Eq. (31)
    gains: Any = None  # adaptation gains of its n parameters; 0 if fixed
    python_parts: str = ""  # parts of a recorded run that its scenario does not contain
    form: Any = None  # error system of a verdict, whose W has its m rows at each node
    change: float = 0.0  # of the transition matrix, if pieces were divided further

    @property
    def scaled_W(self) -> np.ndarray:
        """W of an error system in coordinates of V, shape (1, pieces, nodes, m, n)."""
        shape = 1, len(self.weights), -1, *self.form.W.shape
        return self.form.left @ self.w.reshape(shape) @ self.form.right

    @property
    def start(self) -> float:
        """Start of the window, units.time."""
        return float(self.cuts[0])

    @property
    def window(self) -> float:
        """Length of the window."""
        return float(self.cuts[-1] - self.cuts[0])

    def parts(
        self, starts: np.ndarray, window: float
    ) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield w and weights of windows that begin and end at cuts."""
        ends = starts + window
        cuts = np.searchsorted(self.cuts, np.array([starts, ends]) - 1e-9 * window)
        for begin, end in cuts.T:
            yield self.w[:, begin:end], self.weights[begin:end]


# cuts (pieces + 1,), Gauss-Legendre nodes and weights (pieces, NODES)
Quadrature = tuple[np.ndarray, np.ndarray, np.ndarray]


def quadrature(
    scenario: Scenario, start: float, end: float, edges: Any = ()
) -> Quadrature:
    """Return cuts (pieces + 1,), Gauss-Legendre nodes and weights (pieces, NODES).

    Pieces end at each switch and at `edges`.  They are at most half a period of the fastest tide
    and ten time constants of the vehicle long.
    """
    dwell = scenario.reference.dwell
    tides = scenario.periods[np.isfinite(scenario.periods)] / 2
    longest = min([dwell, TRANSIENT / max(scenario.vehicle.feedback), *tides])
    if (end - start) / longest > MAX_PIECES:
        raise ScenarioError(
            f"window {end - start:g}: takes {(end - start) / longest:.0e} pieces of {longest:.1g} "
            f"{scenario.units.time}, the shortest of reference.dwell, half a tide and "
            f"{TRANSIENT:g}/vehicle.feedback; at most {MAX_PIECES:.0e} are allowed"
        )
    # Step 1: cuts at the switches, the fixes and the edges
    spans = [dwell]
    if scenario.localization is not None:
        spans += scenario.localization.spans.values()
    switches = [multiples(span, start, end) for span in spans]
    inner = np.sort(np.concatenate([*switches, edges]))
    tolerance = 1e-9 * min(longest, end - start)
    inner = inner[(inner > start + tolerance) & (inner < end - tolerance)]
    ends = start, *inner[np.diff(inner, prepend=start) > tolerance], end
    # Step 2: equal pieces between two cuts
    cuts_of_dwells = [
        np.linspace(a, b, int(np.ceil((b - a) / longest * (1 - 1e-12))) + 1)[:-1]
        for a, b in pairwise(ends)
    ]
    cuts = np.append(np.concatenate(cuts_of_dwells), end)
    radius = np.diff(cuts)[:, None] / 2
    return cuts, cuts[:-1, None] + radius * (1 + NODE), radius * WEIGHT


def waypoint_in(scenario: Scenario, cuts: np.ndarray) -> np.ndarray:
    """Return the index of the waypoint in each piece between cuts, (pieces,)."""
    dwell, count = scenario.reference.dwell, len(scenario.waypoints)
    return np.floor((cuts[:-1] + cuts[1:]) / 2 / dwell).astype(int) % count


def checked_window(
    source: Source,
    window: float | None,
    start: float | None,
    cycle: float = 0.0,
    unit: str = "",
) -> tuple[float, float]:
    """Return the window's length and start, by default the second cycle, or as late as fits."""
    begin, end = span_of(source)
    if not cycle:
        members = members_of(system_of(source)).values()
        cycle = max(scenario.cycle for scenario in members)
        unit = next(iter(members)).units.time
    window = float(min(cycle, end - begin) if window is None else window)
    if start is None:
        start = max(begin, min(begin + cycle, end - window))
    start = float(start)
    shortest = SHORTEST * (end - begin)
    inside = start >= begin and start + window <= end * (1 + 1e-12)
    if not (shortest < window < np.inf and inside):
        span = f"{begin:g} to {end:g} {unit}".rstrip()
        raise ScenarioError(
            f"window {window:g} from {start:g}: must be positive and lie within the run, {span}; "
            f"at least {shortest:.0e} long"
        )
    return window, start


def gains_of_w(scenario: Scenario) -> np.ndarray:
    """Return the N + 2 adaptation gains of the parameters that multiply w; 0 if fixed."""
    gains = scenario.learning.used_gains
    flow = 0.0 if scenario.learning.row.given_estimate else gains.parameters
    return np.array([*[flow] * scenario.basis.N, gains.feedback, gains.feedforward])


def scale_of(gains: np.ndarray) -> np.ndarray:
    """Return S, w S scaled by the roots of the gains; a parameter without a gain is left out."""
    return np.diag(np.sqrt(gains))[:, gains > 0]


def joint_regressors(
    source: Source,
    window: float | None = None,
    start: float | None = None,
    edges: Any = (),
    predicted: str = PREDICTED,
    *,
    signals: "Sequence[str] | ErrorSystem | None" = None,
) -> dict[str, Regressor]:
    """Return w = [phi(x), z_i, zc_i] of Eq. (31) over a window, by vehicle, or of `signals`, which
    are names or an error system with its W.

    Pieces end at `edges` too; z is the variable `predicted` of a run.  A piece with large last
    Legendre coefficients is cut in four, because the learner oscillates within a dwell.
    """
    if signals is not None:
        return {"": signal_regressor(source, signals, window, start, edges)}
    system = system_of(source)
    members, simulated = members_of(system), isinstance(source, Scenario | Team)
    window, start = checked_window(source, window, start)
    for _ in range(REFINEMENTS):
        nodes = {
            name: quadrature(scenario, start, start + window, edges)
            for name, scenario in members.items()
        }
        run: Any = _simulated(system, nodes) if simulated else source
        result = {
            name: _regressor(
                scenario,
                run.sel(vehicle=name) if name else run,
                nodes[name],
                predicted,
                simulated,
            )
            for name, scenario in members.items()
        }
        new_cuts = []
        for regressor in result.values():
            w, cuts = regressor.w, regressor.cuts
            tails = np.abs(COEFFICIENTS[-2:] @ w).max(axis=2)
            largest = np.abs(w).max(axis=(1, 2))[:, None]
            rough = np.any(tails > ROUGH * largest, axis=(0, 2))
            quarters = np.linspace(cuts[:-1][rough], cuts[1:][rough], 5)
            new_cuts.append(quarters[1:-1].ravel())
        if not any(map(len, new_cuts)):
            break
        edges = np.concatenate([*new_cuts, *(r.cuts for r in result.values())])
    return result


def _simulated(
    system: Scenario | Team, nodes: dict[str, Quadrature]
) -> "xarray.Dataset":
    """Return the run at the nodes."""
    times = np.unique(np.concatenate([times.ravel() for _, times, _ in nodes.values()]))
    run = simulate(system, times)
    if run.sizes["time"] < times.size or run.attrs["status"] != "finished":
        raise ScenarioError(
            f"window up to {times[-1]:g}: the run ended before: {run.attrs['message']}"
        )
    return run


def _regressor(
    scenario: Scenario,
    run: "xarray.Dataset",
    quadrature: Quadrature,
    predicted: str,
    simulated: bool,
) -> Regressor:
    """Return w of one vehicle at the nodes, which are samples of a simulated run."""
    cuts, times, weights = quadrature
    samples = run.time.values
    positions = [run[POSITION].values, run[predicted].values]
    trajectory, python_parts = "simulated from the initial values", ""
    run_length = scenario.run.duration if simulated else float(np.ptp(samples))
    if simulated:
        indices = np.searchsorted(samples, times)
        x, z = (values[indices] for values in positions)
    else:
        fixes = scenario.localization
        if fixes is not None and fixes.interval > 0:
            raise DataError(
                "localization.interval: z of a recorded run jumps at fixes, and is not known "
                "between samples. Give the scenario in place of the run"
            )
        dwell = scenario.reference.dwell
        x, z = (positions_between(samples, v, dwell, times) for v in positions)
        step = np.median(np.diff(samples))
        trajectory = f"recorded run, sampled each {step:g} {scenario.units.time}"
        python_parts = " and ".join(beyond_scenario(run.attrs))
    zc = scenario.waypoints[waypoint_in(scenario, cuts)][:, None]
    w = w_along(scenario.basis_block(), times, x, z, zc)
    N, gains = scenario.basis.N, gains_of_w(scenario)
    # K and Gamma are left out if the law does not adapt them
    columns = [j for j in range(N + 2) if j < N or gains[j] or python_parts]
    names = {}
    for i in (1, 2):
        theta = [f"theta_{i}[{k}]" for k in range(1, N + 1)]
        labels = [*theta, f"K_{i}", f"Gamma_{i}"]
        names[f"x{i}"] = [labels[j] for j in columns]
    return Regressor(
        names,
        scenario.units.time,
        trajectory,
        cuts,
        weights,
        w[..., columns],
        run_length,
        scenario,
        gains[columns],
        python_parts,
    )


def signal_regressor(
    run: Any, signals: Any, window: float | None, start: float | None, edges: Any
) -> Regressor:
    """Return signals of a run, or W, over a window, cut at its samples and at `edges`."""
    from .error_system import ErrorSystem

    unit, times = run.time.attrs.get("units", ""), run.time.values
    window, start = checked_window(run, window, start, np.inf, unit)
    end = start + window
    trajectory = f"signals of a run, {run.sizes['time']} samples"
    cuts = np.unique(np.clip([*times, *edges, end], start, end))
    length = float(np.ptp(times))
    if isinstance(signals, ErrorSystem):
        form, (W_at, off) = signals, signals.along(run, start, end)
        cuts, w, change = settled(W_at, cuts, form.scaled_A)
        W = np.linalg.solve(form.left, w) @ np.linalg.inv(form.right)
        weights = np.diff(cuts)[:, None] / 2 * gauss(FEW).weight
        by_nodes = trajectory, cuts, np.repeat(weights, len(form.left), axis=1)
        W = W.reshape(1, len(W), -1, W.shape[-1])
        names = {"w": form.names}
        return Regressor(
            names, unit, *by_nodes, W, length, form=form, change=change + off
        )
    ports = ports_along(run)
    columns = {
        label: column
        for name in signals
        for port in ports
        for label, column in signals_of(run[port]).items()
        if name in (port, label)
    }
    unknown = {*signals} - {*ports, *columns}
    if unknown or not columns:
        raise ArgumentError(
            f"gramian: signals = {[*unknown]}: must be signals of the run: {', '.join(ports)}. "
            "run.clpt.table() has the names of single signals"
        )
    along_run = np.transpose([*columns.values()])
    values = interp1d(times, along_run, axis=0)(np.minimum(cuts, times[-1]))
    if not np.isfinite(values).all():
        raise DataError("gramian: signals: must be finite in the window")
    ends = np.stack([values[:-1], values[1:]], axis=1)
    weights = np.tile(np.diff(cuts)[:, None] / 2, 2)
    of_run = trajectory, cuts, weights, ends[None], length
    return Regressor({"w": [*columns]}, unit, *of_run)


def regressors(phi: np.ndarray, z: np.ndarray, zc: np.ndarray) -> np.ndarray:
    """Return w of Eq. (31), axis first, (2, ..., N + 2)."""
    return np.stack(
        [np.concatenate([phi, z[..., [i]], zc[..., [i]]], axis=-1) for i in (0, 1)]
    )


def w_along(
    basis: Block, times: np.ndarray, x: np.ndarray, z: np.ndarray, zc: np.ndarray
) -> np.ndarray:
    """Return w at times (...) and positions (..., 2), shape (2, ..., N + 2)."""
    *shape, _ = x.shape
    every_time = np.broadcast_to(times, shape).ravel()
    phi = evaluate(basis, every_time, x.reshape(-1, 2))
    return regressors(phi.reshape(*shape, -1), z, np.broadcast_to(zc, z.shape))


def factors_of(w: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Return R (..., n, n), R^T R the Gramian of w (..., pieces, nodes, n)."""
    *batch, _, _, n = w.shape
    rows = (np.sqrt(weights)[..., None] * w).reshape(*batch, -1, n)
    padded = np.concatenate([np.zeros((*batch, n, n)), rows], axis=-2)
    return np.asarray(np.linalg.qr(padded, mode="r"))


def eigenvalues_of(w: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Return the eigenvalues (..., n) of the Gramian of w, ascending."""
    return np.linalg.svd(factors_of(w, weights), compute_uv=False)[..., ::-1] ** 2
