"""Typed and checked tables of a scenario (pydantic models).

Numbers are finite (only a period may be infinite) and shapes fit; `experiment` checks the tables
against each other.  A mistake raises a ScenarioError with one sentence: the key, the value and what
is allowed.  Tables made by a call and from nested dicts are checked in the same way.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self, get_args

import numpy as np
import pydantic
from pydantic import Field, Strict
from pydantic_core import PydanticCustomError

from ...base.arguments import nearest
from ...base.errors import ScenarioError
from ...base.html import shortened
from ...base.units import METRES
from ...engine.methods import METHODS
from ..blocks.disturbance import KINDS, DisturbanceKind
from ..blocks.flow import KERNELS
from ..laws.law import Fixes
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


class Quantity(NamedTuple):
    """The names of one quantity, separated by spaces, in addition to its key."""

    parameters: str = ""  # parameters of blocks that have this value
    context: str = ""  # attributes of `LawContext` that have or contain it
    symbol: str = ""  # in the paper
    state: str = ""  # the state whose initial value it is
    axes: str = ""  # dimensions of an array of several axes or functions
    unit: str = ""  # the port that has its unit, if not its state; or time
    jumps: bool = False  # True if breakpoints depend on it


def quantity(default: Any, *names: Any, **facts: Any) -> Any:
    """Return a field that is a `Quantity`; the default ... is of a required key."""
    return Field(default, json_schema_extra=Quantity(*names, **facts)._asdict())


class Table(pydantic.BaseModel):
    """A table of the scenario; unknown keys are errors."""

    model_config = pydantic.ConfigDict(extra="forbid", frozen=True)
    scenario: ClassVar[type["Table"]]  # the one around all tables, which names keys

    def __init__(self, *unnamed: Any, **values: Any):
        name = type(self).__name__
        if unnamed:
            fields = "=, ".join(type(self).model_fields)
            raise ScenarioError(f"{name}: name each argument: {fields}=")
        with _one_sentence(name.lower()):
            super().__init__(**values)

    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]  # not of inner tables

    def __setattr__(self, name: str, value: Any) -> None:
        if name in type(self).model_fields:
            raise ScenarioError(
                f"{name}: a scenario stays as it is. Make another by scenario.with_values, as "
                "with_values({'run.duration': 40})"
            )
        super().__setattr__(name, value)

    @pydantic.model_validator(mode="before")
    @classmethod
    def _keys_are_known(cls, values: Any) -> Any:
        for key, value in values.items() if isinstance(values, dict) else ():
            if key not in cls.model_fields:
                inner = value if isinstance(value, dict) else ()
                names = [f"{key}.{name}" for name in inner]
                call_time_hint = next(filter(None, map(cls.key_hint, names)), "")
                tables = {
                    name
                    for name, field in cls.model_fields.items()
                    if any(tables_in(field.annotation))
                }
                fields = sorted(cls.model_fields, key=tables.__contains__)
                settings = [
                    f"{name}.{setting}"
                    for name, field in cls.model_fields.items()
                    for table in tables_in(field.annotation)
                    for setting in table.model_fields
                ]
                names = [*reversed(cls.quantities()), *settings, *fields]
                by_end = {name.rpartition(".")[2]: name for name in names}
                same = dict.fromkeys(n for n in settings if n.endswith(f".{key}"))
                near = by_end.get(nearest(str(key), by_end), "")
                details = {
                    "key": str(key),
                    "close": " or ".join(same) or near,
                    "allowed": ", ".join(fields),
                    "other": call_time_hint,
                }
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
    @cache
    def quantities(cls) -> dict[str, Quantity]:
        """Return the names of each key, dotted, that a class declares as a quantity."""
        found = {}
        for name, field in cls.model_fields.items():
            names: Any = field.json_schema_extra
            if names and name in cls.__annotations__:
                found[name] = Quantity(**names)
            for table in tables_in(field.annotation):
                inner = table.quantities().items()
                found |= {f"{name}.{key}": quantity for key, quantity in inner}
        return found

    @classmethod
    def key_hint(cls, name: str) -> str:
        """Return a hint on the key for a call-time name, or ""."""
        quantities = cls.scenario.quantities().items()
        keys = [key for key, names in quantities if name in names.parameters.split()]
        says = "is the name at call time, in params; the scenario's key is"
        return f"{name} {says} {' or '.join(keys)}" if keys else ""

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Return a table from nested dicts; ``context["name"]`` is its name in errors."""
        with _one_sentence(
            (options.get("context") or {}).get("name", cls.__name__.lower())
        ):
            return super().model_validate(obj, **options)


def tables_in(annotation: Any) -> Iterator[type[Table]]:
    """Yield the tables among the types of a field."""
    if isinstance(annotation, type) and issubclass(annotation, Table):
        yield annotation
    for part in get_args(annotation):
        yield from tables_in(part)


