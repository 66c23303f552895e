"""Random diagrams: blocks that nobody wrote with care, wired at random.

`random_diagram(random)` draws the source text of some blocks (static and with states;
loops, recurrences, helpers, slices, words, jumps), executes it, and wires the blocks
with permutations, gains, sums, gaps, inputs from outside, linear systems and nested
diagrams.  A `random.Random` makes all choices, so hypothesis can shrink them.
"""

import linecache
import math
import warnings
from itertools import count
from typing import Any, NamedTuple

import control
import numpy as np

from clpt_control.blocks import words as clpt_words
from clpt_control.equations import Block

HELPERS = """
def bend(a, b):
    c = a * b
    return c / (1.5 + c * c), a - b

def mix(v, k):
    s = 0.0
    for i in range(len(v)):
        s += v[i] * math.cos(k * i)
    return s

def damp(v, out, n):
    for i in range(n):
        out[i] = math.tanh(v[i])
"""
_files = count()


class Parameters(NamedTuple):
    """What a random block is given: counts, numbers, an array, a matrix, a table."""

    n: int
    m: int
    a: float
    b: float
    v: np.ndarray
    w: np.ndarray
    table: np.ndarray


class Jumping(NamedTuple):
    """The same, for a block that jumps."""

    n: int
    m: int
    a: float
    b: float
    v: np.ndarray
    w: np.ndarray
    table: np.ndarray
    interval: float = -1.0


def jumps(p: Any, t0: float, t1: float) -> np.ndarray:
    """Jump at each whole number, or three times in two."""
    period = 1.0 if p.n % 2 else 2.0 / 3.0
    times = period * np.arange(1.0, math.floor(t1 / period * (1 + 1e-12)) + 1)
    return times[(times > t0) & (times <= t1)]


