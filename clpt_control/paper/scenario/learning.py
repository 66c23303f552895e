"""The table [learning] of a scenario: the law, its gains, the law's own table, initial values."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator, Field, Strict, create_model
from pydantic_core import PydanticCustomError

from ..laws.law import Gains, Law
from ..laws.table import LAWS
from .tables import (
    NotNegative,
    Pair,
    Positive,
    Table,
    TwoRows,
    quantity,
    start_mistakes,
)


def _square_is_a_number(value: float) -> float:
    if value != 0 and not 1e-100 <= abs(value) <= 1e100:
        raise ValueError("must be 0, if allowed, or between 1e-100 and 1e100 in size")
    return value


# laws square and divide by settings, V by gains
_Squared = AfterValidator(_square_is_a_number)
_Gain = Annotated[Positive, _Squared] | None
KINDS: dict[str, Any] = {  # `Setting.allowed` -> type
    "positive": Annotated[Positive, _Squared],
    "not negative": Annotated[NotNegative, _Squared],
    "below 1": Annotated[Positive, _Squared, Field(lt=1)],
    "at most 1": Annotated[Positive, _Squared, Field(le=1)],
    "row": tuple[Annotated[NotNegative, _Squared], ...],
}


# keys of [learning] that a law does not use if it learns at fixes
NOT_AT_FIXES = (
    "gain",
    "gains",
    "adapt_gains",
    "hedging",
    "sample",
    "feedback",
    "feedforward",
)


class LearningGains(Table):
    """A gain each for alpha, K and Gamma; the law does not adapt a parameter without a gain."""

    parameters: _Gain = quantity(None, "adaptation.gain", "gains.parameters")
    feedback: _Gain = quantity(None, "adaptation.gain_K", "gains.feedback")
    feedforward: _Gain = quantity(None, "adaptation.gain_Gamma", "gains.feedforward")


def _own_table(law: Law) -> tuple[Any, None]:
    """Return a law's own table as an optional field."""
    keys: dict[str, Any] = {}
    for key, setting in law.settings.items():
        kind = KINDS[setting.allowed]
        keys[key] = (kind | None if setting.default is None else kind, setting.default)
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
        *names, last_name = (f"'{name}'" for name in LAWS)
        allowed = f"must be {', '.join(names)} or {last_name}; `clpt laws` says what each does"
        raise PydanticCustomError("law", "{allowed}", {"allowed": allowed})
    return name