def sentence(problem: Any) -> str:
    """Return the sentence of one entry of pydantic's errors."""
    tags = ("circle", "waypoints") if problem["loc"][:1] == ("reference",) else ()
    path = [step for step in problem["loc"] if step not in tags]
    steps = (f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    key = "".join(steps).removeprefix(".")
    message = (
        problem["msg"]
        .replace("Input should be", "must be")
        .replace("Value error, ", "")
    )
    kind = problem["type"]
    if kind == "missing":
        if isinstance(path[-1], int):
            return f"{key}: is missing. Give all coordinates or names of the item"
        return f"missing key {key}"
    if kind == "unknown_key":
        details = problem["ctx"]
        before = f"{key}." if key else ""
        close = details["close"]
        hint = f"did you mean {before}{close}? Allowed" if close else "allowed"
        for kind in (Circle, Waypoints) if tags else ():
            if details["key"] in kind.model_fields:
                name = kind.__name__.lower()
                return f'{before}{details["key"]}: is a key of {before}kind = "{name}"'
        return (
            details["other"]
            or f"unknown key {before}{details['key']}; {hint} here: {details['allowed']}"
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
    if kind == "dict_type":
        message = "must be a dict by name, such as {'west': scenario}"
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
MOST_PHASE = 6.2832  # rad, a turn
SHORT = 1e-6  # share of the interval; closer times are treated as equal


class Units(Table):
    """Units of length and time of every number here."""

    #: length = "m" # m or km
    length: Literal["m", "km"] = "m"
    #: time = "s" # s, min, h or d
    time: Literal["s", "min", "h", "d"] = "s"


class Basis(Table):
    """The flow basis functions of Eq. (5), one entry per function."""

    #: kernel = "exponential" # of the distance d and the width s
    kernel: Literal[*KERNELS]  # type: ignore[valid-type]
    #: centers = [[0, 0], [10, 10], [5, 5]] # centres c_i, length; functions may share one
    centers: Annotated[tuple[Pair, ...], Field(min_length=1)] = quantity(
        ...,
        "basis_x.centers basis_z.centers basis_x_true.centers",
        axes="basis axis",
        unit="x",
    )
    #: widths = [5, 5, 5] # widths sigma_i, length, positive
    widths: tuple[Positive, ...] = quantity(
        ..., "basis_x.widths basis_z.widths basis_x_true.widths", axes="basis", unit="x"
    )
    #: periods = [12.42, 10.42, 24.42] # tidal periods, time; inf is steady
    periods: tuple[Period, ...] | None = quantity(None, axes="basis", unit="time")
    #: # constituents = ["M2", "K1", "steady"] # in place of periods, names
    constituents: tuple[str, ...] | None = None
    #: phases = [0, 0, 0] # radians: cos(2 pi t/period + phase); -1.5707963267948966 makes a sine
    phases: Row | None = quantity(
        None, "basis_x.phases basis_z.phases basis_x_true.phases", axes="basis"
    )

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
        keys = "widths", "periods", "constituents", "phases"
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
        if any(abs(phase) > MOST_PHASE for phase in self.phases or ()):
            yield "basis.phases: are radians, at most 2 pi; 90 degrees are 1.5708"


class TrueBasis(Basis):
    """Functions of the true flow that are not those of the learner, and their parameters."""

    #: # parameters = [[1.0], [0.9]] # their theta
    parameters: TwoRows

    def _mistakes(self) -> Iterator[str]:
        for mistake in super()._mistakes():
            yield mistake.replace("basis.", "flow.basis.")
        if len(self.parameters[0]) != self.N:
            yield f"flow.basis.parameters: must have two rows of {self.N}, one per center"


class Disturbance(Table):
    """The unmodelled flow Delta of Eq. (32)."""

    #: # kind = "square" # one of
    kind: Literal[*KINDS]  # type: ignore[valid-type]
    #: # amplitude = [0.05, 0.0] # each axis, length/time
    amplitude: Pair = quantity(..., "disturbance.amplitude", unit="v_x")
    #: # period = 1.7951958 # time; required but for constant
    period: Positive | None = quantity(
        None, "disturbance.period", unit="time", jumps=True
    )
    #: # seed = 1 # for noise
    seed: Seed | None = quantity(None, "disturbance.seed")

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

    #: parameters = [[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]] # theta, length/time: a row for each axis
    parameters: TwoRows | None = quantity(
        None,
        "true_flow.theta lyapunov.theta",
        symbol="theta",
        axes="axis basis",
        unit="alpha",
    )
    #: # field = "currents.nc" # a NetCDF file as `clpt fit` writes, path relative to the scenario:
    #: u and v over (time, y, x), even steps, no gaps, units on all five, time from 0
    field: str | None = None
    #: # [flow.basis] # in place of both: other functions than the learner's; the keys of basis,
    #: and parameters
    basis: TrueBasis | None = None
    #: # outside = "raise" # beyond the field: raise, clip (hold the edge's value) or stop
    outside: Literal["raise", "clip", "stop"] = "raise"
    #: # [flow.disturbance] # unmodelled flow Delta, Eq. (32)
    disturbance: Disturbance | None = None

    def _mistakes(self) -> Iterator[str]:
        given = self.parameters, self.field, self.basis
        if sum(value is not None for value in given) != 1:
            yield "flow.parameters: give one of parameters, field and basis"
        if self.field is None and "outside" in self.model_fields_set:
            yield f'flow.outside = "{self.outside}": is allowed only with flow.field'


class Model(Table):
    """The modelled flow, alpha_M of Eq. (4); zero if left out."""

    #: parameters = [[0, 0, 0], [0, 0, 0]] # alpha_M, length/time; 0 where left out
    parameters: TwoRows | None = quantity(
        None,
        "modeled_flow.alpha_M vehicle_controller.alpha_M injection.alpha_M adaptation.alpha_M",
        "alpha_M theta_estimate",
        "alpha_M",
        axes="axis basis",
        unit="alpha",
    )


class Vehicle(Table):
    """The vehicle, its controller, Eqs. (1) and (7), and its maximum speed."""

    #: feedback = [1, 1] # KD, diagonal, 1/time, positive
    feedback: PositivePair = quantity(
        ..., "vehicle_controller.KD lyapunov.KD error_system.KD", "KD", "KD", unit="K"
    )
    #: feedforward = [1, 1] # GammaD, diagonal, 1/time
    feedforward: Pair = quantity(
        ...,
        "vehicle_controller.GammaD lyapunov.GammaD",
        "GammaD",
        "GammaD",
        unit="Gamma",
    )
    #: position = [0, 0] # x(0), length
    position: Pair = quantity((0.0, 0.0), context="position", state="x")
    #: # position_lat_lon = [41.2, -69.5] # x(0) in degrees
    position_lat_lon: Pair | None = None
    #: # max_speed = 1.5 # through the water, length/time, positive; left out: no limit
    max_speed: Positive | None = quantity(None, "speed_limit.max_speed", unit="v_x")

    def _mistakes(self) -> Iterator[str]:
        yield from start_mistakes("vehicle", self)


def start_mistakes(name: str, table: Table) -> Iterator[str]:
    """Yield a mistake if the position of a table is given both as lengths and in degrees."""
    if {"position", "position_lat_lon"} <= table.model_fields_set:
        yield (
            f"{name}.position: give either position (lengths) or position_lat_lon (degrees), "
            "one of the two"
        )


DWELL = quantity(..., "reference.dwell", "dwell", unit="time", jumps=True)


class Circle(Table):
    """Waypoints on a circle, section IV."""

    #: kind = "circle" # circle with radius and count, or waypoints
    kind: Literal["circle"]
    #: radius = 3 # length
    radius: Positive
    #: count = 10 # number of waypoints
    count: Count
    #: dwell = 20 # time at each waypoint
    dwell: Positive = DWELL


class Waypoints(Table):
    """Any list of waypoints."""

    kind: Literal["waypoints"]
    #: # points = [[3, 0], [0, 3]] # of waypoints, length
    points: Points | None = quantity(None, axes="waypoint axis", unit="x")
    #: # points_lat_lon = [[41.2, -69.5]] # of waypoints, degrees, with origin
    points_lat_lon: Points | None = quantity(None, axes="waypoint axis")
    dwell: Positive = DWELL

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

    #: # noise = 0.02 # standard deviation of each axis, length
    noise: NotNegative = quantity(
        0.0, "measurement.noise fixes.noise", "fixes.noise", unit="x"
    )
    #: # noise_period = 1 # how long a value is held, time; required with interval 0
    noise_period: Positive | None = quantity(
        None, "measurement.period", unit="time", jumps=True
    )
    #: # seed = 1 # of noise and missing fixes
    seed: Seed | None = quantity(None, "measurement.seed fixes.seed")
    #: # interval = 5 # time between fixes, with law = "fix-regression"; with latency at most the
    #: run; 0: position at all times
    interval: NotNegative = quantity(
        0.0,
        "fixes.between adaptation.between",
        "fixes.interval",
        unit="time",
        jumps=True,
    )
    #: # dropouts = 0.1 # share of fixes that are missing, below 1
    dropouts: Annotated[Number, Field(ge=0, lt=1)] = quantity(0.0, "fixes.dropouts")
    #: # latency = 1 # time from a fix to its arrival, below interval
    latency: NotNegative = quantity(
        0.0, "adaptation.latency", "fixes.latency", unit="time", jumps=True
    )

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
                "with interval = 0, and allowed only with interval = 0: each fix has its own "
                "noise. Beside recorded fixes set interval, to any time"
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

    #: duration = 2000 # time
    duration: Positive
    #: output_step = 1 # time between recorded samples
    output_step: Positive = 1.0
    #: rtol = 1e-8 # relative tolerance of the integrator
    rtol: Annotated[Positive, Field(ge=1e-13, lt=1)] = 1e-8
    #: atol = 1e-10 # absolute tolerance
    atol: Positive = 1e-10
    #: # method = "rodas5p" # auto: explicit, and implicit from where the run is stiff; taylor:
    #: series of smooth equations; others
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
