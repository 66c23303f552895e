"""Random diagrams: blocks that nobody wrote with care, wired at random.

`random_diagram(random)` draws some blocks of `random_programs` (static and with states, jumps,
ports with shapes, sizes with names), plain systems of python-control with the same functions, and
wires them with permutations, gains, sums, gaps, inputs from outside, linear systems and nested
diagrams.  A `random.Random` makes all choices, so hypothesis can shrink them.
"""

import math
from itertools import count
from typing import Any

import control
import numpy as np
from random_programs import executed, plain, program

from clpt_control import Block

SHAPES = ((1,), (2,), (3,), (5,), (2, 3), (8,))
LONG = ((18,), (40,), (6, 5))
NUMBERS = {"v": (3,), "w": (2, 3), "h": (5,)}
_names = count()


def jumps(p: Any, t0: float, t1: float) -> np.ndarray:
    """Jump at each whole number, or three times in two."""
    period = 1.0 if p.a > 0 else 2.0 / 3.0
    times = period * np.arange(1.0, math.floor(t1 / period * (1 + 1e-12)) + 1)
    return times[(times > t0) & (times <= t1)]


def shapes(random, group, count, kinds):
    """Draw ports of these shapes."""
    return {f"{group}{k}": kinds[random.randrange(len(kinds))] for k in range(count)}


def random_block(random, name, dt=0):
    """Draw a block; one of discrete time does not jump."""
    dynamic, jumping = random.random() < 0.5, random.random() < 0.25 and not dt
    plain = dynamic and random.random() < 0.4  # outputs are the states
    later = dynamic and random.random() < 0.6  # inputs do not reach outputs
    kinds = SHAPES if random.random() < 0.9 else LONG
    x = shapes(random, "x", random.randrange(1, 3), kinds) if dynamic else {}
    u = (
        shapes(random, "u", random.randrange(1, 3), kinds)
        if random.random() < 0.9
        else {}
    )
    y = {} if plain else shapes(random, "y", random.randrange(1, 3), kinds)
    interval = dynamic and jumping
    roles = {
        "update": (x, {"x": x, "u": u}),
        "output": (y, {"x": x, "u": {} if later else u}),
    }
    if interval:
        roles["jump"] = roles["update"]
    drawn = ((role, *both) for role, both in roles.items() if both[0])
    texts = [program(random, role, u, y, NUMBERS, interval) for role, y, u in drawn]
    space = executed("\n".join(texts))
    numbers = np.random.default_rng(random.randrange(2**32))
    a, b = numbers.normal(size=2)
    parameters = {
        "a": a,
        "b": b,
        **{k: numbers.normal(size=s) for k, s in NUMBERS.items()},
    }
    ports = {"inputs": u, "outputs": y or None, "states": x or None, "dt": dt}
    functions = {role: space.get(role) for role in ("update", "output", "jump")}
    if interval:
        parameters, ports["breakpoints"] = parameters | {"interval": -1.0}, jumps
    block = Block(name, parameters=parameters, **functions, **ports)
    block.late = plain or later
    return block


def random_system(random, name, dt=0):
    """Draw a nonlinear system of python-control, with its own params."""
    ports = {group: shapes(random, group, 1, SHAPES[:4]) for group in "xuy"}
    x, u, y = ports.values()
    if random.random() < 0.4:
        x = {}
    texts = [program(random, "output", {"x": x, "u": u}, y, NUMBERS)]
    if x:
        texts.append(program(random, "update", {"x": x, "u": u}, x, NUMBERS))
    space = executed(plain("\n".join(texts)))
    numbers = np.random.default_rng(random.randrange(2**32))
    params = {
        "a": 0.7,
        "b": -1.3,
        **{k: numbers.normal(size=s) for k, s in NUMBERS.items()},
    }
    sizes = {"states": x, "inputs": u, "outputs": y}
    sizes = {kind: n for kind, own in sizes.items() for (n,) in own.values()}
    functions = space.get("update"), space["output"]
    return control.nlsys(*functions, params=params, name=name, dt=dt, **sizes)


