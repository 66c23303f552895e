"""What a block shows to the outside: ports, their labels, and its guard."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..errors import BlockError

Equations = Callable[[float, np.ndarray, np.ndarray, Any, np.ndarray], None]


class Guard(NamedTuple):
    """Where a block may be used, and what happens outside.

    Attributes
    ----------
    distance : callable
        ``distance(t, x, u, p, y)`` fills y[0], an equation like a block's own:
        positive inside, negative outside.
    policy : str
        ``"raise"`` fails the run, ``"stop"`` ends it there and keeps it.
    sentence : callable
        ``sentence(t, u, p)``: position, time and bounds, for the message.
    """

    distance: Callable[[float, np.ndarray, np.ndarray, Any, np.ndarray], None]
    policy: str
    sentence: Callable[[float, np.ndarray, Any], str]

    def margin(self, t: float, u: np.ndarray, p: Any) -> float:
        """Return the distance at a time, for inputs and parameters."""
        y = np.zeros(1)
        self.distance(t, np.zeros(0), u, p, y)
        return float(y[0])


def states_as_outputs(t, x, u, p, y):
    """Y = x: the outputs are the states."""
    for i in range(len(y)):
        y[i] = x[i]


def check_names(name: str, *ports: Mapping[str, int] | None) -> None:
    """Refuse names and sizes that python-control cannot wire."""
    words = [(name, ".\n"), *((port, ".[]\n") for own in ports for port in own or ())]
    for word, not_in in words:  # python-control itself calls a system sys[0]
        if not isinstance(word, str) or not word or word[0] in "-+" or set(word) & set(not_in):
            raise BlockError(
                f"the name {word!r} of a block or port must not be empty, begin with a sign or "
                "hold . [ ] or a line end; use letters, digits and _"
            )
    for port, size in (item for own in ports for item in (own or {}).items()):
        if not isinstance(size, int | np.integer) or size < 0:
            raise BlockError(f"{name}.{port}: size {size!r} must be a whole number, 0 or more")


def labels(ports: Mapping[str, int] | None) -> list[str]:
    """Flatten ports to signal labels: ``{"e": 2}`` is ``e[0], e[1]``."""
    return [f"{port}[{k}]" for port, size in (ports or {}).items() for k in range(size)]
