"""Random functions in ordinary Python: what an engineer may write in a block.

`program(random, name, takes, returns, numbers)` draws the source text of one function
``(t, x, u, p)``: branches, early returns, helpers, closures, lambdas, comprehensions, loops
over ranges, arrays and pairs, arrays made empty and filled, views that share what is written,
matrices, NumPy, `math`, `max`, `sorted`, chained comparisons.  A `random.Random` makes all
choices, so hypothesis can shrink them.
"""

import linecache
import math
import re
from itertools import count
from typing import Any

import numpy as np

HELPERS = '''
from math import sqrt

GAIN = 0.75

def bend(a, b=0.5):
    """A pair of numbers."""
    c = a * b
    return c / (1.5 + c * c), a - b

def limited(a, low=-1.0, high=1.0):
    """A limit in words of Python."""
    if a < low:
        return low
    return high if a > high else a

def mix(v, k):
    """A weighted sum."""
    return sum(a * np.cos(k * i) for i, a in enumerate(v))

def turned(v, *, by=GAIN):
    """A vector, changed in a copy of its own."""
    w = np.array(v, dtype=float)
    w[0] += by
    w[1:] *= 0.5
    return w

class Motor:
    """An object with numbers, asked by a method."""

    def __init__(self, k):
        self.k = k

    def torque(self, i):
        return self.k * np.tanh(i) if isinstance(i, float) else 0.0

motor = Motor(1.25)
'''
MOST_QUESTIONS = 5  # each doubles the ways through a function
_files = count()


