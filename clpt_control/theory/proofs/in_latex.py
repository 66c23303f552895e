r"""A verdict in LaTeX: a theorem, its assumptions, and the steps of its proof.

The environments ``theorem`` and ``proof`` are those of amsthm.  Sentences of a verdict have
formulas as Python writes them: `V' = -x[0]**2 <= 0`.  A formula is found by its names, those of the
symbols of V and V', by operators and by calls; SymPy reads it, and it is set as V is:
:math:`\dot V = -x_0^2 \le 0`.  What SymPy does not read stays a text.

Barbalat's lemma and LaSalle's principle are cited from Khalil, Nonlinear Systems, 3rd ed., 2002.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain
from tokenize import TokenError
from typing import Any

import sympy

from ...engine.diagram.symbol_names import typeset
from ..algebra.texts import bound_text
from .conclusions import Judged, signs_of

ESCAPED = {"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\~{}"}
ESCAPED |= {letter: f"\\{letter}" for letter in "&%$#_{}"}
RELATIONS = {"<=": r"\le", ">=": r"\ge", "!=": r"\ne", "=": "=", "<": "<", ">": ">"}
OPERATORS = tuple("*/^+-=|'")
TERMS_IN_A_LINE = 4
LARGEST_LINE = 6  # terms

# words that are names of signals only beside an operator
WORDS = {"a", "and", "as", "at", "in", "is", "it", "no", "of", "so", "to", "where"}
# names of every verdict, and the loss of the paper's loop
OWN = {
    "V(x+) - V(x)": "V(x^+) - V(x)",
    "V": "V",
    "V'": r"\dot V",
    "e^T KD e": "e^T K_D e",
    "level": r"\mathrm{level}",
}
INDEXED = (
    r"[A-Za-z][\w.]*(?:_\w+|\[[\d,]+\])"  # plant.x[0], e_1: a name wherever it stands
)
NAMED = r"[A-Za-z][\w.\[\],]*(?=, | [=<>] )"  # k_x[0] = 2, a > 0
FREE = "crtNq"  # letters of claims: V' <= -r V + c, |q|^2, for t >= 0
FUNCTIONS = "Abs|Max|Min|abs|acos|asin|atan|cosh?|exp|log|sinh?|sqrt|tanh?"
NUMBER = r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)?(?!\w)"
LASALLE = "LaSalle's principle, Khalil, Theorem 4.4"
CITED = {  # by what a step shows
    "limit": "Barbalat's lemma, Khalil, Lemma 8.2",
    "rest": LASALLE,
    "still": LASALLE,
}
SOURCE = r"Khalil: \emph{Nonlinear Systems}, 3rd ed., Prentice Hall, 2002."


def theorem_and_proof(
    judged: Judged, V: sympy.Expr | None, rate: sympy.Expr | None
) -> str:
    """Return a verdict as a theorem, its assumptions and the steps of its proof."""
    name = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
    environment = name[judged.status]
    expressions = [e for e in (V, rate) if e is not None]
    diagram = getattr(judged, "diagram", None)
    said = [c.of for c in judged.conditions if c.name in ("signs", "values")]
    said += [s.detail for s in judged.steps if s.how == "counterexample"]
    inputs = getattr(judged, "inputs", ()), getattr(diagram, "input_labels", ())
    text = Typesetter(expressions, chain(*inputs, re.findall(NAMED, f"{said}")))
    displayed = [
        equation(left, e) for left, e in (("V", V), (r"\dot V", rate)) if e is not None
    ]
    shown = judged.shown
    if isinstance(judged.level, sympy.Basic) and not judged.bound:
        shown = replace(judged, level="level").shown
        shown += f", with level = {bound_text(judged.level)}"
    shown = text.sentence(shown.replace("`point`", "the point of the last step"))
    body = [*displayed, f"Then {shown}." * bool(shown)]
    assumed = [text.sentence(condition) for condition in judged.conditions]
    signs = signs_of(sympy.Tuple(*expressions).free_symbols)
    if diagram and signs and judged.status == "proved":  # a law's
        assumed.append(text.sentence(signs))
    body += [f"Assumptions: {'; '.join(assumed)}."] if assumed else []
    lines = [rf"\begin{{{environment}}}", "Let", *body, rf"\end{{{environment}}}"]
    return "\n".join([*lines, *_proof_of(judged, text)])


def _proof_of(judged: Judged, text: "Typesetter") -> Iterable[str]:
    """Yield the lines of the proof: each step, how it was shown, and its detail.

    Of what is proved without a step that step is left out.
    """
    yield r"\begin{proof}"
    yield r"\begin{enumerate}"
    source = ""
    is_proved = judged.status == "proved"
    for step in [s for s in judged.steps if s.holds or not is_proved]:
        how = step.how if step.holds else "not shown"
        notes = [text.sentence(f"{how}, {step.detail}" if step.detail else how)]
        cited = dict.fromkeys(CITED[one] for one in step.shows.split() if one in CITED)
        yield rf"\item {text.sentence(step.claim)} ({'; '.join([*notes, *cited])})."
        source = SOURCE if cited else source
    yield r"\end{enumerate}"
    yield from filter(None, [source])
    yield r"\end{proof}"


def equation(left: str, e: sympy.Expr) -> str:
    """Return an equation on lines of a few terms."""
    terms = sympy.Add.make_args(e)
    if len(terms) <= LARGEST_LINE:
        return rf"\[ {left} = {mathematics(e)} \]"
    starts = range(0, len(terms), TERMS_IN_A_LINE)
    parts = [mathematics(sympy.Add(*terms[k : k + TERMS_IN_A_LINE])) for k in starts]
    lines = [part if part.startswith("-") else f"+ {part}" for part in parts]
    lines[0] = lines[0].removeprefix("+ ")
    of = " \\\\\n&\\quad ".join(lines)
    return f"\\begin{{align*}}\n{left} &= {of}\n\\end{{align*}}"


def mathematics(e: sympy.Expr) -> str:
    """Return an expression as LaTeX, KD and GammaD with the paper's index D."""
    text = re.sub(r"(?<![A-Za-z])KD_{", "K_{D,", typeset(e))
    return re.sub(r"(?<![A-Za-z])GammaD_{", r"\\Gamma_{D,", text)


