"""The paper's closed loop with the paper's names, and lines of proofs on it.

`PaperLoop` reads the blocks that run, by default as arrays whose size N is open.  A line of a proof
is a claim and what was checked of it:

    line("(22)  kappa' = -gamma z e", loop.zero(loop.rate(kappa) + gamma * z * e))

phi(x), phi(z), zc, Delta and the flown velocity are any functions of time.
"""

from typing import Any

import numpy as np

from ...engine.model.ports import named
from ..algebra.exact import vanishes
from ..proofs.same_as_running import running_step
from ..proofs.statements import said
from ..proofs.steps import Step
from ..proofs.symbolic_loop import ArrayLoop, symbolic_loop
from .theorem_loop import WIRED, Hedging, decay_and_known_error, theorem_loop

Check = tuple[bool, str]  # whether a claim holds, and why not


def line(claim: str, *checks: Check, shows: str = "") -> Step:
    """Return a line of a proof for every N; it holds if each check does."""
    failed = next((detail for holds, detail in checks if not holds), None)
    return Step(said(claim), failed is None, "exact", failed or "", shows=shows)


def algebra(*residuals: str) -> Check:
    """Check that expressions are zero, whatever numbers their letters are."""
    wrong = next((text for text in residuals if not vanishes(text)), "")
    return not wrong, wrong


class PaperLoop:
    """The loop of the learned-flow or the known-flow law by the paper's names, for every N.

    Another loop is given as `loop`; of a team with the name of the vehicle that is meant.
    """

    def __init__(
        self,
        law: str = "learned-flow",
        disturbed: bool = False,
        speed: Hedging = "no limit",
        loop: Any = None,
        vehicle: str = "",
    ):
        if loop is None:
            loop = ArrayLoop(theorem_loop(WIRED, law, disturbed=disturbed, speed=speed))

        def of(kind: str) -> str:
            return named(vehicle, kind) if vehicle else kind

        self.loop = loop
        self.rate = loop.derivative  # of an array along the blocks that run
        states, parameters = loop.states, loop.parameters
        car = parameters[of("vehicle_controller")]
        self.KD, self.GammaD, self.alpha_M = car.KD, car.GammaD, car.alpha_M
        self.theta = parameters[of("true_flow")].theta
        self.gamma = parameters[of("adaptation")].gain
        self.x, self.z = states[of("x")], states[of("z")]
        self.e = loop.signals[of("e")]
        self.phi, self.zc = loop.inputs[of("phi_x")], loop.inputs[of("zc")]
        self.V = loop.signals["V"][0]
        # the errors of what is learned
        self.kappa = states[of("K")] - self.KD
        self.nu = self.GammaD - states[of("Gamma")]
        if of("alpha") in states:
            self.alpha = states[of("alpha")]
            self.eta = self.theta + self.alpha

    @property
    def vehicle_rate(self) -> Any:
        """x' of Eq. (9): of phi, zc and x alone."""
        inputs = (self.theta - self.alpha_M) @ self.phi + self.GammaD * self.zc
        return inputs - self.KD * self.x

    @property
    def error_rate(self) -> Any:
        """e' of Eq. (27)."""
        learned = self.eta @ self.phi + self.kappa * self.z + self.nu * self.zc
        return learned - self.KD * self.e

    def sum_of_squares(self) -> Any:
        """Return V of Eq. (24), or of Eq. (17) where no alpha is learned."""
        errors = np.sum(self.kappa**2) + np.sum(self.nu**2)
        if hasattr(self, "eta"):
            errors = errors + np.sum(self.eta**2)
        return (np.sum(self.e**2) + errors / self.gamma) / 2

    def zero(self, *residuals: Any) -> Check:
        """Check that arrays are zero, and that the loop has a value everywhere."""
        return self.loop.zero(*residuals)

    def positive(self, *values: Any) -> Check:
        """Check that all elements of arrays are positive."""
        elements = [element for value in values for element in self.loop.read(value)]
        wrong = next((e for e in elements if not e.is_positive), None)
        return wrong is None, f"{wrong} is not known to be positive"


# --- steps of several proofs ------------------------------------------------------------------


def running(paper: PaperLoop, points: int, claim: str) -> Step:
    """Check V and all rates at random points of the blocks that run."""
    diagram = paper.loop.diagram
    return running_step(
        lambda: symbolic_loop(diagram), points, said(" ({})", claim), "N = 3, "
    )


def mean_square() -> Step:
    """Check -k e^2 + e d <= -k e^2/2 + d^2/(2 k), which bounds the mean square of e."""
    return line(
        "`-k e^2 + e d <= -k e^2/2 + d^2/(2k)`: what is left is `(k/2)(e - d/k)^2`; its integral "
        "bounds the mean square",
        algebra("k*e**2/2 + d**2/(2*k) - e*d - k*(e - d/k)**2/2"),
        shows="mean",
    )


def quadratic(paper: PaperLoop, equation: str) -> Step:
    """Check that V is half a sum of squares, each error by its gain."""
    return line(
        f"V of Eq. {equation} is positive definite in `e` and the parameter errors, and radially "
        "unbounded: half the sum of their squares, each with a positive weight",
        paper.positive(paper.gamma),
        paper.zero(paper.V - paper.sum_of_squares()),
        shows="definite",
    )


KNOWN_ERROR = said("V' = `-e^T KD e + e^T (theta - theta_hat) phi`")


def known_flow_steps(paper: PaperLoop, points: int) -> list[Step]:
    """Check V' of the known-flow law, Theorem 3.1."""
    zero = paper.zero(paper.rate(paper.V) - decay_and_known_error(paper.loop))
    return [
        line(said("{}, for every N", KNOWN_ERROR), zero, shows="values"),
        running(paper, points, KNOWN_ERROR),
        quadratic(paper, "(17)"),
        mean_square(),
    ]
