"""The table [learning] of a scenario: the law, its gains, its own table, where it starts."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator, Field, Strict, create_model
from pydantic_core import PydanticCustomError

from ..blocks.laws.law import Gains, Law
from ..blocks.laws.table import LAWS
from .tables import NotNegative, Pair, Positive, Table, TwoRows


def _square_is_a_number(value: float) -> float:
    if value != 0 and not 1e-100 <= abs(value) <= 1e100:
        raise ValueError("must be 0, if allowed, or between 1e-100 and 1e100 in size")
    return value


_Squared = AfterValidator(_square_is_a_number)  # laws square and divide by settings, V by gains
_Gain = Annotated[Positive, _Squared] | None
KINDS: dict[str, Any] = {  # what a law's setting may be
    "positive": Annotated[Positive, _Squared],
    "not negative": Annotated[NotNegative, _Squared],
    "below 1": Annotated[Positive, _Squared, Field(lt=1)],
    "at most 1": Annotated[Positive, _Squared, Field(le=1)],
    "row": tuple[Annotated[NotNegative, _Squared], ...],
}


class LearningGains(Table):
    """A gain each for alpha, K and Gamma; the law does not adapt what is left out."""

    parameters: _Gain = None
    feedback: _Gain = None
    feedforward: _Gain = None


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
    gain: Annotated[NotNegative, _Squared] | None = None  # 0 learns nothing
    gains: LearningGains | None = None
    adapt_gains: Annotated[bool, Strict()] = True
    hedging: Annotated[bool, Strict()] | None = None
    sample: Positive | None = None
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
        table = getattr(self, self.row.table, None)
        return {
            key: one.default if table is None else getattr(table, key)
            for key, one in self.row.settings.items()
        }

    @property
    def used_gains(self) -> Gains:
        """The gains with which alpha, K and Gamma adapt; 0 where one is held."""
        one = (self.row.gain or 0.0) if self.gain is None else self.gain
        alpha, K, Gamma = (
            getattr(self.gains, key, one) or 0.0 for key in LearningGains.model_fields
        )
        if not self.adapt_gains:
            K, Gamma = 0.0, 0.0
        return Gains(alpha, K, Gamma, one=self.gains is None and self.adapt_gains)

    def _mistakes(self) -> Iterator[str]:
        own = f'law = "{self.law}"'
        if self.row.alpha_is_constant:
            if self.theta_estimate is None and self.row.given_estimate:
                yield f"learning.theta_estimate: is required by {own}"
            if self.parameters is not None:
                yield f"learning.parameters: {own} keeps alpha = alpha_M; remove the key"
        elif self.theta_estimate is not None:
            allowed = [f'"{law.name}"' for law in LAWS.values() if law.alpha_is_constant]
            yield (
                f"learning.theta_estimate: is allowed only with law = {' or '.join(allowed)}; "
                "remove the key"
            )
        for law in LAWS.values():
            if law.name != self.law and getattr(self, law.table, None) is not None:
                yield (
                    f'learning.{law.table}: belongs to law = "{law.name}", not to {own}; remove '
                    "the table"
                )
        idle = ("gain", "gains", "adapt_gains", "hedging", "feedback", "feedforward")
        if self.row.at_fixes:
            for key in idle:
                if key in self.model_fields_set:
                    yield (
                        f"learning.{key}: {own} adapts by no gain and holds the gains of the "
                        "vehicle; remove the key"
                    )
            if self.sample is not None:
                yield f"learning.sample: {own} runs at fixes alone; remove the key"
            return
        needed = ["parameters"] if self.row.alpha_by_gain else []
        needed += ["feedback", "feedforward"] if self.adapt_gains else []
        if self.gain == 0 and self.row.settings:
            yield (
                "learning.gain: 0 learns nothing with the paper's laws, learned-flow and "
                f"known-flow; {own} learns by its own table too; give a positive number"
            )
        if self.gain is not None and self.gains is not None:
            yield "learning.gains: give either gain or gains, one of the two"
        if self.gains is None:
            if self.gain is None and self.row.gain is None and needed:
                yield f"learning.gain: is required by {own}"
        else:
            for key in LearningGains.model_fields:
                is_set = getattr(self.gains, key) is not None
                if key in needed and not is_set:
                    yield f"learning.gains.{key}: is required; or give one gain for all"
                if is_set and key not in needed:
                    why = "alpha does not adapt by it" if key == "parameters" else "it is held"
                    yield f"learning.gains.{key}: {why} here; remove the key"
        for key in ("feedback", "feedforward"):
            if not self.adapt_gains and key not in self.model_fields_set:
                yield (
                    f"learning.{key}: is required with adapt_gains = false, which holds it; to "
                    f"hold the vehicle's own give the value of vehicle.{key}"
                )
