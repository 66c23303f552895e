r"""A verdict in LaTeX: equations, V, V', the conclusion with its conditions, and the steps.

The environments ``theorem``, ``proposition``, ``conjecture`` and ``proof`` are those of amsthm;
``aligned`` and ``text`` are those of amsmath.  One printer sets all sentences: names of the loop,
numbers, functions and relations stand in math mode, words do not.
"""

import re
from collections.abc import Iterator
from itertools import groupby
from textwrap import TextWrapper
from tokenize import TokenError
from typing import Any

import sympy
from sympy import Function, Symbol
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME, typeset
from .conclusions import CONCLUSIONS, signs_of

ENVIRONMENTS = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
WRAPPED = TextWrapper(900, break_long_words=False, break_on_hyphens=False)
RELATIONS = {"<=": r"\le", ">=": r"\ge"}
PHRASES = {"e^T KD e": r"{e^\top K_D e}", "V'": r"{\dot V}"}
TOKEN = re.compile(
    rf"(?P<phrase>{'|'.join(map(re.escape, PHRASES))})"
    r"|(?P<name>[^\W\d]\w*(?:[.:][^\W\d]\w*)*(?:\[\w+(?:,\w+)*\])*)(?P<of>\(t\))?"
    r"|(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
    r"|(?P<sign>\*\*|\.\.\.|[<>]=?|[-+*/^=(),|])|(?P<blank> )|.",
    re.DOTALL,
)
ARTICLE = re.compile(r"a (?:point|jump|box|line|fix|value)\b")
RELATION = re.compile(r" ([<>]?=|[<>]) ")
CUT = " ..."  # the end of a text that is too long
PRODUCT = re.compile(r"(?<=\w) (?=\w)")
COMMA = re.compile(r", (?![^(]*\))")
BEFORE, AFTER = " ,)*/^=<>+", " ,(-+*/^=<>"  # of a formula, and no part of it
OWN: dict[str, Any] = {name: Function(name) for name in ("maximum", "minimum")}
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
    conditions = [*map(str, verdict.conditions)]
    if verdict.diagram is not None:  # a law, whose gains have these signs
        conditions.append(signs_of(verdict.V.free_symbols | verdict.rate.free_symbols))
    if conditions:
        yield f"Conditions: {written('; '.join(conditions))}."


class Sentences:
    """The printer of the texts of a verdict."""

    def __init__(self, verdict: Any):
        named = {} if verdict.equations is None else verdict.equations.named
        known = [verdict.V, verdict.rate, verdict.claimed, verdict.level]
        known += [s for symbols in named.values() for s in symbols.flat]
        total = sympy.Tuple(*(e for e in known if isinstance(e, sympy.Basic)))
        letters = re.findall(r", (\w+) = ", verdict.claim)  # of the sentence
        signals = total.atoms(Symbol, AppliedUndef)
        self.names = {str(s).removesuffix("(t)") for s in signals} | named.keys()
        self.names |= {"V", "N", "t", *letters}

    def text(self, text: str) -> str:
        """Return a text with its mathematics in math mode, and its words escaped."""
        parts = list[str]()
        for is_formula, tokens in groupby(TOKEN.finditer(text), self._is_mathematics):
            run = "".join(token[0] for token in tokens)
            core = run.lstrip(BEFORE).rstrip(AFTER) if is_formula else ""
            before, _, after = run.partition(core) if core else (run, "", "")
            formulas = map(self._formula, COMMA.split(core))
            parts += [_escaped(before), ", ".join(formulas), _escaped(after)]
        return "".join(parts)

    def _is_mathematics(self, token: re.Match) -> bool:
        """Return whether a token may stand in math mode: any but a word."""
        name, end = token["name"], token.end()
        if not name or ARTICLE.match(token.string, token.start()):
            return not name and token.lastgroup is not None
        is_call = token["of"] or token.string.startswith("(", end)
        return name in self.names or bool(is_call)

    def _formula(self, text: str) -> str:
        """Return equations, inequalities or an expression in math mode, if they can be read."""
        sides = RELATION.split(text)
        sides[::2] = map(self._side, sides[::2])
        latex = " ".join(RELATIONS.get(side, side) for side in sides)
        return f"${latex}$" if all(sides) else _escaped(text)

    def _side(self, text: str) -> str:
        """Return an expression as LaTeX; of one that was cut its whole terms."""
        symbols, whole = OWN | {"t": TIME}, text.removesuffix(CUT)
        end = "" if whole == text else CUT

        def symbol(token: re.Match) -> str:
            name = token["name"] or PHRASES.get(token[0])
            is_call = (
                token["of"] and name not in self.names and hasattr(sympy, f"{name}")
            )
            if not name or is_call or token.string.startswith("(", token.end()):
                return token[0]
            is_input = token["of"] or name not in self.names
            key = f"s_{len(symbols)}"
            symbols[key] = Function(name)(TIME) if is_input else Symbol(name)
            return key

        sizes = re.sub(r"\|([^|]+)\|", r"Abs(\1)", whole)
        plain = PRODUCT.sub("*", TOKEN.sub(symbol, sizes))
        try:
            return typeset(sympy.parse_expr(plain, symbols)) + end
        except (SyntaxError, TokenError, TypeError, ValueError, AttributeError):
            whole = whole.rpartition(" ")[0].rstrip(AFTER)
            return self._side(whole + end) if whole and end else ""


def _escaped(text: str) -> str:
    """Return words with the signs of LaTeX escaped."""
    return "".join(MARKUP.get(letter, letter) for letter in text)
