"""What is read is what Python does: record = function, at random points."""

import functools
import math
from math import atan2, sin

import numpy as np
import pytest

from clpt_control.equations.arrays import Unread
from clpt_control.equations.reading import RAISED, read

GAINS = np.array([[1.0, 2.0], [3.0, 4.0]])
TABLE = np.array([1.0, 1.4, 2.2, 1.1])


def record_of(function, params=None, size=2):
    """Return the record of f(t, x, u, params) for two states and three inputs."""
    params = params or {}
    shapes = {k: np.shape(v) for k, v in params.items() if not isinstance(v, bool)}
    out = {"y": (size,)}
    return read(function, "update", {"x": (2,)}, {"u": (3,)}, params, shapes, out, dict)


def agree(function, params=None, size=2, points=40):
    """Compare a record with its function at random points, small and large."""
    params, random = params or {}, np.random.default_rng(1)
    found = record_of(function, params, size)
    for _ in range(points):
        scale = 3.0 ** random.integers(-3, 3).item()
        x, u = random.normal(size=2) * scale, random.normal(size=3) * scale
        t = np.float64(random.uniform(0.0, 5.0))
        try:
            with np.errstate(all="ignore"):
                asked = np.asarray(function(t, x.copy(), u.copy(), dict(params)), dtype=float)
        except RAISED:
            asked = np.full(size, np.nan)
        groups = {"t": {"t": t}, "x": {"x": x}, "u": {"u": u}, "p": params}
        values = found.record.values(lambda g, n, own=groups: np.asarray(own[g][n], float), {})[0]
        np.testing.assert_allclose(values, asked.reshape(-1), rtol=1e-11, atol=1e-12)
    return found


def helper(a, k=2.0):
    y = np.zeros(2)
    y[0] = a[1]
    y[1] = math.sqrt(abs(a[0])) * k
    return y


class Plant:
    k = 2.0

    def pull(self, a):
        y = np.zeros(2)
        y[0] = math.sin(a[1])
        return y * self.k

    def update(self, t, x, u, p):
        return self.pull(x) + u[0]


def choices(t, x, u, p):
    if (x[0] > 0 and not u[0] > 1) or t > 3:
        return [x[1], -x[0] if u[1] < 0 else 2.0]
    elif 0.2 < x[1] <= 0.8:
        return (0.0, u[2])
    return np.array([x[0] ** 2, abs(u[1]) ** 0.5])


def builtins(t, x, u, p):
    low, *_, high = sorted([x[0], x[1], u[0], 0.3])
    whole, rest = divmod(x[0], 2.0)
    several = any([x[0] > 0, u[0] > 0]) and all(v < 2 for v in x)
    return [max(x) + min(u[0], 1.0, low) + rest, high + round(x[1]) + sum(u) + whole + several]


def mathematics(t, x, u, p):
    y = math.hypot(*x) + math.log1p(x[0] ** 2) + math.copysign(2.0, x[1]) + math.floor(u[0])
    return y, sin(x[0]) + atan2(x[0], x[1]) + math.fmod(x[0], 0.7) + math.degrees(t) + math.erf(
        u[1]
    )


def arrays(t, x, u, p):
    y = np.empty(2)
    y[:] = GAINS @ x
    y[-1] += np.interp(u[0], [0.0, 1.0, 2.0], [1.0, 4.0, 2.0])
    y *= 2
    both = np.vstack([y, np.hstack([u[0], math.cos(t)])])
    return both.sum(axis=0) + np.linalg.norm(u) * np.ones_like(x) + np.clip(x, -0.5, u[0] ** 2)


def linear_algebra(t, x, u, p):
    A = np.array([[2.0 + x[0] ** 2, u[0]], [x[1], 3.0 + u[1] ** 2]])
    return np.linalg.solve(A, x) + np.linalg.inv(A) @ u[:2] + np.linalg.det(A) + np.trace(A.T)


