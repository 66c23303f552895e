r"""A verdict in LaTeX: equations, V, V', the conclusion with its conditions, and the steps.

The environments ``theorem``, ``proposition``, ``conjecture`` and ``proof`` are those of amsthm;
``aligned`` and ``text`` are those of amsmath.  One printer sets all sentences: names of the loop,
numbers, functions and relations stand in math mode, words do not.
"""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from textwrap import TextWrapper
from typing import Any

import sympy
from sympy import Symbol

from ...engine.diagram.symbol_names import typeset
from ..algebra.texts import LARGEST, rounded
from .conclusions import CONCLUSIONS, signs_of
from .statements import joined

ENVIRONMENTS = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
WRAPPED = TextWrapper(900, break_long_words=False, break_on_hyphens=False)
AT_START = sympy.Function("V")(0)
SIGNS = {"<=": r"\le", ">=": r"\ge", "*": r"\,"}
PHRASES = {"e^T KD e": r"{e^\top K_D e}", "V'": r"{\dot V}", "^T": r"^\top"}
FORMS = 0xE000  # letters of private use stand for expressions: the first
TOKEN = re.compile(
    r"(?P<form>[\ue000-\uf8ff])"
    rf"|(?P<phrase>{'|'.join(map(re.escape, PHRASES))})"
    r"|(?P<name>[^\W\d]\w*(?:[.:][^\W\d]\w*)*(?:\[\w+(?:,\w+)*\])*)(?:\(t\))?"
    r"|(?:\*\*|\^)(?P<power>\d+)|(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
    r"|(?P<sign>[<>]=?|[-+*/=(),|])|(?P<blank> )|.",
    re.DOTALL,
)
COMMA = re.compile(r", (?![^(]*\))")
BEFORE, AFTER = " ,)*/^=<>+", " ,(-+*/^=<>"  # of a formula, and no part of it
MARKUP = {c: f"\\{c}" for c in "&%$#_{}"} | {c: f"${c}$" for c in "<>|*"}
MARKUP |= {"^": r"\^{}"}


def verdict_in_latex(verdict: Any) -> str:
    """Return a verdict as a theorem with its proof, as a proposition, or as a conjecture."""
    environment, written = ENVIRONMENTS[verdict.status], Sentences(verdict).text
    lines = [rf"\begin{{{environment}}}", *_statement(verdict, written)]
    lines.append(rf"\end{{{environment}}}")
    if verdict.status == "proved":
        steps = (step for step in verdict.steps if step.holds)
        items = (rf"\item {written(step.claim)} ({step.how})." for step in steps)
        lines += [r"\begin{proof}", r"\begin{itemize}", *items]
        lines += [r"\end{itemize}", r"\end{proof}"]
    text = "\n".join(map(WRAPPED.fill, lines))
    text = text.replace("GammaD_{", r"\Gamma_{D,")
    text = text.replace(r"{\dot V}", r"\dot V")
    return text.replace("KD_{", "K_{D,")  # the paper's index D


def _statement(verdict: Any, written: Any) -> Iterator[str]:
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
        yield f"Refuted: {written(step.claim)}: {written(step.detail)}."
    if verdict.status == "open":
        missing = verdict.failed[0].claim if verdict.failed else claim
        yield f"Not shown: {written(missing)}."
    if verdict.status != "proved":
        return
    row = CONCLUSIONS[verdict.conclusion]
    if not row.requires & {"falls", "claimed"}:
        yield f"Claim: {written(claim)}."
    if verdict.level is not None:
        level = f"$\\displaystyle {typeset(verdict.level)}$"
    bound = written(verdict.bound) or level
    words = row.sentence.removeprefix("so ").replace("V", "$V$")
    words = words.format(of=written(verdict.of), bound=bound, level=level)
    yield f"Conclusion: {words}."
    conditions = [condition.statement for condition in verdict.conditions]
    if verdict.diagram is not None:  # a law, whose gains have these signs
        conditions.append(signs_of(verdict.V.free_symbols | verdict.rate.free_symbols))
    if conditions:
        yield f"Conditions: {written(joined('; ', conditions))}."


class Sentences:
    """The printer of the statements of a verdict."""

    def __init__(self, verdict: Any):
        self.names = {"V", "N", "t"}  # in words
        if verdict.diagram is not None:  # a law, whose claims are written by hand
            named, V = verdict.equations.named, sympy.Tuple(verdict.V, verdict.rate)
            self.names |= named.keys() | {str(s) for s in V.free_symbols}
            self.names |= {str(s) for symbols in named.values() for s in symbols.flat}

    def text(self, statement: str) -> str:
        """Return a statement with its mathematics in math mode, and its words escaped."""
        words, forms = "", list[Any]()
        for part in getattr(statement, "parts", (statement,)):
            if isinstance(part, str):
                words += part
                continue
            of_part = part if isinstance(part, tuple) else (part,)
            letters = range(FORMS + len(forms), FORMS + len(forms) + len(of_part))
            words += ", ".join(map(chr, letters))
            forms += of_part
        parts = list[str]()
        for is_formula, tokens in groupby(TOKEN.finditer(words), self._is_mathematics):
            run = "".join(token[0] for token in tokens)
            core = run.lstrip(BEFORE).rstrip(AFTER) if is_formula else ""
            before, _, after = run.partition(core) if core else (run, "", "")
            formulas = (_formula(text, forms) for text in COMMA.split(core) if text)
            parts += [_escaped(before), ", ".join(formulas), _escaped(after)]
        return "".join(parts)

    def _is_mathematics(self, token: re.Match) -> bool:
        """Return whether a token may stand in math mode: any but a word."""
        if token["name"]:
            return token["name"] in self.names
        return token.lastgroup is not None


def _formula(text: str, forms: Sequence[Any]) -> str:
    """Return words of mathematics and the expressions in their places, in math mode."""
    return f"${''.join(_token(token, forms) for token in TOKEN.finditer(text))}$"


def _token(token: re.Match, forms: Sequence[Any]) -> str:
    """Return a token in LaTeX."""
    kind, text = token.lastgroup, token[token.lastgroup or 0]
    if kind == "form":
        return _typeset(forms[ord(text) - FORMS])
    if kind == "phrase":
        return PHRASES[text]
    if kind == "power":
        return f"^{{{text}}}"
    if kind == "name":
        return typeset(Symbol(text))
    return typeset(sympy.sympify(text)) if kind == "number" else SIGNS.get(text, text)


def _typeset(expression: Any) -> str:
    """Return an expression in LaTeX, its long numbers rounded as in a line."""
    short = rounded(expression)
    whole = (n for n in short.atoms(sympy.Float) if n == int(n) and abs(n) < LARGEST)
    plain = {n: sympy.Integer(n) for n in whole}
    plain |= {s: AT_START for s in short.free_symbols if s.name == f"{AT_START}"}
    return typeset(short.xreplace(plain))


def _escaped(text: str) -> str:
    """Return words with the signs of LaTeX escaped."""
    return "".join(MARKUP.get(letter, letter) for letter in text)
