"""Print docs/each_law.md, a section for each law, from their pages and rows.

    python tools/print_laws.py

A page is a docstring: its equations, four letters in, become formulas.
"""

import inspect
import re
from itertools import groupby
from pathlib import Path

from clpt_control.blocks.laws import regressions
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.promises import promises_in_words

PAGE = Path(__file__).parents[1] / "docs" / "each_law.md"
USUAL = (
    "K and Gamma adapt, or are held at the vehicle's own; the functions span the flow; positions "
    "are exact (at fixes z(0) too)"
)
GREEK = ("alpha", "gamma", "theta", "phi", "eta", "kappa", "sigma", "lambda", "rho")
NAMES = {
    **{name: f"\\{name}" for name in (*GREEK, "Gamma", "Phi", "Delta")},
    "of": r"\text{ of }",
    "eps": r"\varepsilon",
    "KD": "K_D",
    "GammaD": r"\Gamma_D",
    "zc": "z_c",
    "int": r"\int",
    "sum": r"\sum",
    **{name: rf"\{name}" for name in ("max", "min", "det")},
    **{name: rf"\operatorname{{{name}}}" for name in ("clip", "tr", "adj", "norm", "diag")},
}
PROSE = re.compile(
    r"\b(where|with|and|as|the|between|Eqs?|at all|from|in place|what|beside|both|whatever)\b"
)
SPLIT = re.compile(r"\s{2,}|(?=- what)|(?<=,) (?=where)| (?=between)|(?=: the)")
SIGNS = {
    "+=": "+=",
    "-=": "-=",
    "<=": r"\le",
    ">=": r"\ge",
    "->": r"\to",
    "^T": r"^{\top}",
    "'": "'",
    "%": r"\%",
}
TOKEN = re.compile(r"a\*|[+-]=|<=|>=|->|\^T\b|\^-1|[A-Za-z]+(?:_[A-Za-z0-9]+)*(?:\+(?= ))?|\d+|\S")


def name_of(word: str) -> str:
    """Return LaTeX of a name such as theta_hat, phi_f, KD_i or S_kk."""
    after = "^{+}" if word.endswith("+") else ""
    first, *below = word.rstrip("+").split("_")
    hat = "hat" in below
    below = [part for part in below if part != "hat"]
    base = NAMES.get(first, first if len(first) == 1 else rf"\mathrm{{{first}}}")
    base, _, inner = (base, "", "") if hat or not below else base.partition("_")
    base = rf"\hat{{{base}}}" if hat else base
    under = ",".join(filter(None, [inner, *(NAMES.get(part, part) for part in below)]))
    return base + (f"_{{{under}}}" if under else "") + after


def formula(text: str) -> str:
    """Return LaTeX of an equation as a docstring has it."""
    if PROSE.search(text):
        return rf"\text{{{text.replace('_', ' ').replace('^', '')}}}"
    found = []
    for token in TOKEN.findall(text):
        if token == "^-1":
            found.append("^{-1}")
        elif token == "a*":
            found.append("a^{*}")
        elif token in SIGNS:
            found.append(SIGNS[token])
        elif token[0].isalpha():
            found.append(name_of(token))
        else:
            found.append(token)
    return re.sub(r" (?=['^])|(?<=\^) ", "", " ".join(found))


def formulas(lines: list[str]) -> str:
    """Return lines of equations as one formula."""
    rows = []
    for line in lines:
        parts = [formula(part.strip()) for part in SPLIT.split(line.strip())]
        joined = r" \quad ".join(parts)
        left, equals, right = joined.partition("=")
        plain_left = equals and "text" not in left
        rows.append(f"{left}&={right}" if plain_left else f"&{joined}")
    body = " \\\\\n".join(rows)
    return f"\n$$\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n$$\n"


def markdown(page: str) -> str:
    """Return a page up to its ports, equations as formulas."""
    lines = re.split(r"^(?:Ports|States): ", inspect.cleandoc(page), flags=re.M)[0].splitlines()
    found: list[str] = []
    for inside, block in groupby(lines, key=lambda line: line.startswith("    ")):
        text = list(block)
        found.append(formulas(text) if inside else "\n".join(map(plain, text)))
    return re.sub(r"\n{3,}", "\n\n", "\n".join(found)).strip()


def plain(line: str) -> str:
    """Return a line of text as Markdown that shows every letter; tables stay as they are."""
    if line.startswith("|") and line.endswith("|"):
        return line
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(
        one if one.startswith("`") else re.sub(r"([*_<>|])", r"\\\1", one) for one in parts
    )


def whole_page() -> str:
    """Return the page: all laws, those of one page together, and what they share."""
    found = [
        "# Each law\n\nWhich to take when: [laws](laws.md). `clpt laws NAME` prints a section in "
        "plain text. What is asked along runs, `clpt refute` asks; *as usual* says: where "
        f"{USUAL}.\n"
    ]
    for page, laws in groupby(LAWS.values(), key=lambda law: law.page):
        rows = list(laws)
        found.append(f"## {', '.join(f'`{law.name}`' for law in rows)}\n\n{markdown(page)}\n")
        for law in rows:
            words = promises_in_words(law).values()
            said = [f"- {plain(one).replace(f'where: {USUAL}', 'as usual')}" for one in words]
            found.append(f"`{law.name}` promises, asked along runs:\n")
            found.append("\n".join(said) + "\n")
    found.append(f"## Shared: `regressions`\n\n{markdown(str(regressions.__doc__))}\n")
    return "\n".join(found)


if __name__ == "__main__":
    PAGE.write_text(whole_page(), "utf-8")
