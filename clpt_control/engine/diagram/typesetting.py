r"""Expressions in LaTeX: names with their indices, choices as cases, long formulas in lines.

    plant.x[0]  ->  {x}_{0}^{\mathrm{plant}}        where(gt(x, 0), x, 0)  ->  \begin{cases} ...

A long formula is broken before a sign + or -, as little inside of brackets as can be, or else
between two factors.  A bracket with a break in it has no `\left`, which no line may end in.
"""

import re
import unicodedata
from typing import Any

import sympy
from sympy import Piecewise
from sympy.core.function import AppliedUndef

from .symbol_names import TIME

WIDTH = 56  # of a line, in letters
TOKEN = re.compile(r"\\(?:left|right)\W|\\[a-zA-Z]+|\\.| [-+] |.", re.DOTALL)
FLAT = str.maketrans("", "", "\\{}^_&, ")  # what is not as wide as a letter
WORD = re.compile(r"(?<![\\a-zA-Z])[a-zA-Z]{2,}")  # and no command
LAMBDA = re.compile(r"^lam(?=_|\d|$)")  # Python's word for another thing
LEFT, RIGHT = r"\left(", r"\right)"
SIGNS = {" + ": 0, " - ": 0, r"\,": 9}  # at which a line may end, at a cost
INSIDE = {"{": 1, r"\begin": 1, "}": -1, r"\end": -1}
WORDS = ("sin", "cos", "tan", "tanh", "sinh", "cosh", "log", "max", "min")
RELATIONS = {
    "gt": sympy.Gt,
    "ge": sympy.Ge,
    "lt": sympy.Lt,
    "le": sympy.Le,
    "and_": sympy.And,
    "or_": sympy.Or,
    "not_": sympy.Not,
}
FUNCTIONS = {
    "maximum": sympy.Max,
    "minimum": sympy.Min,
    "clip": lambda s, low, high: sympy.Min(sympy.Max(s, low), high),
    "floor": sympy.floor,
    "ceil": sympy.ceiling,
    "sign": sympy.sign,
}


def typeset(expression: Any, accent: str = "{}") -> str:
    """Return an expression as LaTeX, ``plant.x[0]`` as an x with its index and its block.

    The accent, such as a dot, is set over each letter, not over its index.
    """
    expression = with_equations(sympy.sympify(expression))
    inputs = {}
    for function in expression.atoms(AppliedUndef):
        if function.args == (TIME,):
            inputs[function] = sympy.Symbol(str(function.func))
    expression = _with_cases(expression.xreplace(inputs))
    latex = {}
    for symbol in expression.free_symbols:
        block, _, label = symbol.name.rpartition(".")
        name, _, index = in_ascii(label.rstrip("]")).partition("[")
        name = LAMBDA.sub("lambda", name)
        text = sympy.latex(sympy.Symbol(name))
        if text == name and len(name) > 1 and "{" not in name:
            text = rf"\mathrm{{{name}}}"
        else:
            text = WORD.sub(r"\\mathrm{\g<0>}", text)
        letter, underscore, own_index = text.partition("_")
        text = accent.format(letter) + underscore + own_index
        if index:
            text = f"{{{text}}}_{{{index.replace('][', ',')}}}"
        if block:
            text += rf"^{{\mathrm{{{block}}}}}".replace("_", r"\_")
        latex[symbol] = text
    return sympy.latex(
        expression, symbol_names=latex, mul_symbol=r"\,", long_frac_ratio=4
    )


def in_ascii(name: str) -> str:
    """Return a name with Greek letters as words, ``gamma``, and letters without accents."""

    def word(letter: re.Match) -> str:
        _, size, *_, word = unicodedata.name(letter[0]).split()
        return word.title() if size == "CAPITAL" else word.lower()

    plain = re.sub("[Α-ω]", word, unicodedata.normalize("NFKD", name))
    return plain.encode("ascii", "ignore").decode()


# --- choices ------------------------------------------------------------------------------------


def with_equations(expression: Any) -> Any:
    """Return an expression in which a <= b and a >= b is the equation a = b."""

    def is_pair(e: Any) -> bool:
        names = [str(getattr(a, "func", "")) for a in e.args]
        return names == ["le", "ge"] and e.args[0].args == e.args[1].args

    return expression.replace(
        lambda e: str(e.func) == "and_" and is_pair(e),
        lambda e: sympy.Eq(*e.args[0].args, evaluate=False),
    )


def _with_cases(e: Any) -> Any:
    """Return an expression with choices as cases, and limits as max and min."""
    if not e.has(AppliedUndef):
        return e
    name, args = e.func.__name__, e.args
    if name == "where":
        condition, *values = args
        a, b = map(_with_cases, values)
        return Piecewise((a, _truth(condition)), (b, True))
    if name in RELATIONS:
        return Piecewise((1, _truth(e)), (0, True))
    return FUNCTIONS.get(name, e.func)(*map(_with_cases, args))


def _truth(e: Any) -> Any:
    """Return a truth value as a relation, or that a number is not 0."""
    if isinstance(e, sympy.core.relational.Relational):
        return e
    name = e.func.__name__
    if name not in RELATIONS:
        return sympy.Ne(_with_cases(e), 0)
    read = _truth if name.endswith("_") else _with_cases
    return RELATIONS[name](*map(read, e.args))


# --- lines --------------------------------------------------------------------------------------


def in_lines(latex: str) -> str:
    r"""Return a formula with ``\\ &`` where a line is full, for an `aligned`."""
    tokens, breaks, opened = TOKEN.findall(latex), [0], list[int]()
    costs, widths = _costs(tokens), [*map(_width, tokens)]
    for k in range(len(tokens)):
        if sum(widths[breaks[-1] : k + 1]) > WIDTH:
            places = (j for j in costs if breaks[-1] < j <= k)
            breaks += sorted(places, key=lambda j: (costs[j], -j))[:1]
    for k, token in enumerate([*tokens]):
        if token == LEFT:
            opened.append(k)
        elif token == RIGHT and any(opened[-1] < j < k for j in breaks):
            tokens[opened[-1]], tokens[k] = r"\bigl(", r"\bigr)"
        if token == RIGHT:
            opened.pop()
        if k in breaks[1:]:
            sign = r"\cdot " if token == r"\," else token
            tokens[k] = rf" \\ &\quad {{}}{sign}"
    return "".join(tokens)


def _costs(tokens: list[str]) -> dict[int, int]:
    """Return the places where a line may end, and the brackets there; of a product many."""
    costs, inside, brackets = dict[int, int](), 0, 0
    for k, token in enumerate(tokens):
        inside += INSIDE.get(token, 0)
        brackets += (token == LEFT) - (token == RIGHT)
        if not inside and token in SIGNS:
            costs[k] = brackets + SIGNS[token]
    return costs


def _width(token: str) -> int:
    """Return about how many letters wide a token is."""
    if token in SIGNS:
        return 3 - SIGNS[token] // 3
    word = token.lstrip("\\")
    return len(word) if word in WORDS else len(token.translate(FLAT)[:1])
