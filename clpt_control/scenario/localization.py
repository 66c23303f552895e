"""The table `[localization]`: how the vehicle comes to know where it is.

With interval = 0 it reads its position at all times, with noise; without the table it reads the
true one.
"""

from .mistakes import Table
from .tables import NotNegative, Positive, Seed


class Localization(Table):
    """Noise on the position."""

    noise: NotNegative = 0.0
    noise_period: Positive
    seed: Seed | None = None

    @property
    def spans(self) -> dict[str, float]:
        """Times between breakpoints, by key."""
        return {"localization.noise_period": self.noise_period}
