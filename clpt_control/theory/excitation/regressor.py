"""The joint regressor along a trajectory, Eq. (31), at the nodes of a quadrature.

    w = [phi(x), z_i, zc_i],    axis i = 1, 2                                Eq. (31)
    [e_i, eta_i]' = A_i(t) [e_i, eta_i],    A_i = [[-k, w^T], [-gamma w, 0]],    k = KD_i
    eta_i = [theta_i + alpha_i, K_i - KD_i, GammaD_i - Gamma_i]              Eq. (28)

The latter is what the blocks `error_system` and `parameter_system` are, whose two axes do not meet;
a test asks that.

A scenario is simulated to the very nodes; a recorded run is read between its samples.  Between two
switches of the waypoint a spline of degree 5 joins the samples of a position: it is
continuous at a switch, with a kink there.  zc and the tides are the scenario's own, so that
jumps are exact.  On the paper's scenario, started true, eigenvalues of the Gramian over a cycle
are then within 0.2 % at samples each 1 s and 1e-6 at each 0.2 s; in the first cycle of a run
started at zero, where the learner oscillates, within 16 % and 2e-5.  For any run, `thinned`
shows what changes when every second sample is left out.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ...arguments import numbers, public
from ...engine.model.block import evaluate
from ...engine.model.declaration import multiples
from ...errors import ArgumentError, DataError, ScenarioError
from ...scenario.experiment import Scenario
from ...scenario.file import CHANGED, OWN_LAW, OWN_PARTS
from ...scenario.recorded_run import check_run, unknown_parts
from ...scenario.team import Team, system_of_run
from ...simulation.integrate import simulate

if TYPE_CHECKING:
    import xarray

DEGREE = 5
OF_W = {"reference", "basis_x"}  # blocks that make w beside x and z
PLACES = ("position", "predicted_position")
Source = Union[Scenario, "xarray.Dataset"]
AnySource = Union[Scenario, Team, "xarray.Dataset"]  # of one vehicle or several


def system_of(source: AnySource) -> Scenario | Team:
    """Return a scenario or team, or that which a run carries in its attributes."""
    if isinstance(source, Scenario | Team):
        return source
    system = system_of_run(source)
    check_run(source, system, "time", *PLACES)
    if unknown := OF_W & unknown_parts(source):
        raise DataError(
            f"the run was made with a {unknown.pop()} that its scenario does not hold, so the "
            "regressor along it is not known; give a run of the scenario's own"
        )
    return system


def members_of(system: Scenario | Team) -> Mapping[str, Scenario]:
    """Return the scenario of each vehicle by name; "" is that of one alone."""
    return {"": system} if isinstance(system, Scenario) else system.members


def span_of(source: AnySource) -> tuple[float, float]:
    """Return the first and last time of a run; a scenario's starts at 0."""
    if isinstance(source, Scenario | Team):
        return 0.0, float(source.run.duration)
    if source.sizes.get("time", 0) < 2:
        raise DataError("the dataset is no run: it needs two times or more")
    return float(source.time[0]), float(source.time[-1])


def thinned(run: "xarray.Dataset") -> "xarray.Dataset":
    """Return a run without every second sample; the first and last stay."""
    last = run.sizes["time"] - 1
    thin = run.isel(time=np.unique([*range(0, last + 1, 2), last]))
    thin.encoding.update(run.encoding)
    return thin


def positions_between(
    t: np.ndarray, x: np.ndarray, dwell: float, times: np.ndarray
) -> np.ndarray:
    """Return positions x (nt, 2) between their samples t, (pieces, nodes, 2).

    Each row of the times lies within one dwell, whose samples a spline joins.
    """
    from scipy.interpolate import make_interp_spline

    number = np.floor(times.mean(1) / dwell).astype(int)
    found = np.empty((*times.shape, 2))
    for j in np.unique(number):
        near = 1e-9 * dwell
        inside = np.flatnonzero((t >= j * dwell - near) & (t <= (j + 1) * dwell + near))
        if len(inside) < 2:  # fewer samples than switches: what can be done with them
            last = int(np.clip(np.searchsorted(t, (j + 0.5) * dwell), 1, len(t) - 1))
            inside = np.array([last - 1, last])
        k = min(DEGREE, len(inside) - 1)
        spline = make_interp_spline(t[inside], x[inside], k - (k + 1) % 2)
        found[number == j] = spline(times[number == j])
    return found


NODES = 16  # Gauss-Legendre nodes of a piece: exact to degree 31
MOST_PIECES = 1e6  # of a window
SHORTEST = 1e-9  # window, of a run: times that rounding tells apart
# of the largest w: its last coefficients; how often pieces are cut
ROUGH, ROUNDS = (1e-6, 5)
TRANSIENT = 10.0  # longest piece in time constants 1/KD


@dataclass(frozen=True)
class Regressor:
    """w at the nodes of a quadrature."""

    scenario: Scenario  # for names, gains and the law
    trajectory: str  # how it was made; w holds z, which depends on the learner
    # (pieces + 1,), edges of the pieces, units.time; every switch is one
    cuts: np.ndarray
    weights: np.ndarray  # (pieces, NODES)
    w: np.ndarray  # [phi, z_i, zc_i], shape (2, pieces, NODES, N + 2)
    python_parts: str = ""  # what a recorded run has that its scenario does not hold


