"""The quantities of a scenario and their names, from the file to the blocks.

In a scenario a quantity has a key, such as ``learning.gain``.  At call time, in
``simulate(params=...)``, it is ``adaptation.gain``; a law knows it as ``gains.parameters``; the
paper writes gamma.
"""

from typing import Any, NamedTuple

from ..laws.law import Fixes, Gains, Setting


class Quantity(NamedTuple):
    """The names of one quantity, separated by spaces, beside its key."""

    parameters: str = ""  # of blocks, that have its value as it is
    known: str = ""  # what a law knows of it, by the names of `Known`
    symbol: str = ""  # in the paper, of the parameters
    state: str = ""  # the state whose initial value it is
    axes: str = ""  # dimensions of an array of several axes or functions
    unit: str = ""  # the port that has its unit, if its state has not; or time
    jumps: bool = False  # whether breakpoints move with it


QUANTITIES = {
    "basis.centers": Quantity(
        "basis_x.centers basis_z.centers basis_x_true.centers",
        axes="basis axis",
        unit="x",
    ),
    "basis.widths": Quantity(
        "basis_x.widths basis_z.widths basis_x_true.widths", axes="basis"
    ),
    "basis.periods": Quantity(axes="basis", unit="time"),
    "basis.phases": Quantity(
        "basis_x.phases basis_z.phases basis_x_true.phases", axes="basis"
    ),
    "flow.parameters": Quantity(
        "true_flow.theta lyapunov.theta", "", "theta", axes="axis basis", unit="alpha"
    ),
    "flow.disturbance.amplitude": Quantity("disturbance.amplitude", unit="v_x"),
    "flow.disturbance.period": Quantity("disturbance.period", jumps=True, unit="time"),
    "flow.disturbance.seed": Quantity("disturbance.seed"),
    "localization.interval": Quantity(
        "fixes.between adaptation.between", "fixes.between", jumps=True, unit="time"
    ),
    "localization.latency": Quantity(
        "adaptation.latency", "fixes.latency", jumps=True, unit="time"
    ),
    "localization.noise": Quantity(
        "measurement.noise fixes.noise", "fixes.noise", unit="x"
    ),
    "localization.noise_period": Quantity(
        "measurement.period", jumps=True, unit="time"
    ),
    "localization.dropouts": Quantity("fixes.dropouts"),
    "localization.seed": Quantity("measurement.seed fixes.seed"),
    "model.parameters": Quantity(
        "modeled_flow.alpha_M vehicle_controller.alpha_M injection.alpha_M adaptation.alpha_M",
        "alpha_M theta_estimate",
        "alpha_M",
        axes="axis basis",
        unit="alpha",
    ),
    "vehicle.feedback": Quantity(
        "vehicle_controller.KD lyapunov.KD error_system.KD", "KD", "KD", unit="K"
    ),
    "vehicle.feedforward": Quantity(
        "vehicle_controller.GammaD lyapunov.GammaD", "GammaD", "GammaD", unit="Gamma"
    ),
    "vehicle.max_speed": Quantity("speed_limit.max_speed", unit="v_x"),
    "reference.dwell": Quantity("reference.dwell", "dwell", jumps=True, unit="time"),
    "reference.points": Quantity(axes="waypoint axis", unit="x"),
    "learning.gain": Quantity(
        "adaptation.gain adaptation.gain_K adaptation.gain_Gamma parameter_system.gain "
        "lyapunov.gain lyapunov.gain_K lyapunov.gain_Gamma",
        "gains.parameters gains.feedback gains.feedforward",
        "gamma",
    ),
    "learning.gains.parameters": Quantity("adaptation.gain", "gains.parameters"),
    "learning.gains.feedback": Quantity("adaptation.gain_K", "gains.feedback"),
    "learning.gains.feedforward": Quantity(
        "adaptation.gain_Gamma", "gains.feedforward"
    ),
    "learning.theta_estimate": Quantity(
        "injection.theta_hat",
        "theta_estimate",
        "theta_hat",
        axes="axis basis",
        unit="alpha",
    ),
    "vehicle.position": Quantity(known="position", state="x"),
    "learning.position": Quantity(state="z"),
    "learning.parameters": Quantity(known="alpha", state="alpha", axes="axis basis"),
    "learning.feedback": Quantity(state="K"),
    "learning.feedforward": Quantity(state="Gamma"),
}
CALL_TIME_NAMES = {
    key: q.parameters.split() for key, q in QUANTITIES.items() if q.parameters
}
# as states are ordered
STARTS = {key: one.state for key, one in QUANTITIES.items() if one.state}


# --- which parameters have a key's value ---------------------------------------------------------


def _parameters(scenario: Any, key: str) -> list[str]:
    """Return which parameters have a key's value in this scenario, whatever a law makes of it."""
    names, learning = CALL_TIME_NAMES[key], scenario.learning
    if key == "learning.gain" and not learning.adapt_gains:
        names = names[:1]  # the others are 0
    of_a_gain, of_one_each = map(key.startswith, ("learning.gain", "learning.gains."))
    if of_a_gain and of_one_each == (learning.gains is None):
        names = []
    return names


def keys_of(scenario: Any, name: str) -> list[str]:
    """Return the keys of a scenario whose value is that of a call-time name."""
    return [key for key in CALL_TIME_NAMES if name in _parameters(scenario, key)]


def key_hint(name: str) -> str:
    """Return what to write in a scenario in place of a call-time name, or nothing."""
    key = " or ".join(key for key, names in CALL_TIME_NAMES.items() if name in names)
    return (
        f"{name} is the name at call time, in params; the scenario's key is {key}"
        if key
        else ""
    )


def call_time_hint(key: str, known: set[str]) -> str:
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
    """A `Known` that notes the names of the attributes that are read."""

    def __init__(self, known: Any, names: set[str], prefix: str = "") -> None:
        self._known, self._names, self._prefix = known, names, prefix

    def __getattr__(self, name: str) -> Any:
        own = getattr(type(self._known), name)
        if isinstance(own, property):
            return own.__get__(self)
        value = getattr(self._known, name)
        if isinstance(value, Gains | Fixes):
            return Noting(value, self._names, f"{name}.")
        self._names.add(self._prefix + name)
        return value


def keys_of_law(scenario: Any) -> set[str]:
    """Return the keys from whose values the law makes its parameters and its start."""
    row, known, names = scenario.learning.row, scenario.known_to_law, set[str]()
    noting, p = Noting(known, names), row.parameters_of(known)
    for name, value in {**row.keys, **row.parameters}.items():
        if isinstance(value, Setting):
            value.of(noting, name)  # type: ignore[arg-type]
        elif callable(value):
            value(noting)
    for state in row.states.values():
        if callable(state.start):
            state.start(noting, p)
    return {key for key, one in QUANTITIES.items() if names & set(one.known.split())}
