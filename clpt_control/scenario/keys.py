"""What in the diagram holds the value of a scenario's key: one number, two names.

A key such as ``learning.gain`` is its name in a scenario, ``adaptation.gain`` at call
time, in ``simulate(params=...)``.
"""

from collections.abc import Collection, Iterable
from typing import Any

from .made_of import made_of

# scenario key -> parameters of blocks that hold its value as it is
CALL_TIME_NAMES = {
    "basis.centers": ("basis_x.centers", "basis_z.centers", "basis_x_true.centers"),
    "basis.widths": ("basis_x.widths", "basis_z.widths", "basis_x_true.widths"),
    "basis.phases": ("basis_x.phases", "basis_z.phases", "basis_x_true.phases"),
    "flow.parameters": ("true_flow.theta",),
    "flow.disturbance.amplitude": ("disturbance.amplitude",),
    "flow.disturbance.period": ("disturbance.period",),
    "flow.disturbance.seed": ("disturbance.seed",),
    "localization.interval": ("fixes.between", "adaptation.between"),
    "localization.latency": ("adaptation.latency",),
    "localization.noise": ("measurement.noise", "fixes.noise"),
    "localization.noise_period": ("measurement.period",),
    "localization.dropouts": ("fixes.dropouts",),
    "localization.seed": ("measurement.seed", "fixes.seed"),
    "model.parameters": (
        "modeled_flow.alpha_M",
        "vehicle_controller.alpha_M",
        "injection.alpha_M",
        "adaptation.alpha_M",
    ),
    "vehicle.feedback": ("vehicle_controller.KD",),
    "vehicle.feedforward": ("vehicle_controller.GammaD",),
    "vehicle.max_speed": ("speed_limit.max_speed",),
    "reference.dwell": ("reference.dwell",),
    "learning.gain": ("adaptation.gain", "adaptation.gain_K", "adaptation.gain_Gamma"),
    "learning.gains.parameters": ("adaptation.gain",),
    "learning.gains.feedback": ("adaptation.gain_K",),
    "learning.gains.feedforward": ("adaptation.gain_Gamma",),
    "learning.theta_estimate": ("injection.theta_hat",),
}
KEYS = {  # the other way round
    name: " or ".join(key for key, held in CALL_TIME_NAMES.items() if name in held)
    for names in CALL_TIME_NAMES.values()
    for name in names
}
JUMPS = (  # keys that move breakpoints
    "reference.dwell",
    "flow.disturbance.period",
    "localization.interval",
    "localization.latency",
    "localization.noise_period",
)
# scenario key -> the state that starts there, in the order of the diagram's states
STARTS = {
    "vehicle.position": "x",
    "learning.position": "z",
    "learning.parameters": "alpha",
    "learning.feedback": "K",
    "learning.feedforward": "Gamma",
}


def names_held(scenario: Any, keys: Iterable[str], known: Collection[str]) -> dict[str, list[str]]:
    """Return which parameters of a scenario's blocks, of those known, hold each key's value."""
    made = made_of(scenario)  # held elsewhere too
    return {
        key: [name for name in _names(scenario, key) if name in known and key not in made]
        for key in keys
    }


def _names(scenario: Any, key: str) -> tuple[str, ...]:
    """Return which parameters hold a key's value in this scenario, whatever else is made of it."""
    names, learning = CALL_TIME_NAMES.get(key, ()), scenario.learning
    if key == "learning.gain" and not learning.adapt_gains:
        names = names[:1]  # the others are 0
    if key.startswith("learning.gain") and key.startswith("learning.gains.") == (
        learning.gains is None
    ):
        names = ()
    return names


def keys_of(scenario: Any, name: str) -> list[str]:
    """Return the keys of a scenario whose value a call-time name holds."""
    return [key for key in CALL_TIME_NAMES if name in _names(scenario, key)]


def keys_alone(scenario: Any, known: Collection[str]) -> dict[str, str]:
    """Return call-time name -> key, where one parameter of those known holds the key's value."""
    held = names_held(scenario, CALL_TIME_NAMES, known)
    return {names[0]: key for key, names in held.items() if len(names) == 1}


def key_of(name: str) -> str:
    """Return what to write in a scenario in place of a call-time name, or nothing."""
    key = KEYS.get(name)
    return f"{name} is the name at call time, in params; the scenario's key is {key}" if key else ""


def call_time_name_of(key: str, known: set[str]) -> str:
    """Return what to write at call time in place of a scenario's key, or nothing.

    `known` are the parameters of the diagram that is called.
    """
    if key in STARTS:
        return f"{key} is a key of the scenario; at call time give initial_state"
    names = [name for name in CALL_TIME_NAMES.get(key, ()) if name in known]
    if not names:
        return ""
    at_call = f"names at call time are {', '.join(names)}"
    if len(names) == 1:
        at_call = f"name at call time is {names[0]}"
    return f"{key} is a key of the scenario; its {at_call}"
