"""Random functions in ordinary Python: what an engineer may write in a block.

`program(random, name, takes, returns, numbers)` draws the source text of one function
``(t, x, u, p)``: branches, early returns, helpers, closures, lambdas, comprehensions, loops
over ranges, arrays and pairs, arrays made empty and filled, views that share what is written,
matrices, NumPy, `math`, `max`, `sorted`, chained comparisons.  Branches change what outlives them:
variables around a closure, lists with two names, arrays in place, slots, sets, deques, iterators,
rows at a signal, and identities are tested.  A `random.Random` makes all choices, so hypothesis can
shrink them.
"""

import linecache
import math
import re
from itertools import count, product
from typing import Any

import numpy as np

HELPERS = """
from collections import deque
from functools import partial
from math import sqrt
from types import SimpleNamespace

GAIN = 0.75
SLOW = 0.25

class Slots:
    __slots__ = ("k",)

    def __init__(self, k):
        self.k = k

def bend(a, b=0.5):
    c = a * b
    return c / (1.5 + c * c), a - b

def limited(a, low=-1.0, high=1.0):
    if a < low:
        return low
    return high if a > high else a

def mix(v, k):
    return sum(a * np.cos(k * i) for i, a in enumerate(v))

def turned(v, *, by=GAIN):
    w = np.array(v, dtype=float)
    w[0] += by
    w[1:] *= 0.5
    return w

class Motor:
    def __init__(self, k):
        self.k = k

    def torque(self, i):
        return self.k * np.tanh(i) if isinstance(i, float) else 0.0

motor = Motor(1.25)
"""
MOST_QUESTIONS = 5  # each doubles the ways through a function
_files = count()

# --- what is written: before a `?` stands how often it asks --------------------------------------
#
# {s} a number, {l} one that is there, {v} a vector of n numbers, {w} one that is there, {n} their
# number, {m} a vector of as many as a matrix {M} has rows, or of any, {c} a comparison, {C} what an
# `if` asks, {f} a constant, {a|b} one of both, {1} and {2} new names

