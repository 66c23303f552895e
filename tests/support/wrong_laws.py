"""A hundred wrong laws, made of families; most names say what is done.

Each is a law and what else `prove` is given.  A wrong one is wrong for some flow, track or start.
"""

import numpy as np
import user_laws
from user_laws import (
    MORE,
    N,
    V_of,
    changed,
    driven,
    filled,
    law,
    leak,
    scaled,
    seen,
    turned,
    two,
)

SIGNS = {"alpha": (2, N), "K": (2,), "Gamma": (2,)}


def case(make, **more):
    """A law, and what else `prove` is given."""
    return make, more


def family(named, make, *texts):
    """A case of each text, of which its law is made."""
    return {named.format(text): case(make(text)) for text in texts}


def flip(port, index):
    """Make the paper's law with one sign turned."""
    signs = np.ones(SIGNS[port])
    signs[index] = -1.0
    return changed(f"{port}' = array({signs.tolist()})*d{port}")


def by_matrix(M):
    """Make a law with a matrix over the functions."""
    return changed(f"alpha' = -outer(e, array({M}) @ phi_x)")


def backwards_where(condition):
    """Make the paper's law learning backwards somewhere."""
    return scaled(f"where({condition}, -1.0, 1.0)")


def backwards_far(port):
    """Make the paper's law learning backwards in a port where e is large."""
    return scaled("where(abs(e) > 1, -1.0, 1.0)", (port,))


def in_a_box(t, x, u, p):
    """Each alpha stays within -c and c, section III."""
    rates = filled(u, p.gain, u.e)
    a, rate = x.alpha, rates["alpha"]
    leaves = ((a >= p.c) & (rate > 0)) | ((a <= -p.c) & (rate < 0))
    return rates | {"alpha": np.where(leaves, 0.0, rate)}


WRONG = {
    **{
        f"sign of {port} at {index}": (flip(port, index), {})
        for port, shape in SIGNS.items()
        for index in np.ndindex(shape)
    },
    **family("{} in place of e", driven, "e[::-1]", "0*e + sum(e)/2", "e - e[::-1]*2"),
    **family(
        "axes swapped in {}", lambda port: changed(f"{port}' = d{port}[::-1]"), *SIGNS
    ),
    **family(
        "{} in place of e", driven, "-tanh(e)", "sin(e)", "e - e**3", "abs(e)", "e**2"
    ),
    **family("{} in place of e", driven, "maximum(e, 0)", "clip(e, 0.1, 1)", "e + 0.1"),
    **family(
        "{} in place of e", driven, "-e*exp(-(e**2))", "-(e**41)", "(e*1e-200)*1e-200"
    ),
    **family("a gain times {}", scaled, "cos(t)", "1 - t/50", "exp(-t)", "1/(1 + t)"),
    **family(
        "a gain times {}", scaled, "0.5 + sin(t)", "sign(z[0])", "sign(alpha[0, 0])"
    ),
    **family(
        "a gain times {}",
        scaled,
        "1 - e @ e",
        "where(e[0] > 0, 0.0, 1.0)",
        "alpha[0, 0]",
    ),
    **family("a gain times {}", scaled, "tanh(K[0])", "clip(alpha[0, 0], -1, 1)"),
    **family(
        "backwards where {}", backwards_where, "e @ e > 25", "abs(alpha[0, 0]) > 10"
    ),
    **family(
        "backwards where {}", backwards_where, "zc[0] > 4", "phi_x[0] < 0.1", "t > 100"
    ),
    **family(
        "backwards where {}", backwards_where, "t > 1e4", "(e[0] > 2) & (e[0] < 3)"
    ),
    **family("{} learned backwards where e is large", backwards_far, "K", "Gamma"),
    **family(
        "{}", seen, "-tanh(eps)", "sin(eps)", "cos(eps)", "abs(eps)", "eps - eps**3"
    ),
    **family(
        "{}", seen, "clip(eps, 0.1, 1)", "where(abs(eps) > 1, -eps, eps)", "eps[::-1]"
    ),
    **family("{}", seen, "maximum(eps, -eps)", "where(eps > 0, 1.0, 0.5)"),
    **family(
        "a leak {}", leak, "-0.1", "-0.05 - 0.1*sin(t)", "0.1*(3 - sum(alpha**2))"
    ),
    **family(
        "a leak {}", leak, "0.1*alpha[0, 0]", "-0.1*hypot(e[0], e[1])", "-0.1*e @ e"
    ),
    **family("a leak {}", leak, "where(e[0] > 0, -0.1, 0.1)"),
    **family(
        "{}", changed, "K' = dK + 0.01", "K' = dK + sin(t)", "Gamma' = dGamma + 0.1*z"
    ),
    **family("{}", changed, "K' = -gain*z[::-1]*e", "Gamma' = gain*z*e"),
    **family("{}", changed, "alpha' = -gain*outer(e, phi_x**2)"),
    **family("{}", changed, "alpha' = -gain*outer(e, phi_x[::-1])"),
    "alpha by phi(z)": case(
        changed("alpha' = -gain*outer(e, phi_z)", more={"phi_z": "N"})
    ),
    **family(
        "a matrix {}",
        by_matrix,
        "[[1.0, 2.0], [2.0, 1.0]]",
        "[[-1.0, 0.0], [0.0, 1.0]]",
    ),
    **family(
        "a matrix {}",
        by_matrix,
        "[[0.0, 1.0], [-1.0, 0.0]]",
        "[[1.0, 1.0], [1.0, 1.0]]",
    ),
    **family("a matrix {}", by_matrix, "[[1.0, 3.0], [0.0, 1.0]]"),
    **family(
        "alpha = {}",
        user_laws.through,
        "-2*s",
        "s**2",
        "sin(s)",
        "-s - s**3",
        "s + outer(e, phi_x)",
    ),
    "alpha = tanh s": case(
        user_laws.through("tanh(s)"), V=user_laws.of_state("theta*s + log(cosh(s))")
    ),
    "K is driven by a state": case(changed("K' = dK + s; s' = s", states=MORE)),
    "K is driven by a filter": case(changed("K' = dK + s; s' = e[0] - s", states=MORE)),
    "wrong from N = 8 on": case(
        changed("alpha' = dalpha*where(arange(len(phi_x)) == 7, -1.0, 1.0)", n=8)
    ),
    "turned, V turned": case(turned, V=V_of("e @ e/2 - off")),
    "turned, V without an end": case(turned, V=V_of("e @ e/(1 + e @ e)")),
    "turned, V of e alone": case(turned, V=V_of("e @ e/2")),
    "turned, V = 0": case(turned, V=V_of("0.0*e[0]")),
    "turned, V = -V": case(turned, V=V_of("-e @ e/2 - off")),
    "turned, V fades": case(turned, V=V_of("exp(-t)*(e @ e + off)")),
    "e alone, V of e to 1": case(scaled("0.0"), V=V_of("minimum(e @ e, 1.0)")),
    "nothing learned, V without K": case(
        scaled("0.0", ("K",)), V=V_of("e @ e/2 + sum((theta + alpha)**2)")
    ),
    "sign(e), V = |e|": case(driven("-sign(e)"), V=V_of("sum(abs(e)) + off")),
    "a box left outward": case(
        changed("alpha' = where((alpha >= 2) & (dalpha < 0), 0.0, dalpha)")
    ),
    "a box too small": case(lambda: law(in_a_box, two(2.0))),
    "a falling gain, V with it": case(
        scaled("1 + exp(-t)"), V=V_of("e @ e/2 + off/(1 + exp(-t))")
    ),
}
