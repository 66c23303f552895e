"""What a row of the table of laws is, and what all laws share: K and Gamma.

    K'     = -gamma_K z e                         Eq. (14), Eq. (22)
    Gamma' =  gamma_Gamma zc e                    Eq. (15), Eq. (23)

z and zc are diagonal matrices in the paper, so each axis i has its own e_i, z_i, zc_i; there
gamma is one number for all.  A gain of 0 holds what it adapts.

A row declares parameters, states, what the law takes, its rates and V; the block, its
parameters, V's block, starts and what they are made of follow from it.
"""

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Any, Literal, NamedTuple

import control
import numpy as np

from ...equations.block import Block
from ...equations.declaration import Parameters, parameters_of, ports_of
from ...errors import DiagramError
from ..lyapunov import SHAPES, learned_flow, weighed
from .known import Known, Noting, Truth


class Setting(NamedTuple):
    """A key of a law's own table of the scenario."""

    default: Any  # a number; None where it is made of what is known
    # "below 1" and "at most 1" are positive too
    allowed: Literal[
        "number", "positive", "not negative", "below 1", "at most 1", "row", "two rows"
    ]
    meaning: str  # what it is, with its unit
    usual: Callable[[Known], Any] | None = None  # what it is where it is left out

    def of(self, known: Known, key: str) -> Any:
        """Return what the scenario gives for a key, or what is usual."""
        given = known.settings[key]
        return self.usual(known) if given is None and self.usual else given


class State(NamedTuple):
    """A state of a law."""

    shape: Any  # of numbers and "N"
    start: Any = None  # a number, or made of what is known and the parameters; None: 0, or a key's


PAPER = {"e": 2, "phi_x": "N", "z": 2, "zc": 2}  # what Eqs. (21)-(23) take
MOVING = {**PAPER, "x": 2, "v_x": 2}  # and laws that see where the vehicle was carried
LEARNED = {"alpha": State((2, "N")), "K": State(2), "Gamma": State(2)}  # what they make
HELD = {"gain_K": "gains.feedback", "gain_Gamma": "gains.feedforward"}  # 0 holds K or Gamma:
# per length squared per time squared, and gamma > 0 of alpha per time squared
GAINS = {"gain": "gains.parameters", **HELD}
MORE_SHAPES = {"alpha_M": (2, "N"), "alpha_0": (2, "N"), "information": "N"}  # of parameters


