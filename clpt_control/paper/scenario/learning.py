"""The table [learning] of a scenario: the law, its gains, its own table, where it starts."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator, Field, Strict, create_model
from pydantic_core import PydanticCustomError

from ..laws.law import Gains, Law
from ..laws.table import LAWS
from .tables import NotNegative, Pair, Positive, Table, TwoRows


def _square_is_a_number(value: float) -> float:
    if value != 0 and not 1e-100 <= abs(value) <= 1e100:
        raise ValueError("must be 0, if allowed, or between 1e-100 and 1e100 in size")
    return value


# laws square and divide by settings, V by gains
_Squared = AfterValidator(_square_is_a_number)
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
        allowed = (
            f"must be {', '.join(names)} or {last}; `clpt laws` says what each does"
        )
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
        own, row = f'law = "{self.law}"', self.row
        given = [key for key in type(self).model_fields if key in self.model_fields_set]
        given = [key for key in given if getattr(self, key) is not None]
        idle = {law.table for law in LAWS.values() if law.name != self.law}
        idle.add("parameters" if row.alpha_is_constant else "theta_estimate")
        adapted = ["parameters"] if row.alpha_by_gain else []
        adapted += ["feedback", "feedforward"] if self.adapt_gains else []
        required = ["theta_estimate"] if row.given_estimate else []
        if row.at_fixes:
            idle |= {
                "gain",
                "gains",
                "adapt_gains",
                "hedging",
                "sample",
                "feedback",
                "feedforward",
            }
        else:
            required += (
                ["gain"] if adapted and row.gain is None and self.gains is None else []
            )
            required += [] if self.adapt_gains else ["feedback", "feedforward"]
        for key in given:
            if key in idle:
                yield f"learning.{key}: {own} has no use for it; remove the key"
        for key in required:
            if key not in given:
                held = "" if self.adapt_gains else " with adapt_gains = false"
                yield f"learning.{key}: is required by {own}{held}"
        if self.gain == 0 and row.settings:
            yield (
                "learning.gain: 0 learns nothing with the paper's laws, learned-flow and "
                f"known-flow; {own} learns by its own table too; give a positive number"
            )
        if self.gain is not None and self.gains is not None:
            yield "learning.gains: give either gain or gains, one of the two"
        for key, value in self.gains or ():
            if (value is not None) != (key in adapted):
                yield (
                    f"learning.gains.{key}: {own} adapts {', '.join(adapted) or 'nothing'} here; "
                    "give a gain for each of these, and no other"
                )
