"""A hundred wrong laws, made of families; a name says what is done.

Each is a law and what else `prove` is given.  A wrong one is wrong for some flow, track or start.
"""

import numpy as np
import textbook_laws as book
from own_laws import GAIN, LEARNED, MORE, N, V_of, changed, driven, filled, law, leak, off, two

SIGNS = {"alpha": (2, N), "K": (2,), "Gamma": (2,)}


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


def with_rates(others):
    """Make the paper's law with some rates in place of its own."""
    return changed(lambda t, x, u, p, r: r | others(t, u, p, r), more={"phi_z": "N"})


def by_matrix(M):
    """Make a law with a matrix over the functions."""
    return with_rates(lambda t, u, p, r: {"alpha": -np.outer(u.e, np.array(M) @ u.phi_x)})


def mapped(function):
    """Make a law whose alpha is made of a state."""
    more = book.through(lambda x, u, p: function(x.s, u))
    return lambda: law(book.behind, GAIN, **more)


def flip(port, index):
    """Make the paper's law with one sign turned."""
    turned = np.ones(SIGNS[port])
    turned[index] = -1.0
    return changed(lambda t, x, u, p, r: r | {port: turned * r[port]})


turned = changed(lambda t, x, u, p, r: {port: -own for port, own in r.items()})
WRONG = {
    **{
        f"sign of {port} at {index}": (flip(port, index), {})
        for port, shape in SIGNS.items()
        for index in np.ndindex(shape)
    },
    "axes swapped in all": case(driven(lambda t, x, u, p: u.e[::-1])),
    **family(
        "axes swapped in {}",
        lambda port: changed(lambda t, x, u, p, r: r | {port: r[port][::-1]}),
        {port: port for port in LEARNED},
    ),
    "the mean of e": case(driven(lambda t, x, u, p: 0 * u.e + np.sum(u.e) / 2)),
    "the difference of e": case(driven(lambda t, x, u, p: u.e - u.e[::-1] * 2)),
    **family(
        "{} in place of e",
        lambda f: driven(lambda t, x, u, p: f(u.e)),
        {
            "-tanh(e)": lambda e: -np.tanh(e),
            "sin(e)": np.sin,
            "e - e^3": lambda e: e - e**3,
            "|e|": np.abs,
            "e^2": lambda e: e**2,
            "max(e, 0)": lambda e: np.maximum(e, 0),
            "clip(e, 0.1, 1)": lambda e: np.clip(e, 0.1, 1),
            "e + 0.1": lambda e: e + 0.1,
            "e exp(-e^2)": lambda e: -e * np.exp(-(e**2)),
        },
    ),
    **family(
        "a gain times {}",
        scaled,
        {
            "cos t": lambda t, x, u: np.cos(t),
            "1 - t/50": lambda t, x, u: 1 - t / 50,
            "exp(-t)": lambda t, x, u: np.exp(-t),
            "1/(1 + t)": lambda t, x, u: 1 / (1 + t),
            "0.5 + sin t": lambda t, x, u: 0.5 + np.sin(t),
            "sign of z": lambda t, x, u: np.sign(u.z[0]),
            "sign of alpha": lambda t, x, u: np.sign(x.alpha[0, 0]),
            "1 - |e|^2": lambda t, x, u: 1 - u.e @ u.e,
            "-1 where |e| > 5": lambda t, x, u: np.where(u.e @ u.e > 25, -1.0, 1.0),
            "-1 where |alpha| > 10": lambda t, x, u: np.where(
                np.abs(x.alpha[0, 0]) > 10, -1.0, 1.0
            ),
            "-1 where zc > 4": lambda t, x, u: np.where(u.zc[0] > 4, -1.0, 1.0),
            "-1 where phi < 0.1": lambda t, x, u: np.where(u.phi_x[0] < 0.1, -1.0, 1.0),
            "-1 after 100": lambda t, x, u: np.where(t > 100, -1.0, 1.0),
            "-1 after 1e4": lambda t, x, u: np.where(t > 1e4, -1.0, 1.0),
            "-1 in a ring": lambda t, x, u: np.where((u.e[0] > 2) & (u.e[0] < 3), -1.0, 1.0),
            "0 where e > 0": lambda t, x, u: np.where(u.e[0] > 0, 0.0, 1.0),
            "alpha": lambda t, x, u: x.alpha[0, 0],
            "tanh(K)": lambda t, x, u: np.tanh(x.K[0]),
            "clip(alpha, -1, 1)": lambda t, x, u: np.clip(x.alpha[0, 0], -1, 1),
        },
    ),
    **family(
        "{} learned backwards where e is large",
        lambda port: scaled(lambda t, x, u: np.where(np.abs(u.e) > 1, -1.0, 1.0), port),
        {"K": "K", "Gamma": "Gamma"},
    ),
    **family(
        "{} of eps",
        book.seen,
        {
            "-tanh": lambda s: -np.tanh(s),
            "sin": np.sin,
            "cos": np.cos,
            "|eps|": np.abs,
            "eps - eps^3": lambda s: s - s**3,
            "clip(0.1, 1)": lambda s: np.clip(s, 0.1, 1),
            "-sign beyond 1": lambda s: np.where(np.abs(s) > 1, -s, s),
            "eps swapped": lambda s: s[::-1],
            "max(eps, -eps)": lambda s: np.maximum(s, -s),
            "a step": lambda s: np.where(s > 0, 1.0, 0.5),
        },
    ),
    **family(
        "a leak {}",
        leak,
        {
            "-0.1": lambda t, x, u, p: -0.1,
            "0.05 + 0.1 sin t turned": lambda t, x, u, p: -0.05 - 0.1 * np.sin(t),
            "of |alpha| - 3, turned": lambda t, x, u, p: 0.1 * (3 - np.sum(x.alpha**2)),
            "alpha, any sign": lambda t, x, u, p: 0.1 * x.alpha[0, 0],
            "-|e|": lambda t, x, u, p: -0.1 * np.hypot(u.e[0], u.e[1]),
            "-|e|^2": lambda t, x, u, p: -0.1 * u.e @ u.e,
            "where e > 0, turned": lambda t, x, u, p: np.where(u.e[0] > 0, -0.1, 0.1),
        },
    ),
    **family(
        "{}",
        with_rates,
        {
            "pushed": lambda t, u, p, r: {"K": r["K"] + 0.01},
            "pushed by time": lambda t, u, p, r: {"K": r["K"] + np.sin(t)},
            "pushed by z": lambda t, u, p, r: {"Gamma": r["Gamma"] + 0.1 * u.z},
            "K by the other z": lambda t, u, p, r: {"K": -p.gain * u.z[::-1] * u.e},
            "Gamma by z": lambda t, u, p, r: {"Gamma": p.gain * u.z * u.e},
            "alpha by phi^2": lambda t, u, p, r: {"alpha": -p.gain * np.outer(u.e, u.phi_x**2)},
            "alpha by phi turned round": lambda t, u, p, r: {
                "alpha": -p.gain * np.outer(u.e, u.phi_x[::-1])
            },
            "alpha by phi(z)": lambda t, u, p, r: {"alpha": -p.gain * np.outer(u.e, u.phi_z)},
        },
    ),
    **family(
        "a matrix {}",
        by_matrix,
        {
            "indefinite": [[1.0, 2.0], [2.0, 1.0]],
            "turned": [[-1.0, 0.0], [0.0, 1.0]],
            "of a rotation": [[0.0, 1.0], [-1.0, 0.0]],
            "singular": [[1.0, 1.0], [1.0, 1.0]],
            "not symmetric": [[1.0, 3.0], [0.0, 1.0]],
        },
    ),
    **family(
        "alpha = {}",
        mapped,
        {
            "-2 s": lambda s, u: -2 * s,
            "s^2": lambda s, u: s**2,
            "sin s": lambda s, u: np.sin(s),
            "-s - s^3": lambda s, u: -s - s**3,
            "s + e phi": lambda s, u: s + np.outer(u.e, u.phi_x),
        },
    ),
    "alpha = tanh s": case(
        mapped(lambda s, u: np.tanh(s)),
        V=book.of_state(lambda s, p: p.theta * s + np.log(np.cosh(s))),
    ),
    **{
        f"K is driven by a {name}": case(
            changed(lambda t, x, u, p, r, f=f: r | {"K": r["K"] + x.s, "s": f(x, u)}, states=MORE)
        )
        for name, f in {"state": lambda x, u: x.s, "filter": lambda x, u: u.e[0] - x.s}.items()
    },
    "a tiny gain of e, then a large one": case(driven(lambda t, x, u, p: (u.e * 1e-200) * 1e-200)),
    "e to the 41st, turned": case(driven(lambda t, x, u, p: -(u.e**41))),
    "wrong from N = 8 on": case(
        lambda: law(
            lambda t, x, u, p: {
                port: own * (np.where(np.arange(len(u.phi_x)) == 7, -1.0, 1.0) if k == 0 else 1.0)
                for k, (port, own) in enumerate(filled(u, p.gain, u.e).items())
            },
            GAIN,
            n=8,
        )
    ),
    "turned, V turned": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / 2 - off(u, p))),
    "turned, V without an end": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / (1 + u.e @ u.e))),
    "turned, V of e alone": case(turned, V=V_of(lambda t, u, p: u.e @ u.e / 2)),
    "turned, V = 0": case(turned, V=V_of(lambda t, u, p: 0.0 * u.e[0])),
    "turned, V = -V": case(turned, V=V_of(lambda t, u, p: -u.e @ u.e / 2 - off(u, p))),
    "turned, V fades": case(turned, V=V_of(lambda t, u, p: np.exp(-t) * (u.e @ u.e + off(u, p)))),
    "e alone, V of e to 1": case(
        scaled(lambda t, x, u: 0.0), V=V_of(lambda t, u, p: np.minimum(u.e @ u.e, 1.0))
    ),
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
            )
        )
    ),
    "a box too small": case(lambda: law(book.in_a_box, two(2.0))),
    "a falling gain, V with it": case(
        scaled(lambda t, x, u: 1 + np.exp(-t)),
        V=V_of(lambda t, u, p: u.e @ u.e / 2 + off(u, p) / (1 + np.exp(-t))),
    ),
}