def random_diagram(random, blocks=None, nested=True, dt=0):
    """Draw a diagram, of discrete time unless `dt` is 0."""
    parts: list[Any] = []
    for k in range(blocks or random.randrange(1, 5)):
        draw = random.random()
        if 0.12 <= draw < 0.25 and nested:
            parts.append(random_diagram(random, random.randrange(1, 3), False, dt))
            parts[-1].name = f"inner{k}"
        else:
            kind = "linear" if draw < 0.12 else "system" if draw < 0.4 else "block"
            make = {
                "linear": linear_part,
                "system": random_system,
                "block": random_block,
            }[kind]
            parts.append(make(random, f"{kind}{k}", dt))
    if all(isinstance(part, control.StateSpace) for part in parts):
        # python-control refuses some of linear ones
        parts.append(random_block(random, "more", dt))
    return wired(random, parts)


def linear_part(random, name, dt=0):
    """Draw a linear system of python-control."""
    numbers = np.random.default_rng(random.randrange(2**32))
    n, m, r = (random.randrange(low, 4) for low in (0, 1, 1))
    D = (
        numbers.normal(size=(r, m))
        if n == 0 or random.random() < 0.3
        else np.zeros((r, m))
    )
    if n == 0:
        return control.ss([], [], [], D, dt, name=name)
    A, B, C = (numbers.normal(size=size) for size in ((n, n), (n, m), (r, n)))
    return control.ss(A, B, C, D, dt, name=name)


def is_late(part):
    """Return whether inputs reach a part's outputs through its states only, as it was drawn."""
    if isinstance(part, control.StateSpace):
        return not np.any(part.D)
    return getattr(part, "late", False)


def wired(random, parts):
    """Wire parts: most inputs from signals before them or from states, some from outside."""
    owners = [k for k, part in enumerate(parts) for _ in range(part.noutputs)]
    late = {k for k, part in enumerate(parts) if is_late(part)}
    taken = sum(part.ninputs for part in parts)
    outside, to = random.randrange(0, 4), -1
    wires, feeds = np.zeros((taken, len(owners))), np.zeros((taken, outside))
    for k, part in enumerate(parts):
        allowed = [s for s, own in enumerate(owners) if own < k or own in late]
        in_order = random.random() < 0.4 and allowed
        for j in range(part.ninputs):
            to += 1
            draw = random.random()
            if draw < 0.07:
                continue  # a gap
            if (draw < 0.2 and outside) or not allowed:
                if outside:
                    feeds[to, random.randrange(outside)] = 1.0
                continue
            for _ in range(1 if random.random() < 0.8 else 2):
                pick = j % len(allowed) if in_order else random.randrange(len(allowed))
                sign = 1.0 if in_order or random.random() < 0.6 else -1.0
                gain = (
                    1.0 if in_order or random.random() < 0.7 else random.uniform(-2, 2)
                )
                wires[to, allowed[pick]] += sign * gain
    if parts[0].ninputs:
        feeds[0, ~feeds.any(axis=0)] = 1.0  # what feeds nothing else
    feeds = feeds[:, feeds.any(axis=0)]
    shown = [s for s in range(len(owners)) if random.random() < 0.7] or [0][
        : len(owners)
    ]
    counts = {"inputs": ("in", feeds.shape[1]), "outputs": ("out", len(shown))}
    ports = {kind: [f"{own}{k}" for k in range(n)] for kind, (own, n) in counts.items()}
    diagram = control.InterconnectedSystem(
        parts, name=f"diagram{next(_names)}", **ports
    )
    diagram.set_connect_map(wires)
    diagram.set_input_map(feeds)
    diagram.set_output_map(np.eye(len(owners), len(owners) + taken)[shown])
    return diagram
