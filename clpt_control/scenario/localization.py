"""The table `[localization]`: how the vehicle comes to know where it is.

Without the table it reads its true position at all times; with interval = 0 with noise, and with
an interval above 0 it has fixes and steers on its own prediction in between.
"""

from typing import Annotated

from pydantic import Field, model_validator

from ..blocks.laws.known import Fixes
from .mistakes import Table
from .tables import NotNegative, Number, Positive, Seed

SHORT = 1e-6  # of the interval: times that are nearer count as one


class Localization(Table):
    """Fixes of the position, and their noise."""

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
        """What a law may know of the fixes; None where the position is read at all times."""
        return Fixes(self.interval, self.latency, self.noise) if self.interval > 0 else None

    @model_validator(mode="after")
    def _of_noise_or_of_fixes(self) -> "Localization":
        if self.interval == 0:
            if self.noise_period is None:
                raise ValueError(
                    "localization.noise_period: is required where interval is 0; give how long a "
                    "value of the noise is held, or an interval above 0 for fixes"
                )
            for key in ("dropouts", "latency"):
                if getattr(self, key) > 0:
                    raise ValueError(
                        f"localization.{key} = {getattr(self, key)}: is of fixes; give an interval "
                        "above 0, or remove the key"
                    )
        elif self.noise_period is not None:
            raise ValueError(
                f"localization.noise_period = {self.noise_period}: is allowed only with interval = "
                "0; each fix has a noise of its own"
            )
        else:
            few = SHORT * self.interval
            if self.latency != 0 and not few <= self.latency <= self.interval - few:
                raise ValueError(
                    f"localization.latency = {self.latency}: must be 0 or below the interval, "
                    f"{self.interval}, and not within {few:.1g} of either"
                )
        return self
