r"""A verdict as a theorem and a proof in LaTeX, for a paper.

The environments ``theorem`` and ``proof`` are those of amsthm.  V and V' are typeset; steps and
conditions are sentences.
"""

import re
from collections.abc import Iterable
from typing import Any

import sympy

from ...engine.diagram.symbol_names import typeset
from .conclusions import Judged

ESCAPED = {"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\~{}"}
ESCAPED |= {letter: f"\\{letter}" for letter in "&%$#_{}"}
RELATIONS = {"<=": r"$\le$", ">=": r"$\ge$", "<": "$<$", ">": "$>$", "|": "$|$"}
TERMS_IN_A_LINE = 4
LARGEST_LINE = 6  # terms


def theorem_and_proof(
    judged: Judged, V: sympy.Expr | None, rate: sympy.Expr | None
) -> str:
    """Return a verdict as a theorem, its assumptions and the steps of its proof."""
    name = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
    environment = name[judged.status]
    displayed = [
        equation(left, e) for left, e in (("V", V), (r"\dot V", rate)) if e is not None
    ]
    body = [*displayed, f"Then {sentence(judged.shown)}." * bool(judged.shown)]
    assumed = [sentence(f"{condition}") for condition in judged.conditions]
    symbols = sympy.Tuple(*(e for e in (V, rate) if e is not None)).free_symbols
    positive = sorted((s for s in symbols if s.is_positive), key=str)
    if positive and judged.status == "proved":
        assumed.append(f"${', '.join(map(mathematics, positive))} > 0$")
    body += [f"Assumptions: {'; '.join(assumed)}."] if assumed else []
    lines = [rf"\begin{{{environment}}}", "Let", *body, rf"\end{{{environment}}}"]
    return "\n".join([*lines, *proof_of(judged)])


def proof_of(judged: Judged) -> Iterable[str]:
    """Yield the lines of the proof: each step, how it was shown, and its detail.

    Of what is proved without a step that step is left out.
    """
    yield r"\begin{proof}"
    yield r"\begin{enumerate}"
    is_proved = judged.status == "proved"
    for step in [s for s in judged.steps if s.holds or not is_proved]:
        how = step.how if step.holds else "not shown"
        detail = f", {step.detail}" if step.detail else ""
        yield rf"\item {sentence(step.claim)} ({sentence(how + detail)})."
    yield r"\end{enumerate}"
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


def sentence(text: Any) -> str:
    """Return a sentence with the signs of LaTeX escaped, and relations as mathematics."""
    parts = re.split(r"(<=|>=|[<>|])", f"{text}")
    escaped = (RELATIONS.get(part) or _escaped(part) for part in parts)
    return "".join(escaped)


def _escaped(text: str) -> str:
    return "".join(ESCAPED.get(letter, letter) for letter in text)
