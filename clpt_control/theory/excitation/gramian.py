"""Persistent excitation, Definition 3.1, measured along a trajectory.

    kappa_2 I > int_t^{t+T} w(s) w(s)^T ds > kappa_1 I            Definition 3.1

The joint regressor of an axis is w = [phi(x), z_i, zc_i], Eq. (31).  The eigenvalues of its
Gramian measure the identifiability of the parameters on this trajectory.  The Gramian R^T R is
stored as its QR factor R, so that eigenvalues of 1e-21 and 1e3 keep their digits.  With
c_i = (theta_i - alpha_M_i, -KD_i, GammaD_i), Eqs. (1), (3), (7) give w^T c_i = x_i' + KD_i e_i, so

    kappa_1 <= int (x_i' + KD_i e_i)^2 dt / |c_i|^2

The vehicles of a team share the flow parameters of an axis and have their own K_i and Gamma_i.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from textwrap import shorten
from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.errors import ClptError, ScenarioError
from ...base.html import facts, fragment, paragraphs
from ...paper.scenario.experiment import Scenario
from .certificates import Certificate, certificate
from .excitation_figure import draw_excitation
from .regressor import (
    AnySource,
    Regressor,
    Source,
    joint_regressor,
    joint_regressors,
    span_of,
    system_of,
)

AXES = ("x1", "x2")
REPORTED = (
    "window",
    "start",
    "time_unit",
    "trajectory",
    "ceilings",
    "least_excited",
    "dimension",
    "not_learnable",
)
NOT_LEARNABLE = 1e-9  # share of the largest eigenvalue
INVOLVED = 0.05  # smallest length of a parameter's unit vector in a subspace
MAX_LETTERS = 250  # of a summary sentence
MAX_FUNCTIONS = 100  # of a basis that `not_learned` measures


@dataclass(frozen=True)
class Excitation:
    """Gramians of the joint regressor over one window, axes ``"x1"`` and ``"x2"``."""

    start: float  # of the window, units.time
    window: float  # its length
    trajectory: str  # description of the trajectory
    time_unit: str
    names: dict[str, list[str]]  # axis -> names of its N + 2 parameters
    factors: dict[str, np.ndarray]  # axis -> R, shape (N + 2, N + 2)
    truth: dict[str, np.ndarray] = field(default_factory=dict)  # axis -> c, if known
    vehicles: dict[str, "Excitation"] = field(default_factory=dict)  # of a team
    source: Any = field(default=None, repr=False)  # scenario or run that was measured

    def __repr__(self) -> str:
        learnable = [f"{axis} {count}" for axis, count in self._counts().items()]
        return f"<Excitation {self._span()}: can be learned {', '.join(learnable)}>"

    def _repr_html_(self) -> str:
        rows = []
        for name, excitation in {**self.vehicles, "": self}.items():
            for axis, values in excitation.eigenvalues.items():
                extremes = [f"{values[k]:.4g}" for k in (0, -1)]
                rows.append((f"{name} {axis}", *extremes, excitation.dimension[axis]))
        table = facts(rows, ("", "smallest eigenvalue", "largest", "can be learned"))
        sentences = [*self.not_learnable, f"Measured: {self.trajectory}."]
        return fragment("Excitation", self._span(), table, paragraphs(sentences))

    @property
    def report(self) -> dict[str, Any]:
        """Entries of a JSON report."""
        values = {axis: array.tolist() for axis, array in self.eigenvalues.items()}
        return {name: getattr(self, name) for name in REPORTED} | {
            "eigenvalues": values
        }

    def _span(self) -> str:
        """Return the window as text."""
        return f"from {self.start:g} to {self.start + self.window:g} {self.time_unit}"

    def _counts(self) -> dict[str, str]:
        """Return the dimension of each axis out of its number of parameters."""
        return {a: f"{n} of {len(self.names[a])}" for a, n in self.dimension.items()}

    def certificate(self) -> Certificate:
        """Return the decay of V over this window, by one of the paper's laws."""
        return certificate(self.source, self.window, self.start)

    def plot(self, *, ax: Any = None) -> np.ndarray:
        """Draw the eigenvalues along time and the least excited direction, (2, 2) Axes."""
        starts, eigenvalues = sliding_excitation(self.source, self.window)
        return draw_excitation(self, starts, eigenvalues, ax)

    @property
    def gramians(self) -> dict[str, np.ndarray]:
        """Gramian int w w^T dt of each axis, shape (N + 2, N + 2)."""
        return {axis: R.T @ R for axis, R in self.factors.items()}

    @property
    def eigenvalues(self) -> dict[str, np.ndarray]:
        """Eigenvalues of each axis, from kappa_1 to kappa_2."""
        return {axis: values for axis, (values, _) in self._spectra.items()}

    @property
    def smallest(self) -> float:
        """The smallest eigenvalue over both axes."""
        return min(float(values[0]) for values in self.eigenvalues.values())

    @property
    def directions(self) -> dict[str, np.ndarray]:
        """Unit eigenvectors as columns, in the order of the eigenvalues."""
        return {axis: vectors for axis, (_, vectors) in self._spectra.items()}

    @property
    def least_excited(self) -> dict[str, dict[str, float]]:
        """Unit eigenvector of the smallest eigenvalue, by parameter name."""
        components = {}
        for axis, vectors in self.directions.items():
            vector = vectors[:, 0]
            vector = vector * np.sign(vector[np.argmax(np.abs(vector))])
            components[axis] = dict(zip(self.names[axis], vector.tolist(), strict=True))
        return components

    @property
    def identifiable(self) -> dict[str, np.ndarray]:
        """Orthonormal basis of the identifiable subspace, (N + 2, dimension)."""
        idle = self._idle()
        return {axis: self.directions[axis][:, ~idle[axis]] for axis in idle}

    @property
    def dimension(self) -> dict[str, int]:
        """Dimension of the identifiable subspace of each axis."""
        return {axis: basis.shape[1] for axis, basis in self.identifiable.items()}

    @property
    def ceilings(self) -> dict[str, float]:
        """Upper bounds of the smallest eigenvalue for this motion of the vehicle, by axis."""
        return {
            axis: float(np.sum((self.factors[axis] @ c) ** 2) / np.sum(c**2))
            for axis, c in self.truth.items()
        }

    @property
    def not_learnable(self) -> list[str]:
        """Sentences that name the parameters that cannot be learned on this track.

        A parameter whose own direction is not excited has its own sentence; parameters that are
        excited in combinations only share one.
        """
        sentences = []
        for single, mixed in self._not_learnable_names():
            sentences += [f"{name} is not learnable on this track" for name in single]
            if mixed:
                joined = ", ".join(mixed[:-1])
                joined = f"{joined} and {mixed[-1]}" if joined else mixed[0]
                sentences.append(f"{joined} are not learnable one by one on this track")
        return sentences

    def _not_learnable_names(self) -> Iterator[tuple[list[str], list[str]]]:
        """Yield the parameters of each axis that are not excited, alone and in combinations."""
        for axis, idle in self._idle().items():
            length = np.linalg.norm(self.directions[axis][:, idle], axis=1)
            single = length > np.sqrt(1 - INVOLVED**2)
            names = np.array(self.names[axis])
            mixed = names[(length > INVOLVED) & ~single]
            yield names[single].tolist(), mixed.tolist()

    @property
    def in_one_sentence(self) -> str:
        """Summary of `not_learnable`; "" if every parameter is learnable."""
        names = [
            name
            for single, mixed in self._not_learnable_names()
            for name in single + mixed
        ]
        if not names:
            return ""
        counts = [f"{count} along {axis}" for axis, count in self._counts().items()]
        sentence = (
            "parameters that this track does not teach (of their combinations it teaches "
            f"{', '.join(counts)}): {', '.join(names)}"
        )
        ending = " ... (`clpt excitation` names all)"
        return shorten(sentence, MAX_LETTERS, placeholder=ending)

    @cached_property
    def _spectra(self) -> dict[str, tuple[np.ndarray, np.ndarray]]:
        """Return rising eigenvalues and the eigenvectors of each axis."""
        spectra = {}
        for axis, R in self.factors.items():
            _, singular_values, rows = np.linalg.svd(R)
            spectra[axis] = singular_values[::-1] ** 2, rows[::-1].T
        return spectra

    def _idle(self) -> dict[str, np.ndarray]:
        """Return the eigenvalues of each axis that count as zero, as a mask."""
        values = self.eigenvalues
        return {axis: v <= NOT_LEARNABLE * v[-1] for axis, v in values.items()}


