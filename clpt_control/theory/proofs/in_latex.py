r"""A verdict in LaTeX: equations, V, V', the conclusion with its conditions, and the steps.

The environments ``theorem``, ``proposition``, ``conjecture`` and ``proof`` are those of amsthm;
``aligned`` is that of amsmath.  Equations, V, V', claims and a level are formulas.  Conditions, and
claims in words, are texts, with the names of signals as the user wrote them: a product is 2 x.
In a line LaTeX breaks a long V' at its signs.
"""

import re
from collections.abc import Iterator
from tokenize import TokenError
from typing import Any

import sympy

from ...engine.diagram.symbol_names import typeset
from .conclusions import CONCLUSIONS, signs_of

ENVIRONMENTS = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
SIGNS = {  # replaced in this order
    "V'": r"$\dot V$",
    "**": "^",
    "*": " ",
    "^": r"\^{}",
    "<=": r"$\le$",
    ">=": r"$\ge$",
    "<": "$<$",
    ">": "$>$",
    "|": "$|$",
}
RELATIONS = {"<=": r"\le", ">=": r"\ge", "<": "<", ">": ">", "=": "="}
FUNCTIONS = {"sqrt", "Abs", "sign", "exp", "log", "sin", "cos", "cosh", "sinh", "tanh"}
FUNCTIONS |= {"Min", "Max"}
NAME = r"(?<![\w.])[^\W\d][\w.]*(?:\[[\d,]+\])?(?:\(t\))?(?![\w.(\[])"
SIDES = {"V'": r"\dot V", "-e^T KD e": r"-e^\top K_D e", "-r V + c": "-r V + c"}


def verdict_in_latex(verdict: Any) -> str:
    """Return a verdict as a theorem with its proof, as a proposition, or as a conjecture."""
    environment = ENVIRONMENTS[verdict.status]
    lines = [rf"\begin{{{environment}}}", *_statement(verdict)]
    lines.append(rf"\end{{{environment}}}")
    if verdict.status == "proved":
        lines.append("\\begin{proof}\n\\begin{itemize}")
        lines += [
            rf"\item {claim_in_latex(step.claim)} ({step.how})."
            for step in verdict.steps
            if step.holds
        ]
        lines.append("\\end{itemize}\n\\end{proof}")
    text = "\n".join(lines).replace("GammaD_{", r"\Gamma_{D,")
    return text.replace("KD_{", "K_{D,")  # the paper's index D


def _statement(verdict: Any) -> Iterator[str]:
    """Yield the formulas, and what is proved, refuted or open."""
    equations, claim, level = verdict.equations, verdict.claim, ""
    if equations is not None:
        change = " = V(x^+) - V(x)" if equations.discrete else ""
        yield rf"Let \[ {equations.latex()} \]"
        yield rf"and $\displaystyle V = {typeset(verdict.V)}$."
        yield rf"Then $\displaystyle \dot V{change} = {typeset(verdict.rate)}$."
    if verdict.claimed is not None:
        yield rf"Claim: $\displaystyle \dot V \le {typeset(verdict.claimed)}$."
    if verdict.status == "refuted":
        step = verdict.steps[-1]
        yield f"Refuted: {claim_in_latex(step.claim)}: {escaped(step.detail)}."
    if verdict.status == "open":
        missing = verdict.failed[0].claim if verdict.failed else claim
        yield f"Not shown: {claim_in_latex(missing)}."
    if verdict.status != "proved":
        return
    row = CONCLUSIONS[verdict.conclusion]
    if not row.requires & {"falls", "claimed"}:
        yield f"Claim: {claim_in_latex(claim)}."
    if verdict.level is not None:
        level = f"$\\displaystyle {typeset(verdict.level)}$"
    bound = escaped(verdict.bound) or level
    words = row.sentence.format(of=escaped(verdict.of), bound=bound, level=level)
    yield f"Conclusion: {words.removeprefix('so ')}."
    conditions = [*map(str, verdict.conditions)]
    if verdict.diagram is not None:  # a law, whose gains have these signs
        conditions.append(signs_of(verdict.V.free_symbols | verdict.rate.free_symbols))
    if conditions:
        yield f"Conditions: {escaped('; '.join(conditions))}."


def claim_in_latex(claim: str) -> str:
    """Return a claim with its equations, inequalities and forms as formulas."""
    words, of, rest = claim.rpartition("positive definite in ")
    parts = []
    for part in re.split(r", (?![^(]*\))", rest):
        sides = re.split(" ([<>]?=|[<>]) ", part)
        latex = [RELATIONS.get(side) or _side(side) for side in sides]
        is_formula = all(latex) and (of or len(sides) > 1)
        parts.append(f"${' '.join(latex)}$" if is_formula else escaped(part))
    return escaped(words + of) + ", ".join(parts)


def _side(text: str) -> str:
    """Return an expression as LaTeX; "" of words."""
    if text in SIDES:
        return SIDES[text]
    symbols: dict[str, Any] = {}

    def symbol(match: re.Match) -> str:
        """Return a name that SymPy reads, of a signal such as plant.x[0] or w(t)."""
        name = match[0].removesuffix("(t)")
        if name in FUNCTIONS:
            return match[0]
        symbols[key := f"s_{len(symbols)}"] = sympy.Symbol(name)
        return key

    plain = re.sub(NAME, symbol, text)
    words = {*re.findall(r"[^\W\d]\w*", plain)} - symbols.keys()
    try:
        if words <= FUNCTIONS and not re.search(r"[^\w\s.,+*/()-]", plain):
            return typeset(sympy.parse_expr(plain, symbols))
    except (SyntaxError, TokenError, TypeError, ValueError):
        pass
    return ""


def escaped(text: str) -> str:
    """Return a text with the signs of LaTeX escaped."""
    text = re.sub(r"[&%$#_{}]", r"\\\g<0>", text)
    for sign, latex in SIGNS.items():
        text = text.replace(sign, latex)
    return text