class Typesetter:
    """Sets sentences whose formulas are written as Python writes them."""

    def __init__(self, expressions: Iterable[sympy.Expr], inputs: Iterable[str] = ()):
        symbols = sympy.Tuple(*expressions)
        names: dict[str, Any] = {letter: sympy.Symbol(letter) for letter in FREE}
        names |= {name: sympy.Symbol(name) for name in inputs}
        calls = symbols.atoms(sympy.core.function.AppliedUndef)
        names |= {str(f.func): sympy.Symbol(str(f.func)) for f in calls}
        self.calls = {f"{f}": f"{f.func}" for f in calls}  # r(t): r
        names |= {str(symbol): symbol for symbol in symbols.free_symbols}
        self.names: Mapping[str, Any] = names
        words = sorted(map(re.escape, [*names, *OWN]), key=len, reverse=True)
        name = rf"(?<![\w.])(?:{'|'.join([*words, INDEXED])})(?![\w\[(]|\.\w|'\w)"
        self.name = re.compile(name)
        called = rf"(?<![\w.])(?:{FUNCTIONS})(?=\()"
        relation = "<=|>=|!=|<|>|="
        atom = rf"[-+(|]*(?:{called}|{name}|{NUMBER})(?:[)|]|\^\d)*"
        joint = rf" ?(?:\*\*|[-+*/^]|{relation}) ?|, |\(| "
        self.formula = re.compile(rf"{atom}(?:(?:{joint}){atom})*")
        self.relation = re.compile(rf" ?({relation}) ?")

    def sentence(self, text: Any) -> str:
        """Return a sentence: formulas as mathematics, other signs of LaTeX escaped."""
        text, parts, end = f"{text}", [], 0
        for call, name in self.calls.items():
            text = re.sub(rf"(?<![\w.]){re.escape(call)}", name, text)
        for found in self.formula.finditer(text):
            before, behind = (
                text[: found.start()].rstrip(),
                text[found.end() :].lstrip(),
            )
            if before.endswith(OPERATORS) or behind.startswith(OPERATORS):
                continue  # a part of what has unknown names
            listed = _parts(found.group(), "(, )")
            set_parts = [self._formula(part) for part in listed[::2]]
            parts += [_escaped(text[end : found.start()]), ", ".join(set_parts)]
            end = found.end()
        return "".join([*parts, _escaped(text[end:])])

    def _formula(self, text: str) -> str:
        """Return a formula as mathematics, and as a text if it is a word or is not read."""
        if text in WORDS or re.fullmatch(NUMBER, text):
            return _escaped(text)
        sides = self.relation.split(text)
        read = [RELATIONS.get(side) or self._side(side) for side in sides]
        return _escaped(text) if None in read else f"${' '.join(map(str, read))}$"

    def _side(self, text: str) -> str | None:
        """Return one side of a relation as LaTeX, or None; its terms stay in their order."""
        # 1. names such as plant.x[0] become letters that SymPy reads
        letters: dict[str, str] = {}

        def letter_of(found: re.Match) -> str:
            name = found.group()
            letter = f"name{len(letters)}_"
            symbol = self.names.get(name, sympy.Symbol(name))
            letters[letter] = OWN.get(name) or mathematics(symbol)
            return letter

        text = self.name.sub(letter_of, text)
        # 2. a product may be written with a space, a power with ^, a size with bars
        text = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text).replace("^", "**")
        text = re.sub(r"\|([^|]*)\|", r"Abs(\1)", text)
        parts = _parts(text, "( [-+] )")
        for k in range(0, len(parts), 2):
            try:
                read = sympy.parse_expr(parts[k])
            except (SyntaxError, TokenError, TypeError, ValueError, AttributeError):
                return None
            if not isinstance(read, sympy.Expr):
                return None
            used = {one: letters.get(str(one), str(one)) for one in read.free_symbols}
            parts[k] = sympy.latex(read, symbol_names=used, mul_symbol=r"\,")
        return " ".join(parts)


def _parts(text: str, separator: str) -> list[str]:
    """Return the parts of a formula, and the separators between them that no bracket holds."""
    parts, depth = [""], 0
    for k, word in enumerate(re.split(separator, text)):
        if k % 2 and depth == 0:
            parts += [word.strip(), ""]
        else:
            parts[-1] += word
            depth += word.count("(") - word.count(")")
    return parts


def _escaped(text: str) -> str:
    parts = re.split(r"(<=|>=|!=|[<>|])", text)
    signs = RELATIONS | {"|": "|"}
    return "".join(
        f"${signs[part]}$"
        if part in signs
        else "".join(ESCAPED.get(c, c) for c in part)
        for part in parts
    )
