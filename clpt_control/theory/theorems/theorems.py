"""The four theorems of section III, line by line, each checked as printed.

A theorem is a page: read it from top to bottom.  Every line is checked on the blocks that run, for
every N (`PaperLoop`); V' is compared with the running blocks at random points as well.  A printed
statement that is false meets a counterexample, and the page carries the statement that holds.

    e = x - z,  eta = theta + alpha,  kappa = K - KD,  nu = GammaD - Gamma
    V = (|e|^2 + (|eta|^2 + |kappa|^2 + |nu|^2)/gamma)/2                          Eq. (24)

Source: Cho, Zhang and Edwards (2016), section III.  Theorem 3.3 and the ultimate bound of 3.4 take
the regressor of the vehicle alone, w* = [phi(x), x, zc], as `clpt.certify` does, without citations.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import sympy
from sympy import Matrix, Symbol, cos, simplify, sin

from ...base.arguments import public
from ...base.errors import ClptError
from ...base.progress import interrupt
from ...simulation.loops import error_loop
from ..laws.paper_loop import (
    PaperLoop,
    algebra,
    known_flow_steps,
    line,
    mean_square,
    quadratic,
    running,
)
from ..laws.theorem_loop import WIRED, decay, theorem_scenario
from ..proofs.proof import Proof, proof_or_failure, theorem
from ..proofs.steps import Step, checked, counterexample
from ..proofs.symbolic_loop import ArrayLoop
from .counterexamples import (
    burst_counterexample,
    disturbance_counterexample,
    known_flow_counterexample,
    square_wave_counterexample,
    unlearned_counterexample,
)

FILTERED = "excites through the filter 1/(s + KD_i) in every window alike"
POINTS = 10_000  # at which the running blocks are called for Theorem 3.2
FEWER = 1_000  # for 3.1 and 3.4, whose blocks are the same but for one
POSITIVE_KD = "Assumption 3.2: KD is positive definite, here diagonal"
PIECEWISE = (
    "zc is bounded and piecewise constant, with finitely many jumps in finite time"
)
SMOOTH = (
    "phi(x, t) is bounded, and a trajectory exists for all t >= 0: assumed, not shown"
)
NO_DELTA = "the true flow is theta phi, without Delta"


def theorem_3_1() -> Proof:
    """Judge Theorem 3.1: the known-flow law and its bound, Eq. (16)."""
    paper = PaperLoop("known-flow")
    return theorem(
        "CLPE is ultimately bounded by |e| <= |(theta - theta_hat) phi|/mu, mu < lambda_min(KD)",
        (
            POSITIVE_KD,
            PIECEWISE,
            SMOOTH,
            "|(theta - theta_hat) phi| is bounded, Assumption 3.3",
        ),
        [
            *known_flow_steps(paper, FEWER),
            counterexample(
                "the paper's system with one wrong theta_hat leaves Eq. (16) for every mu < KD",
                known_flow_counterexample,
                lambda run: run.ratio > 1.05,
                "max|e| = {0.ratio:.3f} of the largest drive over KD",
            ),
        ],
        "V' < 0 outside a ball in e bounds nothing while V also holds gain errors: "
        "the gains can store the drive and give it back.",
        corrected="int |e|^2 dt <= 2 V(0)/k + int |(theta - theta_hat) phi|^2 dt/k^2 with "
        "k = lambda_min(KD): in the mean square |e| is at most the drive over k",
        not_proved=(
            "a pointwise ultimate bound; it needs excitation, see Theorem 3.4",
        ),
    )


def theorem_3_2() -> Proof:
    """Judge Theorem 3.2: the learned-flow law drives CLPE to zero."""
    paper = PaperLoop("learned-flow")
    rate, zero = paper.rate, paper.zero
    x, z, e, phi, zc = paper.x, paper.z, paper.e, paper.phi, paper.zc
    KD, gamma = paper.KD, paper.gamma
    eta, kappa, nu = paper.eta, paper.kappa, paper.nu
    e_rate, V_rate = paper.error_rate, rate(paper.V)
    steps = [
        line(
            "(9)   x' + KD x is made of phi and zc alone, and KD > 0: x is bounded",
            paper.positive(KD),
            zero(rate(x) - paper.vehicle_rate),
        ),
        line(
            "(27)  e' = -KD e + eta phi + kappa z + nu zc", zero(rate(x - z) - e_rate)
        ),
        line("(21)  eta' = -gamma e phi^T", zero(rate(eta) + gamma * np.outer(e, phi))),
        line("(22)  kappa' = -gamma z e", zero(rate(kappa) + gamma * z * e)),
        line("(23)  nu' = -gamma zc e", zero(rate(nu) + gamma * zc * e)),
        quadratic(paper, "(24)"),
        line("V' = -e^T KD e, for every N", zero(V_rate + np.sum(KD * e**2))),
        running(paper, POINTS, "V' = -e^T KD e"),
        line(
            "(26)  V' <= 0, so e, eta, kappa and nu are bounded, and z = x - e",
            zero(e - (x - z)),
        ),
        line(
            "V'' = -2 e^T KD e' holds no derivative of phi or zc, so |V''| <= some B",
            zero(rate(V_rate) + 2 * np.sum(KD * e * e_rate)),
        ),
        line(
            "where g = -V' reaches eps, V loses int_0^(eps/B) (eps - B s) ds = eps^2/(2B) > 0: "
            "that can happen finitely often only, so V' -> 0 and e -> 0",
            algebra("integrate(eps - B*s, (s, 0, eps/B)) - eps**2/(2*B)"),
        ),
    ]
    return theorem(
        "under Assumptions 3.1 and 3.2 CLPE converges to zero",
        (POSITIVE_KD, PIECEWISE, SMOOTH, NO_DELTA),
        steps,
        "V falls and is bounded below, V'' is bounded, so V' -> 0 (Barbalat's lemma, "
        "whose argument is the last step) and e -> 0.",
        not_proved=(
            "any rate of convergence",
            "that alpha, K or Gamma converge (Theorem 3.3)",
        ),
    )


def theorem_3_3() -> Proof:
    """Judge Theorem 3.3: the parameters converge."""
    errors = ArrayLoop(error_loop(theorem_scenario(WIRED, "learned-flow")))
    e_decay = -np.sum(errors.parameters["error_system"].KD * errors.states["e"] ** 2)
    steps = [
        line(
            "(27)-(29) as blocks: (X^T P X)' = -e^T KD e with P = diag(I, I/gamma)/2, Eq. (29)",
            errors.zero(errors.derivative(level_of_errors(errors)) - e_decay),
        ),
        line("(27)-(28) are the closed loop's e' and eta'", same_dynamics(errors)),
        *filtered_steps(PaperLoop("learned-flow")),
        *vehicle_alone(PaperLoop("learned-flow")),
        circle_step(),
        counterexample(
            "zc exciting is not enough: with the gaussian-sigma kernel a parameter stands still",
            unlearned_counterexample,
            lambda run: run.kappa > 1.0 and run.moved < 1e-9 and run.error > 0.1,
            "zc excites (smallest eigenvalue {0.kappa:.0f}), yet theta[2] moves by "
            "{0.moved:.1e} and stays {0.error:.2f} off",
        ),
    ]
    return theorem(
        "under the setting of Theorem 3.2 alpha, K, Gamma converge to -theta, KD, GammaD",
        (POSITIVE_KD, PIECEWISE, SMOOTH, NO_DELTA),
        steps,
        "zc alone does not make the parameters converge; the joint regressor of the vehicle does.",
        corrected=f"if w* = [phi(x), x_i, zc_i] of each axis {FILTERED}, "
        "(e, alpha + theta, K - KD, Gamma - GammaD) goes to zero from every start, exponentially "
        "in the end",
        not_proved=(
            "that a given track excites w*: `clpt excitation --bounds` measures it",
        ),
    )


def level_of_errors(errors: Any) -> Any:
    """Return V = X^T P X of Eqs. (27)-(28)."""
    squares = {port: np.sum(state**2) for port, state in errors.states.items()}
    gain = errors.parameters["parameter_system"].gain
    return (squares.pop("e") + sum(squares.values()) / gain) / 2


def same_dynamics(errors: ArrayLoop) -> tuple[bool, str]:
    """Check that Eqs. (27)-(28) as blocks are the rates of the errors in the closed loop."""
    states = errors.states
    phi, z, zc = (errors.inputs[port] for port in ("phi_x", "z", "zc"))
    KD = errors.parameters["error_system"].KD
    gamma = errors.parameters["parameter_system"].gain
    e, eta, kappa, nu = (states[name] for name in ("e", "eta", "eta_3", "eta_4"))
    rates = {
        "e": -KD * e + eta @ phi + z * kappa + zc * nu,
        "eta": -gamma * np.outer(e, phi),
        "eta_3": -gamma * z * e,
        "eta_4": -gamma * zc * e,
    }
    return errors.zero(*(errors.rates[name] - rates[name] for name in rates))


def theorem_3_4() -> Proof:
    """Judge Theorem 3.4: the bound (33) under a disturbance, by Eq. (35)."""
    paper = PaperLoop("learned-flow", disturbed=True)
    disturbed_decay = decay(paper.loop) + paper.e @ paper.loop.inputs["delta"]
    claim = "V' = -e^T KD e + e^T Delta"
    steps = [
        line(
            f"(35)  {claim}, for every N",
            paper.zero(paper.rate(paper.V) - disturbed_decay),
        ),
        running(paper, FEWER, claim),
        quadratic(paper, "(24)"),
        mean_square(),
        *vehicle_alone(paper),
        line(
            "8  where a = D/k step 6 takes nothing from V: V ends at most where the root of "
            "step 5 is D/k",
            algebra("-k*(D/k)**2 + (D/k)*D"),
        ),
        counterexample(
            "the paper's system, started true, with a square wave leaves Eq. (33) for every "
            "beta < KD within t = 60 to 120, and keeps the mean-square bound",
            partial(disturbance_counterexample, start=60.0, end=120.0, samples=20),
            lambda run: run.ratio > 1.05 and run.rms <= 1.0,
            "max|e| = {0.ratio:.3f} Delta_max/KD, rms(e) = {0.rms:.3f} of its bound",
        ),
        counterexample(
            "phi = 1, k = 1, gamma = 100, a unit square wave at sqrt(gamma): limsup|e| = 4/pi",
            square_wave_counterexample,
            lambda run: abs(run.peak * np.pi / 4 - 1) < 1e-2,
            "limsup|e| = {0.peak:.4f}",
        ),
        counterexample(
            "k = gamma = Delta = 1, phi = 0.2 for a time of 250, then 1 for 20, again and again: "
            "phi is exciting, and |e| > 2 Delta/k comes back",
            burst_counterexample,
            lambda run: run.ratio > 2.0,
            "|e| peaks at {0.peak:.3f} in each cycle",
        ),
    ]
    return theorem(
        "|e| <= |Delta|/beta with a positive constant beta < lambda_min(KD)",
        (POSITIVE_KD, PIECEWISE, SMOOTH, "Delta is bounded and piecewise continuous"),
        steps,
        "V' < 0 outside a ball in e bounds nothing while V also holds parameter errors.",
        corrected="int |e|^2 dt <= 2 V(0)/k + int |Delta|^2 dt/k^2 always, so rms(e) <= "
        "rms(Delta)/k in the long run; where w* = [phi(x), x, zc] " + FILTERED + ", V "
        "ends at most where the root of step 5 is D/k, and |e| <= (2 V)^(1/2)",
        not_proved=("an ultimate bound where that root stays below D/k for every V",),
    )


THEOREMS: dict[str, Callable[[], Proof]] = {
    "3.1": theorem_3_1,
    "3.2": theorem_3_2,
    "3.3": theorem_3_3,
    "3.4": theorem_3_4,
}


def numbers_of(theorem: str | None) -> list[str]:
    """Return the theorem that was requested, or all."""
    if theorem is not None and theorem not in THEOREMS:
        raise ClptError(f"theorem {theorem}: must be one of {', '.join(THEOREMS)}")
    return list(THEOREMS) if theorem is None else [theorem]


@public
def audit(
    theorem: str | None = None, progress: Callable[[float], None] | None = None
) -> dict[str, Proof]:
    """Judge the paper's theorems on the equations that run.

    Parameters
    ----------
    theorem : str, optional
        One of ``"3.1"`` to ``"3.4"``; all by default.
    progress : callable, optional
        Called with the number of theorems judged.

    Returns
    -------
    dict
        Number -> Proof: its `status`, the `printed` statement, its `assumptions`, the `steps`, and
        what is `corrected`, `cited` and `not_proved`.

    Raises
    ------
    ClptError
        If there is no such theorem.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.theory.audit("3.2")["3.2"].status
    'proved'
    """
    proofs = {}
    for finished, number in enumerate(numbers_of(theorem), 1):
        interrupt.check()
        proofs[number] = proof_or_failure(THEOREMS[number])
        if progress is not None:
            progress(finished)
    return proofs


# --- excitation, for Theorem 3.3 ----------------------------------------------------------------


def circle_step() -> Step:
    """Prove that points on a circle excite, Assumption 3.1: the Gramian is (n tau r^2/2) I.

    zc zc^T is (r^2/2) (I + R), R turning twice as fast as zc; over n >= 3 points, tau at each, R is
    a geometric sum of q = exp(4 pi i/n), which is not 1 and whose n-th power is.
    """

    def excites() -> tuple[bool, str]:
        n, m = (Symbol(name, integer=True, nonnegative=True) for name in "nm")
        a, q = Symbol("a", real=True), Symbol("q")
        zc = Matrix([cos(a), sin(a)])
        c, s = cos(2 * a), sin(2 * a)
        doubled = zc * zc.T - Matrix([[1 + c, s], [s, 1 - c]]) / 2
        geometric = (q**n - 1) / (q - 1)
        difference = geometric.subs(n, n + 1) - geometric - q**n
        closed = sympy.exp(4 * sympy.pi * sympy.I / (m + 3)) ** (m + 3) - 1
        below_a_turn = sympy.factor(1 - 2 / (m + 3))  # so q is not 1
        zero = *simplify(doubled), simplify(difference), closed
        return not any(zero) and bool(below_a_turn.is_positive), (
            "zc zc^T = (r^2/2) (I + [[cos 2a, sin 2a], [sin 2a, -cos 2a]]), and sum exp(2 i a) is "
            "(q^n - 1)/(q - 1) = 0 with q = exp(4 pi i/n)"
        )

    claim = "n >= 3 waypoints on a circle excite: int zc zc^T dt = (n tau r^2/2) I over a cycle"
    return checked(claim, excites)


def filtered_steps(paper: PaperLoop) -> list[Step]:
    """Check the lines by which the parameters converge where the filtered regressor excites."""
    return [
        line(
            "e' = -KD e + w*^T eta + d, w* = [phi(x), x, zc] and d = -kappa e, from z = x - e",
            paper.zero(
                paper.rate(paper.e)
                - (paper.error_rate + paper.kappa * (paper.x - paper.z - paper.e))
            ),
        ),
        line(
            "w_f' = -KD w_f + w*: y = e - w_f^T eta obeys y' = -KD y + d - w_f^T eta', where d and "
            "eta' go to zero with e (Theorem 3.2) and w_f is bounded: so y and w_f^T eta go to 0",
            paper.positive(paper.KD),
            algebra("(w*n + d - k*e) - ((w - k*f)*n + f*m) - (d - f*m - k*(e - f*n))"),
        ),
        line(
            "eta' goes to 0, so eta stands still in a window, and int (w_f(s)^T eta(t))^2 ds over "
            "it goes to 0: (a + b)^2 <= 2 a^2 + 2 b^2",
            algebra("2*a**2 + 2*b**2 - (a + b)**2 - (a - b)**2"),
        ),
        line(
            f"w* {FILTERED}: the integral is at least c |eta(t)|^2, so eta goes to 0",
            algebra("c*n**2 - c*n*n"),
        ),
    ]


def vehicle_alone(paper: PaperLoop) -> list[Step]:
    """Check the seven steps by which V falls where the vehicle's own track excites.

    T is a window from t on, v a bound of |y|^2 = 2 V in it, k the smaller of KD, |.| the
    mean-square norm over the window, a = |e| and D = |Delta|.  Of axis i, y' = A* y loses at least
    the share delta_i of |y|^2 over the window.
    """
    rate, zero, square = paper.rate, paper.zero, np.sum
    x, e, phi, zc, KD, gamma = (
        paper.x,
        paper.e,
        paper.phi,
        paper.zc,
        paper.KD,
        paper.gamma,
    )
    eta, kappa, nu = paper.eta, paper.kappa, paper.nu
    delta = paper.loop.inputs.get("delta", 0.0)
    # rates of y' = A* y, in which x is in the place of z
    e_rate = -KD * e + eta @ phi + kappa * x + nu * zc
    eta_rate = -gamma * np.outer(e, phi)
    kappa_rate, nu_rate = -gamma * x * e, -gamma * zc * e
    work = square(eta * eta_rate) + square(kappa * kappa_rate) + square(nu * nu_rate)
    return [
        line(
            "1  units: V = |y|^2/2 of y = (e, Y), Y = (eta, kappa, nu)/gamma^(1/2)",
            zero(paper.V - paper.sum_of_squares()),
        ),
        line(
            "2  y' = A* y + d + (Delta, 0), A* of w* = [phi(x), x, zc] alone; d is -kappa e on e "
            "and gamma e^2 on kappa, from z = x - e",
            zero(
                rate(e) - (e_rate - kappa * e + delta),
                rate(eta) - eta_rate,
                rate(kappa) - (kappa_rate + gamma * e**2),
                rate(nu) - nu_rate,
            ),
        ),
        line(
            "3  along y' = A* y |y|^2 falls by 2 int e^T KD e over the window, which is "
            "delta |y|^2 at least",
            paper.positive(KD),
            zero(2 * square(e * e_rate) + 2 * work / gamma + 2 * square(KD * e**2)),
        ),
        line(
            "4  e = Phi_e y(t) + e_1 + e_2 + e_3, from rest by -kappa e, by gamma e^2 and by "
            "Delta: k b^2 <= b u gives |e_1| <= (gamma v)^(1/2) a/k and |e_3| <= D/k, and "
            "k |e_2|^2 <= int p p' = p^2/2 with p = gamma^(1/2) a^2",
            algebra("b*(k*b - u) - (k*b**2 - b*u)", "integrate(s, (s, 0, p)) - p**2/2"),
        ),
        line(
            "5  (c V(t))^(1/2) <= |Phi_e y(t)| <= B a + A a^2 + D/k, c the smaller delta_i/k_i, "
            "B = 1 + (gamma v)^(1/2)/k, A = (gamma/(2 k))^(1/2); the least a is the root",
            algebra(
                "A*((sqrt(B**2 + 4*A*s) - B)/(2*A))**2"
                " + B*(sqrt(B**2 + 4*A*s) - B)/(2*A) - s"
            ),
        ),
        line(
            "6  V(t+T) <= V(t) - k a^2 + a D, and V <= V(t) + D^2/(4 k) within the window",
            algebra("-k*a**2 + a*D - (D**2/(4*k) - k*(a - D/(2*k))**2)"),
        ),
        line(
            "7  D = 0 and c > 0 in every window alike: a > 0 while V > 0, so V falls to 0 from any "
            "start; as V -> 0, a^2 -> c V and V(t+T) <= (1 - k c) V(t)",
            algebra("limit(((sqrt(1 + 4*A*sqrt(c*V)) - 1)/(2*A))**2/V, V, 0) - c"),
        ),
    ]
