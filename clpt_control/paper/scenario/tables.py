"""Typed and checked tables of a scenario (pydantic models).

Numbers are finite (only a period may be infinite) and shapes fit; `experiment` checks the tables
against each other.  A mistake raises a ScenarioError with one sentence: the key, the value and what
is allowed.  Tables made by a call and from nested dicts are checked in the same way.
"""

import difflib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Annotated, Any, Literal, Self

import numpy as np
import pydantic
from pydantic import Field, Strict
from pydantic_core import PydanticCustomError

from ...base.errors import ScenarioError
from ...base.html import shortened
from ...base.units import METRES
from ...engine.methods.table import METHODS
from ..blocks.disturbance import KINDS, DisturbanceKind
from ..blocks.flow import KERNELS
from ..laws.law import Fixes
from .quantities import key_hint
from .tidal_periods import period


@contextmanager
def _one_sentence(name: str) -> Iterator[None]:
    """Raise a ScenarioError that begins with `name` in place of pydantic's error."""
    try:
        yield
    except pydantic.ValidationError as error:
        problems = sorted(error.errors(), key=lambda p: p["type"] != "unknown_key")
        count = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
        raise ScenarioError(f"{name}: {sentence(problems[0])}{count}") from None


class Table(pydantic.BaseModel):
    """A table of the scenario; unknown keys are errors."""

    model_config = pydantic.ConfigDict(extra="forbid", frozen=True)

    def __init__(self, **values: Any) -> None:
        with _one_sentence(type(self).__name__.lower()):
            super().__init__(**values)

    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]  # not of inner tables

    @pydantic.model_validator(mode="before")
    @classmethod
    def _keys_are_known(cls, values: Any) -> Any:
        for key, value in values.items() if isinstance(values, dict) else ():
            if key not in cls.model_fields:
                inner = value if isinstance(value, dict) else ()
                call_time_hint = next(
                    filter(None, (key_hint(f"{key}.{name}") for name in inner)), ""
                )
                close = difflib.get_close_matches(str(key), cls.model_fields, n=1)
                hint = f"; did you mean {close[0]}? Allowed" if close else "; allowed"
                allowed = f"{hint} here: {', '.join(cls.model_fields)}"
                details = {"key": str(key), "allowed": allowed, "other": call_time_hint}
                raise PydanticCustomError("unknown_key", "unknown key", details)
        return values

    def _mistakes(self) -> Iterator[str]:
        """Yield a sentence for each mismatch between keys."""
        yield from ()

    @pydantic.model_validator(mode="after")
    def _fits_together(self) -> Self:
        for mistake in self._mistakes():
            raise ValueError(mistake)
        return self

    def every_key(self, before: str = "") -> Iterator[tuple[str, Any, bool]]:
        """Yield each key, dotted as in `with_values`, its value, and True if the key is set."""
        for name, value in self:
            if isinstance(value, Table):
                yield from value.every_key(f"{before}{name}.")
            else:
                is_set = value is not None and name in self.model_fields_set
                yield f"{before}{name}", value, is_set

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Return a table from nested dicts; ``context["name"]`` is its name in errors."""
        with _one_sentence(
            (options.get("context") or {}).get("name", cls.__name__.lower())
        ):
            return super().model_validate(obj, **options)


def sentence(problem: Any) -> str:
    """Return the sentence of one entry of pydantic's errors."""
    tags = ("circle", "waypoints") if problem["loc"][:1] == ("reference",) else ()
    path = [step for step in problem["loc"] if step not in tags]
    key = ""
    for step in path:
        key += (
            f"[{step}]" if isinstance(step, int) else f".{step}" if key else str(step)
        )
    message = (
        problem["msg"]
        .replace("Input should be", "must be")
        .replace("Value error, ", "")
    )
    kind = problem["type"]
    if kind == "missing":
        return f"missing key {key}"
    if kind == "unknown_key":
        details = problem["ctx"]
        return (
            details["other"]
            or f"unknown key {key}{'.' * bool(key)}{details['key']}{details['allowed']}"
        )
    if kind in ("union_tag_not_found", "union_tag_invalid"):
        return f'{key}.kind: must be "circle" or "waypoints"'
    if kind == "value_error" and len(path) <= 1:
        return message
    if kind in ("too_long", "too_short", "missing_argument"):
        message = message.replace("Tuple should", "must").replace(
            " after validation", ""
        )
    if kind == "tuple_type":
        message = "must be a list, in brackets"
    if kind in ("model_type", "model_attributes_type"):
        message = "must be a table of keys"
    value = shortened(" ".join(repr(problem["input"]).split()), 60)
    return f"{key} = {value}: {message}" if key else f"{value}: {message}"