class _Writer:
    """Writes the text of one function."""

    def __init__(self, random, nx, nu, nout, n, m, jumping, out):
        self.random, self.nx, self.nu, self.nout, self.n, self.m = random, nx, nu, nout, n, m
        self.jumping, self.out = jumping, out
        self.lines: list[str] = []
        self.numbers: list[str] = []  # local names that hold numbers
        self.fresh = count()
        self.indent = 1
        self.loops: list[tuple[str, int]] = []
        self.written: set[int] = set()

    def add(self, line):
        self.lines.append("    " * self.indent + line)

    def choice(self, options):
        return options[self.random.randrange(len(options))]

    def index(self, size):
        """An index of an array of that size, from a loop where one fits."""
        options = [str(self.random.randrange(size)), str(-1 - self.random.randrange(size))]
        for name, turns in self.loops:
            if turns <= size:
                options += [name, f"{size - 1} - {name}", f"{name} - {size}"]
                if turns < size:
                    options.append(f"{name} + {size - turns}")
            if 2 * turns <= size:
                options += [f"2 * {name}", f"2 * {name} + 1"]
        return self.choice(options)

    def leaf(self):
        options = [
            "t",
            f"{self.random.uniform(-2, 2):.3f}",
            "p.a",
            "p.b",
            f"p.v[{self.index(self.n)}]",
            f"p.w[{self.index(self.m)}, {self.index(self.n)}]",
        ]
        options += [name for name, _ in self.loops] + self.numbers * 2
        if self.nu:
            options += [f"u[{self.index(self.nu)}]"] * 4
        if self.nx:
            options += [f"x[{self.index(self.nx)}]"] * 3
        if self.jumping:
            options.append("p.interval")
        return self.choice(options)

    def expression(self, depth=3):
        if depth == 0 or self.random.random() < 0.15:
            return self.leaf()
        a, b = self.expression(depth - 1), self.expression(depth - 1)
        kind = self.random.randrange(20)
        if kind < 4:
            return f"({a} + {b})"
        if kind < 6:
            return f"({a} - {b})"
        if kind < 10:
            return f"math.sin({a}) * {b}"
        if kind == 10:
            return f"{a} / (1.5 + math.fabs({b}))"
        if kind == 11:
            return f"math.{self.choice(['cos', 'tanh', 'atan', 'sin', 'erf'])}({a})"
        if kind == 12:
            return f"math.exp(-math.fabs({a}))"
        if kind == 13:
            return f"where({a} {self.choice(['<', '<=', '>', '>='])} {b}, {b}, {self.leaf()})"
        if kind == 14:
            return f"{self.choice(['minimum', 'maximum'])}({a}, {b})"
        if kind == 15:
            return f"clip({a}, -1.0, {self.random.uniform(0, 2):.2f})"
        if kind == 16:
            return f"{self.choice(['sign', 'floor', '-', ''])}({a})"
        if kind == 17:
            return f"lookup(p.table, clip(floor({a}), {self.choice(['0.0', '-5.0'])}, 4.0))"
        if kind == 18:
            return f"math.sqrt(math.fabs({a})) ** {self.choice(['2', '3', '0.7', '1'])}"
        return f"({a}) % {self.random.uniform(0.5, 3):.2f}"

    def name(self):
        return f"a{next(self.fresh)}"

    def assign(self):
        name, value = self.name(), self.expression()
        self.add(f"{name} = {value}")
        self.numbers.append(name)

    def swap(self):
        a, b = self.name(), self.name()
        self.add(f"{a}, {b} = 1.0, math.tanh({self.leaf()})")
        k, turns = self.name(), self.random.randrange(2, 9)
        self.add(f"for {k} in range(1, {turns}):")
        self.add(f"    {a}, {b} = {b}, ((2 * {k} + 1) * 0.3 * {b} - {k} * {a}) / ({k} + 1)")
        self.numbers += [a, b]

    def helper(self):
        a, b = self.name(), self.name()
        self.add(f"{a}, {b} = bend({self.leaf()}, {self.leaf()})")
        self.numbers += [a, b]
        if self.nu > 1 and self.random.random() < 0.5:
            c = self.name()
            cut = self.random.randrange(1, self.nu)
            part = self.choice([f"u[:{cut}]", f"u[{cut}:]", "u[::-1]", "u[::2]", "u"])
            self.add(f"{c} = mix({part}, {self.leaf()})")
            self.numbers.append(c)

    def loop(self):
        k = self.name()
        sizes = [size for size in (self.n, self.nu, self.nx, self.m, self.nout) if size > 1]
        turns = self.choice(sizes or [3])
        kind = self.random.randrange(6)
        s = self.name()
        start = self.choice(["0.0", "0", self.leaf()])
        if kind != 4:
            self.add(f"{s} = {start}")
        self.add(f"for {k} in range({turns}):")
        self.indent += 1
        self.loops.append((k, turns))
        if kind == 0:
            self.add(f"{s} {self.choice(['+=', '-='])} {self.expression(2)}")
            if self.random.random() < 0.3:
                self.add(f"{s} -= {self.expression(1)}")
        elif kind == 1:
            self.add(f"{s} = {self.choice(['maximum', 'minimum'])}({s}, {self.expression(1)})")
        elif kind == 2:
            self.add(f"{s} = 0.7 * {s} + {self.expression(1)}")
        elif kind == 3:
            old = self.name()
            self.add(f"{old} = {s}")
            self.add(f"{s} = {s} + {self.expression(1)}")
            self.add(f"{s} += 0.1 * ({s} - {old})")
        elif kind == 4:
            if turns <= self.nout:
                place = self.choice([k, f"{turns - 1} - {k}", f"{k} - {self.nout}"])
                self.add(f"{self.out}[{place}] {self.choice(['=', '+='])} {self.expression(2)}")
            else:
                self.add("pass")
        else:
            inner, more = self.name(), self.choice([2, 3, self.n])
            self.add(f"for {inner} in range({more}):")
            self.indent += 1
            self.loops.append((inner, more))
            self.add(f"{s} += {self.expression(2)}")
            self.loops.pop()
            self.indent -= 1
        self.loops.pop()
        self.indent -= 1
        if kind != 4:
            self.numbers.append(s)

    def whole_array(self):
        kind = self.random.randrange(3)
        if kind == 0 and self.nu >= self.nout:
            first = self.random.randrange(self.nu - self.nout + 1)
            self.add(f"{self.out}[:] = u[{first}:{first + self.nout}] * {self.leaf()}")
        elif kind == 1 and self.nu >= self.nout:
            self.add(f"damp(u, {self.out}, {self.nout})")
        elif self.nout > 1:
            self.add(f"part = {self.out}[1:]")
            self.add(f"part[0] = {self.expression(2)}")

    def text(self, name):
        for k in range(self.nout):
            if self.random.random() < 0.5:
                self.add(f"{self.out}[{k}] = {self.expression(1)}")
            else:
                self.add(f"{self.out}[{k}] = 0.0")
        parts = [self.assign, self.loop, self.loop, self.swap, self.helper, self.whole_array]
        for _ in range(self.random.randrange(1, 5)):
            self.choice(parts)()
        for k in range(self.nout):
            if self.random.random() < 0.8:
                how = self.choice(["=", "+=", "-="])
                place = self.choice([k, k - self.nout])
                self.add(f"{self.out}[{place}] {how} {self.expression(2)}")
        if self.random.random() < 0.1:
            self.add("return")
            self.add(f"{self.out}[0] = 17.0")
        head = f"def {name}(t, x, u, p, {self.out}):\n"
        return head + "\n".join(self.lines) + "\n"