def parameter_names(N: int) -> dict[str, list[str]]:
    """Return the N + 2 names of each axis's parameters, numbered from 1."""
    return {
        f"x{i}": [*(f"theta_{i}[{k + 1}]" for k in range(N)), f"K_{i}", f"Gamma_{i}"]
        for i in (1, 2)
    }


def weighted(regressor: Regressor) -> np.ndarray:
    """Return the rows of each axis's Gramian, (2, pieces, nodes, N + 2)."""
    return np.sqrt(regressor.weights)[..., None] * regressor.w


def factor(rows: np.ndarray) -> np.ndarray:
    """Return R (n, n), R^T R the Gramian of rows (..., n)."""
    n = rows.shape[-1]
    padded = np.vstack([np.zeros((n, n)), rows.reshape(-1, n)])
    return np.asarray(np.linalg.qr(padded, mode="r"))


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
        Methods `plot()` and `certificate()`, the decay of V over the window. By axis, ``"x1"`` and
        ``"x2"``: `gramians` of w = [phi(x), z_i, zc_i], Definition 3.1, `eigenvalues` (ascending),
        `least_excited` (parameter name -> component), `identifiable` and its `dimension`;
        `not_learnable` are sentences. The Gramian of a team is pooled, and `vehicles` has each
        vehicle's by name. If gains are fixed, it has the flow parameters only.

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
    >>> found = clpt.gramian(true, 200.0, 200.0)
    >>> [round(float(values[0]), 3) for values in found.eigenvalues.values()]
    [4.333, 4.669]
    """
    regressors = joint_regressors(source, window, start)
    if "" not in regressors:
        return replace(_team_excitation(regressors), source=source)
    regressor = regressors[""]
    truth = {} if regressor.python_parts else _truth(regressor.scenario)
    names = parameter_names(regressor.scenario.basis.N)
    rows = weighted(regressor)
    return _excitation(regressor, names, rows, truth=truth, source=source)


def _team_excitation(regressors: dict[str, Regressor]) -> Excitation:
    """Return the pooled excitation of a team, with each vehicle's."""
    regressor = next(iter(regressors.values()))
    N = regressor.scenario.basis.N
    gains = 2 if regressor.scenario.learning.adapt_gains else 0
    names = {axis: labels[: N + gains] for axis, labels in parameter_names(N).items()}
    vehicles = {}
    pooled = []
    for k, (name, single) in enumerate(regressors.items()):
        rows = weighted(single)[..., : N + gains]
        vehicles[name] = _excitation(single, names, rows)
        # the vehicle's gains have columns of their own
        wide = np.zeros((*rows.shape[:-1], N + gains * len(regressors)))
        wide[..., :N] = rows[..., :N]
        wide[..., N + gains * k : N + gains * (k + 1)] = rows[..., N:]
        pooled.append(wide)
    team_names = {
        axis: labels[:N] + [f"{g} of {name}" for name in regressors for g in labels[N:]]
        for axis, labels in names.items()
    }
    rows = np.concatenate(pooled, axis=1)
    return _excitation(regressor, team_names, rows, vehicles=vehicles)


