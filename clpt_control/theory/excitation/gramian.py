"""Persistent excitation, Definition 3.1, measured along a trajectory.

    kappa_2 I > int_t^{t+T} w(s) w(s)^T ds > kappa_1 I            Definition 3.1

The joint regressor of an axis is w = [phi(x), z_i, zc_i], Eq. (31); of a run of any other loop w
has the signals that are named.  A direction that the Gramian does not excite cannot be learned by
any law.  The Gramian R^T R is stored as its QR factor R, so that eigenvalues of 1e-21 and 1e3 keep
their digits.  With
c_i = (theta_i - alpha_M_i, -KD_i, GammaD_i), Eqs. (1), (3), (7) give w^T c_i = x_i' + KD_i e_i, so

    kappa_1 <= int (x_i' + KD_i e_i)^2 dt / |c_i|^2

The vehicles of a team share the flow parameters of an axis and have their own K_i and Gamma_i.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import control
import numpy as np

from ...base.arguments import known, public
from ...base.errors import ArgumentError, ClptError, DataError
from ...base.html import fragment, paragraphs, table
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import is_response, thinned
from ...simulation.integrate import simulate
from .carried import transition_of, watch_of
from .certificates import Certificate, certificate
from .excitation_report import (
    draw_excitation,
    draw_tube,
    in_one_sentence_of,
    learned_text,
    least_excited_of,
    not_learnable_of,
    repeated_text,
    report_of,
    result_of,
    slow_direction_of,
)
from .regressor import (
    POSITION,
    PREDICTED,
    Regressor,
    Source,
    eigenvalues_of,
    factors_of,
    joint_regressors,
    span_of,
    system_of,
)
from .state_curves import SAME, samples_around

NOT_LEARNABLE = 1e-9  # share of the largest eigenvalue
TINY = np.finfo(float).tiny
MAX_CHANGE = 0.1  # of an eigenvalue, up to which it estimates the error
MAX_FUNCTIONS = 100  # of a basis that `not_learned` measures


@dataclass(frozen=True)
class Excitation(Regressor):
    """Gramians over one window: of axes ``"x1"`` and ``"x2"``, or of signals, ``"w"``."""

    vehicles: dict[str, "Excitation"] = field(default_factory=dict)  # of a team
    source: Any = None  # scenario or run that was measured

    def __repr__(self) -> str:
        learned = self.certified[0] and (
            f"; in windows like this one {learned_text(self)}; {repeated_text(self)}"
        )
        return f"<Excitation {self.span}: excited {self.counted()}{learned or ''}>"

    def _repr_html_(self) -> str:
        result = self.result
        contents = table(result)
        return fragment("Excitation", self.span, contents, paragraphs(result.sentences))

    report = property(report_of)
    result = property(result_of)
    least_excited = property(least_excited_of)
    not_learnable = property(not_learnable_of)
    in_one_sentence = property(in_one_sentence_of)
    transition = cached_property(transition_of)
    watch = property(watch_of)

    @property
    def span(self) -> str:
        """The window as text."""
        end = self.start + self.window
        return f"from {self.start:g} to {end:g} {self.time_unit}".rstrip()

    def counted(self, counts: dict[str, int] | None = None) -> str:
        """Return counts of directions, by default excited ones, out of all."""
        by_axis = (counts or self.dimension).items()
        return ", ".join(f"{n} of {len(self.names[a])} along {a}" for a, n in by_axis)

    def certificate(self) -> Certificate:
        """Return the decay of V over this window, by one of the paper's laws or `of` a verdict."""
        return certificate(self)

    @cached_property
    def factors(self) -> dict[str, np.ndarray]:
        """Factor R of each axis, R^T R its Gramian, shape (n, n)."""
        return dict(zip(self.names, factors_of(self.w, self.weights), strict=True))

    @cached_property
    def certified(self) -> tuple[Certificate | None, str]:
        """The certificate, or None and the reason."""
        return or_reason(self.certificate)

    @cached_property
    def along_run(self) -> tuple[Any, str]:
        """The Dataset `transition`, or None and the reason."""
        return or_reason(lambda: self.transition)

    @cached_property
    def exact(self) -> "Excitation":
        """The same of a recorded run's scenario, which is simulated again at the nodes."""
        scenario, end = self.scenario, self.start + self.window
        if scenario is None or isinstance(self.source, Scenario) or self.python_parts:
            return self
        run = samples_around(self.source, self.start, end)
        again = simulate(scenario, run.time.values)
        x, y = (np.hstack([one[POSITION], one[PREDICTED]]) for one in (run, again))
        if not np.allclose(y, x, SAME, SAME * np.abs(x).max()):
            raise DataError(
                "no certificate: positions in the window are not those of the run's scenario. "
                "Give the scenario in place of the run"
            )
        longer = {"run.duration": max(scenario.run.duration, end)}
        return self.over(
            scenario.with_values(longer), self.window, self.start, self.cuts
        )

    @cached_property
    def accuracy(self) -> float | None:
        """Relative change of the eigenvalues of a recorded run without every second sample."""
        last = self.source.sizes["time"] - 1
        thin = thinned(self.source, 2)
        try:
            coarse = self.over(thin, self.window, self.start).eigenvalues
        except DataError:
            return None
        changes = [
            np.abs(coarse[axis] - values)
            / np.maximum(values, NOT_LEARNABLE * values[-1] + TINY)
            for axis, values in self.eigenvalues.items()
        ]
        change = float(np.max(changes))
        return change if thin.sizes["time"] <= last and change <= MAX_CHANGE else None

    def over(self, *where: Any) -> "Excitation":
        """Return the same over a run, window and start, cut at edges."""
        signals = self.form or self.names.get("w")
        regressor = joint_regressors(*where, signals=signals)[""]
        return Excitation(**vars(regressor), source=where[0])

    def plot(self, *, ax: Any = None) -> np.ndarray:
        """Draw the eigenvalues along time and the least excited direction, (2, axes) Axes."""
        return draw_excitation(self, *self.sliding(), ax)

    def plot_tube(self, *, ax: Any = None) -> Any:
        """Draw the root of V along the run, and its tubes if the window repeats; one Axes."""
        self.certificate()
        run = (
            simulate(self.source) if isinstance(self.source, Scenario) else self.source
        )
        if not self.form and "lyapunov" not in run:
            raise DataError(
                "plot_tube: V of the run is not known. Give a run that has it"
            )
        return draw_tube(self, run, ax)

    def sliding(self, count: int = 100) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Return starts of a sliding window and the eigenvalues of each axis, (count, n)."""
        if self.source is None or self.vehicles:
            raise DataError(
                "sliding: is for the run of one scenario and for signals. A team and its vehicles "
                "have Gramians of one window"
            )
        begin, end = span_of(self.source)
        starts = np.unique(np.linspace(begin, max(begin, end - self.window), count))
        edges = np.concatenate([starts, starts + self.window])
        regressor = self.over(self.source, end - begin, begin, edges)
        parts = regressor.parts(starts, self.window)
        by_axis = np.stack([eigenvalues_of(*part) for part in parts], axis=1)
        return starts, dict(zip(self.names, by_axis, strict=True))

    @property
    def gramians(self) -> dict[str, np.ndarray]:
        """Gramian int w w^T dt of each axis, shape (n, n)."""
        return {axis: R.T @ R for axis, R in self.factors.items()}

    @cached_property
    def eigenvalues(self) -> dict[str, np.ndarray]:
        """Eigenvalues of each axis, from kappa_1 to kappa_2."""
        return {axis: s[::-1] ** 2 for axis, (_, s, _) in self._svd.items()}

    @property
    def smallest(self) -> float:
        """The smallest eigenvalue over both axes."""
        return min(float(values[0]) for values in self.eigenvalues.values())

    @property
    def directions(self) -> dict[str, np.ndarray]:
        """Unit eigenvectors as columns, in the order of the eigenvalues."""
        return {axis: rows[::-1].T for axis, (_, _, rows) in self._svd.items()}

    @property
    def excited(self) -> dict[str, np.ndarray]:
        """Orthonormal basis of the excited subspace, (n, dimension)."""
        return {a: self.directions[a][:, n:] for a, n in self.idle.items()}

    @property
    def dimension(self) -> dict[str, int]:
        """Dimension of the excited subspace of each axis."""
        return {axis: len(self.names[axis]) - n for axis, n in self.idle.items()}

    @cached_property
    def truth(self) -> dict[str, np.ndarray]:
        """c of each axis, w^T c = x' + KD e, unless something else moves the vehicle."""
        scenario = self.scenario
        if scenario is None or self.python_parts or scenario.flow.parameters is None:
            return {}
        if len(self.names["x1"]) < scenario.basis.N + 2:  # without held gains
            return {}
        vehicle, flow = scenario.vehicle, scenario.flow
        forces = vehicle.max_speed, flow.disturbance, scenario.localization
        if any(force is not None for force in forces):
            return {}
        errors = np.subtract(flow.parameters, scenario.model_parameters)
        c = np.column_stack(
            [errors, np.negative(vehicle.feedback), vehicle.feedforward]
        )
        return {axis: row for axis, row in zip(self.names, c, strict=True) if row.any()}

    @property
    def ceilings(self) -> dict[str, float]:
        """Upper bounds of the smallest eigenvalue for this motion of the vehicle, by axis."""
        return {
            axis: float(np.sum((self.factors[axis] @ c) ** 2) / np.sum(c**2))
            for axis, c in self.truth.items()
        }

    @cached_property
    def _svd(self) -> dict[str, Any]:
        """Singular value decomposition of each factor."""
        return {axis: np.linalg.svd(R) for axis, R in self.factors.items()}

    @cached_property
    def without_noise(self) -> "Excitation":
        """The same window of the run without noise, which moves a vehicle but teaches nothing."""
        scenario = self.scenario
        fixes = None if scenario is None else scenario.localization
        if fixes is None or fixes.noise == 0 or self.python_parts:
            return self
        duration = max(scenario.run.duration, self.start + self.window)
        quiet = {"localization.noise": 0.0, "run.duration": duration}
        return gramian(scenario.with_values(quiet), self.window, self.start)

    @property
    def idle(self) -> dict[str, int]:
        """Number of eigenvalues of each axis that count as zero, on the track without noise.

        Of an error system they are those in the coordinates of V, whatever the units.
        """
        values = self.without_noise.eigenvalues
        if self.form:
            (scaled,) = self.scaled_W.reshape(self.w.shape)
            values = {"w": eigenvalues_of(scaled, self.weights)}
        return {a: int(np.sum(v <= NOT_LEARNABLE * v[-1])) for a, v in values.items()}