def random_block(random, name):
    """Draw a block."""
    dynamic, jumping = random.random() < 0.5, random.random() < 0.25
    sizes = [1, 2, 3, 5, 8] if random.random() < 0.9 else [18, 40]
    nx = sizes[random.randrange(len(sizes))] if dynamic else 0
    nu, ny = (sizes[random.randrange(len(sizes))] for _ in range(2))
    if random.random() < 0.1:
        nu = 0
    n, m = random.randrange(2, 9), random.randrange(2, 5)
    texts = [HELPERS]
    plain = dynamic and random.random() < 0.4  # outputs are the states
    later = dynamic and random.random() < 0.6  # no feedthrough
    if dynamic:
        texts.append(_Writer(random, nx, nu, nx, n, m, jumping, "dx").text("update"))
    if not plain:
        own = 0 if later else nu
        texts.append(_Writer(random, nx, own, ny, n, m, jumping, "y").text("output"))
    if dynamic and jumping:
        texts.append(_Writer(random, nx, nu, nx, n, m, jumping, "new").text("jump"))
    space = executed("\n".join(texts))
    numbers = np.random.default_rng(random.randrange(2**32))
    kind = Jumping if jumping else Parameters
    parameters = kind(
        n,
        m,
        *numbers.normal(size=2),
        numbers.normal(size=n),
        numbers.normal(size=(m, n)),
        numbers.normal(size=5),
    )
    return Block(
        name,
        update=space.get("update"),
        output=space.get("output"),
        inputs={"u": nu} if nu else {},
        outputs=None if plain else {"y": ny},
        states={"x": nx} if dynamic else None,
        parameters=parameters,
        feedthrough=None if plain else not later,
        breakpoints=jumps if jumping else None,
        jump=space.get("jump"),
    )


def executed(text):
    """Execute text as a module whose source is at hand."""
    file = f"<random block {next(_files)}>"
    linecache.cache[file] = (len(text), None, text.splitlines(True), file)
    space: dict[str, Any] = {"math": math, **clpt_words.WORDS}
    exec(compile(text, file, "exec"), space)
    return space


def random_diagram(random, blocks=None, nested=True):
    """Draw a diagram."""
    parts: list[Any] = []
    for k in range(blocks or random.randrange(1, 5)):
        draw = random.random()
        if draw < 0.12:
            parts.append(linear_part(random, f"linear{k}"))
        elif draw < 0.25 and nested:
            inner = random_diagram(random, random.randrange(1, 3), nested=False)
            inner.name = f"inner{k}"
            parts.append(inner)
        else:
            parts.append(random_block(random, f"block{k}"))
    if all(isinstance(part, control.StateSpace) for part in parts):
        parts.append(random_block(random, "more"))  # python-control refuses some of linear parts
    return wired(random, parts)


def linear_part(random, name):
    """Draw a linear system of python-control."""
    numbers = np.random.default_rng(random.randrange(2**32))
    n, m, r = (random.randrange(low, 4) for low in (0, 1, 1))
    D = numbers.normal(size=(r, m)) if n == 0 or random.random() < 0.3 else np.zeros((r, m))
    if n == 0:
        return control.ss([], [], [], D, name=name)
    A, B, C = (numbers.normal(size=size) for size in ((n, n), (n, m), (r, n)))
    return control.ss(A, B, C, D, name=name)


def wired(random, parts):
    """Wire parts: most inputs from signals before them or from states, some from outside."""
    from clpt_control.diagrams.wiring import reaches_outputs

    signals: list[tuple[int, str, int]] = []
    for k, part in enumerate(parts):
        signals += [(k, part.name, j) for j in range(part.noutputs)]
    late = {k for k, part in enumerate(parts) if not reaches_outputs(part)}
    connections, outside = [], random.randrange(0, 4)
    fed: dict[int, list[str]] = {k: [] for k in range(outside)}
    for k, part in enumerate(parts):
        allowed = [s for s in signals if s[0] < k or s[0] in late]
        in_order = random.random() < 0.4 and allowed
        for j in range(part.ninputs):
            draw = random.random()
            if draw < 0.07:
                continue  # a gap
            if (draw < 0.2 and outside) or not allowed:
                if outside:
                    fed[random.randrange(outside)].append(f"{part.name}.{part.input_labels[j]}")
                continue
            sources = []
            for _ in range(1 if random.random() < 0.8 else 2):
                pick = j % len(allowed) if in_order else random.randrange(len(allowed))
                number, _, index = allowed[pick]
                sign = "" if in_order or random.random() < 0.6 else "-"
                gain = 1.0 if in_order or random.random() < 0.7 else random.uniform(-2, 2)
                sources.append((number, index, -gain if sign else gain))
            connections.append([f"{part.name}.{part.input_labels[j]}", *sources])
    spare = [f"{parts[0].name}.{label}" for label in parts[0].input_labels[:1]]
    inplist = [targets or spare for targets in fed.values() if targets or spare]
    chosen = [s for s in signals if random.random() < 0.7] or signals[:1]
    outlist = [f"{name}.{parts[k].output_labels[j]}" for k, name, j in chosen]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # python-control says that it adds what meets at an input
        return control.interconnect(
            parts,
            connections=connections or False,
            inplist=inplist,
            inputs=[f"in{k}" for k in range(len(inplist))] or 0,
            outlist=outlist,
            outputs=[f"out{k}" for k in range(len(outlist))],
            name=f"diagram{next(_files)}",
            check_unused=False,
        )