def _excitation(
    regressor: Regressor, names: dict[str, list[str]], rows: np.ndarray, **fields: Any
) -> Excitation:
    """Return the excitation of named parameters from the rows (2, ..., n) of their Gramians."""
    start, end = regressor.cuts[[0, -1]].tolist()
    unit = regressor.scenario.units.time
    factors = dict(zip(names, map(factor, rows), strict=True))
    window = end - start
    return Excitation(
        start, window, regressor.trajectory, unit, names, factors, **fields
    )


def not_learned(source: Source) -> str:
    """Return a sentence on the parameters that a cycle of the track cannot identify.

    The sentence is empty if all are identifiable, and for a team, a recorded run with fixes, a
    learner that leaves its field, and more than 100 functions, which take longer than the run.
    """
    try:
        system = system_of(source)
        if not isinstance(system, Scenario) or system.basis.N > MAX_FUNCTIONS:
            return ""
        return gramian(source).in_one_sentence
    except ClptError:
        return ""


def _truth(scenario: Scenario) -> dict[str, np.ndarray]:
    """Return c of each axis, w^T c = x' + KD e, unless another force moves the vehicle."""
    vehicle, theta = scenario.vehicle, scenario.flow.parameters
    forces = vehicle.max_speed, scenario.flow.disturbance, scenario.localization
    if theta is None or any(force is not None for force in forces):
        return {}
    flow = np.array(theta) - np.array(scenario.model_parameters)
    feedback, feedforward = np.array(vehicle.feedback), np.array(vehicle.feedforward)
    c = np.column_stack([flow, -feedback, feedforward])
    return {axis: row for axis, row in zip(AXES, c, strict=True) if row.any()}


def sliding_excitation(
    source: Source, window: float, count: int = 100
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return starts of a sliding window and the eigenvalues of each axis, (count, N + 2)."""
    begin, end = span_of(source)
    starts = np.unique(np.linspace(begin, max(begin, end - window), count))
    edges = np.concatenate([starts, starts + window])
    regressor = joint_regressor(source, end - begin, begin, edges)
    tolerance = 1e-9 * window
    from_piece = np.searchsorted(regressor.cuts, starts - tolerance)
    to_piece = np.searchsorted(regressor.cuts, starts + window - tolerance)
    slices = [slice(*pair) for pair in zip(from_piece, to_piece, strict=True)]
    eigenvalues = {}
    for axis, rows in zip(AXES, weighted(regressor), strict=True):
        factors = [factor(rows[piece]) for piece in slices]
        eigenvalues[axis] = np.linalg.svd(factors, compute_uv=False)[:, ::-1] ** 2
    return starts, eigenvalues
