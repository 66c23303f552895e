"""Persistent excitation, Definition 3.1, measured along a trajectory.

    kappa_2 I > int_t^{t+T} w(s) w(s)^T ds > kappa_1 I            Definition 3.1

Axis by axis the joint regressor is w = [phi(x), z_i, zc_i], of Eq. (31).  The
integral is not divided by the window.  Its eigenvalues say how well the
parameters of that axis can be told apart on this track; w holds z, which
depends on the learner, so a Gramian belongs to the trajectory it came from.

A Gramian is kept as a triangular factor R, Gramian = R^T R, R from the QR factors of
sqrt(weight) w^T: so an eigenvalue of 1e-21 keeps its digits beside one of 1e3.

There is a ceiling.  With c_i = (theta_i - alpha_M_i, -KD_i, GammaD_i) Eqs. (1), (3), (7) say

    w^T c_i = x_i' + KD_i e_i,    so    kappa_1 <= int (x_i' + KD_i e_i)^2 dt / |c_i|^2

which where e = 0 is how far the vehicle moves: one that waits teaches nothing.

Of a team all vehicles share the flow parameters of an axis; K_i and Gamma_i are each vehicle's own:

    G = sum_m int w_m w_m^T dt,    w_m = [phi(x_m), 0, ..., z_i, zc_i of m, ..., 0]

so that its flow part is sum_m int phi(x_m) phi(x_m)^T dt.  Where the gains are held only the flow
part counts, of each vehicle and of the team.

Persistent excitation asks for kappa_1 > 0 for all t; `sliding_excitation` takes a window along a
run, and where the smallest eigenvalue falls to zero, the track stops teaching.
"""

from dataclasses import dataclass, field
from functools import cached_property
from textwrap import shorten
from typing import Any

import numpy as np

from ...arguments import public
from ...errors import ClptError, ScenarioError
from ...html import facts, fragment, paragraphs
from ...scenario.experiment import Scenario
from .regressor import (
    AnySource,
    Regressor,
    Source,
    joint_regressor,
    joint_regressors,
    span_of,
    system_of,
)

NOT_LEARNABLE = 1e-9  # eigenvalues below this share of the largest say: not learnable
LETTERS = 250  # of one sentence
MOST = 100  # functions of a basis whose track is judged beside other work
# a parameter belongs to a subspace if its unit vector has this length in it
INVOLVED = 0.05


