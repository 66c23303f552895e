"""What a row of the table of laws is, and what all laws share: K and Gamma.

    K'     = -gamma_K z e                         Eq. (14), Eq. (22)
    Gamma' =  gamma_Gamma zc e                    Eq. (15), Eq. (23)

z and zc are diagonal matrices in the paper, so each axis i has its own e_i, z_i, zc_i; there
gamma is one number for all.  A gain of 0 holds what it adapts.
"""

from collections.abc import Callable, Mapping
from typing import Any, Literal, NamedTuple

import control
import numpy as np

from ...equations.block import Block
from ...equations.declaration import ports_of
from ...errors import DiagramError


class Gains(NamedTuple):
    """The gains with which a law adapts; 0 holds K or Gamma."""

    parameters: float  # gamma of alpha, per time squared
    feedback: float  # gamma of K, per length squared per time squared
    feedforward: float  # gamma of Gamma, per length squared per time squared
    one: bool  # whether one number is given for all, as in the paper


class Setting(NamedTuple):
    """A key of a law's own table of the scenario."""

    default: Any  # a number; None where the law makes it of what is known
    allowed: Literal["number", "positive", "not negative", "row", "two rows"]
    meaning: str  # what it is, with its unit


class Fixes(NamedTuple):
    """When the vehicle learns where it is."""

    between: float  # from one fix to the next, time
    latency: float  # from a fix to its arrival, time; below `between`
    noise: float  # standard deviation of each axis, length


class Known(NamedTuple):
    """What a law may know of the experiment: never theta."""

    N: int  # number of basis functions
    gains: Gains
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    waypoints: np.ndarray  # shape (n, 2), length
    dwell: float  # time at each waypoint
    position: np.ndarray  # shape (2,), x(0), length
    alpha: np.ndarray  # shape (2, N), alpha(0), length per time
    theta_estimate: np.ndarray  # shape (2, N), given, or alpha_M, length per time
    settings: Mapping[str, Any]  # every key of the law's own table, its value or default
    GammaD: np.ndarray  # shape (2,), feedforward gains of the vehicle, per time
    fixes: Fixes | None = None  # None: the position is read at all times
    limited: bool = False  # whether the vehicle's speed is limited: v_c of Eq. (7) is not v_x

    @property
    def cycle(self) -> float:
        """Time to visit every waypoint once."""
        return len(self.waypoints) * self.dwell

    @property
    def reach(self) -> float:
        """The largest distance of a waypoint from the origin; 1 where all are at it."""
        return float(np.hypot(*self.waypoints.T).max()) or 1.0

    def setting(self, key: str, scale: float) -> float:
        """Return what the scenario gives for a key, or this scale of its own."""
        given = self.settings[key]
        return scale if given is None else given


class Truth(NamedTuple):
    """What V measures the distance to."""

    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time


class Law(NamedTuple):
    """A row of the table of laws."""

    name: str  # learning.law; its own table is learning.NAME, with _ for -
    promise: str  # one line
    needs: str  # one line
    block: Callable[[Known], Block]  # named "adaptation"; makes alpha[2N], K[2], Gamma[2]
    V: Callable[[Any, Truth], Block]  # of the block's parameters; inputs e and the law's outputs
    settings: Mapping[str, Setting] = {}
    gain: float | None = None  # where learning.gain is left out; None: it is required
    starts: Callable[[Known], dict[str, Any]] = lambda known: {}  # its own states at t = 0
    # keys of which its parameters and starts are made, beside its own
    made_of: tuple[str, ...] = ()
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
    alpha_by_gain: bool = True  # whether learning.gain adapts alpha too, not only K and Gamma
    at_fixes: bool = False  # whether it makes z too, and learns at fixes; K and Gamma are true
    given_estimate: bool = False  # theta_hat is given, alpha = alpha_M, Eq. (13)
    makes_estimate: bool = False  # theta_hat[2N] is a state of it, alpha = alpha_M, Eq. (13)

    @property
    def keeps_alpha(self) -> bool:
        """Whether alpha stays alpha_M, and the injection is Eq. (13)."""
        return self.given_estimate or self.makes_estimate

    @property
    def table(self) -> str:
        """The name of its own table within [learning]."""
        return self.name.replace("-", "_")


def adapt_feedback(gamma, e, z):
    """Return K_i' = -gamma z_i e_i, Eq. (14) and Eq. (22)."""
    return -gamma * z * e


def adapt_feedforward(gamma, e, zc):
    """Return Gamma_i' = gamma zc_i e_i, Eq. (15) and Eq. (23)."""
    return gamma * zc * e


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
