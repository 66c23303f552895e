"""Rows of the table of laws, and the rates of K and Gamma that all laws share.

    K'     = -gamma_K z e                         Eq. (14), Eq. (22)
    Gamma' =  gamma_Gamma zc e                    Eq. (15), Eq. (23)

z and zc are diagonal matrices in the paper, so each axis i has its own e_i, z_i, zc_i; there
gamma is one number for all.  A gain of 0 holds what it adapts.

A row declares parameters, states, what the law takes, its rates and V; the block, its
parameters, V's block and starts follow from it.

What a law may know of an experiment, the truth that V measures to, and a law's settings.

A setting that is left out is made of two scales: k, the mean of KD, per time; R, how far the track
reaches, length.
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
from ..blocks.ports import among

# --- what is known ----------------------------------------------------------------------------


class Gains(NamedTuple):
    """The gains with which a law adapts; 0 holds K or Gamma."""

    parameters: float  # gamma of alpha, per time squared
    feedback: float  # gamma of K, per length squared per time squared
    feedforward: float  # gamma of Gamma, per length squared per time squared
    one: bool  # whether they are one number, as in the paper


class Fixes(NamedTuple):
    """Times and noise of position fixes."""

    between: float  # from one fix to the next, time
    latency: float  # from a fix to its arrival, time; below `between`
    noise: float  # standard deviation of each axis, length


class Known(NamedTuple):
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
    # whether the vehicle's speed is limited: v_c of Eq. (7) is not v_x
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
        places = np.vstack([self.waypoints, self.position])
        R = float(np.max(np.linalg.norm(places - self.waypoints.mean(axis=0), axis=1)))
        if R == 0:
            place = "start and waypoints lie at one place"
            raise ScenarioError(
                f"reference: {place}; give prior and noise in the law's own table"
            )
        return R

    @property
    def prior(self) -> float:
        """The standard deviation of each parameter, as given or the usual one."""
        return PRIOR.of(self, "prior")


class Truth(NamedTuple):
    """The true parameters, from which V is a distance."""

    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time


class Setting(NamedTuple):
    """A key of a law's own table of the scenario."""

    meaning: str  # what it is, with its unit
    usual: Any  # where it is left out: a number, or what makes it of what is known
    # "below 1" and "at most 1" are positive too
    allowed: Literal["positive", "not negative", "below 1", "at most 1", "row"] = (
        "positive"
    )

    @property
    def default(self) -> Any:
        """A number; None where it is made of what is known."""
        return None if callable(self.usual) else self.usual

    def of(self, known: Known, key: str) -> Any:
        """Return what the scenario gives for a key, or what is usual."""
        given = known.settings[key]
        return self.usual(known) if given is None and callable(self.usual) else given


def scaled(factor: float, k: float = 1, R: int = 0) -> Any:
    """Return a function of what is known: factor times the scale of time^k, of length^R."""
    return lambda known: factor * known.k**k * (known.R**R if R else 1)


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
    start: Any = None  # a number, or made of what is known and the parameters; None: 0, or a key's


PAPER = {"e": 2, "phi_x": "N", "z": 2, "zc": 2}  # the inputs of Eqs. (21)-(23)
# and of laws that read where the vehicle was carried
MOVING = {**PAPER, "x": 2, "v_x": 2}
BY_P = ("e", "alpha", "K", "Gamma", "weighted")  # of V by P
# the outputs of a law
LEARNED = {"alpha": State((2, "N")), "K": State(2), "Gamma": State(2)}
# gamma of K and Gamma, per length squared per time squared; 0 holds K or Gamma
K_GAMMA = {"gain_K": "gains.feedback", "gain_Gamma": "gains.feedforward"}
GAINS = {"gain": "gains.parameters", **K_GAMMA}  # gamma > 0 of alpha, per time squared
Part = dict[str, Any]  # fields of a row that laws share
MAPPINGS = ("keys", "parameters", "states", "inputs")  # fields that are merged


