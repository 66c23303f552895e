"""Append to the page docs/each_law.md a section for each law, from its docstring and its promises.

The equations of a docstring, indented by four letters, become formulas, and so do symbols in its
sentences; what comes after "Source:" stays as it is.
"""

import inspect
import re
from itertools import groupby

from clpt_control.paper.laws import regressions
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.laws.promises import promises_in_words

PAGE = "each_law"
CONDITIONS = {  # of promises, by letter
    "K and Gamma adapt, or are held at the vehicle's own": "a",
    "the functions span the flow": "b",
    "positions are exact (at fixes z(0) too)": "c",
}
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
    **{
        name: rf"\operatorname{{{name}}}"
        for name in ("clip", "tr", "adj", "norm", "diag")
    },
}
PROSE = re.compile(
    r"\b(where|with|and|as|the|between|Eqs?|at all|from|in place|if|dissipative|both)\b"
)
SPLIT = re.compile(r"\s{2,}|(?=- dissipative)|(?<=,) (?=where)| (?=between)|(?=: the)")
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
TOKEN = re.compile(
    r"a\*|[+-]=|<=|>=|->|\^T\b|\^-1|[A-Za-z]+(?:_[A-Za-z0-9]+)*(?:\+(?= ))?|\d+(?:\.\d+)?|\S"
)
LETTERS = "|".join(name for name in GREEK if name != "sigma")  # which is a law
WORDS = LETTERS + "|Gamma|Phi|Delta|eps|KD|GammaD|zc|size|layer|margin|origin"
CALLED = r"(?:max|diag|norm|clip)(?=\()|(?:det|tr)(?=\(| [A-Z])|int(?= \w )"
LETTER = r"[b-zB-Z]|[aA](?!\s+[A-Za-z]{2})"
NAME = rf"(?:(?:{WORDS}|{LETTER})(?:_[A-Za-z0-9]+)*(?!\w|-[a-z])|{CALLED})"
ATOM = rf"(?:{NAME}|\d+(?:\.\d+)?(?!\w)INNER)(?:'|\^T|\^-1|\^\d|\*)*"
RUN = rf"-?{ATOM}(?:(?:\s*(?:[<>]=|[-+/=<>])\s*-?|\s*){ATOM})*"
SYMBOLS = RUN.replace("INNER", "")
for _ in range(2):  # brackets within brackets
    SYMBOLS = RUN.replace("INNER", rf"|\|{SYMBOLS}\||\({SYMBOLS}(?:,\s+{SYMBOLS})*\)")
SYMBOLS = rf"`[^`]*`|(?<![\w.'-]){SYMBOLS}(?!\w)"


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
    lines = re.split(r"^(?:Ports|States): ", inspect.cleandoc(page), flags=re.M)[
        0
    ].splitlines()
    found: list[str] = []
    for inside, block in groupby(lines, key=lambda line: line.startswith("    ")):
        text = list(block)
        found.append(formulas(text) if inside else typeset("\n".join(text)))
    return re.sub(r"\n{3,}", "\n\n", "\n".join(found)).strip()


def typeset(text: str) -> str:
    """Return sentences as Markdown, symbols as formulas; a table's rows cell by cell."""
    if "\n\n" in text:
        return "\n\n".join(map(typeset, text.split("\n\n")))
    if text.lstrip().startswith("|"):
        return "|".join(map(typeset, text.split("|")))
    said, source, where = (*re.split(r"\b(Sources?: )", text, maxsplit=1), "", "")[:3]
    said = said.replace("N x N", "N by N")
    found, at = [], 0
    for one in re.finditer(SYMBOLS, said):
        found.append(plain(said[at : one.start()]))
        whole = one[0].startswith("`") or not re.search("[A-Za-z]", one[0])
        found.append(one[0] if whole else f"${formula(one[0])}$")
        at = one.end()
    return "".join(found) + plain(said[at:]) + source + plain(where)


def plain(text: str) -> str:
    """Return text as Markdown that shows every letter."""
    return re.sub(r"([*_<>|])", r"\\\1", text)


def promise(text: str) -> str:
    """Return a promise as Markdown, frequent conditions as letters."""
    claim, _, conditions = text.partition(", where: ")
    names = [CONDITIONS.get(name, name) for name in conditions.split("; ") if name]
    return typeset(claim) + (f" ({typeset(', '.join(names))})" if names else "")


def sections() -> str:
    """Return the sections of all laws, those of one docstring together, and what they share."""
    conditions = "; ".join(
        f"({letter}) {typeset(text)}" for text, letter in CONDITIONS.items()
    )
    found = [
        f"A law makes its promises under the conditions in brackets: {conditions}.\n"
    ]
    for page, laws in groupby(LAWS.values(), key=lambda law: law.page):
        rows = list(laws)
        found.append(
            f"## {', '.join(f'`{law.name}`' for law in rows)}\n\n{markdown(page)}\n"
        )
        for law in rows:
            promises = "; ".join(map(promise, promises_in_words(law).values()))
            found.append(f"`{law.name}` promises: {promises}.\n")
    found.append(f"## Shared: `regressions`\n\n{markdown(str(regressions.__doc__))}\n")
    return "\n".join(found)


def append_sections(app, page: str, source: list[str]) -> None:
    """Append the sections to the text of the page that lists them."""
    if page == PAGE:
        source[0] += "\n" + sections()


def setup(app):
    """Append the sections when Sphinx has read the page's file."""
    app.connect("source-read", append_sections)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