def or_reason(make: Any) -> tuple[Any, str]:
    """Return what a function makes, or None and the reason."""
    try:
        return make(), ""
    except ClptError as error:
        return None, str(error)


@public
def gramian(
    source: Source | control.InputOutputSystem,
    window: float | None = None,
    start: float | None = None,
    *,
    signals: Sequence[str] | None = None,
    of: Any = None,
    **options: Any,
) -> Excitation:
    """Compute the Gramian of a regressor, or of any signals of a run.

    Parameters
    ----------
    source : Scenario, Team, control.InputOutputSystem or xarray.Dataset
        A scenario, a team or a diagram is simulated; a Dataset is a run.
    window : float, optional
        Length of the window; by default one cycle of the waypoints, a team's longest, and with
        `signals` the whole run.
    start : float, optional
        Start of the window; by default the second cycle, or as late as fits.
    signals : sequence of str, optional
        Components of w: signals of the run, such as ``["r", "y"]``, or ports, such as ``"phi_x"``.
        By default w = [phi(x), z_i, zc_i] of Eq. (31). Required for a diagram without `of`, where
        they are the states that are parameters, by default read from V'.
    of : Verdict, optional
        A verdict of `lyapunov`. By its V the errors of the diagram that ran, with the parameters
        and inputs of the run, must have the form e' = A e + W th, th' = -G W^T P e. The Gramian is
        that of W along the run, and `certificate()` works for it. A run from a file has no diagram.
    **options
        Arguments of `simulate`: `timepts`, `inputs`, `initial_state`, `params`.

    Returns
    -------
    Excitation
        By axis, ``"x1"`` and ``"x2"``, or for ``"w"``, the signals: `gramians`, int w w^T dt of
        Definition 3.1, `eigenvalues` (ascending), `least_excited` (name -> component), `excited`
        (basis of the excited subspace) and its `dimension`. `not_learnable` are sentences. Methods:
        `plot()`, and `certificate()`, the decay of V over the window, with the number of directions
        that the law learns within the run. The Gramian of a team is pooled, and `vehicles` has that
        of each vehicle by name. Gains that the law does not adapt are left out.

        `transition` is a Dataset of norms of Phi along the run: `factor`, from the start of the
        run, by which its errors fall at least, but for what a disturbance adds, and
        `window_factor`, in each window. `watch` has blocks that carry Phi beside a loop, with the
        same norms as outputs, for `clpt.connect` and `clpt.export`.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.
    ArgumentError
        If `signals` are missing, or not in the run.
    DataError
        If the dataset is no run.

    Notes
    -----
    Gauss-Legendre quadrature integrates w of Eq. (31), and W of a verdict as a function of time,
    along states of the diagram, which runs again between the samples. The trapezoidal rule
    integrates `signals` from sample to sample, so that the error falls with the square of the time
    between samples.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> true = clpt.paper_scenario().started_true()
    >>> found = clpt.gramian(true, 200.0, 200.0)
    >>> [round(float(values[0]), 3) for values in found.eigenvalues.values()]
    [4.333, 4.669]
    >>> lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y")
    >>> clpt.gramian(lag, signals=["u"], timepts=[0, 1, 2], inputs=1).gramians
    {'w': array([[2.]])}
    """
    run: Any = source
    recorded = hasattr(run, "data_vars")
    w: Any = signals
    for name in options if recorded else ():
        cure = known(name, ("window", "start", "signals", "of"), "Leave it out")
        raise ArgumentError(
            f"gramian: {name}: a run has its own times and inputs. {cure}"
        )
    if options or not (recorded or (signals is None and of is None)):
        run = simulate(run, **options)
    if of is not None:
        from .error_system import error_system_of

        w = error_system_of(of, signals or (), run)
    if w is None and (
        isinstance(source, control.InputOutputSystem) or (recorded and is_response(run))
    ):
        raise ArgumentError(
            "gramian: signals: is required for a diagram. Name signals of the diagram, such as "
            "signals=['y'], or give of=verdict"
        )
    regressors = joint_regressors(run, window, start, signals=w)
    if "" not in regressors:
        return _team_excitation(regressors, run)
    return Excitation(**vars(regressors[""]), source=run)


