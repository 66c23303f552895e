"""The chain behind Theorem 3.2: bounded signals, then Barbalat's lemma.

    x' = (theta - alpha_M) phi - KD x + GammaD zc              Eq. (9)
    z  = x - e
    V'' = -2 e^T KD e',   e' = -KD e + W^T eta

V of Eq. (24) bounds e and eta; x is bounded by Eq. (9), stable and linear in x
but for the bounded phi; z = x - e then is bounded, and so are e' and V''.  The
print bounds z by calling Eq. (8) "linear with sinusoidal inputs", which is no
argument: its gains adapt.
"""

import sympy

from .lyapunov import PHI, lyapunov_derivative, theorem_loop
from .observability import eta_of
from .proof import Step, checked
from .trace import trace


def definite_steps(law: str) -> list[Step]:
    """Check that V is positive definite in e and the errors.

    Parameters
    ----------
    law : str
        ``"known-flow"``, Eq. (17), or ``"learned-flow"``, Eq. (24).

    Returns
    -------
    list of Step
        One, a definite form.

    Examples
    --------
    >>> definite_steps("learned-flow")[0].holds
    True
    """
    equation = "(17)" if law == "known-flow" else "(24)"

    def check() -> bool:
        loop = trace(theorem_loop(2, law), PHI)
        V = loop.signals["V"][0]
        p = loop.parameters["vehicle_controller"]
        states = [*loop.states["x"], *loop.states["K"], *loop.states["Gamma"]]
        true = dict(zip(states, [*loop.states["z"], *p.KD, *p.GammaD], strict=True))
        if law == "learned-flow":
            alpha = loop.states["alpha"]
            states += list(alpha)
            theta = loop.parameters["true_flow"].theta.ravel()
            true |= dict(zip(alpha, -theta, strict=True))
        H = sympy.hessian(V, states)
        slopes = [sympy.diff(V, s).subs(true, simultaneous=True) for s in states]
        return (
            H.is_diagonal()
            and all(H[i, i].is_positive for i in range(len(states)))
            and all(sympy.expand(slope) == 0 for slope in slopes)
            and sympy.expand(V.subs(true, simultaneous=True)) == 0
        )

    return [
        checked(
            f"V of Eq. {equation} is positive definite in e and the parameter errors, and "
            "radially unbounded: a constant positive diagonal Hessian, zero at the truth",
            "definite form",
            check,
        )
    ]


def dissipation_step() -> Step:
    """Check that -e^T KD e is not positive where KD > 0."""

    def check() -> bool:
        loop, rate = lyapunov_derivative(theorem_loop(1, "learned-flow"))
        H = sympy.hessian(rate, list(loop.states["x"]))
        return H.is_diagonal() and all(H[i, i].is_negative for i in range(2))

    claim = "V' <= 0: -e^T KD e is negative definite in e for KD > 0"
    return checked(claim, "definite form", check)


def young_step() -> Step:
    """Check e d <= k e^2/2 + d^2/(2k), for the mean square."""
    k = sympy.Symbol("k", positive=True)
    e, d = sympy.symbols("e d", real=True)
    whole = k * e**2 / 2 + d**2 / (2 * k) - e * d
    return checked(
        "-k e^2 + e d <= -k e^2/2 + d^2/(2k): what is left is (k/2)(e - d/k)^2",
        "definite form",
        lambda: sympy.expand(whole - k * (e - d / k) ** 2 / 2) == 0,
    )


def barbalat_steps() -> list[Step]:
    """Check the boundedness chain of Theorem 3.2.

    Returns
    -------
    list of Step
        Symbolic; with |phi| <= 1 from the basis steps.

    Examples
    --------
    >>> all(step.holds for step in barbalat_steps())
    True
    """
    loop = trace(theorem_loop(2, "learned-flow"), PHI)
    p = loop.parameters["vehicle_controller"]
    e, phi = loop.signals["e"], loop.signals["phi_x"]
    phis = {f: sympy.Dummy() for f in phi}

    def vehicle_stable() -> bool:
        for i in range(2):
            rest = sympy.expand(loop.rates["x"][i] + p.KD[i] * loop.states["x"][i])
            rest = rest.subs(phis)
            moving = {s for port in loop.states.values() for s in port}
            if rest.free_symbols & moving or not p.KD[i].is_positive:
                return False
            flow = sympy.expand(rest - rest.subs(dict.fromkeys(phis.values(), 0)))
            if flow.has(*loop.signals["zc"]):
                return False
        return True

    def prediction() -> bool:
        return all(
            sympy.expand(loop.states["z"][i] - (loop.states["x"][i] - e[i])) == 0 for i in range(2)
        )

    def error_rate() -> bool:
        eta, z, zc, N = eta_of(loop), loop.states["z"], loop.signals["zc"], 2
        for i in range(2):
            joint = sum(phi[k] * eta[i * N + k] for k in range(N))
            joint += z[i] * eta[2 * N + i] + zc[i] * eta[2 * N + 2 + i]
            if sympy.expand(loop.derivative(e[i]) + p.KD[i] * e[i] - joint) != 0:
                return False
        return True

    def second() -> bool:
        _, rate = lyapunov_derivative(theorem_loop(2, "learned-flow"))
        twice = loop.derivative(rate)
        wanted = -2 * sum(p.KD[i] * e[i] * loop.derivative(e[i]) for i in range(2))
        return sympy.expand(twice - wanted) == 0 and not twice.has(sympy.Derivative)

    return [
        checked("Eq. (9): x' + KD x holds only phi and zc, so x is bounded", "symbolic",
                vehicle_stable),
        checked("z = x - e, so z is bounded where x and e are", "symbolic", prediction),
        checked("e' = -KD e + W^T eta, products of bounded signals", "symbolic", error_rate),
        checked("V'' = -2 e^T KD e' holds no derivative of phi or zc, so it is bounded",
                "symbolic", second),
    ]  # fmt: skip