def places(t, x, u, p):
    gears = [1.0, 2.0, 3.0]
    return [gears[int(abs(x[0]))], TABLE[min(np.searchsorted([0.0, 0.5, 1.0], u[0]), 3)]]


def imports(t, x, u, p):
    import math as m

    import numpy as n
    from numpy.linalg import norm

    return n.array([m.tanh(x[0]), norm(x) + n.real(1.0 + 2.0j)])


def masked(t, x, u, p):
    y = -x + u[0]
    y[x > 0.5] *= 2
    y[np.abs(y) < 0.1] = 0.0
    return np.where(np.isnan(y), 0.0, y)


def counted(t, x, u, p):
    total = 0.0
    for k in range(p["n"]):
        total += p["m"] * x[k % 2] * k
    return p["K"] @ x + total if p.get("on", True) else x


def comprehended(t, x, u, p):
    a, (b, c) = x[0], (x[1], u[0])
    found = {f"k{k}": v * w for k, (v, w) in enumerate(zip(x, u[1:], strict=True))}
    return [*found.values()][::-1] + np.array([a, b * c]) * isinstance(x[0], float)


def caught(t, x, u, p):
    try:
        return [math.sqrt(x[0]), x[1]]
    except ValueError:
        return [-math.sqrt(-x[0]), 0.0]


def raising(t, x, u, p):
    if x[0] < 0:
        raise ValueError("an empty tank")
    return [x[0], math.nan if x[1] != x[1] else 1.0]


READ = [
    *(choices, builtins, mathematics, arrays, linear_algebra, places, imports, masked),
    *(comprehended, caught, raising, Plant().update),
    lambda t, x, u, p: helper(x) + helper(u, k=t),
    functools.partial(lambda gain, t, x, u, p: gain * x * np.sign(u[0]), 3.0),
]


@pytest.mark.parametrize("function", READ, ids=lambda f: getattr(f, "__name__", "partial"))
def test_a_record_is_its_function(function):
    agree(function)


def test_parameters_stay_open_until_python_counts_with_them():
    found = agree(counted, {"n": 3, "m": 2, "K": GAINS, "on": True})
    assert found.pinned == {"n"}
    assert set(found.record.leaves("p")) == {"m", "K"}


def test_a_way_that_raises_is_nan_and_its_sentence_is_kept():
    (sentence,) = record_of(raising).raised
    assert sentence.startswith("raising, line")
    assert sentence.endswith("an empty tank")


class Relay:
    on = False

    def update(self, t, x, u, p):
        if x[0] < 0.4:
            self.on = True
        elif x[0] > 0.6:
            self.on = False
        return [1.0 * self.on, x[1]]


COUNT = 0


def counting(t, x, u, p):
    global COUNT
    COUNT += 1
    return x * COUNT


UNREAD = {
    "update keeps": Relay().update,
    "changes the global 'COUNT'": counting,
    "more than 64 questions": lambda t, x, u, p: [_newton(x[0]), 0.0],
    "256 ways": lambda t, x, u, p: [sum(1.0 if x[0] > k else 2.0 for k in range(9)), 0.0],
}


def _newton(v):
    while v > 1e-3:
        v = 0.5 * v
    return v


@pytest.mark.parametrize("cause", UNREAD)
def test_what_cannot_be_read_is_said(cause):
    with pytest.raises(Unread, match=cause):
        record_of(UNREAD[cause])


def test_a_reading_leaves_all_as_it_was():
    relay, log = Relay(), []

    def logging(t, x, u, p):
        log.append(t)
        relay.last = x[0]
        return [relay.last, x[1]]

    agree(logging, points=1)
    del log[-1:]
    assert log == []
    assert relay.__dict__.keys() == {"last"}
    assert COUNT == 0


def test_a_global_changed_afterwards_counts_at_the_next_reading():
    space = {"gain": 2.0}
    exec("def rate(t, x, u, p):\n    return gain * x\n", space)
    assert "2.0" in str(record_of(space["rate"]).record)
    space["gain"] = 5.0
    assert "5.0" in str(record_of(space["rate"]).record)
