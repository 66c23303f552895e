"""What a team can learn together: the pooled Gramian.

All vehicles share the flow parameters of an axis; K_i and Gamma_i are each vehicle's own.  With
the vehicles m = 1 ... M, the parameters of axis i and the pooled Gramian are

    theta_i[1..N], K_i and Gamma_i of each vehicle
    G = sum_m int w_m w_m^T dt,    w_m = [phi(x_m), 0, ..., z_i, zc_i of m, ..., 0]

so that its flow part is sum_m int phi(x_m) phi(x_m)^T dt.  Where the gains are held only the flow
part counts, of each vehicle and of the team.  A vehicle's Gramian with K_i and Gamma_i has a
smallest eigenvalue at most that of its flow part, as of every matrix and a part of it.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ...arguments import public
from ...errors import DataError
from ...html import facts, fragment, shortened
from ...scenario.file import TEAM, scenario_to_text
from ...scenario.team import Team, team_of_run
from .gramian import (
    EXCITATION_COLUMNS,
    NOT_LEARNABLE,
    Excitation,
    excitation_of,
    excitation_rows,
    parameter_names,
    piece_factors,
)
from .regressor import Regressor, along_runs, checked_window, joint_regressor, resolved

if TYPE_CHECKING:
    import xarray

TeamSource = Union[Team, "xarray.Dataset"]


@dataclass(frozen=True)
class TeamExcitation:
    """Excitation of each vehicle alone, and of the team."""

    gains_adapt: bool  # whether K and Gamma are among what is learned
    vehicles: dict[str, Excitation]
    team: Excitation

    def __repr__(self) -> str:
        least = ", ".join(f"{name} {value:.3g}" for name, value in self.smallest().items())
        return f"<TeamExcitation, smallest eigenvalues: {shortened(least, 100)}>"

    def _repr_html_(self) -> str:
        rows = excitation_rows({**self.vehicles, "team": self.team})
        return fragment("Excitation", "of a team", facts(rows, EXCITATION_COLUMNS))

    def smallest(self) -> dict[str, float]:
        """Return the smallest eigenvalue over both axes of each vehicle, and of ``"team"``."""
        every = {**self.vehicles, "team": self.team}
        return {
            name: min(float(values[0]) for values in one.eigenvalues.values())
            for name, one in every.items()
        }


@public
def team_gramian(
    source: TeamSource,
    window: float | None = None,
    start: float | None = None,
    tolerance: float = NOT_LEARNABLE,
) -> TeamExcitation:
    """Measure the Gramians of a team over one window.

    Parameters
    ----------
    source : Team or xarray.Dataset
        A team is run from its own initial values; a run is read.
    window : float, optional
        Length of the window, units.time; the longest cycle of the waypoints.
    start : float, optional
        Start of the window; the second cycle, or as late as fits.
    tolerance : float, optional
        Eigenvalues up to this share of the largest are not excited.

    Returns
    -------
    TeamExcitation
        `vehicles`, by name, and `team`: the pooled Gramian, each an Excitation as `gramian`
        gives it. Where the gains are held, of the flow parameters alone.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.
    DataError
        If the dataset is no run of a team.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> one = clpt.paper_scenario().with_values({"run.duration": 400})
    >>> other = one.with_values({"reference.radius": 2.0})
    >>> team = clpt.Team(members={"a": one, "b": other}, coupling=0.5)
    >>> found = clpt.theory.team_gramian(team).smallest()
    >>> found["team"] > found["a"]
    True
    """
    along = _regressors(source, window, start)
    one = next(iter(along.values()))
    N, adapt = one.scenario.basis.N, one.scenario.learning.adapt_gains
    adapted = slice(None if adapt else N)
    own_names = {axis: names[adapted] for axis, names in parameter_names(N).items()}
    pieces = {name: piece_factors(one)[..., adapted] for name, one in along.items()}
    vehicles = {
        name: excitation_of(along[name], own_names, own, tolerance) for name, own in pieces.items()
    }
    names = {
        axis: own[:N] + [f"{gain} of {name}" for name in along for gain in own[N:]]
        for axis, own in own_names.items()
    }
    wide = [_placed(own, k, len(along), N) for k, own in enumerate(pieces.values())]
    team = [np.concatenate([one[axis] for one in wide]) for axis in range(2)]
    return TeamExcitation(adapt, vehicles, excitation_of(one, names, team, tolerance))


def _placed(pieces: np.ndarray, vehicle: int, vehicles: int, N: int) -> np.ndarray:
    """Return a vehicle's factors with its own gains in their columns among all vehicles'."""
    gains = pieces.shape[-1] - N
    wide = np.zeros((*pieces.shape[:-1], N + gains * vehicles))
    wide[..., :N] = pieces[..., :N]
    wide[..., N + gains * vehicle : N + gains * (vehicle + 1)] = pieces[..., N:]
    return wide


def _regressors(
    source: TeamSource, window: float | None, start: float | None
) -> dict[str, Regressor]:
    """Return w of every vehicle over one window."""
    team = source if isinstance(source, Team) else team_of_run(source)
    runs: Any = team.members
    if not isinstance(source, Team):
        runs = {name: vehicle_run(source, team, name) for name in team.members}
    cycle = max(one.cycle for one in team.members.values())
    window, start = checked_window(next(iter(runs.values())), window, start, cycle)
    if source is not team:
        return {name: joint_regressor(run, window, start) for name, run in runs.items()}

    def read(edges: np.ndarray | None) -> list[Regressor]:
        return along_runs(team, team.members, start, start + window, edges)

    return dict(zip(team.members, resolved(read), strict=True))


def vehicle_run(run: "xarray.Dataset", team: Team, name: str) -> "xarray.Dataset":
    """Return what one vehicle of a team did, as a run of its own scenario."""
    if "vehicle" not in run.dims or name not in run.vehicle:
        raise DataError(f"the run holds no vehicle {name}; `clpt run` writes all of a team")
    alone = run.sel(vehicle=name, drop=True)
    attributes = {key: value for key, value in run.attrs.items() if key != TEAM}
    alone.attrs = {**attributes, "scenario": scenario_to_text(team.members[name])}
    alone.encoding.update(run.encoding)
    return alone


def team_excitation_report(
    source: TeamSource, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Return what a team's run can teach over one window, for JSON.

    ``window``, ``start``, ``time_unit``, ``trajectory``; ``measured`` (of which parameters);
    ``vehicles`` by name and ``team``: by axis ``eigenvalues`` (ascending) and ``dimension`` of
    what can be learned, and ``not_learnable``, sentences.
    """
    found = team_gramian(source, window, start)
    both = "the flow parameters, which all share, and each vehicle's own K and Gamma"
    alone = "the flow parameters, which all share; K and Gamma are held"
    return {
        **found.team.span,
        "measured": both if found.gains_adapt else alone,
        "smallest": found.smallest(),
        "vehicles": {name: one.report for name, one in found.vehicles.items()},
        "team": found.team.report,
    }