class Learning(OwnTables):
    """The adaptive law, its gains, its own table and its initial values."""

    #: law = "learned-flow" # learned-flow: Eqs. (20)-(23); known-flow: Eqs. (13)-(15); `clpt laws`
    #: lists all
    law: Annotated[str, AfterValidator(_law)]
    #: gain = 0.8 # gamma of alpha, K and Gamma, positive; required unless `clpt laws` names the
    #: law's own; 0: no learning, of the paper's laws
    gain: Annotated[NotNegative, _Squared] | None = quantity(
        None,
        "adaptation.gain adaptation.gain_K adaptation.gain_Gamma parameter_system.gain "
        "lyapunov.gain lyapunov.gain_K lyapunov.gain_Gamma",
        "gains.parameters gains.feedback gains.feedforward",
        symbol="gamma",
    )
    #: # gains = { parameters = 0.8, feedback = 0.3, feedforward = 0.3 } # in place of gain, for
    #: alpha, K and Gamma
    gains: LearningGains | None = None
    #: # adapt_gains = false # false holds K and Gamma at feedback and feedforward
    adapt_gains: Annotated[bool, Strict()] = True
    #: # hedging = false # with max_speed; false: no hedging of what was not flown; left out: true
    hedging: Annotated[bool, Strict()] | None = None
    #: # sample = 0.02 # period of a sampled law by Euler's step; left out: continuous time
    sample: Positive | None = None
    #: # theta_estimate = [[1, 0, 1], [1, 0, 1]] # of known-flow, length/time
    theta_estimate: TwoRows | None = quantity(
        None,
        "injection.theta_hat",
        "theta_estimate",
        "theta_hat",
        axes="axis basis",
        unit="alpha",
    )
    #: position = [0, 0] # z(0), length
    position: Pair = quantity((0.0, 0.0), state="z")
    #: # position_lat_lon = [41.2, -69.5] # z(0) in degrees
    position_lat_lon: Pair | None = None
    #: parameters = [[0, 0, 0], [0, 0, 0]] # alpha(0), length/time; driven to -theta; 0 where left
    #: out
    parameters: TwoRows | None = quantity(
        None, context="alpha", state="alpha", axes="axis basis"
    )
    #: feedback = [0, 0] # K(0), 1/time
    feedback: Pair = quantity((0.0, 0.0), state="K")
    #: feedforward = [0, 0] # Gamma(0), 1/time
    feedforward: Pair = quantity((0.0, 0.0), state="Gamma")

    @property
    def row(self) -> Law:
        """The law's row in the table of laws."""
        return LAWS[self.law]

    @property
    def settings(self) -> dict[str, Any]:
        """Every key of the law's own table, its value or default."""
        table = getattr(self, self.row.table, None)
        return {
            key: setting.default if table is None else getattr(table, key)
            for key, setting in self.row.settings.items()
        }

    @property
    def used_gains(self) -> Gains:
        """The gains with which alpha, K and Gamma adapt; 0 for a fixed one."""
        common = (self.row.gain or 0.0) if self.gain is None else self.gain
        alpha, K, Gamma = (
            getattr(self.gains, key, common) or 0.0
            for key in LearningGains.model_fields
        )
        if not self.adapt_gains:
            K, Gamma = 0.0, 0.0
        return Gains(alpha, K, Gamma, shared=self.gains is None and self.adapt_gains)

    @property
    def _adapted(self) -> list[str]:
        """The keys of [learning.gains] that this law adapts by a gain."""
        adapted = ["parameters"] if self.row.alpha_by_gain else []
        return adapted + (["feedback", "feedforward"] if self.adapt_gains else [])

    @property
    def _unused(self) -> set[str]:
        """The keys that this law does not use."""
        unused = {law.table for law in LAWS.values() if law.name != self.law}
        unused.add("parameters" if self.row.alpha_is_constant else "theta_estimate")
        if self.row.at_fixes:
            unused.update(NOT_AT_FIXES)
        return unused

    @property
    def _required(self) -> list[str]:
        """The keys that this law needs."""
        row = self.row
        required = ["theta_estimate"] if row.given_estimate else []
        if row.at_fixes:
            return required
        if self._adapted and row.gain is None and self.gains is None:
            required.append("gain")
        return required + ([] if self.adapt_gains else ["feedback", "feedforward"])

    def _mistakes(self) -> Iterator[str]:
        yield from start_mistakes("learning", self)
        law, adapted = f'law = "{self.law}"', self._adapted
        set_keys = [
            key
            for key in type(self).model_fields
            if key in self.model_fields_set and getattr(self, key) is not None
        ]
        for key in set_keys:
            if key in self._unused:
                yield f"learning.{key}: {law} has no use for it. Remove the key"
        for key in self._required:
            if key not in set_keys:
                condition = "" if self.adapt_gains else " with adapt_gains = false"
                yield f"learning.{key}: is required by {law}{condition}"
        if self.gain == 0 and self.row.settings:
            yield (
                "learning.gain: 0 learns nothing with the paper's laws, learned-flow and "
                f"known-flow; {law} learns by its own table too. Give a positive number"
            )
        if self.gain is not None and self.gains is not None:
            yield "learning.gains: give either gain or gains, one of the two"
        for key, value in self.gains or ():
            if (value is not None) != (key in adapted):
                yield (
                    f"learning.gains.{key}: {law} adapts {', '.join(adapted) or 'nothing'} here. "
                    "Give a gain for each of these, and no other"
                )