@dataclass(frozen=True)
class Excitation:
    """Gramians of the joint regressor over one window, axes ``"x1"`` and ``"x2"``."""

    start: float  # of the window, units.time
    window: float  # its length
    trajectory: str  # which one it was measured on
    time_unit: str
    names: dict[str, list[str]]  # axis -> names of its N + 2 parameters
    factors: dict[str, np.ndarray]  # axis -> R, shape (N + 2, N + 2)
    # axis -> c; none with a field
    truth: dict[str, np.ndarray] = field(default_factory=dict)
    # of a team, each alone
    vehicles: dict[str, "Excitation"] = field(default_factory=dict)

    def __repr__(self) -> str:
        learnable = ", ".join(
            f"{axis} {n} of {len(self.names[axis])}"
            for axis, n in self.dimension.items()
        )
        return f"<Excitation {self._when()}: can be learned {learnable}>"

    def _repr_html_(self) -> str:
        rows = [
            (
                f"{name} {axis}",
                f"{values[0]:.4g}",
                f"{values[-1]:.4g}",
                one.dimension[axis],
            )
            for name, one in {**self.vehicles, "": self}.items()
            for axis, values in one.eigenvalues.items()
        ]
        table = facts(rows, ("", "smallest eigenvalue", "largest", "can be learned"))
        said = [*self.not_learnable, f"Measured: {self.trajectory}."]
        return fragment("Excitation", self._when(), table, paragraphs(said))

    @property
    def report(self) -> dict[str, Any]:
        """What JSON says of it."""
        names = (
            "window",
            "start",
            "time_unit",
            "trajectory",
            "ceilings",
            "least_excited",
        )
        found = {
            name: getattr(self, name) for name in (*names, "dimension", "not_learnable")
        }
        eigenvalues = {
            axis: values.tolist() for axis, values in self.eigenvalues.items()
        }
        return found | {"eigenvalues": eigenvalues}

    def _when(self) -> str:
        return f"from {self.start:g} to {self.start + self.window:g} {self.time_unit}"

    @property
    def gramians(self) -> dict[str, np.ndarray]:
        """Gramian int w w^T dt of each axis, shape (N + 2, N + 2)."""
        return {axis: R.T @ R for axis, R in self.factors.items()}

    @property
    def eigenvalues(self) -> dict[str, np.ndarray]:
        """Eigenvalues of each axis, from kappa_1 to kappa_2."""
        return {axis: sizes[::-1] ** 2 for axis, (_, sizes, _) in self._spectra.items()}

    @property
    def smallest(self) -> float:
        """The smallest eigenvalue over both axes."""
        return min(float(values[0]) for values in self.eigenvalues.values())

    @property
    def directions(self) -> dict[str, np.ndarray]:
        """Unit eigenvectors as columns, in the order of the eigenvalues."""
        return {axis: rows[::-1].T for axis, (_, _, rows) in self._spectra.items()}

    @property
    def least_excited(self) -> dict[str, dict[str, float]]:
        """Unit eigenvector of the smallest eigenvalue, by parameter name."""
        found = {}
        for axis, vectors in self.directions.items():
            vector = vectors[:, 0] * np.sign(
                vectors[np.argmax(np.abs(vectors[:, 0])), 0]
            )
            found[axis] = dict(zip(self.names[axis], map(float, vector), strict=True))
        return found

    @property
    def identifiable(self) -> dict[str, np.ndarray]:
        """Orthonormal basis of what can be learned, (N + 2, dimension)."""
        return {
            axis: self.directions[axis][:, ~idle] for axis, idle in self._idle().items()
        }

    @property
    def dimension(self) -> dict[str, int]:
        """Dimension of the identifiable subspace of each axis."""
        return {axis: basis.shape[1] for axis, basis in self.identifiable.items()}

    @property
    def ceilings(self) -> dict[str, float]:
        """Upper bounds of the smallest eigenvalue where the vehicle moves so, by axis."""
        return {
            axis: float(np.sum((self.factors[axis] @ c) ** 2) / np.sum(c**2))
            for axis, c in self.truth.items()
        }

    @property
    def not_learnable(self) -> list[str]:
        """Sentences that name what cannot be learned on this track.

        A parameter whose own direction is not excited is named alone; those that are excited in
        combinations only are named together.
        """
        sentences = []
        for axis, idle in self._idle().items():
            lean = np.linalg.norm(self.directions[axis][:, idle], axis=1)
            alone, names = lean > np.sqrt(1 - INVOLVED**2), np.array(self.names[axis])
            sentences += [
                f"{name} is not learnable on this track" for name in names[alone]
            ]
            if mixed := names[(lean > INVOLVED) & ~alone].tolist():
                listed = (
                    ", ".join(mixed[:-1]) + f" and {mixed[-1]}"
                    if mixed[1:]
                    else mixed[0]
                )
                sentences.append(f"{listed} are not learnable one by one on this track")
        return sentences

    @property
    def in_one_sentence(self) -> str:
        """What cannot be learned on this track, in one sentence; "" where all can."""
        if not self.not_learnable:
            return ""
        counts = [
            f"{n} of {len(self.names[axis])} along {axis}"
            for axis, n in self.dimension.items()
        ]
        whole = (
            f"of the combinations of parameters this track teaches {', '.join(counts)}: "
            f"{'; '.join(self.not_learnable)}"
        )
        return shorten(whole, LETTERS, placeholder=" ... (`clpt excitation` names all)")

    @cached_property
    def _spectra(self) -> dict[str, Any]:
        return {axis: np.linalg.svd(R) for axis, R in self.factors.items()}

    def _idle(self) -> dict[str, np.ndarray]:
        return {
            a: values <= NOT_LEARNABLE * values[-1]
            for a, values in self.eigenvalues.items()
        }


def parameter_names(N: int) -> dict[str, list[str]]:
    """Return the N + 2 names of each axis's parameters, numbered from 1."""
    return {
        f"x{i}": [f"theta_{i}[{k}]" for k in range(1, N + 1)] + [f"K_{i}", f"Gamma_{i}"]
        for i in (1, 2)
    }


def weighted(along: Regressor) -> np.ndarray:
    """Return the rows of which the Gramian of each axis is made, (2, pieces, nodes, N + 2)."""
    return np.sqrt(along.weights)[..., None] * along.w


def factor(rows: np.ndarray) -> np.ndarray:
    """Return R (n, n), R^T R the Gramian of rows (..., n)."""
    n = rows.shape[-1]
    return np.asarray(
        np.linalg.qr(np.vstack([np.zeros((n, n)), rows.reshape(-1, n)]), mode="r")
    )


@public
def started_true(scenario: Scenario) -> Scenario:
    """Return the scenario with the learner started true.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta and the learned-flow law.

    Returns
    -------
    Scenario
        alpha(0) = -theta, K(0) = KD, Gamma(0) = GammaD, z(0) = x(0).

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.theory.started_true(clpt.paper_scenario()).learning.parameters[0]
    (-1.0, -0.4, -0.8)
    """
    if scenario.flow.parameters is None:
        raise ScenarioError(
            "flow.field: a gridded field has no true parameters to start from"
        )
    return scenario.with_values(
        {
            "learning.parameters": (-np.array(scenario.flow.parameters)),
            "learning.feedback": scenario.vehicle.feedback,
            "learning.feedforward": scenario.vehicle.feedforward,
            "learning.position": scenario.vehicle.position,
        }
    )


