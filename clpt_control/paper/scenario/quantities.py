"""Names of the quantities of a scenario, from the file to the blocks.

In a scenario a quantity has a key, such as ``learning.gain``.  At call time, in
``simulate(params=...)``, it is ``adaptation.gain``; in a law's context it is ``gains.parameters``;
in the paper it is gamma.
"""

from typing import Any, NamedTuple

from ..laws.law import Fixes, Gains, Setting


class Quantity(NamedTuple):
    """The names of one quantity, separated by spaces, in addition to its key."""

    parameters: str = ""  # parameters of blocks that have this value
    context: str = ""  # attributes of `LawContext` that have or contain it
    symbol: str = ""  # in the paper
    state: str = ""  # the state whose initial value it is
    axes: str = ""  # dimensions of an array of several axes or functions
    unit: str = ""  # the port that has its unit, if not its state; or time
    jumps: bool = False  # True if breakpoints depend on it


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
        "fixes.between adaptation.between", "fixes.interval", jumps=True, unit="time"
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
    "reference.points_lat_lon": Quantity(axes="waypoint axis"),
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
    "vehicle.position_lat_lon": Quantity(),
    "learning.position_lat_lon": Quantity(),
    "vehicle.position": Quantity(context="position", state="x"),
    "learning.position": Quantity(state="z"),
    "learning.parameters": Quantity(context="alpha", state="alpha", axes="axis basis"),
    "learning.feedback": Quantity(state="K"),
    "learning.feedforward": Quantity(state="Gamma"),
}
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


def key_hint(name: str) -> str:
    """Return a hint on the scenario's key for a call-time name, or ""."""
    key = " or ".join(key for key, names in CALL_TIME_NAMES.items() if name in names)
    return (
        f"{name} is the name at call time, in params; the scenario's key is {key}"
        if key
        else ""
    )


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

    def __init__(self, context: Any, names: set[str], prefix: str = "") -> None:
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
