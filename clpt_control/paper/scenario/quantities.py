"""Names of the quantities of a scenario, from the file to the blocks.

In a scenario a quantity has a key, such as ``learning.gain``.  At call time, in
``simulate(params=...)``, it is ``adaptation.gain``; in a law's context it is ``gains.parameters``;
in the paper it is gamma.
"""

from typing import Any

from ..laws.law import Fixes, Gains, Setting
from .experiment import Scenario

QUANTITIES = Scenario.quantities()
CALL_TIME_NAMES = {
    key: q.parameters.split() for key, q in QUANTITIES.items() if q.parameters
}
# as states are ordered
STARTS = {key: quantity.state for key, quantity in QUANTITIES.items() if quantity.state}


# --- parameters with a key's value ---------------------------------------------------------------


def _parameters(scenario: Any, key: str) -> list[str]:
    """Return the parameters of blocks that have a key's value in this scenario."""
    names, learning = CALL_TIME_NAMES[key], scenario.learning
    if key.startswith("learning.gain"):
        has_gains = learning.gains is not None
        if key.startswith("learning.gains.") != has_gains:
            return []
    if key == "learning.gain" and not learning.adapt_gains:
        return names[:1]  # the gains of K and Gamma are 0
    return names


def keys_of(scenario: Any, name: str) -> list[str]:
    """Return the keys of a scenario whose value is that of a call-time name."""
    return [key for key in CALL_TIME_NAMES if name in _parameters(scenario, key)]


def call_time_hint(key: str, parameters: set[str]) -> str:
    """Return a hint on the call-time name for a scenario's key, or "".

    `parameters` are those of the diagram.
    """
    if key in STARTS:
        return f"{key} is a key of the scenario; at call time give initial_state"
    names = [name for name in CALL_TIME_NAMES.get(key, []) if name in parameters]
    if not names:
        return ""
    at_call = "name at call time is" if len(names) == 1 else "names at call time are"
    return f"{key} is a key of the scenario; its {at_call} {', '.join(names)}"


# --- keys that a law's parameters depend on ------------------------------------------------------


class RecordingContext:
    """Proxy of a `LawContext` that records the names of attributes that are read."""

    def __init__(self, context: Any, names: set[str], prefix: str = ""):
        self._context, self._names, self._prefix = context, names, prefix

    def __getattr__(self, name: str) -> Any:
        member = getattr(type(self._context), name)
        if isinstance(member, property):
            return member.__get__(self)
        value = getattr(self._context, name)
        if isinstance(value, Gains | Fixes):
            return RecordingContext(value, self._names, f"{name}.")
        self._names.add(self._prefix + name)
        return value


def keys_of_law(scenario: Any) -> set[str]:
    """Return the keys on which the law's parameters and initial states depend."""
    row = scenario.learning.row
    context = scenario.known_to_law
    names = set[str]()
    recorder = RecordingContext(context, names)
    p = row.parameters_of(context)
    for name, value in {**row.keys, **row.parameters}.items():
        if isinstance(value, Setting):
            value.of(recorder, name)  # type: ignore[arg-type]
        elif callable(value):
            value(recorder)
    for state in row.states.values():
        if callable(state.start):
            state.start(recorder, p)
    return {
        key
        for key, quantity in QUANTITIES.items()
        if names & set(quantity.context.split())
    }
