"""Which keys a law's parameters and starts are made of, other than as they are."""

from typing import Any

from ..blocks.laws.known import Fixes, Gains, Setting

# what is known -> the keys of the scenario that say it
SAID_BY = {
    "gains.parameters": ("learning.gain", "learning.gains.parameters"),
    "gains.feedback": ("learning.gain", "learning.gains.feedback"),
    "gains.feedforward": ("learning.gain", "learning.gains.feedforward"),
    "alpha_M": ("model.parameters",),
    "KD": ("vehicle.feedback",),
    "GammaD": ("vehicle.feedforward",),
    "dwell": ("reference.dwell",),
    "position": ("vehicle.position",),
    "alpha": ("learning.parameters",),
    "theta_estimate": ("learning.theta_estimate", "model.parameters"),
    "fixes.between": ("localization.interval",),
    "fixes.latency": ("localization.latency",),
    "fixes.noise": ("localization.noise",),
}


class Noting:
    """What is known, noting the names of what is asked for."""

    def __init__(self, known: Any, asked: set[str], within: str = "") -> None:
        self._known, self._asked, self._within = known, asked, within

    def __getattr__(self, name: str) -> Any:
        own = getattr(type(self._known), name)
        if isinstance(own, property):
            return own.__get__(self)
        value = getattr(self._known, name)
        if isinstance(value, Gains | Fixes):
            return Noting(value, self._asked, f"{name}.")
        self._asked.add(self._within + name)
        return value


def made_of(scenario: Any) -> set[str]:
    """Return the keys that the law holds in another form, beside its own and as they are."""
    row, known, asked = scenario.learning.row, scenario.known_to_law, set[str]()
    noting, p = Noting(known, asked), row.parameters_of(known)
    for name, made in {**row.keys, **row.parameters}.items():
        if isinstance(made, Setting):
            made.of(noting, name)  # type: ignore[arg-type]
        elif callable(made):
            made(noting)
    for state in row.states.values():
        if callable(state.start):
            state.start(noting, p)
    return {key for name in asked for key in SAID_BY.get(name, ())}