def _team_excitation(regressors: dict[str, Regressor], source: Any) -> Excitation:
    """Return the pooled excitation of a team, with each vehicle's."""
    any_regressor = next(iter(regressors.values()))
    N = any_regressor.scenario.basis.N
    vehicles = {}
    pooled = []
    for name, regressor in regressors.items():
        alone = vars(replace(regressor, scenario=None))
        vehicles[name] = Excitation(**alone)
        flow, gains = np.split(regressor.w, [N], axis=-1)
        # the vehicle's gains have columns of their own
        gain_columns = [gains * (vehicle == name) for vehicle in regressors]
        pooled.append(np.concatenate([flow, *gain_columns], axis=-1))
    names = {
        axis: labels[:N] + [f"{g} of {name}" for name in regressors for g in labels[N:]]
        for axis, labels in any_regressor.names.items()
    }
    weights = np.concatenate([single.weights for single in regressors.values()])
    w = np.concatenate(pooled, axis=1)
    alone |= {"names": names, "w": w, "weights": weights}
    return Excitation(**alone, vehicles=vehicles, source=source)


def not_learned(source: Source) -> str:
    """Return a sentence on the parameters that a cycle of the track does not excite, or slowly.

    The sentence is empty if all are excited, and for a team, a recorded run with fixes, a
    learner that leaves its field, and more than 100 functions, which take longer than the run.
    """
    try:
        system = system_of(source)
        if not isinstance(system, Scenario) or system.basis.N > MAX_FUNCTIONS:
            return ""
        excitation = gramian(source)
        return excitation.in_one_sentence or slow_direction_of(excitation, source)
    except ClptError:
        return ""
