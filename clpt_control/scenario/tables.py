"""The tables of a scenario, each typed and checked.

Numbers are finite (only a period may be infinite) and shapes fit; what one
table needs of another is checked in `experiment`.
"""

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, Strict, create_model, model_validator
from pydantic_core import PydanticCustomError

from ..blocks.laws.law import Gains, Law
from ..blocks.laws.table import LAWS
from .mistakes import Table
from .tides import period


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise ValueError("must be a finite number")
    return value


def _period(value: float) -> float:
    if not value > 0:
        raise ValueError("must be positive; inf is steady")
    return value


def _whole(value: Any) -> Any:
    """Return a whole float, such as an ensemble has, as an int."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


Number = Annotated[float, Strict(), AfterValidator(_finite)]
Positive = Annotated[Number, Field(gt=0)]
NotNegative = Annotated[Number, Field(ge=0)]
Period = Annotated[float, Strict(), AfterValidator(_period)]
Count = Annotated[int, Strict(), Field(ge=1, le=10**6)]
Seed = Annotated[int, BeforeValidator(_whole), Strict(), Field(ge=0, lt=67108859)]
Pair = tuple[Number, Number]
PositivePair = tuple[Positive, Positive]
Row = tuple[Number, ...]
TwoRows = tuple[Row, Row]
KINDS: dict[str, Any] = {  # what a law's setting may be
    "number": Number,
    "positive": Positive,
    "not negative": NotNegative,
    "row": tuple[NotNegative, ...],
    "two rows": TwoRows,
}
Kernel = Literal["exponential", "gaussian", "gaussian-sigma"]


class Units(Table):
    """Units of length and time of every number here."""

    length: Literal["m", "km"] = "m"
    time: Literal["s", "min", "h", "d"] = "s"


class Basis(Table):
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


class Disturbance(Table):
    """The unmodelled flow Delta of Eq. (32)."""

    kind: Literal["constant", "sine", "square", "noise"]
    amplitude: Pair
    period: Positive | None = None
    seed: Seed | None = None

    @model_validator(mode="after")
    def _what_the_kind_needs(self) -> "Disturbance":
        where = "flow.disturbance"
        if self.kind != "constant" and self.period is None:
            raise ValueError(f'{where}.period: is required for kind = "{self.kind}"')
        if self.kind != "noise" and self.seed is not None:
            raise ValueError(f'{where}.seed = {self.seed}: is allowed only for kind = "noise"')
        return self


class Flow(Table):
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


class Model(Table):
    """The modelled flow, alpha_M of Eq. (4); zero if left out."""

    parameters: TwoRows | None = None


class Vehicle(Table):
    """The vehicle, its controller, Eqs. (1) and (7), and how fast it is."""

    feedback: PositivePair
    feedforward: Pair
    position: Pair = (0.0, 0.0)
    max_speed: Positive | None = None


class Circle(Table):
    """Waypoints on a circle, section IV."""

    kind: Literal["circle"]
    radius: Positive
    count: Count
    dwell: Positive


class Waypoints(Table):
    """Any list of waypoints."""

    kind: Literal["waypoints"]
    points: Annotated[tuple[Pair, ...], Field(min_length=1)]
    dwell: Positive


class LearningGains(Table):
    """A gain each for alpha, K and Gamma; what is left out is not adapted by the law."""

    parameters: Positive | None = None
    feedback: Positive | None = None
    feedforward: Positive | None = None


def _own_table(law: Law) -> tuple[Any, None]:
    """Return a law's own table as a field that may be left out."""
    keys: dict[str, Any] = {}
    for key, one in law.settings.items():
        kind = KINDS[one.allowed]
        keys[key] = (kind | None if one.default is None else kind, one.default)
    return create_model(law.table, __base__=Table, **keys) | None, None


if TYPE_CHECKING:
    OwnTables = Table
else:
    OwnTables = create_model(
        "OwnTables",
        __base__=Table,
        **{law.table: _own_table(law) for law in LAWS.values() if law.settings},
    )


def _law(name: str) -> str:
    if name not in LAWS:
        *names, last = (f"'{known}'" for known in LAWS)
        allowed = f"must be {', '.join(names)} or {last}; `clpt laws` says what each does"
        raise PydanticCustomError("law", "{allowed}", {"allowed": allowed})
    return name


