"""Functions that remember: a place that outlives the call, a shape of code, an order of accesses.

`programs()` yields (name, text) of all combinations; `made(text)` executes a text and returns the
function ``rate(t, x, u, p)`` with a memory of its own.
"""

import linecache
from itertools import count, product

HEAD = """\
import math
from collections import deque

import numpy as np


class Box:
    m = 0.0

    def __init__(self):
        self.m = 0.0


class Slotted:
    __slots__ = ("m",)


class Gate:
    def __init__(self, on):
        self.on = on

    def __enter__(self):
        return self.on

    def __exit__(self, *error):
        return False


class Setting:
    def __set__(self, owner, value):
        owner.act(value)


class Lever:
    at = Setting()

    def __init__(self, act):
        self.act = act

    level = property(None, lambda self, value: self.act(value))


"""
# place: what is made once, what is declared in a function, the memory
PLACES = {
    "attribute": ("box = Box()", "", "box.m"),
    "class attribute": ("Box.m = 0.0", "", "Box.m"),
    "slot": ("box = Slotted()\nbox.m = 0.0", "", "box.m"),
    "dict": ("box = {'m': 0.0}", "", "box['m']"),
    "list": ("box = [0.0]", "", "box[0]"),
    "deque": ("box = deque([0.0])", "", "box[0]"),
    "array": ("box = np.zeros(1)", "", "box[0]"),
    "closure": ("m = 0.0", "nonlocal m", "m"),
    "global": ("m_global = 0.0", "global m_global", "m_global"),
    "default argument": ("", "", "box[0]"),
    "function attribute": ("def box(): pass\nbox.m = 0.0", "", "box.m"),
}
# order: what the function does before, how it writes, what it gives
ORDERS = {
    "write on one path": ("", "put(1.0)", "get()"),
    "read, then write": ("last = get()", "put(x[0])", "last"),
    "toggle": ("", "put(1.0 - get())", "get()"),
    "counter with reset": ("", "put((get() + 1.0) % 5.0)", "get()"),
    "last of both paths": ("last = get()\nput(0.5 * x[0])", "put(x[0])", "last"),
}
# code around the write {W}; {C} is a condition on the state
SHAPES = {
    "if": "if {C}:\n    {W}",
    "elif": "if x[0] > 9.0:\n    pass\nelif {C}:\n    {W}\nelif x[0] < -9.0:\n    {W}",
    "nested": "if x[0] > -1.0:\n    if {C}:\n        {W}",
    "match": "match bool({C}):\n    case True:\n        {W}",
    "try": "try:\n    math.sqrt(float(x[0]) - 0.3)\n    {W}\nexcept ValueError:\n    pass",
    "while": "k = 0\nwhile {C} and k < 1:\n    k += 1\n    {W}",
    "for with break": "for v in (x[0], 0.1):\n    if v > 0.3:\n        {W}\n        break",
    "and": "{C} and {W}",
    "or": "not {C} or {W}",
    "conditional expression": "_ = {W} if {C} else 0.0",
    "walrus": "if (v := x[0]) > 0.3:\n    {W}",
    "comprehension": "_ = [{W} for v in x if v > 0.3]",
    "early return": "def step():\n    if not {C}:\n        return\n    {W}\nstep()",
    "decorator": "def twice(f):\n    return lambda: (f(), f())\n@twice\ndef step():\n"
    "    if {C}:\n        {W}\nstep()",
    "context manager": "with Gate({C}) as on:\n    if on:\n        {W}",
    "property": "def act(v):\n    if v > 0.3:\n        {W}\nLever(act).level = x[0]",
    "descriptor": "def act(v):\n    if v > 0.3:\n        {W}\nLever(act).at = x[0]",
    "generator": "def steps():\n    if {C}:\n        {W}\n    yield 1.0\n_ = sum(steps())",
    "lambda": "(lambda v: {W} if v > 0.3 else None)(x[0])",
    "finally": "try:\n    pass\nfinally:\n    if {C}:\n        {W}",
}
_files = count()


def indented(text, spaces):
    return "".join(f"{' ' * spaces}{line}\n" for line in text.splitlines() if line)


def program(place, shape, order):
    """Return the text of a maker of a function that remembers."""
    once, declared, memory = PLACES[place]
    before, write, given = ORDERS[order]
    code = SHAPES[shape].replace("{W}", write).replace("{C}", "(x[0] > 0.3)")
    default = ", box=[0.0]" if place == "default argument" else ""
    outer = once if place == "global" else ""
    text = HEAD + indented(outer, 0) + "\n\ndef make():\n"
    text += indented("" if place == "global" else once, 4)
    text += f"    def rate(t, x, u, p{default}):\n"
    text += indented(
        f"def put(value):\n    {declared or 'pass'}\n    {memory} = value", 8
    )
    text += "            return value\n"
    text += indented(f"def get():\n    return {memory}", 8)
    text += indented(before, 8) + indented(code, 8)
    text += f"        return [{given} - x[0], -x[1]]\n    return rate\n"
    return text


def programs():
    """Yield the name and text of each combination."""
    for place, shape, order in product(PLACES, SHAPES, ORDERS):
        if (shape, order) != ("decorator", "toggle"):  # twice is none
            yield f"{place}, {shape}, {order}", program(place, shape, order)


def made(text):
    """Execute a text, whose source is at hand; return the function."""
    file = f"<memory program {next(_files)}>"
    linecache.cache[file] = (len(text), None, text.splitlines(True), file)
    space = {"__name__": "memory_program"}
    exec(compile(text, file, "exec"), space)
    return space["make"]()
