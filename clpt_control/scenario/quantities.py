"""The quantities of a scenario: under which names each is held, from the file to the blocks.

A key such as ``learning.gain`` is its name in a scenario; ``adaptation.gain`` is one at call time,
in ``simulate(params=...)``; a law knows it as ``gains.parameters``; the paper writes gamma.
"""

from collections.abc import Collection
from typing import Any, NamedTuple

from ..blocks.laws.law import Fixes, Gains, Setting


class Quantity(NamedTuple):
    """The names of one quantity, separated by spaces, beside its key."""

    held: str = ""  # parameters of blocks that hold its value as it is
    known: str = ""  # what a law knows that is made of it
    symbol: str = ""  # in the paper, of the parameters
    state: str = ""  # the state that starts there
    axes: str = ""  # dimensions of an array of several axes or functions
    jumps: bool = False  # whether it moves breakpoints


QUANTITIES = {
    "basis.centers": Quantity(
        "basis_x.centers basis_z.centers basis_x_true.centers", axes="basis axis"
    ),
    "basis.widths": Quantity("basis_x.widths basis_z.widths basis_x_true.widths", axes="basis"),
    "basis.periods": Quantity(axes="basis"),
    "basis.phases": Quantity("basis_x.phases basis_z.phases basis_x_true.phases", axes="basis"),
    "flow.parameters": Quantity("true_flow.theta lyapunov.theta", "", "theta", axes="axis basis"),
    "flow.disturbance.amplitude": Quantity("disturbance.amplitude"),
    "flow.disturbance.period": Quantity("disturbance.period", jumps=True),
    "flow.disturbance.seed": Quantity("disturbance.seed"),
    "localization.interval": Quantity(
        "fixes.between adaptation.between", "fixes.between", jumps=True
    ),
    "localization.latency": Quantity("adaptation.latency", "fixes.latency", jumps=True),
    "localization.noise": Quantity("measurement.noise fixes.noise", "fixes.noise"),
    "localization.noise_period": Quantity("measurement.period", jumps=True),
    "localization.dropouts": Quantity("fixes.dropouts"),
    "localization.seed": Quantity("measurement.seed fixes.seed"),
    "model.parameters": Quantity(
        "modeled_flow.alpha_M vehicle_controller.alpha_M injection.alpha_M adaptation.alpha_M",
        "alpha_M theta_estimate",
        "alpha_M",
        axes="axis basis",
    ),
    "vehicle.feedback": Quantity("vehicle_controller.KD lyapunov.KD error_system.KD", "KD", "KD"),
    "vehicle.feedforward": Quantity(
        "vehicle_controller.GammaD lyapunov.GammaD", "GammaD", "GammaD"
    ),
    "vehicle.max_speed": Quantity("speed_limit.max_speed"),
    "reference.dwell": Quantity("reference.dwell", "dwell", jumps=True),
    "reference.points": Quantity(axes="waypoint axis"),
    "learning.gain": Quantity(
        "adaptation.gain adaptation.gain_K adaptation.gain_Gamma parameter_system.gain "
        "lyapunov.gain lyapunov.gain_K lyapunov.gain_Gamma",
        "gains.parameters gains.feedback gains.feedforward",
        "gamma",
    ),
    "learning.gains.parameters": Quantity("adaptation.gain", "gains.parameters"),
    "learning.gains.feedback": Quantity("adaptation.gain_K", "gains.feedback"),
    "learning.gains.feedforward": Quantity("adaptation.gain_Gamma", "gains.feedforward"),
    "learning.theta_estimate": Quantity(
        "injection.theta_hat", "theta_estimate", "theta_hat", axes="axis basis"
    ),
    "vehicle.position": Quantity(known="position", state="x"),
    "learning.position": Quantity(state="z"),
    "learning.parameters": Quantity(known="alpha", state="alpha", axes="axis basis"),
    "learning.feedback": Quantity(state="K"),
    "learning.feedforward": Quantity(state="Gamma"),
}
CALL_TIME_NAMES = {key: one.held.split() for key, one in QUANTITIES.items() if one.held}
STARTS = {key: one.state for key, one in QUANTITIES.items() if one.state}  # as states are ordered


# --- what holds a key's value -------------------------------------------------------------------


def names_held(scenario: Any, known: Collection[str]) -> dict[str, list[str]]:
    """Return which parameters of a scenario's blocks, of those known, hold each key's value."""
    made = made_of(scenario)  # held elsewhere too
    return {
        key: [name for name in _names(scenario, key) if name in known and key not in made]
        for key in CALL_TIME_NAMES
    }


def _names(scenario: Any, key: str) -> list[str]:
    """Return which parameters hold a key's value in this scenario, whatever else is made of it."""
    names, learning = CALL_TIME_NAMES.get(key, []), scenario.learning
    if key == "learning.gain" and not learning.adapt_gains:
        names = names[:1]  # the others are 0
    if key.startswith("learning.gain") and key.startswith("learning.gains.") == (
        learning.gains is None
    ):
        names = []
    return names


def keys_of(scenario: Any, name: str) -> list[str]:
    """Return the keys of a scenario whose value a call-time name holds."""
    return [key for key in CALL_TIME_NAMES if name in _names(scenario, key)]


def key_of(name: str) -> str:
    """Return what to write in a scenario in place of a call-time name, or nothing."""
    key = " or ".join(key for key, held in CALL_TIME_NAMES.items() if name in held)
    return f"{name} is the name at call time, in params; the scenario's key is {key}" if key else ""


def call_time_name_of(key: str, known: set[str]) -> str:
    """Return what to write at call time in place of a scenario's key, or nothing.

    `known` are the parameters of the diagram that is called.
    """
    if key in STARTS:
        return f"{key} is a key of the scenario; at call time give initial_state"
    names = [name for name in CALL_TIME_NAMES.get(key, []) if name in known]
    if not names:
        return ""
    at_call = "name at call time is" if len(names) == 1 else "names at call time are"
    return f"{key} is a key of the scenario; its {at_call} {', '.join(names)}"


# --- what a law makes of a key's value -----------------------------------------------------------


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
    return {key for key, one in QUANTITIES.items() if asked & set(one.known.split())}