# A quadrature: cuts (pieces + 1,), Gauss-Legendre nodes and weights (pieces, NODES)
Nodes = tuple[np.ndarray, np.ndarray, np.ndarray]


def quadrature(
    scenario: Scenario, start: float, end: float, edges: np.ndarray | None = None
) -> Nodes:
    """Return cuts (pieces + 1,), Gauss-Legendre nodes and weights (pieces, NODES).

    No node lies on a switch: pieces end at each and at `edges`, and are no longer than half a
    period of the fastest tide and ten time constants of the vehicle.
    """
    dwell = scenario.reference.dwell
    tides = scenario.periods[np.isfinite(scenario.periods)] / 2
    longest = min([dwell, TRANSIENT / max(scenario.vehicle.feedback), *tides])
    if (end - start) / longest > MOST_PIECES:
        raise ScenarioError(
            f"window {end - start:g}: takes {(end - start) / longest:.0e} pieces of {longest:.1g} "
            f"{scenario.units.time}, the shortest of reference.dwell, half a tide and "
            f"{TRANSIENT:g}/vehicle.feedback; at most {MOST_PIECES:.0e} are allowed"
        )
    inner = np.concatenate(
        [multiples(dwell, start, end), [] if edges is None else edges]
    )
    spans = {} if scenario.localization is None else scenario.localization.spans
    inner = np.concatenate(
        [inner, *(multiples(span, start, end) for span in spans.values())]
    )
    near = 1e-9 * min(longest, end - start)
    inner = np.sort(inner[(inner > start + near) & (inner < end - near)])
    ends = start, *inner[np.diff(inner, prepend=start) > near], end
    pieces = [
        np.linspace(a, b, int(np.ceil((b - a) / longest * (1 - 1e-12))) + 1)[:-1]
        for a, b in pairwise(ends)
    ]
    cuts = np.append(np.concatenate(pieces), end)
    node, weight = np.polynomial.legendre.leggauss(NODES)
    half = np.diff(cuts)[:, None] / 2
    return cuts, cuts[:-1, None] + half * (1 + node), half * weight


def waypoint_in(scenario: Scenario, cuts: np.ndarray) -> np.ndarray:
    """Return which waypoint the vehicle holds in each piece between cuts, (pieces,)."""
    dwell, count = scenario.reference.dwell, len(scenario.waypoints)
    return np.floor((cuts[:-1] + cuts[1:]) / 2 / dwell).astype(int) % count


def checked_window(
    source: AnySource, window: float | None, start: float | None
) -> tuple[float, float]:
    """Return the window's length and start; by default the second cycle, or as late as fits."""
    first, last = span_of(source)
    members = members_of(system_of(source)).values()
    cycle, time = max(one.cycle for one in members), next(iter(members)).units.time
    window = float(min(cycle, last - first) if window is None else window)
    if start is None:
        start = max(first, min(first + cycle, last - window))
    start = float(start)
    least = SHORTEST * (last - first)
    if not (
        least < window < np.inf
        and start >= first
        and start + window <= last * (1 + 1e-12)
    ):
        raise ScenarioError(
            f"window {window:g} from {start:g}: must be positive and lie within the run, "
            f"{first:g} to {last:g} {time}; at least {least:.0e} long"
        )
    return window, start


def joint_regressor(source: Source, *where: Any, **how: Any) -> Regressor:
    """Return w of one vehicle, as `joint_regressors` has it."""
    found = joint_regressors(source, *where, **how)
    if "" not in found:
        raise DataError("the run is a team's; clpt.theory.gramian measures a team")
    return found[""]


def joint_regressors(
    source: AnySource,
    window: float | None = None,
    start: float | None = None,
    edges: np.ndarray | None = None,
    predicted: str = "predicted_position",
) -> dict[str, Regressor]:
    """Return w = [phi(x), z_i, zc_i] of Eq. (31) over a window, of each vehicle.

    A scenario is run from its own initial values; a run is read.  Pieces end at `edges` too, and z
    is the variable `predicted` of a run.
    Pieces are cut in four where w turns too often in them: there its last Legendre coefficients
    are not small, as the learner swings within a dwell.
    """
    system = system_of(source)
    window, start = checked_window(source, window, start)
    node, weight = np.polynomial.legendre.leggauss(NODES)
    last = (np.polynomial.legendre.legvander(node, NODES - 1) * weight[:, None])[
        :, -2:
    ] * NODES
    for _ in range(ROUNDS):
        nodes = {
            name: quadrature(one, start, start + window, edges)
            for name, one in members_of(system).items()
        }
        found = _along(source, system, nodes, (PLACES[0], predicted))
        ends = []
        for one in found.values():
            tails = np.abs(np.swapaxes(one.w, -1, -2) @ last).max(axis=-1)
            rough = np.any(
                tails > ROUGH * np.abs(one.w).max(axis=(1, 2))[:, None], axis=(0, 2)
            )
            ends.append(
                np.linspace(one.cuts[:-1][rough], one.cuts[1:][rough], 5)[1:-1].ravel()
            )
        if not any(map(len, ends)):
            break
        edges = np.concatenate([*ends, *(one.cuts for one in found.values())])
    return found


