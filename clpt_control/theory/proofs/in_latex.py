r"""A verdict in LaTeX: equations, V, V', the conclusion with its conditions, and the steps.

The environments ``theorem``, ``proposition``, ``conjecture`` and ``proof`` are those of amsthm;
``aligned`` and ``text`` are those of amsmath.  One printer sets all sentences: expressions,
formulas that are written by hand, V, N, t, numbers and relations stand in math mode, words do not.
"""

import re
from collections.abc import Iterator
from itertools import groupby
from textwrap import TextWrapper
from typing import Any

import sympy
from sympy import Symbol, sympify

from ...engine.diagram.typesetting import in_lines, typeset
from ..algebra.texts import LARGEST, rounded
from .conclusions import CONCLUSIONS, signs_of
from .statements import Formula, joined

ENVIRONMENTS = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
WRAPPED = TextWrapper(900, break_long_words=False, break_on_hyphens=False)
AT_START = sympy.Function("V")(0)
SIGNS = {"<=": r"\le", ">=": r"\ge", "->": r"\to", "*": r"\,"}
NAMED = {"V'": r"\dot V", "int": r"\int", "sum": r"\sum", "tr": r"\mathrm{tr}"}
PAPER_NAMES = {  # its index D
    r"\mathrm{GammaD}_{": r"\Gamma_{D,",
    r"\mathrm{GammaD}": r"\Gamma_D",
    r"\mathrm{KD}_{": "K_{D,",
    r"\mathrm{KD}": "K_D",
}
PAPER_NAME = re.compile("|".join(map(re.escape, PAPER_NAMES)))
IN_WORDS = ("V", "N", "t")  # that are mathematics
WIDE = 38  # letters; a longer formula has a line of its own
NO_LETTERS = re.compile(r"\\[a-z]+|[{}_^,\\ ]")  # in LaTeX
FORMS = 0xE000  # letters of private use stand for expressions: the first
TOKEN = re.compile(
    r"(?P<form>[\ue000-\uf8ff])|(?P<phrase>V')"
    r"|(?P<name>[^\W\d]\w*(?:[.:][^\W\d]\w*)*(?:\[\w+(?:,\w+)*\])*)(?:\(t\))?"
    r"|(?:\*\*|\^)(?P<power>-?\d+|T|\(\d/\d\))"
    r"|(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
    r"|(?P<sign>[<>]=?|->|[-+*/=(),|])|(?P<blank> )|.",
    re.DOTALL,
)
PRODUCT = re.compile(r"(?<=[\w)|']) (?=[\w(|])")  # of a formula
COMMA = re.compile(r", (?![^(]*\))")
BEFORE, AFTER = " ,)*/^=<>+", " ,(-+*/^=<>"  # of a formula, and no part of it
MARKUP = {c: f"\\{c}" for c in "&%$#_{}"} | {c: f"${c}$" for c in "<>|*"}
MARKUP |= {"^": r"\^{}"}


def verdict_in_latex(verdict: Any) -> str:
    """Return a verdict as a theorem with its proof, as a proposition, or as a conjecture."""
    environment = ENVIRONMENTS[verdict.status]
    lines = [rf"\begin{{{environment}}}", *_statement(verdict)]
    lines.append(rf"\end{{{environment}}}")
    if verdict.status == "proved":
        steps = (step for step in verdict.steps if step.holds)
        items = (rf"\item {written(step.claim)} ({step.how})." for step in steps)
        lines += [r"\begin{proof}", r"\begin{itemize}", *items]
        lines += [r"\end{itemize}", r"\end{proof}"]
    text = "\n".join(map(WRAPPED.fill, lines))
    return PAPER_NAME.sub(lambda name: PAPER_NAMES[name[0]], text)


