"""One experiment, typed and checked.

A scenario says what flows, what swims, what learns and how long; it is the
same thing as a TOML file, in the file's own units of length and time.  Nothing
in here integrates: `diagram.closed_loop` makes blocks of it.
"""

import math
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    PrivateAttr,
    Strict,
    model_validator,
)

from .tides import period


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise ValueError("must be a finite number")
    return value


def _period(value: float) -> float:
    if not value > 0:
        raise ValueError("must be positive; inf is steady")
    return value


Number = Annotated[float, Strict(), AfterValidator(_finite)]
Positive = Annotated[Number, Field(gt=0)]
Period = Annotated[float, Strict(), AfterValidator(_period)]
Count = Annotated[int, Strict(), Field(ge=1)]
Pair = tuple[Number, Number]
PositivePair = tuple[Positive, Positive]
Row = tuple[Number, ...]
TwoRows = tuple[Row, Row]
Kernel = Literal["exponential", "gaussian", "gaussian-sigma"]


class Part(BaseModel):
    """A table of the scenario; unknown keys are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Units(Part):
    """Units of length and time of every number here."""

    length: Literal["m", "km"] = "m"
    time: Literal["s", "min", "h", "d"] = "s"


class Basis(Part):
    """The flow basis functions of Eq. (5), one entry per function."""

    kernel: Kernel
    centers: Annotated[tuple[Pair, ...], Field(min_length=1)]
    widths: tuple[Positive, ...]
    periods: tuple[Period, ...] | None = None
    constituents: tuple[str, ...] | None = None
    phases: Row | None = None

    @property
    def N(self) -> int:
        """Number of basis functions."""
        return len(self.centers)

    @model_validator(mode="after")
    def _one_entry_per_function(self) -> "Basis":
        if (self.periods is None) == (self.constituents is None):
            raise ValueError("basis.periods: give either periods or constituents, one of the two")
        for key in ("widths", "periods", "constituents", "phases"):
            value = getattr(self, key)
            if value is not None and len(value) != self.N:
                raise ValueError(
                    f"basis.{key} = {list(value)}: must have {self.N} entries, one per center"
                )
        for name in self.constituents or ():
            period(name)
        return self


class Disturbance(Part):
    """The unmodelled flow Delta of Eq. (32)."""

    kind: Literal["constant", "sine", "square", "noise"]
    amplitude: Pair
    period: Positive | None = None
    seed: Annotated[int, Strict(), Field(ge=0, lt=2**26)] | None = None

    @model_validator(mode="after")
    def _what_the_kind_needs(self) -> "Disturbance":
        where = "flow.disturbance"
        if self.kind != "constant" and self.period is None:
            raise ValueError(f'{where}.period: is required for kind = "{self.kind}"')
        if self.kind != "noise" and self.seed is not None:
            raise ValueError(f'{where}.seed = {self.seed}: is allowed only for kind = "noise"')
        return self


class Flow(Part):
    """The true flow: parameters theta of Eq. (3), or a gridded field."""

    parameters: TwoRows | None = None
    field: str | None = None
    outside: Literal["raise", "clip", "stop"] = "raise"
    disturbance: Disturbance | None = None

    @model_validator(mode="after")
    def _one_truth(self) -> "Flow":
        if (self.parameters is None) == (self.field is None):
            raise ValueError("flow.parameters: give either parameters or field, one of the two")
        if self.field is None and "outside" in self.model_fields_set:
            raise ValueError(f'flow.outside = "{self.outside}": is allowed only with flow.field')
        return self


class Model(Part):
    """The modelled flow, alpha_M of Eq. (4); zero if left out."""

    parameters: TwoRows | None = None


class Vehicle(Part):
    """The vehicle and its controller, Eqs. (1) and (7)."""

    feedback: PositivePair
    feedforward: Pair
    position: Pair = (0.0, 0.0)


class Circle(Part):
    """Waypoints on a circle, section IV."""

    kind: Literal["circle"]
    radius: Positive
    count: Count
    dwell: Positive


class Waypoints(Part):
    """Any list of waypoints."""

    kind: Literal["waypoints"]
    points: Annotated[tuple[Pair, ...], Field(min_length=1)]
    dwell: Positive


class Learning(Part):
    """The adaptive law and its initial values."""

    law: Literal["known-flow", "learned-flow"]
    gain: Positive
    theta_estimate: TwoRows | None = None
    position: Pair = (0.0, 0.0)
    feedback: Pair = (0.0, 0.0)
    feedforward: Pair = (0.0, 0.0)
    parameters: TwoRows | None = None

    @model_validator(mode="after")
    def _what_the_law_needs(self) -> "Learning":
        if self.law == "known-flow":
            if self.theta_estimate is None:
                raise ValueError('learning.theta_estimate: is required by law = "known-flow"')
            if self.parameters is not None:
                raise ValueError(
                    'learning.parameters: law = "known-flow" keeps alpha = alpha_M; remove the key'
                )
        elif self.theta_estimate is not None:
            raise ValueError(
                'learning.theta_estimate: is allowed only with law = "known-flow"; remove the key'
            )
        return self


class Run(Part):
    """How long, how often recorded, how exact."""

    duration: Positive
    output_step: Positive = 1.0
    rtol: Annotated[Positive, Field(ge=1e-13, lt=1)] = 1e-8
    atol: Positive = 1e-10

    @model_validator(mode="after")
    def _not_endless(self) -> "Run":
        if self.duration / self.output_step > 1e8:
            raise ValueError(
                f"run.output_step = {self.output_step}: would record "
                f"{self.duration / self.output_step:.0e} samples; at most 1e8 are allowed"
            )
        return self


class Scenario(Part):
    """One experiment: flow, vehicle, waypoints, law and run.

    Made by `load_scenario`, or from keywords of the same names as the tables
    of the TOML file. All numbers are in ``units.length`` and ``units.time``.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> scenario.basis.N, scenario.learning.gain
    (3, 0.8)
    """

    title: str = ""
    units: Units = Units()
    basis: Basis
    flow: Flow
    model: Model = Model()
    vehicle: Vehicle
    reference: Annotated[Circle | Waypoints, Field(discriminator="kind")]
    learning: Learning
    run: Run
    _folder: Path = PrivateAttr(default_factory=Path)

    @model_validator(mode="after")
    def _two_rows_of_N(self) -> "Scenario":
        for table, key in (
            ("flow", "parameters"),
            ("model", "parameters"),
            ("learning", "parameters"),
            ("learning", "theta_estimate"),
        ):
            rows = getattr(getattr(self, table), key)
            if rows is not None and any(len(row) != self.basis.N for row in rows):
                raise ValueError(
                    f"{table}.{key}: must be 2 rows of {self.basis.N} numbers, one per basis "
                    f"function; the rows have {len(rows[0])} and {len(rows[1])}"
                )
        return self

    @property
    def periods(self) -> np.ndarray:
        """Periods of the basis functions, units.time; inf is steady."""
        if self.basis.periods is not None:
            return np.array(self.basis.periods)
        return np.array([period(c, self.units.time) for c in self.basis.constituents or ()])

    @property
    def frequencies(self) -> np.ndarray:
        """Angular frequencies omega_i of Eq. (5), rad per units.time."""
        return 2 * np.pi / self.periods

    @property
    def phases(self) -> tuple[float, ...]:
        """Phases of the basis functions, rad."""
        return self.basis.phases or (0.0,) * self.basis.N

    @property
    def model_parameters(self) -> TwoRows:
        """alpha_M of Eq. (4), zero where the scenario leaves it out."""
        return self.model.parameters or ((0.0,) * self.basis.N,) * 2

    @property
    def learning_parameters(self) -> TwoRows:
        """alpha(0); the known-flow law keeps alpha_M."""
        if self.learning.law == "known-flow":
            return self.model_parameters
        return self.learning.parameters or ((0.0,) * self.basis.N,) * 2

    @property
    def waypoints(self) -> np.ndarray:
        """Waypoints, shape (n, 2), units.length."""
        from .blocks.reference import circle

        if isinstance(self.reference, Circle):
            return circle(self.reference.radius, self.reference.count)
        return np.array(self.reference.points)

    @property
    def cycle(self) -> float:
        """Time to visit every waypoint once, units.time."""
        return len(self.waypoints) * self.reference.dwell

    @property
    def field_path(self) -> Path | None:
        """Where the gridded field lies; None where theta is the truth."""
        return None if self.flow.field is None else self._folder / self.flow.field

    def with_values(self, values: dict[str, Any]) -> "Scenario":
        """Give a scenario with some values changed and checked again.

        Parameters
        ----------
        values : dict
            ``{"learning.gain": 2.0}``: dotted keys as in the TOML file.

        Returns
        -------
        Scenario
            A new scenario.

        Raises
        ------
        ScenarioError
            If a key or value is not allowed.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> clpt.paper_scenario().with_values({"learning.gain": 2.0}).learning.gain
        2.0
        """
        from .scenario_file import checked_scenario, scenario_tables

        tables = scenario_tables(self)
        for key, value in values.items():
            *path, last = key.split(".")
            table = tables
            for name in path:
                table = table.setdefault(name, {})
            if value is None:
                table.pop(last, None)
            else:
                table[last] = (
                    value.tolist() if isinstance(value, np.ndarray | np.generic) else value
                )
        return checked_scenario(tables, "scenario", self._folder)
