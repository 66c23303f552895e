"""Rows of the table of laws, and the rates of K and Gamma that all laws share.

    K'     = -gamma_K z e                         Eq. (14), Eq. (22)
    Gamma' =  gamma_Gamma zc e                    Eq. (15), Eq. (23)

z and zc are diagonal matrices in the paper, so each axis i has its own e_i, z_i, zc_i; there
gamma is one number for all.  A parameter whose gain is 0 is fixed.

A row (`Law`) declares parameters, states, inputs, rates and V.  The block of the law, its
parameters, the block of V and the initial states follow from the row.  A law computes its
parameters from the facts in `LawContext`, never from theta; V measures the distance to `Truth`.

The default of a setting is a factor times two scales: k, the mean of KD, per time, and R, the
largest distance of the track from the waypoints' mean, length.
"""

import inspect
from collections.abc import Callable, Iterable, Mapping
from functools import partial, update_wrapper
from operator import attrgetter
from typing import Any, Literal, NamedTuple

import numpy as np

from ...base.errors import ScenarioError
from ...engine.model.block import Block
from ...engine.model.declaration import Parameters
from ..blocks.lyapunov import BY_GAINS, known_flow_V, learned_flow_V, weighted
from ..blocks.ports import shapes_of

# --- facts of the experiment ------------------------------------------------------------------


class Gains(NamedTuple):
    """The gains with which a law adapts; with a gain of 0, K or Gamma is fixed."""

    parameters: float  # gamma of alpha, per time squared
    feedback: float  # gamma of K, per length squared per time squared
    feedforward: float  # gamma of Gamma, per length squared per time squared
    shared: bool  # True if they are one number, as in the paper


class Fixes(NamedTuple):
    """Times and noise of position fixes."""

    interval: float  # from one fix to the next, time
    latency: float  # from a fix to its arrival, time; below the interval
    noise: float  # standard deviation of each axis, length


class LawContext(NamedTuple):
    """Facts of the experiment that a law may use: never theta."""

    N: int  # number of basis functions
    gains: Gains
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    waypoints: np.ndarray  # shape (n, 2), length
    dwell: float  # time at each waypoint
    position: np.ndarray  # shape (2,), x(0), length
    alpha: np.ndarray  # shape (2, N), alpha(0), length per time
    theta_estimate: np.ndarray  # shape (2, N), given, or alpha_M, length per time
    # every key of the law's own table, its value or default
    settings: Mapping[str, Any]
    GammaD: np.ndarray  # shape (2,), feedforward gains of the vehicle, per time
    fixes: Fixes | None = None  # None: the position is read at all times
    # True if the vehicle's speed is limited: v_c of Eq. (7) is not v_x
    limited: bool = False

    @property
    def cycle(self) -> float:
        """Time to visit every waypoint once."""
        return len(self.waypoints) * self.dwell

    @property
    def reach(self) -> float:
        """The largest distance of a waypoint from the origin; 1 where all are at it."""
        return float(np.hypot(*self.waypoints.T).max()) or 1.0

    @property
    def k(self) -> float:
        """The mean feedback gain of the vehicle, per time: the scale of time."""
        return float(np.mean(self.KD))

    @property
    def R(self) -> float:
        """Largest distance of start and waypoints from the waypoints' mean: the scale of length."""
        points = np.vstack([self.waypoints, self.position])
        R = float(np.max(np.linalg.norm(points - self.waypoints.mean(axis=0), axis=1)))
        if R == 0:
            raise ScenarioError(
                "reference: start and waypoints lie at one place. Give prior and noise "
                "in the law's own table"
            )
        return R

    @property
    def prior(self) -> float:
        """The standard deviation of each parameter, as set or the default."""
        return PRIOR.of(self, "prior")


class Truth(NamedTuple):
    """The true parameters; V measures the distance to them."""

    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time