def _statement(verdict: Any) -> Iterator[str]:
    """Yield the formulas, and what is proved, refuted or open."""
    equations, claim = verdict.equations, verdict.claim
    if equations is not None:
        change = " = V(x^+) - V(x)" if equations.discrete else ""
        yield rf"Let \[ {equations.latex()} \]"
        yield _equation("and", "V =", verdict.V)
        still = (c for c in verdict.conditions if c.name == "zero inputs")
        words = "".join(f", {written(c.statement).strip()}," for c in still)
        yield _equation(f"Then{words}", rf"\dot V{change} =", verdict.rate)
    if verdict.claimed is not None:
        yield _equation("Claim:", r"\dot V \le", verdict.claimed)
    if verdict.status == "refuted":
        step = verdict.steps[-1]
        yield f"Refuted: {written(step.claim)}: {written(step.detail)}."
    if verdict.status == "open":
        missing = verdict.failed[0].claim if verdict.failed else claim
        yield f"Not shown: {written(missing)}."
    if verdict.status != "proved":
        return
    if not CONCLUSIONS[verdict.conclusion].requires & {"falls", "claimed"}:
        yield f"Claim: {written(claim)}."
    yield f"Conclusion: {written(verdict.follows).removeprefix('so ')}."
    conditions = [condition.statement for condition in verdict.conditions]
    if verdict.diagram is not None:  # a law, whose gains have these signs
        conditions.append(signs_of(verdict.V.free_symbols | verdict.rate.free_symbols))
    if conditions:
        yield f"Conditions: {written(joined('; ', conditions))}."


def _equation(words: str, left: str, right: Any) -> str:
    """Return words with an equation in math mode, a long one in lines."""
    lines = _lines(right)
    if r"\\ &" in lines:
        return rf"{words} \[ \begin{{aligned}}{left} {{}}&{lines}.\end{{aligned}} \]"
    is_unbroken = r"\left(" in lines  # over the end of a line
    if len(NO_LETTERS.sub("", lines)) > WIDE * (1 - 0.6 * is_unbroken):
        return rf"{words} \[ {left} {lines}. \]"
    return rf"{words} $\displaystyle {left} {lines}$."


def written(statement: str) -> str:
    """Return a statement with its mathematics in math mode, and its words escaped."""
    words, forms = "", list[Any]()
    for part in getattr(statement, "parts", (statement,)):
        if isinstance(part, str) and not isinstance(part, Formula):
            words += part
            continue
        of_part = part if isinstance(part, tuple) else (part,)
        letters = range(FORMS + len(forms), FORMS + len(forms) + len(of_part))
        words += ", ".join(map(chr, letters))
        forms += map(_typeset, of_part)

    def formula(text: str) -> str:
        tokens = TOKEN.finditer(text)
        latex = (forms[ord(t[0]) - FORMS] if t["form"] else _token(t) for t in tokens)
        return f"${''.join(latex)}$"

    parts = list[str]()
    for is_formula, tokens in groupby(TOKEN.finditer(words), _is_mathematics):
        run = "".join(token[0] for token in tokens)
        core = run.lstrip(BEFORE).rstrip(AFTER) if is_formula else ""
        before, _, after = run.partition(core) if core else (run, "", "")
        formulas = (formula(text) for text in COMMA.split(core) if text)
        parts += [_escaped(before), ", ".join(formulas), _escaped(after)]
    return "".join(parts)


def _is_mathematics(token: re.Match) -> bool:
    """Return whether a token may stand in math mode: any but a word."""
    return token["name"] in IN_WORDS if token["name"] else token.lastgroup is not None


def _token(token: re.Match) -> str:
    """Return a token in LaTeX."""
    kind, text = token.lastgroup, token[token.lastgroup or 0]
    if kind == "power":
        return f"^{{{text.strip('()')}}}".replace("T", r"\top")
    if kind == "number":
        return typeset(sympify(text))
    if kind == "name" and text not in NAMED:
        return typeset(Symbol(text))
    return NAMED.get(text) or SIGNS.get(text, text)


def _typeset(form: Any) -> str:
    """Return an expression or a formula in LaTeX."""
    if isinstance(form, Formula):
        tokens = TOKEN.finditer(PRODUCT.sub("*", form))
        return COMMA.sub("$, $", "".join(map(_token, tokens)))
    lines = _lines(form)
    if r"\\ &" in lines:
        return rf"\begin{{aligned}}[t]&{lines}\end{{aligned}}"
    return lines


def _lines(form: Any) -> str:
    """Return an expression in LaTeX, its long numbers rounded to 17 digits."""
    short = rounded(form)
    whole = (n for n in short.atoms(sympy.Float) if n == int(n) and abs(n) < LARGEST)
    plain = {n: sympy.Integer(n) for n in whole}
    plain |= {s: AT_START for s in short.free_symbols if s.name == f"{AT_START}"}
    return in_lines(typeset(short.xreplace(plain)))


def _escaped(text: str) -> str:
    """Return words with the signs of LaTeX escaped."""
    return "".join(MARKUP.get(letter, letter) for letter in text)