class Learning(OwnTables):
    """The adaptive law, its gains, its own table and its initial values."""

    law: Annotated[str, AfterValidator(_law)]
    gain: Positive | None = None
    gains: LearningGains | None = None
    adapt_gains: Annotated[bool, Strict()] = True
    hedging: Annotated[bool, Strict()] | None = None
    theta_estimate: TwoRows | None = None
    position: Pair = (0.0, 0.0)
    feedback: Pair = (0.0, 0.0)
    feedforward: Pair = (0.0, 0.0)
    parameters: TwoRows | None = None

    @property
    def row(self) -> Law:
        """The law's row in the table of laws."""
        return LAWS[self.law]

    @property
    def settings(self) -> dict[str, Any]:
        """Every key of the law's own table, its value or default."""
        given = getattr(self, self.row.table, None)
        return {
            key: one.default if given is None else getattr(given, key)
            for key, one in self.row.settings.items()
        }

    @property
    def used_gains(self) -> Gains:
        """The gains with which alpha, K and Gamma adapt; 0 where they are held."""
        one = self.gain or self.row.gain or 0.0
        alpha, K, Gamma = (
            getattr(self.gains, key, one) or 0.0 for key in LearningGains.model_fields
        )
        if not self.adapt_gains:
            K, Gamma = 0.0, 0.0
        return Gains(alpha, K, Gamma, one=self.gains is None and self.adapt_gains)

    @model_validator(mode="after")
    def _what_the_law_needs(self) -> "Learning":
        own = f'law = "{self.law}"'
        if self.row.keeps_alpha:
            if self.theta_estimate is None and self.row.given_estimate:
                raise ValueError(f"learning.theta_estimate: is required by {own}")
            if self.parameters is not None:
                raise ValueError(
                    f"learning.parameters: {own} keeps alpha = alpha_M; remove the key"
                )
        elif self.theta_estimate is not None:
            allowed = [f'"{law.name}"' for law in LAWS.values() if law.keeps_alpha]
            raise ValueError(
                f"learning.theta_estimate: is allowed only with law = {' or '.join(allowed)}; "
                "remove the key"
            )
        for law in LAWS.values():
            if law.name != self.law and getattr(self, law.table, None) is not None:
                raise ValueError(
                    f'learning.{law.table}: belongs to law = "{law.name}", not to {own}; remove '
                    "the table"
                )
        return self

    @model_validator(mode="after")
    def _nothing_idle_at_fixes(self) -> "Learning":
        idle = ("gain", "gains", "adapt_gains", "hedging", "feedback", "feedforward")
        for key in idle if self.row.at_fixes else ():
            if key in self.model_fields_set:
                raise ValueError(
                    f'learning.{key}: law = "{self.law}" adapts by no gain and holds the gains of '
                    "the vehicle; remove the key"
                )
        return self

    @model_validator(mode="after")
    def _gain_or_gains(self) -> "Learning":
        if self.row.at_fixes:
            return self
        needed = ["parameters"] if self.row.alpha_by_gain else []
        needed += ["feedback", "feedforward"] if self.adapt_gains else []
        if self.gain is not None and self.gains is not None:
            raise ValueError("learning.gains: give either gain or gains, one of the two")
        if self.gains is None:
            if self.gain is None and self.row.gain is None and needed:
                raise ValueError(f'learning.gain: is required by law = "{self.law}"')
        else:
            for key in LearningGains.model_fields:
                given = getattr(self.gains, key) is not None
                if key in needed and not given:
                    raise ValueError(f"learning.gains.{key}: is required; or give one gain for all")
                if given and key not in needed:
                    why = "alpha does not adapt by it" if key == "parameters" else "it is held"
                    raise ValueError(f"learning.gains.{key}: {why} here; remove the key")
        for key in ("feedback", "feedforward"):
            if not self.adapt_gains and key not in self.model_fields_set:
                raise ValueError(
                    f"learning.{key}: is required with adapt_gains = false, which holds it; to "
                    f"hold the vehicle's own give the value of vehicle.{key}"
                )
        return self


class Run(Table):
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