SCALARS = [
    *["({s} {+|-|*} {s})"] * 6,
    *["np.sin({s}) * {s}"] * 2,
    *(
        "({s} / (1.5 + abs({s})))",
        "np.exp(-np.abs({s}))",
        "sqrt(abs({s})) ** {2|3|0.7|1}",
    ),
    *(
        "np.{cos|tanh|arctan|sign|floor|square}({s})",
        "math.{cos|tanh|atan|sin|erf|fabs}({s})",
    ),
    *("np.where({c}, {s}, {s})", "np.{minimum|maximum|hypot|arctan2}({s}, {s})"),
    *("np.clip({s}, -1.0, {f})", "(({s}) % {f})", "motor.torque({s})"),
    *("2?limited({s})", "1?{max|min}({s}, {s})", "1?({s} if {C} else {s})"),
]
OF_VECTORS = [
    *(
        "(({v}) @ {w})",
        "np.dot({v}, {w})",
        "np.trace(np.outer({v}, {w}))",
        "mix({w}, 0.7)",
    ),
    *("np.{sum|mean|linalg.norm}({v})", "sum({v})", "({v}).max()", "({v})[{n} - 1]"),
    "sum(b * {l} for b in {w})",
]
OF_MATRICES = ["({m} @ {M} @ {w})", "np.sum({M}[0])", "({M}).sum()"]
VECTORS = [
    *["({v} {+|-|*} {v})"] * 4,
    *(
        "({v} * {s})",
        "({v})[::-1]",
        "turned({v})",
        "np.clip({v}, -1.0, {f})",
        "np.array([{S}])",
    ),
    *("np.{sin|tanh|cos|fabs}({v})", "np.where({v} > {l}, {v}, 0.5)"),
    *("np.array([a * {l} for a in {v}])", "np.concatenate([{w}[1:], [{s}]])"),
]
COMPARISONS = [
    *["{s} {<|<=|>|>=} {l}"] * 4,
    "({s} > 0) & ({l} < 0.3)",
    "({s} > 0) | ({l} < 0.3)",
]
CONDITIONS = [
    *COMPARISONS,
    "-0.5 < {s} <= 1.5",
    "{s} > 0 {and|or} {l} < {l}",
    "not {s} > {l}",
]
SEEN = [  # of an array {1}, some are copies
    *(
        "{1}[::-1]",
        "np.asarray({1})",
        "{1}.reshape(1, -1)[0]",
        "np.ravel({1}[::2])",
        "+{1}",
    ),
    *(
        "np.transpose({1}[None])[:, 0]",
        "np.prod({1}[None], axis=0)",
        "{1}[...]",
        "{1}.copy()",
    ),
    *(
        "np.squeeze({1}[None], 0)",
        "np.flip({1})",
        "np.split({1}, [0])[1]",
        "np.hsplit({1}, 1)[0]",
    ),
    *("np.moveaxis({1}[None], 0, 1)[:, 0]", "np.rot90({1}[None], 2)[0]"),
    *("np.atleast_3d({1})[0, :, 0]", "np.sum({1}[None], axis=0)"),
    *("np.maximum.reduce({1}[None])", "np.where(True, {1}, 0.0)"),
]
CHANGES = [
    *("{2}[0] = {s}", "{2} += {l}", "{2}.put([0], 0.5)", "np.copyto({2}, {l})"),
    "{1}[0], {2}[-1] = {2}[-1], {1}[0]",
]
IF = "1?if {C}:\n    {1} = {s}\nelse:\n    {1} = {s}"
LOOPS = [
    "for {2} in {w}:\n    {1} += {2} * {s}",
    "for {2}, b in zip({w}, {w}):\n    {1} = 0.7 * {1} + {2} * b",
    "for {2}, b in enumerate({w}):\n    {1} -= b / ({2} + 1)",
    "{2} = {1|3|5}\nwhile {2} > 0:\n    {2} -= 1\n    {1} = math.sin({1}) + {2} * {l}",
    "for {2} in range({n}):\n    if {2} % 2:\n        continue\n"
    "    {1} += ({w})[{2}] * ({w})[{n} - 1 - {2}]",
    "for {2} in range(len({w})):\n    {1} = np.tanh({1}) * ({w})[{2}] + {s}",
]
LOOPS = [f"{{1}} = {{l}}\n{loop}" for loop in LOOPS]
FILLED = [
    "{1} = np.{zeros|ones}({n})\nfor {2} in range({n}):\n    {1}[{2}] {=|+=} {s} * {2}",
    "{1} = np.zeros({n})\n{1}[:{n} - 1] = ({v})[1:]\n{1}[-1] = {s}\n{1} *= {l}",
    "{1} = np.zeros({n} + 1)\n{1}[1:] = {v}\n{1}b = {1}[1:]\n{1}b[0] {=|-=} {s}\n{1} = {1}[:-1]",
]
SHARED = product(("{v}", "np.zeros({n})", "np.linspace(0.0, 1.0, {n})"), SEEN, CHANGES)
SHARED = [
    f"{{1}} = np.array({start})\n{{2}} = {seen}\n{change}"
    for start, seen, change in SHARED
]
EFFECTS = [  # of branches on what outlives them
    "1?{1} = {l}\ndef {2}(v):\n    nonlocal {1}\n    {1} {+=|-=} v\nif {C}:\n    {2}({s})",
    "1?{1} = 0.0\ndef {2}():\n    nonlocal {1}\n    if {C}:\n        return {l}\n"
    "    {1} = {s}\n    return {1}\n{1} = {2}() + {1}",
    "1?{1}b = np.zeros(2)\ndef {2}(k, v):\n    {1}b[k] = v\nif {C}:\n    {2}({0|1}, {s})\n"
    "{1} = {1}b[0] - {1}b[1]",
    "1?{1}b = []\n{2} = {1}b.append\nif {C}:\n    {2}({s})\n{1} = sum({1}b)",
    "1?{2} = dict(k={l})\n{1}b = partial({2}.update, k={s})\nif {C}:\n    {1}b()\n{1} = {2}['k']",
    "1?def {2}(v):\n    return v * {2}.k\n{2}.k = {l}\nif {C}:\n    {2}.k = {s}\n{1} = {2}({l})",
    # in place, or anew
    "1?def {2}(v):\n    if {C}:\n        v {*=|+=} {l}\n        return v\n    return v {*|+} {l}\n"
    "{1}b = np.array([{s}, {l}])\n{1}c = {2}({1}b)\n{1} = {1}b[0] + {1}c[1]",
    "1?{2} = [{l}, {l}, {l}]\nif {C}:\n    {2}.{reverse|pop|copy}()\n{1} = {2}[0] - {2}[-1]",
    # two names
    "1?{1}b = [{l}, {l}]\n{2} = {1}b\nif {C}:\n    {2} = [0.0, 1.0]\n{2}[0] = {s}\n"
    "{1} = {1}b[0] + {2}[1]",
    "1?{1}b = [{l}, {l}]\n{2} = {1}b[:] if {C} else {1}b\n{2}[0] = {s}\n{1} = {1}b[0] + {2}[1]",
    "1?{1}b = np.array([{s}, {l}])\n{2} = {1}b[:1]\nif {C}:\n    {1}b = {1}b * {l}\n"
    "{2}[0] = {l}\n{1} = {1}b[0]",
    "1?{2} = [{l}, {l}]\n{1}b = [{l}, {l}]\n{1}c = {2}\nif {2}[0] > {1}b[0]:\n    {1}c = {1}b\n"
    "{1}c[1] = {s}\n{1} = {2}[1] + {1}b[1]",
    # slots, sets, deques, iterators, orders
    "1?{2} = Slots({l})\nif {C}:\n    {2}.k = {s}\n{1} = {2}.k",
    "1?{2} = set()\nif {C}:\n    {2}.add('high')\n{1} = {l} if {2} else {l}",
    "1?{2} = deque([{l}, {l}], maxlen=2)\nif {C}:\n    {2}.append({s})\n{1} = {2}[0] - {2}[1]",
    "1?{2} = iter([{l}, {l}, {l}])\nif {C}:\n    next({2})\n{1} = next({2})",
    "1?{2} = (v * {l} for v in ({l}, {l}, {l}))\nif {C}:\n    next({2})\n{1} = next({2})",
    "1?{2} = dict(a={l}, b={l})\nif {C}:\n    {2}['a'] = {2}.pop('a')\n{1} = list({2}.values())[0]",
    "1?{2} = SimpleNamespace()\nif {C}:\n    {2}.a, {2}.b = {l}, {s}\nelse:\n"
    "    {2}.b, {2}.a = {l}, {s}\n{1} = {2}.a - {2}.b",
    # identity and class
    "1?{2} = SLOW if {C} else GAIN\n{1} = {l} if {2} is SLOW else {s}",
    "1?{1} = {s} if bool({c}) is {True|False} else {l}",
    "{1} = {s} if ({c}) is True else {l}",
    "{1} = {s} if isinstance(float({l}) > {l}, {bool|np.bool_|float}) else {l}",
    "1?match float({l}) > {l}:\n    case True:\n        {1} = {s}\n    case _:\n        {1} = {l}",
    # a row at a signal
    "2?{1}b = [[{l}, {l}], [{l}, {l}]]\n{1}b[int({l} > 0)][1] = {s}\n{1} = {1}b[1][1] - {1}b[0][1]",
    "2?{1}b = np.array([[{l}, 1.0], [{l}, 2.0]])\n{1}b[int({l} > 0)][1] = {s}\n"
    "{1} = {1}b[1, 1] - {1}b[0, 1]",
    # places of a branch
    "1?{2} = [{l}]\ntry:\n    if {C}:\n        raise ValueError\n    {2}[0] = {s}\n"
    "except ValueError:\n    {2}.append({l})\n{1} = {2}[-1]",
    "1?{2} = [{l}]\nmatch bool({c}):\n    case True:\n        {2}.append({s})\n    case _:\n"
    "        {2}[0] = {s}\n{1} = sum({2})",
    "2?{2} = []\nfor v in ({l}, {l}):\n    if v > {l}:\n        {2}.append({s})\n        break\n"
    "{1} = sum({2}, {l})",
    "1?if ({2} := {s}) > {l}:\n    {2} += {l}\n{1} = {2}",
    "1?{2} = []\n({C}) and {2}.append({s})\n{1} = sum({2}, {l})",
]
STATEMENTS = [  # and what their names are: numbers, a first element, a vector, a matrix
    (["{1} = {s}"], "s1"),
    (["{1} = {v}"], "v1"),
    (
        [
            "1?{1} = {s}\nif {C}:\n    {1} {=|+=|*=} {s}",
            IF,
            IF.replace("1?if {C}", "2?if {c}"),
        ],
        "s1",
    ),
    *[(LOOPS, "s1")] * 2,
    (FILLED, "v1"),
    (["{1} = np.outer({v}, {m})", "{1} = np.outer({v}, {m})\n{1}[0] *= 0.5"], "M1"),
    (["{1} = np.outer({m}, {v}).T"], "M1"),
    (["{1}, {2} = bend({l}, {s})", "{1}, {2} = bend(b={l}, a={l})"], "s1 s2"),
    (
        ["def {2}(v, k={l}):\n    return v * k + {l}\n{1} = {2}({l}) * {2}({l}, {l})"],
        "s1",
    ),
    (["{2} = {s}\n{1} = (lambda v: v * {2} - {l})({l})"], "s1 s2"),
    (["3?{1} = sorted([{l}, {l}, {l}]{|, reverse=True})[1]"], "s1"),
    (SHARED, "v1 e2"),
    *[(EFFECTS, "s1")] * 3,
]


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
            self.scalars += [
                f"{group}[{k}]" for k in sorted({0, size // 2, size - 1}) if size
            ]
        self.known(numbers, "p.")

    def known(self, ports, prefix=""):
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

    def size(self):
        return self.choice(sorted(self.vectors) or [3])

    def expand(self, forms, depth, n=None, rows=None):
        """Return one of some forms that may ask so often, filled; its names, n and m."""
        for _ in range(100):
            asks, _, form = self.choice(forms).rpartition("?")
            if self.questions + int(asks or 0) <= MOST_QUESTIONS:
                break
        self.questions += int(asks or 0)
        n, m, M, names = n or self.size(), self.size(), "", {}
        if "{M}" in form:
            shapes = [
                shape for shape in sorted(self.matrices) if rows in (None, shape[0])
            ]
            m, n = shape = self.choice(shapes)
            M = self.choice(self.matrices[shape])
        made = {
            "s": lambda: self.scalar(depth),
            "S": lambda: ", ".join(self.scalar(1) for _ in range(n)),
            "l": self.leaf,
            **{"v": lambda: self.vector(n, depth), "w": lambda: self.vector(n, 0)},
            **{"m": lambda: self.vector(m, 0), "M": lambda: M, "n": lambda: str(n)},
            "f": lambda: f"{self.random.uniform(0.3, 2):.2f}",
            "c": lambda: self.expand(COMPARISONS, 0)[0],
            "C": lambda: self.expand(CONDITIONS, 1)[0],
        }

        def filled(match):
            key = match[1]
            if "|" in key:
                return self.choice(key.split("|"))
            if key.isdigit():
                return names.setdefault(key, f"a{next(self.fresh)}")
            return made[key]()

        return re.sub(r"\{([^{}]*)\}", filled, form), names, n, m

    def leaf(self):
        if self.jumping and self.chance(0.1):
            return "p.interval"
        if self.chance(0.15):
            return f"{self.random.uniform(-2, 2):.3f}"
        return self.choice(self.scalars)

    def scalar(self, depth=2):
        if depth <= 0 or self.chance(0.15):
            return self.leaf()
        of_arrays = OF_MATRICES if self.matrices and self.chance(0.3) else OF_VECTORS
        return self.expand(of_arrays if self.chance(0.15) else SCALARS, depth - 1)[0]

    def vector(self, n, depth=2):
        if depth <= 0 or self.chance(0.2):
            longer = [
                f"{v}[{m - n}:]"
                for m, names in self.vectors.items()
                if m > n
                for v in names
            ]
            own = self.vectors.get(n, []) * 3
            return self.choice([*own, *longer, f"np.full({n}, {self.leaf()})"])
        known = any(rows == n for rows, _ in self.matrices)
        return self.expand([*VECTORS, *["({M} @ {w})"] * known], depth - 1, n, n)[0]

    # --- the whole --------------------------------------------------------------------------------

    def statement(self):
        forms, kinds = self.choice(STATEMENTS)
        text, names, n, m = self.expand(forms, 2)
        self.lines += [f"    {line}" for line in text.split("\n")]
        for kind, key in kinds.split():
            if kind in "se":
                self.scalars.append(names[key] + "[0]" * (kind == "e"))
            else:
                self.known({names[key]: (n,) if kind == "v" else (n, m)})

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
        return f"[*({'), *('.join(values)})]"

    def text(self, name, returns):
        for _ in range(self.random.randrange(1, 6)):
            self.statement()
        if self.chance(0.15) and self.questions < MOST_QUESTIONS:
            self.questions += 1
            self.lines.append(f"    if {self.expand(COMPARISONS, 0)[0]}:")
            self.lines.append(f"        return {self.returned(returns)}")
        self.lines.append(f"    return {self.returned(returns)}")
        return f"def {name}(t, x, u, p):\n" + "\n".join(self.lines) + "\n"


def program(random, name, takes, returns, numbers, jumping=False):
    """Draw the text of one function of ports and parameters of these shapes."""
    return Writer(random, takes, numbers, jumping).text(name, returns)


def plain(text: str) -> str:
    """Write a function of one port each as python-control's own: vectors, and params by key."""
    text = re.sub(r"\b([xu])\.\1\d", r"\1", text.replace('p["b"]', "p.b"))
    text = re.sub(
        r"\bp\.(\w+)", r'params["\1"]', text.replace("x, u, p)", "x, u, params)")
    )
    return re.sub(r'return \{"\w+": (.*)\}$', r"return \1", text, flags=re.MULTILINE)


def executed(text: str) -> dict[str, Any]:
    """Execute text as a module whose source is at hand."""
    file = f"<random program {next(_files)}>"
    text = HELPERS + text
    linecache.cache[file] = (len(text), None, text.splitlines(True), file)
    space: dict[str, Any] = {"math": math, "np": np, "__name__": "random_program"}
    exec(compile(text, file, "exec"), space)
    return space