# --- numbers, and the tables ---------------------------------------------------------------------


def _period(value: float) -> float:
    if not value > 0:
        raise ValueError("must be positive; inf is steady")
    return value


def _as_integer(value: Any) -> Any:
    """Return a float that is an integer as an int; sampled parameters are floats."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


Number = Annotated[float, Strict(), Field(allow_inf_nan=False)]
Positive = Annotated[Number, Field(gt=0)]
NotNegative = Annotated[Number, Field(ge=0)]
Period = Annotated[float, Strict(), pydantic.AfterValidator(_period)]
Count = Annotated[int, Strict(), Field(ge=1, le=10**6)]
Seed = Annotated[
    int, pydantic.BeforeValidator(_as_integer), Strict(), Field(ge=0, lt=67108859)
]
Pair = tuple[Number, Number]
PositivePair = tuple[Positive, Positive]
Points = Annotated[tuple[Pair, ...], Field(min_length=1, max_length=10**6)]
Row = tuple[Number, ...]
TwoRows = tuple[Row, Row]
EARTH = 2e7  # m, half of its circumference
SHORT = 1e-6  # share of the interval; closer times are treated as equal


class Units(Table):
    """Units of length and time of every number here."""

    length: Literal["m", "km"] = "m"
    time: Literal["s", "min", "h", "d"] = "s"


class Basis(Table):
    """The flow basis functions of Eq. (5), one entry per function."""

    kernel: Literal[*KERNELS]  # type: ignore[valid-type]
    centers: Annotated[tuple[Pair, ...], Field(min_length=1)]
    widths: tuple[Positive, ...]
    periods: tuple[Period, ...] | None = None
    constituents: tuple[str, ...] | None = None
    phases: Row | None = None

    @property
    def N(self) -> int:
        """Number of basis functions."""
        return len(self.centers)

    @property
    def lengths(self) -> np.ndarray:
        """Length over which each function falls, units.length."""
        return KERNELS[self.kernel].length(np.array(self.widths))

    def is_everywhere(self, unit: str) -> bool:
        """Return True if the functions are the same everywhere on Earth."""
        return bool(self.lengths.min() * METRES[unit] > EARTH)

    def periods_in(self, unit: str) -> np.ndarray:
        """Return the periods in a unit of time; inf is steady."""
        if self.periods is not None:
            return np.array(self.periods)
        return np.array([period(name, unit) for name in self.constituents or ()])

    def _mistakes(self) -> Iterator[str]:
        if (self.periods is None) == (self.constituents is None):
            yield "basis.periods: give either periods or constituents, one of the two"
        keys = ("widths", "periods", "constituents", "phases")
        values = {key: getattr(self, key) for key in keys}
        wrong = [
            f"basis.{key} has {len(value)}"
            for key, value in values.items()
            if value is not None and len(value) != self.N
        ]
        if wrong:
            yield (
                f"{', '.join(wrong)} entries: must have {self.N}, one per center, as the rows of "
                "flow.parameters, model.parameters and learning.parameters"
            )
        for name in self.constituents or ():
            period(name)


class TrueBasis(Basis):
    """Functions of the true flow that are not those of the learner, and their parameters."""

    parameters: TwoRows

    def _mistakes(self) -> Iterator[str]:
        for mistake in super()._mistakes():
            yield mistake.replace("basis.", "flow.basis.")
        if len(self.parameters[0]) != self.N:
            yield f"flow.basis.parameters: must have two rows of {self.N}, one per center"


class Disturbance(Table):
    """The unmodelled flow Delta of Eq. (32)."""

    kind: Literal[*KINDS]  # type: ignore[valid-type]
    amplitude: Pair
    period: Positive | None = None
    seed: Seed | None = None

    @property
    def row(self) -> DisturbanceKind:
        """Row of the kind."""
        return KINDS[self.kind]

    def _mistakes(self) -> Iterator[str]:
        for key in ("period", "seed"):
            value, where = getattr(self, key), f"flow.disturbance.{key}"
            if value is None and self.row.keys.get(key):
                yield f'{where}: is required for kind = "{self.kind}"'
            if value is not None and key not in self.row.keys:
                yield f'{where} = {value}: kind = "{self.kind}" has no {key}. Leave it out'


class Flow(Table):
    """The true flow: parameters theta of Eq. (3), a gridded field, or functions of its own."""

    parameters: TwoRows | None = None
    field: str | None = None
    basis: TrueBasis | None = None
    outside: Literal["raise", "clip", "stop"] = "raise"
    disturbance: Disturbance | None = None

    def _mistakes(self) -> Iterator[str]:
        given = (self.parameters, self.field, self.basis)
        if sum(value is not None for value in given) != 1:
            yield "flow.parameters: give one of parameters, field and basis"
        if self.field is None and "outside" in self.model_fields_set:
            yield f'flow.outside = "{self.outside}": is allowed only with flow.field'


class Model(Table):
    """The modelled flow, alpha_M of Eq. (4); zero if left out."""

    parameters: TwoRows | None = None


class Vehicle(Table):
    """The vehicle, its controller, Eqs. (1) and (7), and its maximum speed."""

    feedback: PositivePair
    feedforward: Pair
    position: Pair = (0.0, 0.0)
    position_lat_lon: Pair | None = None
    max_speed: Positive | None = None

    def _mistakes(self) -> Iterator[str]:
        yield from start_mistakes("vehicle", self)


def start_mistakes(name: str, table: Table) -> Iterator[str]:
    """Yield a mistake if the position of a table is given both as lengths and in degrees."""
    if {"position", "position_lat_lon"} <= table.model_fields_set:
        yield (
            f"{name}.position: give either position (lengths) or position_lat_lon (degrees), "
            "one of the two"
        )


class Circle(Table):
    """Waypoints on a circle, section IV."""

    kind: Literal["circle"]
    radius: Positive
    count: Count
    dwell: Positive


class Waypoints(Table):
    """Any list of waypoints."""

    kind: Literal["waypoints"]
    points: Points | None = None
    points_lat_lon: Points | None = None
    dwell: Positive

    def _mistakes(self) -> Iterator[str]:
        if (self.points is None) == (self.points_lat_lon is None):
            yield (
                "reference.points: give either points (lengths) or points_lat_lon (degrees), one "
                "of the two"
            )


class Localization(Table):
    """Position measurements of the vehicle: fixes, and their noise.

    Without the table the vehicle measures its true position at all times, with interval = 0 its
    position with noise.  With an interval above 0 it has fixes and steers by its prediction between
    them.
    """

    interval: NotNegative = 0.0
    noise: NotNegative = 0.0
    noise_period: Positive | None = None
    dropouts: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    latency: NotNegative = 0.0
    seed: Seed | None = None

    @property
    def spans(self) -> dict[str, float]:
        """Times between breakpoints, by key."""
        if self.noise_period is not None:
            return {"localization.noise_period": self.noise_period}
        return {"localization.interval": self.interval}

    @property
    def fixes(self) -> Fixes | None:
        """Fixes that a law may use; None if the position is read at all times."""
        return (
            Fixes(self.interval, self.latency, self.noise)
            if self.interval > 0
            else None
        )

    def _mistakes(self) -> Iterator[str]:
        if (self.interval == 0) != (self.noise_period is not None):
            yield (
                "localization.noise_period: how long a value of the noise is held; is required "
                "with interval = 0, and allowed only with interval = 0: each fix has its own noise"
            )
        for key in ("dropouts", "latency") if self.interval == 0 else ():
            if getattr(self, key) > 0:
                yield (
                    f"localization.{key} = {getattr(self, key)}: is of fixes. Give an interval "
                    "above 0, or remove the key"
                )
        margin = SHORT * self.interval
        if self.latency and not margin <= self.latency <= self.interval - margin:
            yield (
                f"localization.latency = {self.latency}: must be 0 or below the interval, "
                f"{self.interval}, and not within {margin:.1g} of either"
            )


@dataclass(frozen=True)
class LeftOut:
    """A table of the simulated truth that a scenario for recorded fixes leaves out."""

    table: str

    def __getattr__(self, key: str) -> Any:
        if key.startswith("__"):
            raise AttributeError(key)
        raise ScenarioError(
            f"{self.table}: the scenario leaves this table out, so it can only learn from recorded "
            "fixes (clpt estimate FIXES --scenario). Add the table"
        )


def left_out(table: str) -> Any:
    """Return the default of a table; reading one of its keys is an error."""
    return LeftOut(table)


class Run(Table):
    """Duration, output step and tolerances of a run."""

    duration: Positive
    output_step: Positive = 1.0
    rtol: Annotated[Positive, Field(ge=1e-13, lt=1)] = 1e-8
    atol: Positive = 1e-10
    method: Literal[*METHODS] = "auto"  # type: ignore[valid-type]

    @property
    def solver(self) -> dict[str, Any]:
        """The solver's options: tolerances and method."""
        return {"rtol": self.rtol, "atol": self.atol, "method": self.method}

    def _mistakes(self) -> Iterator[str]:
        if self.duration / self.output_step > 1e8:
            yield (
                f"run.output_step = {self.output_step}: would record "
                f"{self.duration / self.output_step:.0e} samples; at most 1e8 are allowed"
            )
