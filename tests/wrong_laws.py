"""Wrong laws, made of families; a name says what is done.

Each is a law and what else `prove` is given.  A wrong one is wrong for some flow, track or start.
"""

import numpy as np
import textbook_laws as book
from own_laws import (
    GAIN,
    LEARNED,
    N,
    V_of,
    changed,
    driven,
    law,
    leak,
    off,
)


def case(make, **more):
    """A law, and what else `prove` is given."""
    return make, more


def family(form, make, rows):
    """A case of each row: a name, and what its law is made of."""
    return {form.format(name): case(make(own)) for name, own in rows.items()}


def scaled(factor, port=None):
    """Make the paper's law with rates times a factor, of one port or all."""

    def change(t, x, u, p, rates):
        by = factor(t, x, u)
        return {name: by * r if port in (None, name) else r for name, r in rates.items()}

    return changed(change)


def by_matrix(M):
    """Make a law with a matrix over the functions."""
    return changed(
        lambda t, x, u, p, r: r | {"alpha": -np.outer(u.e, np.array(M) @ u.phi_x)},
    )


def mapped(function):
    """Make a law whose alpha is made of a state."""
    more = book.through(lambda x, u, p: function(x.s, u))
    return lambda: law(book.behind, GAIN, **more)


def driven_by_state(rate):
    """Make the paper's law with K driven by a state s, too."""
    return changed(
        lambda t, x, u, p, r: r | {"K": r["K"] + x.s, "s": rate(x, u)}, states={**LEARNED, "s": 1}
    )


def flip(port, index):
    """Make the paper's law with one sign turned."""
    turned = np.ones({"alpha": (2, N), "K": 2}[port])
    turned[index] = -1.0
    return changed(lambda t, x, u, p, r: r | {port: turned * r[port]})