class Law(NamedTuple):
    """A row of the table of laws."""

    name: str  # learning.law; its own table is learning.NAME, with _ for -
    promise: str  # one line
    needs: str  # one line
    rates: Callable[..., Any]  # the rates of its states
    # a key of its own table; a name of what is known, as it is; or what makes it of what is known
    parameters: Mapping[str, Any] = GAINS
    one_gain: bool = False  # whether one gain for all is one parameter, as in the paper
    keys: Mapping[str, Setting] = {}  # of its own table, that are no parameters
    takes: Mapping[str, Any] = PAPER  # v_c where the speed is limited
    states: Mapping[str, State] = LEARNED
    output: Callable[..., Any] | None = None  # and what it `makes`, where that is not its states
    makes: Mapping[str, Any] | None = None
    jump: Callable[..., Any] | None = None  # at its breakpoints
    breakpoints: Callable[..., np.ndarray] | None = None
    candidate: Callable[..., Any] = learned_flow  # V
    measures: tuple[str, ...] = ("e", "alpha", "K", "Gamma")  # of e and what it makes
    weighs: Callable[[Any], float] = lambda p: p.get("gain", 1.0)  # the gain of alpha in V
    shares: tuple[str, ...] = ()  # its parameters that are V's too
    refuses: Callable[[Any, Known], None] = lambda law, known: None
    gain: float | None = None  # where learning.gain is left out; None: it is required
    # for the proof, of (states, parameters, truth): relations of its states
    keeps: Callable[..., dict[str, Any]] | None = None
    # what V' loses beyond e^T KD e where they hold: products of factors that are not negative
    losses: Callable[..., list[tuple]] = lambda states, p, truth: []
    push: Callable[..., Any] | None = None  # what V' has beside; the law is bounded by it
    comes_to: str = ""  # what is reached with a push, in words
    over: Callable[..., Any] | None = None  # eta P^-1, of a law with a covariance P
    # of a law that makes an estimate: what the error's square, over its covariance, grows by;
    # beside the states it is given d P^-1, shape (2, N), d = theta_hat - theta
    gains: Callable[..., Any] = lambda states, p, truth: 0
    cones: tuple[str, ...] = ()  # states that are matrices M >= 0
    shrinking: str = ""  # a state w: every parameter's error is w times its first, and w' <= 0
    readout: str = ""  # an output that is theta once w has shrunk
    says: str = ""  # V' in words

    @property
    def table(self) -> str:
        """The name of its own table within [learning]."""
        return self.name.replace("-", "_")

    @property
    def settings(self) -> dict[str, Setting]:
        """The keys of its own table."""
        own = {**self.keys, **self.parameters}
        return {key: one for key, one in own.items() if isinstance(one, Setting)}

    @property
    def alpha_by_gain(self) -> bool:
        """Whether learning.gain adapts alpha too, not only K and Gamma."""
        return "gain" in self.parameters

    @property
    def at_fixes(self) -> bool:
        """Whether it makes z too, and learns at fixes; K and Gamma are true."""
        return "fix" in self.takes

    @property
    def keeps_alpha(self) -> bool:
        """Whether alpha stays alpha_M, and the injection is Eq. (13)."""
        return "alpha" not in self.states

    @property
    def makes_estimate(self) -> bool:
        """Whether theta_hat of Eq. (13) is a state of it."""
        return "theta_hat" in self.states

    @property
    def given_estimate(self) -> bool:
        """Whether theta_hat of Eq. (13) is given."""
        return self.keeps_alpha and not self.makes_estimate

    def parameters_of(self, known: Known) -> Parameters:
        """Return its parameters, of what is known."""
        self.refuses(self, known)
        found: dict[str, Any] = {}
        for name, made in self.parameters.items():
            if isinstance(made, Setting):
                found[name] = made.of(known, name)
            else:
                found[name] = attrgetter(made)(known) if isinstance(made, str) else made(known)
        if self.one_gain and known.gains.one:
            rest = {name: value for name, value in found.items() if name not in GAINS}
            found = {"gain": known.gains.feedback, **rest}
        return parameters_of(found)

    def block(self, known: Known) -> Block:
        """Make the law: a block "adaptation" with alpha[2N], K[2] and Gamma[2]."""
        return self.of(known.N, known.limited, **self.parameters_of(known)._asdict())

    def of(self, N: int, limited: bool = False, **parameters: Any) -> Block:
        """Make the law of its parameters."""
        return Block(
            "adaptation",
            update=self.rates,
            output=self.output,
            inputs={port: n for port, n in self.takes.items() if port != "v_c" or limited},
            outputs=self.makes,
            states={name: state.shape for name, state in self.states.items()},
            parameters=parameters | ({"interval": -1.0} if self.breakpoints else {}),
            shapes=among(parameters, MORE_SHAPES),
            sizes={"N": N},
            jump=self.jump,
            breakpoints=self.breakpoints,
        )

    def starts(self, known: Known) -> dict[str, Any]:
        """Return where its own states are at t = 0; the others are zero."""
        p = self.parameters_of(known)
        own = {name: state.start for name, state in self.states.items() if state.start is not None}
        return {name: start(known, p) if callable(start) else start for name, start in own.items()}

    def made_of(self, known: Known) -> set[str]:
        """Return keys of which parameters and starts are made, beside its own and as they are."""
        noting, p = Noting(known, set()), self.parameters_of(known)
        for name, made in {**self.keys, **self.parameters}.items():
            if isinstance(made, Setting):
                made.of(noting, name)  # type: ignore[arg-type]
            elif callable(made):
                made(noting)
        for state in self.states.values():
            if callable(state.start):
                state.start(noting, p)
        return noting.keys

    def V(self, p: Any, truth: Truth) -> Block:
        """Make V of its parameters."""
        weights = self.weighs(p), *gains_of(p)
        own = weighed([1.0 if gain is None else gain for gain in weights], *truth)._asdict()
        own |= {name: getattr(p, name) for name in self.shares}
        ports = {name: state.shape for name, state in {**LEARNED, **self.states}.items()}
        return Block(
            "lyapunov",
            output=self.candidate,
            inputs={port: {"e": 2, **ports}[port] for port in self.measures},
            outputs={"V": 1},
            parameters=own,
            shapes=among(own, {**SHAPES, **MORE_SHAPES}),
        )


def among(parameters: Any, shapes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the shapes of those parameters that have any."""
    return {name: shapes[name] for name in parameters if name in shapes}


def gains_of(p: Any) -> tuple[Any, Any]:
    """Return gamma of K and of Gamma."""
    one = p.get("gain")
    return p.get("gain_K", one), p.get("gain_Gamma", one)


def adapt_gains(p, e, z, zc):
    """Return K' and Gamma', Eqs. (14)-(15) and (22)-(23)."""
    gain_K, gain_Gamma = gains_of(p)
    return {"K": -gain_K * z * e, "Gamma": gain_Gamma * zc * e}


def functions_of(law: control.NonlinearIOSystem) -> int:
    """Return the N of a law; refuse a part that does not make alpha[2N], K[2] and Gamma[2]."""
    if not isinstance(law, control.NonlinearIOSystem):
        what = f"a {type(law).__name__}" if hasattr(law, "name") else f"{law!r:.60}"
        raise DiagramError(f"{what} is no law: give a Block")
    taken, made = (
        {port: len(places) for port, places in ports_of(labels).items()}
        for labels in (law.input_labels, law.output_labels)
    )
    N = made.get("alpha", 0) // 2
    if N < 1 or made.get("alpha") != 2 * N or made.get("K") != 2 or made.get("Gamma") != 2:
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            + (", ".join(f"{port}[{size}]" for port, size in made.items()) or "nothing")
        )
    if taken.get("phi_x", N) != N:
        raise DiagramError(f"{law.name}: phi_x has {taken['phi_x']} signals, N is {N}")
    return N