class Writer:
    """Writes the text of one function."""

    def __init__(self, random, takes, numbers, jumping=False):
        self.random, self.jumping = random, jumping
        self.lines: list[str] = []
        self.fresh, self.questions = count(), 0
        self.scalars = ["t", "p.a", 'p["b"]']
        self.vectors: dict[int, list[str]] = {}
        self.matrices: dict[tuple, list[str]] = {}
        for group, ports in takes.items():
            self.known(ports, f"{group}.")
            size = sum(math.prod(shape) for shape in ports.values())
            self.scalars += [f"{group}[{k}]" for k in sorted({0, size // 2, size - 1}) if size]
        self.known(numbers, "p.")

    def known(self, ports, prefix):
        """Take named arrays as something to calculate with."""
        for port, shape in ports.items():
            name = f"{prefix}{port}"
            if len(shape) == 2:
                self.matrices.setdefault(shape, []).append(name)
                self.scalars.append(f"{name}[{shape[0] - 1}, 0]")
            elif len(shape) == 1 and shape[0]:
                self.vectors.setdefault(shape[0], []).append(name)
                self.scalars += [f"{name}[0]", f"{name}[-1]"]

    # --- choices ----------------------------------------------------------------------------

    def choice(self, options):
        return options[self.random.randrange(len(options))]

    def chance(self, share):
        return self.random.random() < share

    def name(self):
        return f"a{next(self.fresh)}"

    def add(self, *lines):
        self.lines += ["    " + line for line in lines]

    def asks(self, times=1):
        """Whether there may be so many more questions of signals."""
        if self.questions + times > MOST_QUESTIONS:
            return False
        self.questions += times
        return True

    # --- expressions --------------------------------------------------------------------------

    def leaf(self):
        if self.jumping and self.chance(0.1):
            return "p.interval"
        if self.chance(0.15):
            return f"{self.random.uniform(-2, 2):.3f}"
        return self.choice(self.scalars)

    def scalar(self, depth=2):
        if depth <= 0 or self.chance(0.15):
            return self.leaf()
        a, b = self.scalar(depth - 1), self.scalar(depth - 1)
        one_of, number = self.choice, self.random.uniform
        smooth = ["cos", "tanh", "arctan", "sign", "floor", "square"]
        forms = [
            *[lambda: f"({a} {one_of('+-*')} {b})"] * 6,
            *[lambda: f"np.sin({a}) * {b}"] * 2,
            lambda: f"({a} / (1.5 + abs({b})))",
            lambda: f"np.{one_of(smooth)}({a})",
            lambda: f"math.{one_of(['cos', 'tanh', 'atan', 'sin', 'erf', 'fabs'])}({a})",
            lambda: f"np.exp(-np.abs({a}))",
            lambda: f"sqrt(abs({a})) ** {one_of(['2', '3', '0.7', '1'])}",
            lambda: f"np.where({self.condition(0)}, {a}, {b})",
            lambda: f"np.{one_of(['minimum', 'maximum', 'hypot', 'arctan2'])}({a}, {b})",
            lambda: f"np.clip({a}, -1.0, {number(0, 2):.2f})",
            lambda: f"{one_of(['max', 'min'])}({a}, {b})" if self.asks() else self.of_vector(),
            lambda: f"({a} if {self.condition(1)} else {b})" if self.asks() else self.of_vector(),
            lambda: f"(({a}) % {number(0.5, 3):.2f})",
            lambda: f"motor.torque({a})",
            lambda: f"limited({a})" if self.asks(2) else self.of_vector(),
            self.of_vector,
        ]
        return one_of(forms)()

    def of_vector(self):
        """A number that is made of a vector or matrix."""
        n = self.choice(sorted(self.vectors) or [3])
        v, w = self.vector(n, 1), self.vector(n, 0)
        if self.matrices and self.chance(0.3):
            (rows, columns), names = self.choice(sorted(self.matrices.items()))
            M, v, w = self.choice(names), self.vector(rows, 0), self.vector(columns, 0)
            return self.choice([f"({v} @ {M} @ {w})", f"np.sum({M}[0])", f"({M}).sum()"])
        kinds = [
            f"(({v}) @ {w})",
            f"np.sum({v})",
            f"({v}).max()",
            f"np.mean({v})",
            f"mix({w}, 0.7)",
        ]
        kinds += [f"np.linalg.norm({v})", f"np.dot({v}, {w})", f"sum({v})", f"({v})[{n - 1}]"]
        kinds += [f"sum(b * {self.leaf()} for b in {w})", f"np.trace(np.outer({v}, {w}))"]
        return self.choice(kinds)

    def condition(self, depth=1):
        a, b = self.scalar(depth), self.leaf()
        kind = self.random.randrange(8)
        if depth and kind == 0:
            return f"-0.5 < {a} <= 1.5"
        if depth and kind < 3:
            return f"{a} > 0 {self.choice(['and', 'or'])} {self.leaf()} < {b}"
        if depth and kind == 3:
            return f"not {a} > {b}"
        if kind == 4:
            return f"({a} > 0) {self.choice('&|')} ({b} < 0.3)"
        return f"{a} {self.choice(['<', '<=', '>', '>='])} {b}"

    def vector(self, n, depth=2):
        known = self.vectors.get(n, [])
        if depth <= 0 or self.chance(0.2):
            longer = [f"{v}[{m - n}:]" for m, names in self.vectors.items() if m > n for v in names]
            return self.choice([*known * 3, *longer, f"np.full({n}, {self.leaf()})"])
        v, w = self.vector(n, depth - 1), self.vector(n, depth - 1)

        def joined():
            return f"np.concatenate([{self.vector(n, 0)}[1:], [{self.scalar(1)}]])"

        def multiplied():
            shapes = [shape for shape in sorted(self.matrices) if n in shape]
            if not shapes:
                return joined()
            rows, columns = shape = self.choice(shapes)
            M = self.choice(self.matrices[shape])
            if rows == n:
                return f"({M} @ {self.vector(columns, 0)})"
            return f"({self.vector(rows, 0)} @ {M})"

        forms = [
            *[lambda: f"({v} {self.choice('+-*')} {w})"] * 4,
            lambda: f"({v} * {self.scalar(1)})",
            lambda: f"np.{self.choice(['sin', 'tanh', 'cos', 'fabs'])}({v})",
            lambda: f"np.where({v} > {self.leaf()}, {w}, 0.5)",
            lambda: f"np.array([{', '.join(self.scalar(1) for _ in range(n))}])",
            lambda: f"np.array([a * {self.leaf()} for a in {v}])",
            lambda: f"({v})[::-1]",
            lambda: f"turned({v})",
            lambda: f"np.clip({v}, -1.0, {self.random.uniform(0, 2):.2f})",
            multiplied,
            joined,
        ]
        return self.choice(forms)()

    # --- statements -----------------------------------------------------------------------------

    def number(self):
        name, value = self.name(), self.scalar(3)
        self.add(f"{name} = {value}")
        self.scalars.append(name)

    def array(self):
        name, n = self.name(), self.choice(sorted(self.vectors) or [3])
        value = self.vector(n)
        self.add(f"{name} = {value}")
        self.vectors.setdefault(n, []).append(name)

    def branch(self):
        if not self.asks():
            return
        name = self.name()
        if self.chance(0.5):
            self.add(f"{name} = {self.scalar(1)}", f"if {self.condition()}:")
            self.add(f"    {name} {self.choice(['=', '+=', '*='])} {self.scalar(1)}")
        else:
            self.add(f"if {self.condition()}:", f"    {name} = {self.scalar(1)}")
            if self.asks():
                self.add(f"elif {self.condition(0)}:", f"    {name} = {self.scalar(1)}")
            self.add("else:", f"    {name} = {self.scalar(1)}")
        self.scalars.append(name)

    def loop(self):
        s, k = self.name(), self.name()
        n = self.choice(sorted(self.vectors) or [3])
        v, w = self.vector(n, 0), self.vector(n, 0)
        self.add(f"{s} = {self.leaf()}")
        kind = self.random.randrange(6)
        if kind == 0:
            self.add(f"for {k} in {v}:", f"    {s} += {k} * {self.scalar(1)}")
        elif kind == 1:
            self.add(f"for {k}, b in zip({v}, {w}, strict=True):", f"    {s} = 0.7 * {s} + {k} * b")
        elif kind == 2:
            self.add(f"for {k}, b in enumerate({v}):", f"    {s} -= b / ({k} + 1)")
        elif kind == 3:
            self.add(f"{k} = {self.random.randrange(1, 6)}", f"while {k} > 0:", f"    {k} -= 1")
            self.add(f"    {s} = math.sin({s}) + {k} * {self.leaf()}")
        elif kind == 4:
            self.add(f"for {k} in range({n}):", f"    if {k} % 2:", "        continue")
            self.add(f"    {s} += ({v})[{k}] * ({w})[{n - 1} - {k}]")
        else:
            self.add(f"for {k} in range(len({v})):")
            self.add(f"    {s} = np.tanh({s}) * ({v})[{k}] + {self.scalar(1)}")
        self.scalars.append(s)

    def filled(self):
        name, k, n = self.name(), self.name(), self.random.randrange(2, 6)
        self.add(f"{name} = np.{self.choice(['zeros', 'ones'])}({n})")
        if self.chance(0.6):
            self.add(f"for {k} in range({n}):")
            self.add(f"    {name}[{k}] {self.choice(['=', '+='])} {self.scalar(1)} * {k}")
        else:
            self.add(f"{name}[:{n - 1}] = {self.vector(n - 1, 1)}")
            self.add(f"{name}[-1] = {self.scalar(1)}")
        if self.chance(0.4):
            self.add(f"{name}b = {name}[1:]")
            self.add(f"{name}b[0] {self.choice(['=', '-='])} {self.scalar(1)}")
        if self.chance(0.2):
            self.add(f"{name} *= {self.leaf()}")
        self.vectors.setdefault(n, []).append(name)

    def matrix(self):
        name = self.name()
        n, m = (self.choice(sorted(self.vectors) or [2]) for _ in range(2))
        self.add(f"{name} = np.outer({self.vector(n, 1)}, {self.vector(m, 1)})")
        if self.chance(0.3):
            self.add(f"{name} = {name}.T")
            n, m = m, n
        if n == m and self.chance(0.5):
            self.add(f"{name} = {name} + np.eye({n}) * {self.leaf()}")
        elif self.chance(0.3):
            self.add(f"{name}[0] *= 0.5")
        self.matrices.setdefault((n, m), []).append(name)

    def called(self):
        a, b = self.name(), self.name()
        kind = self.random.randrange(4)
        if kind == 0:
            self.add(f"{a}, {b} = bend({self.leaf()}, {self.scalar(1)})")
        elif kind == 1:
            self.add(f"{a}, {b} = bend(b={self.leaf()}, a={self.leaf()})")
        elif kind == 2:
            self.add(f"def inner(v, k={self.leaf()}):", f"    return v * k + {self.leaf()}")
            self.add(f"{a}, {b} = inner({self.leaf()}), inner({self.leaf()}, {self.leaf()})")
        else:
            self.add(f"{b} = {self.scalar(1)}")
            self.add(f"{a} = (lambda v: v * {b} - {self.leaf()})({self.leaf()})")
        self.scalars += [a, b]

    def shared(self):
        """An array that is changed by another name, or a copy that is not."""
        a, b, n = self.name(), self.name(), self.choice(sorted(self.vectors) or [3])
        seen = [f"{a}[::-1]", f"np.asarray({a})", f"{a}.reshape(1, -1)[0]", f"np.ravel({a}[::2])"]
        seen += [
            f"+{a}",
            f"np.transpose({a}[None])[:, 0]",
            f"np.prod({a}[None], axis=0)",
            f"{a}[...]",
        ]
        changes = [f"{b}[0] = {self.scalar(1)}", f"{b} += {self.leaf()}", f"{b}.put([0], 0.5)"]
        changes += [f"np.copyto({b}, {self.leaf()})", f"{a}[0], {b}[-1] = {b}[-1], {a}[0]"]
        start = self.choice([self.vector(n, 1), f"np.zeros({n})", f"np.linspace(0.0, 1.0, {n})"])
        self.add(f"{a} = np.array({start})", f"{b} = {self.choice(seen)}", self.choice(changes))
        self.vectors.setdefault(n, []).append(a)
        self.scalars.append(f"{b}[0]")

    def ordered(self):
        if not self.asks(3):
            return
        name = self.name()
        three = ", ".join(self.leaf() for _ in range(3))
        self.add(f"{name} = sorted([{three}]{self.choice(['', ', reverse=True'])})[1]")
        self.scalars.append(name)

    # --- the whole --------------------------------------------------------------------------------

    def value(self, shape):
        """An expression of the shape of a port."""
        if not shape:
            return self.scalar()
        if len(shape) == 1:
            return self.vector(shape[0])
        known = [*self.matrices.get(shape, []), f"np.ones({shape})"]
        outer = f"np.outer({self.vector(shape[0], 1)}, {self.vector(shape[1], 1)})"
        return f"{self.choice(known)} * ({self.scalar(1)}) + {outer}"

    def returned(self, returns):
        """What the function gives, in one of the ways that are allowed."""
        values = [self.value(shape) for shape in returns.values()]
        if self.chance(0.6) or any(len(shape) == 2 for shape in returns.values()):
            ports = zip(returns, values, strict=True)
            return "{" + ", ".join(f'"{port}": {value}' for port, value in ports) + "}"
        if self.chance(0.5):
            return f"np.concatenate([{', '.join(values)}])"
        every = (f"*({value})" for value in values)
        return f"[{', '.join(every)}]"

    def text(self, name, returns):
        parts = [self.number, self.array, self.branch, self.loop, self.loop, self.filled]
        parts += [self.matrix, self.called, self.ordered, self.shared]
        for _ in range(self.random.randrange(1, 6)):
            self.choice(parts)()
        if self.chance(0.15) and self.asks():
            self.add(f"if {self.condition(0)}:")
            self.add(f"    return {self.returned(returns)}")
        self.add(f"return {self.returned(returns)}")
        return f"def {name}(t, x, u, p):\n" + "\n".join(self.lines) + "\n"


def program(random, name, takes, returns, numbers, jumping=False):
    """Draw the text of one function of ports and parameters of these shapes."""
    return Writer(random, takes, numbers, jumping).text(name, returns)


def plain(text: str) -> str:
    """Write a function of one port each as python-control's own: vectors, and params by key."""
    text = re.sub(r"\b([xu])\.\1\d", r"\1", text.replace('p["b"]', "p.b"))
    text = re.sub(r"\bp\.(\w+)", r'params["\1"]', text.replace("x, u, p)", "x, u, params)"))
    return re.sub(r'return \{"\w+": (.*)\}$', r"return \1", text, flags=re.MULTILINE)


def executed(text: str) -> dict[str, Any]:
    """Execute text as a module whose source is at hand."""
    file = f"<random program {next(_files)}>"
    text = HELPERS + text
    linecache.cache[file] = (len(text), None, text.splitlines(True), file)
    space: dict[str, Any] = {"math": math, "np": np, "__name__": "random_program"}
    exec(compile(text, file, "exec"), space)
    return space