turned = changed(lambda t, x, u, p, r: {port: -own for port, own in r.items()})
WRONG = {
    "sign of alpha[1, 0]": case(flip("alpha", (1, 0))),
    "sign of K[1]": case(flip("K", 1)),
    "axes swapped in all": case(driven(lambda t, x, u, p: u.e[::-1])),
    "axes swapped in K": case(changed(lambda t, x, u, p, r: r | {"K": r["K"][::-1]})),
    "the difference of e": case(driven(lambda t, x, u, p: u.e - u.e[::-1] * 2)),
    **family(
        "{} in place of e",
        lambda f: driven(lambda t, x, u, p: f(u.e)),
        {
            "-tanh(e)": lambda e: -np.tanh(e),
            "sin(e)": np.sin,
            "|e|": np.abs,
            "clip(e, 0.1, 1)": lambda e: np.clip(e, 0.1, 1),
        },
    ),
    **family(
        "a gain times {}",
        scaled,
        {
            "1 - t/50": lambda t, x, u: 1 - t / 50,
            "0.5 + sin t": lambda t, x, u: 0.5 + np.sin(t),
            "sign of z": lambda t, x, u: np.sign(u.z[0]),
            "1 - |e|^2": lambda t, x, u: 1 - u.e @ u.e,
            "-1 where |e| > 5": lambda t, x, u: np.where(u.e @ u.e > 25, -1.0, 1.0),
            "-1 where phi < 0.1": lambda t, x, u: np.where(u.phi_x[0] < 0.1, -1.0, 1.0),
            "-1 after 1e4": lambda t, x, u: np.where(t > 1e4, -1.0, 1.0),
            "-1 in a ring": lambda t, x, u: np.where((u.e[0] > 2) & (u.e[0] < 3), -1.0, 1.0),
            "clip(alpha, -1, 1)": lambda t, x, u: np.clip(x.alpha[0, 0], -1, 1),
        },
    ),
    "K learned backwards where e is large": case(
        scaled(lambda t, x, u: np.where(np.abs(u.e) > 1, -1.0, 1.0), "K")
    ),
    **family(
        "{} of eps",
        book.seen,
        {
            "-tanh": lambda s: -np.tanh(s),
            "|eps|": np.abs,
            "-sign beyond 1": lambda s: np.where(np.abs(s) > 1, -s, s),
            "eps swapped": lambda s: s[::-1],
            "a step": lambda s: np.where(s > 0, 1.0, 0.5),
        },
    ),
    **family(
        "a leak {}",
        leak,
        {
            "-0.1": lambda t, x, u, p: -0.1,
            "of |alpha| - 3, turned": lambda t, x, u, p: 0.1 * (3 - np.sum(x.alpha**2)),
            "alpha, any sign": lambda t, x, u, p: 0.1 * x.alpha[0, 0],
            "-|e|^2": lambda t, x, u, p: -0.1 * u.e @ u.e,
        },
    ),
    "pushed": case(changed(lambda t, x, u, p, r: r | {"K": r["K"] + 0.01})),
    "pushed by z": case(changed(lambda t, x, u, p, r: r | {"Gamma": r["Gamma"] + 0.1 * u.z})),
    "K by the other z": case(changed(lambda t, x, u, p, r: r | {"K": -p.gain * u.z[::-1] * u.e})),
    "alpha by phi^2": case(
        changed(lambda t, x, u, p, r: r | {"alpha": -p.gain * np.outer(u.e, u.phi_x**2)})
    ),
    "alpha by phi(z)": case(
        changed(
            lambda t, x, u, p, r: r | {"alpha": -p.gain * np.outer(u.e, u.phi_z)},
            more={"phi_z": "N"},
        )
    ),
    **family(
        "a matrix {}",
        by_matrix,
        {
            "indefinite": [[1.0, 2.0], [2.0, 1.0]],
            "of a rotation": [[0.0, 1.0], [-1.0, 0.0]],
            "not symmetric": [[1.0, 3.0], [0.0, 1.0]],
        },
    ),
    "alpha = s^2": case(mapped(lambda s, u: s**2)),
    "alpha = s + e phi": case(mapped(lambda s, u: s + np.outer(u.e, u.phi_x))),
    "alpha = tanh s": case(
        mapped(lambda s, u: np.tanh(s)),
        V=book.of_state(lambda s, p: p.theta * s + np.log(np.cosh(s))),
    ),
    "K is driven by a state": case(driven_by_state(lambda x, u: x.s)),
    "K is driven by a filter": case(driven_by_state(lambda x, u: u.e[0] - x.s)),
    "a tiny gain of e, then a large one": case(driven(lambda t, x, u, p: (u.e * 1e-200) * 1e-200)),
    "turned, V turned": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / 2 - off(u, p))),
    "turned, V without an end": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / (1 + u.e @ u.e))),
    "turned, V of e alone": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / 2)),
    "turned, V = 0": case(turned, V=V_of(lambda t, u, p: 0.0 * u.e[0])),
    "turned, V fades": case(turned, V=V_of(lambda t, u, p: np.exp(-t) * (u.e @ u.e + off(u, p)))),
    "nothing learned, V without K": case(
        scaled(lambda t, x, u: 0.0, "K"),
        V=V_of(lambda t, u, p: u.e @ u.e / 2 + np.sum((p.theta + u.alpha) ** 2)),
    ),
    "sign(e), V = |e|": case(
        driven(lambda t, x, u, p: -np.sign(u.e)),
        V=V_of(lambda t, u, p: np.sum(np.abs(u.e)) + off(u, p)),
    ),
    "a box left outward": case(
        changed(
            lambda t, x, u, p, r: (
                r | {"alpha": np.where((x.alpha >= 2) & (r["alpha"] < 0), 0.0, r["alpha"])}
            ),
            n=1,
        ),
        given=lambda s, p, truth: [*np.ravel(2 - truth.theta), *np.ravel(2 + truth.theta)],
    ),
    "a falling gain, V with it": case(
        scaled(lambda t, x, u: 1 + np.exp(-t)),
        V=V_of(lambda t, u, p: u.e @ u.e / 2 + off(u, p) / (1 + np.exp(-t))),
    ),
}