def _along(
    source: AnySource,
    system: Scenario | Team,
    nodes: dict[str, Nodes],
    places: tuple[str, ...],
) -> dict[str, Regressor]:
    """Return w of each vehicle at its nodes, to which a scenario is run."""
    found, parts = dict[str, Regressor](), ""
    if simulated := isinstance(source, Scenario | Team):
        times = np.unique(np.concatenate([own.ravel() for _, own, _ in nodes.values()]))
        run = simulate(system, times)
        trajectory = "simulated from the initial values"
        if run.sizes["time"] < times.size or run.attrs["status"] != "finished":
            raise ScenarioError(
                f"window up to {times[-1]:g}: the run ended before: {run.attrs['message']}"
            )
    else:
        run, step = source, np.median(np.diff(source.time.values))
        kinds = {
            OWN_LAW: "the law",
            OWN_PARTS: "parts given in Python,",
            CHANGED: "parameters",
        }
        parts = " and ".join(
            f"{kinds[a]} {run.attrs[a]}" for a in kinds if a in run.attrs
        )
    for name, scenario in members_of(system).items():
        (cuts, at, weights), dwell = nodes[name], scenario.reference.dwell
        of_vehicle = run.sel(vehicle=name) if name else run
        x, z = (of_vehicle[place].values for place in places)
        if simulated:
            x, z = (one[np.searchsorted(run.time.values, at)] for one in (x, z))
        else:
            trajectory = f"recorded run, sampled each {step:g} {scenario.units.time}"
            if scenario.localization is not None and scenario.localization.interval > 0:
                raise DataError(
                    "localization.interval: z of a recorded run jumps at fixes, and is not known "
                    "between samples; give the scenario in place of the run"
                )
            x, z = (
                positions_between(run.time.values, one, dwell, at) for one in (x, z)
            )
        zc = scenario.waypoints[waypoint_in(scenario, cuts)]
        w = w_along(scenario, at, x, z, np.broadcast_to(zc[:, None], z.shape))
        found[name] = Regressor(scenario, trajectory, cuts, weights, w, parts)
    return found


@public
def error_matrices(
    phi: np.ndarray, z: np.ndarray, zc: np.ndarray, KD: np.ndarray, gain: float
) -> np.ndarray:
    """Return A(t) of Eq. (28), axis by axis.

    Parameters
    ----------
    phi : ndarray, shape (..., N)
        Basis functions at the vehicle.
    z, zc : ndarray, shape (..., 2)
        Predicted and desired position, length.
    KD : array_like, shape (2,)
        Feedback gains, per time.
    gain : float
        Adaptation gain gamma; 0 leaves the parameters at rest.

    Returns
    -------
    ndarray, shape (2, ..., N + 3, N + 3)
        Axis first; the states are e_i and that axis's N + 2 of eta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> phi, z, zc = np.array([0.5]), np.array([2, 2]), np.array([3, 3])
    >>> clpt.theory.error_matrices(phi, z, zc, [1, 1], 2.0)[0]
    array([[-1. ,  0.5,  2. ,  3. ],
           [-1. ,  0. ,  0. ,  0. ],
           [-4. ,  0. ,  0. ,  0. ],
           [-6. ,  0. ,  0. ,  0. ]])
    """
    phi, KD = numbers("phi", phi, None), numbers("KD", KD, 2)
    z, zc = numbers("z", z, 2), numbers("zc", zc, 2)
    N, shape = phi.shape[-1], phi.shape[:-1]
    for name, value in (("z", z), ("zc", zc)):
        if value.shape[:-1] != shape:
            raise ArgumentError(
                f"{name}: has shape {value.shape}; must be {(*shape, 2)}, as phi is"
            )
    w = regressors(phi, z, zc)
    A = np.zeros((*w.shape[:-1], N + 3, N + 3))
    A[..., 0, 0] = -KD.reshape(2, *[1] * len(shape))
    A[..., 0, 1:] = w
    A[..., 1:, 0] = -gain * w
    return A + 0.0  # without -0


def regressors(phi: np.ndarray, z: np.ndarray, zc: np.ndarray) -> np.ndarray:
    """Return w of Eq. (31), axis first, (2, ..., N + 2)."""
    return np.stack(
        [np.concatenate([phi, z[..., [i]], zc[..., [i]]], axis=-1) for i in (0, 1)]
    )


def w_along(
    scenario: Scenario, times: np.ndarray, x: np.ndarray, z: np.ndarray, zc: np.ndarray
) -> np.ndarray:
    """Return w at times (...) and positions (..., 2), shape (2, ..., N + 2)."""
    phi = evaluate(scenario.basis_block(), times.ravel(), x.reshape(-1, 2))
    return regressors(phi.reshape(*times.shape, -1), z, zc)