class Setting(NamedTuple):
    """A key of a law's own table of the scenario."""

    meaning: str  # with its unit
    usual: Any  # the default: a number, or a function of the context
    # "below 1" and "at most 1" are positive too
    allowed: Literal["positive", "not negative", "below 1", "at most 1", "row"] = (
        "positive"
    )

    @property
    def default(self) -> Any:
        """The default if it is a number; None if it is a function of the context."""
        return None if callable(self.usual) else self.usual

    def of(self, context: LawContext, key: str) -> Any:
        """Return the scenario's value of a key, or the default."""
        value = context.settings[key]
        return self.usual(context) if value is None and callable(self.usual) else value


def scaled(factor: float, k: float = 1, R: int = 0) -> Any:
    """Return a function of the context: factor times k^k times R^R."""
    return lambda context: factor * context.k**k * (context.R**R if R else 1)


PRIOR = Setting(
    "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
    scaled(0.3, k=1, R=1),
)
NOISE = Setting(
    "r of the regression, length/time^0.5; 0.1 R k^0.5", scaled(0.1, k=0.5, R=1)
)
FILTER = Setting("pole l of the filter, 1/time; 2 k", scaled(2))
MEMORY = Setting(
    "m of the memory, which keeps all and comes to 1/m, 1/time; 0.1 k",
    scaled(0.1),
    "not negative",
)


# --- a row ------------------------------------------------------------------------------------


class State(NamedTuple):
    """A state of a law."""

    shape: Any  # of numbers and "N"
    # a number, or a function of context and parameters; None: 0, or the value of a scenario's key
    start: Any = None


PAPER = {"e": 2, "phi_x": "N", "z": 2, "zc": 2}  # the inputs of Eqs. (21)-(23)
# inputs of laws that learn from the vehicle's motion
MOVING = {**PAPER, "x": 2, "v_x": 2}
BY_P = ("e", "alpha", "K", "Gamma", "weighted")  # inputs of V with a covariance P
GAIN_STATES = {"K": State(2), "Gamma": State(2)}
LEARNED = {"alpha": State((2, "N")), **GAIN_STATES}  # the outputs of a law
# gamma of K and Gamma, per length squared per time squared; 0 fixes K or Gamma
K_GAMMA = {"gain_K": "gains.feedback", "gain_Gamma": "gains.feedforward"}
GAINS = {"gain": "gains.parameters", **K_GAMMA}  # gamma > 0 of alpha, per time squared
Part = dict[str, Any]  # fields of a row that laws share
MAPPINGS = ("keys", "parameters", "states", "inputs")  # fields that are merged


def output_and_states(
    output: Any, states: tuple[str, ...], t: Any, x: Any, u: Any, p: Any
) -> Any:
    """Return the outputs of a law by port: those of `output`, and its states."""
    return {**output(t, x, u, p), **{name: getattr(x, name) for name in states}}


class Promise(NamedTuple):
    """A promise of a law, which `theory.laws.promises` describes."""

    claim: str  # a key of `theory.laws.promises.CLAIMS`
    conditions: tuple[str, ...]  # keys of `theory.laws.promises.CONDITIONS`


def promised(conditions: str, *claims: str) -> tuple[Promise, ...]:
    """Return promises of the same conditions."""
    return tuple(Promise(claim, tuple(conditions.split())) for claim in claims)