@public
def gramian(
    source: AnySource | Regressor,
    window: float | None = None,
    start: float | None = None,
) -> Excitation:
    """Measure the joint regressor's Gramian over one window.

    Parameters
    ----------
    source : Scenario, Team, xarray.Dataset or Regressor
        A scenario or a team is run from its own initial values; a run is read.
    window : float, optional
        Length of the window, units.time; one cycle of the waypoints, a team's longest.
    start : float, optional
        Start of the window; the second cycle, or as late as fits.

    Returns
    -------
    Excitation
        By axis, ``"x1"`` and ``"x2"``: `gramians` of w = [phi(x), z_i, zc_i], Definition 3.1,
        `eigenvalues` (ascending), `least_excited` (parameter name -> component), `identifiable`
        and its `dimension`; `not_learnable` are sentences. Of a team it is the pooled Gramian;
        `vehicles`, by name, has each alone. Where its gains are held, of the flow parameters.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.
    DataError
        If the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> true = clpt.theory.started_true(clpt.paper_scenario())
    >>> found = clpt.theory.gramian(true, 200.0, 200.0)
    >>> [round(float(values[0]), 3) for values in found.eigenvalues.values()]
    [4.333, 4.669]
    """
    along = (
        {"": source}
        if isinstance(source, Regressor)
        else joint_regressors(source, window, start)
    )
    one = next(iter(along.values()))
    N, names = one.scenario.basis.N, parameter_names(one.scenario.basis.N)
    if "" in along:
        truth = {} if one.python_parts else _truth(one.scenario)
        return _excitation(one, names, weighted(one), truth)
    adapted = slice(None if one.scenario.learning.adapt_gains else N)
    names = {axis: own[adapted] for axis, own in names.items()}
    rows = {name: weighted(own)[..., adapted] for name, own in along.items()}
    vehicles = {
        name: _excitation(along[name], names, own) for name, own in rows.items()
    }
    gains, wide = len(names["x1"]) - N, list[np.ndarray]()
    for k, own in enumerate(rows.values()):
        # its gains in their columns among all vehicles'
        wide.append(np.zeros((*own.shape[:-1], N + gains * len(along))))
        wide[k][..., :N] = own[..., :N]
        wide[k][..., N + gains * k : N + gains * (k + 1)] = own[..., N:]
    names = {
        axis: own[:N] + [f"{gain} of {name}" for name in along for gain in own[N:]]
        for axis, own in names.items()
    }
    pooled = [np.concatenate([own[axis] for own in wide]) for axis in range(2)]
    return _excitation(one, names, pooled, vehicles=vehicles)


def _excitation(
    along: Regressor, names: dict[str, list[str]], rows: Any, *more: Any, **also
) -> Excitation:
    """Return the excitation of parameters by axis, of the rows of Gramians (2, ..., n)."""
    first, last = along.cuts[[0, -1]].tolist()
    factors = dict(zip(names, map(factor, rows), strict=True))
    where = first, last - first, along.trajectory, along.scenario.units.time
    return Excitation(*where, names, factors, *more, **also)


def not_learned(source: Source) -> str:
    """Return in one sentence what a cycle of the track cannot teach; "" where it teaches all.

    It is empty too of a team, and where that is not known: of a recorded run with fixes, of a
    learner that leaves its field, of more than 100 functions, which take longer than the run.
    """
    try:
        system = system_of(source)
        if not isinstance(system, Scenario) or system.basis.N > MOST:
            return ""
        return gramian(source).in_one_sentence
    except ClptError:
        return ""


def _truth(scenario: Scenario) -> dict[str, np.ndarray]:
    """Return c of each axis, w^T c = x' + KD e; none where something else moves the vehicle."""
    car, theta = scenario.vehicle, scenario.flow.parameters
    else_moved = car.max_speed, scenario.flow.disturbance, scenario.localization
    if theta is None or any(one is not None for one in else_moved):
        return {}
    flow = np.array(theta) - np.array(scenario.model_parameters)
    c = np.column_stack([flow, -np.array(car.feedback), np.array(car.feedforward)])
    return {axis: row for axis, row in zip(("x1", "x2"), c, strict=True) if row.any()}


def sliding_excitation(
    source: Source, window: float, count: int = 100
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return starts of a window that slides over a run, evenly, and the eigenvalues in it.

    Of each axis they are (count, N + 2), ascending.
    """
    first, last = span_of(source)
    starts = np.unique(np.linspace(first, max(first, last - window), count))
    along = joint_regressor(
        source, last - first, first, np.concatenate([starts, starts + window])
    )
    left = np.searchsorted(along.cuts, starts - 1e-9 * window)
    right = np.searchsorted(along.cuts, starts + window * (1 - 1e-9))
    found = {}
    for axis, pieces in zip(("x1", "x2"), weighted(along), strict=True):
        whole = [factor(pieces[a:b]) for a, b in zip(left, right, strict=True)]
        found[axis] = np.linalg.svd(whole, compute_uv=False)[:, ::-1] ** 2
    return starts, found