def output_and_states(
    output: Any, states: tuple[str, ...], t: Any, x: Any, u: Any, p: Any
) -> Any:
    """Return the outputs of a law that has more than its states, by port."""
    return {**output(t, x, u, p), **{name: getattr(x, name) for name in states}}


class Promise(NamedTuple):
    """A promise of a law, which `theory.promises` describes and checks along runs."""

    what: str  # a predicate
    where: tuple[str, ...]  # its conditions


def promised(where: str, *what: str) -> tuple[Promise, ...]:
    """Return promises of the same conditions."""
    return tuple(Promise(one, tuple(where.split())) for one in what)


class Law(NamedTuple):
    """A row of the table of laws."""

    name: str  # learning.law; its own table is learning.NAME, with _ for -
    rates: Callable[..., Any]  # the rates of its states; their docstring is its page
    # whose docstring is the page of several laws
    family: Callable[..., Any] | None = None
    needs: str = ""  # one line
    # a key of its own table; the name of what is known, as it is; or what makes it of what is known
    parameters: Mapping[str, Any] = GAINS
    one_gain: bool = False  # whether one gain for all is one parameter, as in the paper
    keys: Mapping[str, Setting] = {}  # of its own table, that are no parameters
    inputs: Mapping[str, Any] = PAPER  # v_c where the speed is limited
    states: Mapping[str, State] = LEARNED
    output: Callable[..., Any] | None = None  # of the `outputs` that are no states
    outputs: Mapping[str, Any] = {}
    jump: Callable[..., Any] | None = None  # at its breakpoints
    breakpoints: Callable[..., np.ndarray] | None = None
    candidate: Callable[..., Any] | None = None  # V, where it is not Eq. (17) or (24)
    V_inputs: tuple[str, ...] = ("e", "alpha", "K", "Gamma")  # e and outputs of the law
    # the gain of alpha in V
    V_gain: Callable[[Any], float] = lambda p: p.get("gain", 1.0)
    # raises where it cannot run
    check: Callable[[Any, Known], None] = lambda law, known: None
    # for the proof, of (states, parameters, truth): state -> what it is in the others, at all times
    invariants: Callable[..., dict[str, Any]] | None = None
    semidefinite: tuple[str, ...] = ()  # states that are matrices M = M^T >= 0
    # what V' loses beyond e^T KD e where they hold: products of factors that are not negative
    losses: Callable[..., list[tuple]] = lambda states, p, truth: []
    # what V' has beside, which bounds the law
    perturbation: Callable[..., Any] | None = None
    # eta P^-1, of a law with a covariance P
    weighted_error: Callable[..., Any] | None = None
    # V of such a law of its input eta P^-1, which is what it is anywhere, not as the invariants say
    candidate_by_P: Callable[..., Any] | None = None
    # of a law that makes an estimate: (d P^-1 d^T)', d = theta_hat - theta; its states have d P^-1
    # too, shape (2, N)
    error_growth: Callable[..., Any] = lambda states, p, truth: 0
    # a state w: every parameter's error is w times its first, and w' <= 0
    error_left: str = ""
    readout: str = ""  # an output that is theta once w has fallen
    V_rate: str = ""  # V' in words
    promises: tuple[Promise, ...] = ()
    # why it need not keep its promise
    doubt: Callable[[Any, Truth], str] = lambda p, truth: ""
    # of V, of the largest disturbance
    level: Callable[[Any, Truth, float], float] | None = None

    @property
    def table(self) -> str:
        """The name of its own table within [learning]."""
        return self.name.replace("-", "_")

    @property
    def page(self) -> str:
        """Its page: equations, V, V' and source."""
        return inspect.cleandoc(str((self.family or self.rates).__doc__))

    @property
    def settings(self) -> dict[str, Setting]:
        """The keys of its own table."""
        whole = {**self.keys, **self.parameters}
        return {key: one for key, one in whole.items() if isinstance(one, Setting)}

    @property
    def gain(self) -> float | None:
        """learning.gain where it is left out; required of laws that learn by CLPE alone."""
        return 1.0 if "x" in self.inputs else None

    @property
    def alpha_by_gain(self) -> bool:
        """True if learning.gain adapts alpha too, not only K and Gamma."""
        return "gain" in self.parameters

    @property
    def at_fixes(self) -> bool:
        """True if it learns at fixes; z is then a state of it, and K and Gamma are true."""
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

    def with_parts(self, *parts: Part) -> "Law":
        """Return the row with the fields of its parts; semidefinite states are symmetric."""
        whole = (self._asdict(), *parts)

        def every(field: str) -> list[Any]:
            return [part[field] for part in whole if part.get(field)]

        def invariants(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
            symmetric = {name: (s[name] + s[name].T) / 2 for name in semidefinite}
            relations = (
                one({**s, **symmetric}, p, truth) for one in every("invariants")
            )
            return merged([symmetric, *relations])

        def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
            return [product for one in every("losses") for product in one(s, p, truth)]

        semidefinite = tuple(
            sorted(name for names in every("semidefinite") for name in names)
        )
        fields = merged(parts) | {field: merged(every(field)) for field in MAPPINGS}
        fields |= {
            "invariants": invariants,
            "losses": losses,
            "semidefinite": semidefinite,
        }
        return self._replace(**fields)

    def parameters_of(self, known: Known) -> Parameters:
        """Return the parameters that follow from what is known."""
        self.check(self, known)
        values: dict[str, Any] = {}
        for name, source in self.parameters.items():
            make = attrgetter(source) if isinstance(source, str) else source
            values[name] = (
                make.of(known, name) if isinstance(make, Setting) else make(known)
            )
        if self.one_gain and known.gains.one:
            rest = {name: value for name, value in values.items() if name not in GAINS}
            values = {"gain": known.gains.feedback} | rest
        return Parameters(**values)

    def block(self, known: Known) -> Block:
        """Make the law: a block "adaptation" with alpha[2N], K[2] and Gamma[2]."""
        return self.of(known.N, known.limited, **self.parameters_of(known)._asdict())

    def of(self, N: int, limited: bool = False, **parameters: Any) -> Block:
        """Make the law of its parameters."""
        states = {name: state.shape for name, state in self.states.items()}
        whole = partial(output_and_states, self.output, tuple(states))
        return Block(
            "adaptation",
            update=self.rates,
            output=update_wrapper(whole, self.output) if self.output else None,
            inputs={
                port: n for port, n in self.inputs.items() if port != "v_c" or limited
            },
            outputs={**self.outputs, **states},
            states=states,
            parameters=parameters | ({"interval": -1.0} if self.breakpoints else {}),
            shapes=among(parameters),
            sizes={"N": N},
            jump=self.jump,
            breakpoints=self.breakpoints,
        )

    def starts(self, known: Known) -> dict[str, Any]:
        """Return where its own states are at t = 0; the others are zero."""
        p = self.parameters_of(known)
        starts = {
            name: one.start
            for name, one in self.states.items()
            if one.start is not None
        }
        return {
            name: one(known, p) if callable(one) else one
            for name, one in starts.items()
        }

    def V(self, p: Any, truth: Truth, along_run: bool = False) -> Block:
        """Make V of its parameters; along a run eta P^-1, `weighted`, is an input of its own."""
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
            shapes=among(values) | BY_GAINS,
        )


def merged(mappings: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Return mappings as one."""
    return {name: value for mapping in mappings for name, value in mapping.items()}


def gains_of(p: Any) -> tuple[Any, Any]:
    """Return gamma of K and of Gamma; 1 where a law adapts neither."""
    one = p.get("gain", 1.0)
    return p.get("gain_K", one), p.get("gain_Gamma", one)


def adapt_gains(p, e, u):
    """Return K' and Gamma', Eqs. (14)-(15) and (22)-(23)."""
    gain_K, gain_Gamma = gains_of(p)
    return {"K": -gain_K * u.z * e, "Gamma": gain_Gamma * u.zc * e}