class Law(NamedTuple):
    """A row of the table of laws."""

    name: str  # learning.law; its own table is learning.NAME, with _ for -
    rates: Callable[..., Any]  # the rates of its states; their docstring is its page
    # a function whose docstring is the page of several laws
    family: Callable[..., Any] | None = None
    needs: str = ""  # one line
    # parameter -> `Setting` of its own table, name of an attribute of the context (a gain or what
    # else has a name at call time), or function of the context
    parameters: Mapping[str, Any] = GAINS
    one_gain: bool = False  # True if one gain for all is one parameter, as in the paper
    keys: Mapping[str, Setting] = {}  # keys of its own table that are not parameters
    inputs: Mapping[str, Any] = PAPER  # v_c only if the speed is limited
    states: Mapping[str, State] = LEARNED
    output: Callable[..., Any] | None = None  # computes `outputs`, which are not states
    outputs: Mapping[str, Any] = {}
    jump: Callable[..., Any] | None = None  # at its breakpoints
    breakpoints: Callable[..., np.ndarray] | None = None
    candidate: Callable[..., Any] | None = None  # V, if it is not Eq. (17) or (24)
    V_inputs: tuple[str, ...] = ("e", "alpha", "K", "Gamma")  # e and outputs of the law
    # the gain of alpha in V
    V_gain: Callable[[Any], float] = lambda p: p.get("gain", 1.0)
    # raises an error if the law cannot run in this context
    check: Callable[[Any, LawContext], None] = lambda law, context: None
    # of (states, parameters, truth): state -> its value in terms of the other states, at all times
    invariants: Callable[..., dict[str, Any]] | None = None
    semidefinite: tuple[str, ...] = ()  # states that are matrices M = M^T >= 0
    # dissipative terms of V' in addition to e^T KD e: products of non-negative factors
    losses: Callable[..., list[tuple]] = lambda states, p, truth: []
    # estimate whose error drives CLPE: V' has e^T (theta + alpha) phi of "alpha", and
    # e^T (theta - theta_hat) phi of "theta_hat"
    driving_estimate: Literal["", "alpha", "theta_hat"] = ""
    # eta P^-1 of a law with a covariance P
    weighted_error: Callable[..., Any] | None = None
    # V of a law with a covariance P from the input eta P^-1, without the invariants
    candidate_by_P: Callable[..., Any] | None = None
    # (d P^-1 d^T)' of a law that estimates theta, d = theta_hat - theta; its states include d P^-1,
    # shape (2, N)
    error_growth: Callable[..., Any] = lambda states, p, truth: 0
    # a state w with w' <= 0: the error of each parameter is w times its initial error
    error_left: str = ""
    readout: str = ""  # an output that is theta once w has fallen
    V_rate: str = ""  # V' as a formula
    promises: tuple[Promise, ...] = ()
    # a reason for which the law may break its promise, or ""
    doubt: Callable[[Any, Truth], str] = lambda p, truth: ""
    # of (P, time, settings): covariance P after a time without fixes; None: not for recorded fixes
    between_fixes: Callable[..., np.ndarray] | None = None

    @property
    def table(self) -> str:
        """The name of the law's table within [learning]."""
        return self.name.replace("-", "_")

    @property
    def page(self) -> str:
        """The law's page: equations, V, V' and source."""
        return inspect.cleandoc(str((self.family or self.rates).__doc__))

    @property
    def settings(self) -> dict[str, Setting]:
        """The keys of the law's table in the scenario."""
        sources = {**self.keys, **self.parameters}
        return {
            key: source
            for key, source in sources.items()
            if isinstance(source, Setting)
        }

    @property
    def gain(self) -> float | None:
        """Default of learning.gain; None (required) for laws that learn from CLPE alone."""
        return 1.0 if "x" in self.inputs else None

    @property
    def alpha_by_gain(self) -> bool:
        """True if learning.gain adapts alpha too, not only K and Gamma."""
        return "gain" in self.parameters

    @property
    def at_fixes(self) -> bool:
        """True if it learns at fixes; z is then one of its states, and K and Gamma are true."""
        return "fix" in self.inputs

    @property
    def alpha_is_constant(self) -> bool:
        """True if alpha stays alpha_M, and the injection is Eq. (13)."""
        return "alpha" not in self.states

    @property
    def makes_estimate(self) -> bool:
        """True if theta_hat of Eq. (13) is a state of the law."""
        return "theta_hat" in self.states

    @property
    def given_estimate(self) -> bool:
        """True if theta_hat of Eq. (13) is given."""
        return self.alpha_is_constant and not self.makes_estimate

    def with_parts(self, *shared_fields: Part) -> "Law":
        """Return the row merged with shared fields; semidefinite states are symmetric."""
        groups = (self._asdict(), *shared_fields)

        def values_of(field: str) -> list[Any]:
            return [group[field] for group in groups if group.get(field)]

        def invariants(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
            symmetric = {name: (s[name] + s[name].T) / 2 for name in semidefinite}
            states = {**s, **symmetric}
            relations = (rule(states, p, truth) for rule in values_of("invariants"))
            return merged([symmetric, *relations])

        def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
            terms = (rule(s, p, truth) for rule in values_of("losses"))
            return [product for products in terms for product in products]

        semidefinite = tuple(
            sorted(name for names in values_of("semidefinite") for name in names)
        )
        fields = merged(shared_fields)
        fields |= {field: merged(values_of(field)) for field in MAPPINGS}
        fields |= {
            "invariants": invariants,
            "losses": losses,
            "semidefinite": semidefinite,
        }
        return self._replace(**fields)

    def parameters_of(self, context: LawContext) -> Parameters:
        """Return the parameters that follow from the context."""
        self.check(self, context)
        values = {}
        for name, source in self.parameters.items():
            make = attrgetter(source) if isinstance(source, str) else source
            values[name] = (
                make.of(context, name) if isinstance(make, Setting) else make(context)
            )
        if self.one_gain and context.gains.shared:
            settings = {name: values[name] for name in values if name not in GAINS}
            values = {"gain": context.gains.feedback} | settings
        return Parameters(**values)

    def block(self, context: LawContext) -> Block:
        """Make the law: a block "adaptation" with alpha[2N], K[2] and Gamma[2]."""
        parameters = self.parameters_of(context)._asdict()
        return self.of(context.N, context.limited, **parameters)

    def of(self, N: int, limited: bool = False, **parameters: Any) -> Block:
        """Make the law from its parameters."""
        states = {name: state.shape for name, state in self.states.items()}
        full_output = partial(output_and_states, self.output, tuple(states))
        return Block(
            "adaptation",
            update=self.rates,
            output=update_wrapper(full_output, self.output) if self.output else None,
            inputs={
                port: n for port, n in self.inputs.items() if port != "v_c" or limited
            },
            outputs={**self.outputs, **states},
            states=states,
            parameters=parameters | ({"interval": -1.0} if self.breakpoints else {}),
            shapes=shapes_of(parameters),
            sizes={"N": N},
            jump=self.jump,
            breakpoints=self.breakpoints,
        )

    def starts(self, context: LawContext) -> dict[str, Any]:
        """Return the values of its states at t = 0; states that are left out are zero."""
        p = self.parameters_of(context)
        starts = {name: state.start for name, state in self.states.items()}
        return {
            name: start(context, p) if callable(start) else start
            for name, start in starts.items()
            if start is not None
        }

    def V(self, p: Any, truth: Truth, along_run: bool = False) -> Block:
        """Make the block of V; along a run eta P^-1 is the separate input `weighted`."""
        values = weighted((self.V_gain(p), *gains_of(p)), *truth)._asdict()
        values |= {
            name: getattr(p, name) for name in self.parameters if name not in values
        }
        ports = {
            name: state.shape for name, state in {**LEARNED, **self.states}.items()
        }
        ports |= {"e": 2, "weighted": (2, "N")}
        usual = known_flow_V if self.alpha_is_constant else learned_flow_V
        by_P = self.candidate_by_P if along_run else None
        return Block(
            "lyapunov",
            output=by_P or self.candidate or usual,
            inputs={port: ports[port] for port in (BY_P if by_P else self.V_inputs)},
            outputs={"V": 1},
            parameters=values,
            shapes=shapes_of(values) | BY_GAINS,
        )


def merged(mappings: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Return all mappings merged into one dict."""
    return {name: value for mapping in mappings for name, value in mapping.items()}


def gains_of(p: Any) -> tuple[Any, Any]:
    """Return gamma of K and of Gamma; 1 if a law adapts neither."""
    gain = p.get("gain", 1.0)
    return p.get("gain_K", gain), p.get("gain_Gamma", gain)


def adapt_gains(p, e, u):
    """Return K' and Gamma', Eqs. (14)-(15) and (22)-(23)."""
    gain_K, gain_Gamma = gains_of(p)
    return {"K": -gain_K * u.z * e, "Gamma": gain_Gamma * u.zc * e}
