"""Checks of the LaTeX of a verdict: signs, environments, and no text of a program in it."""

import re

ENVIRONMENTS = {"proved": "theorem", "refuted": "proposition", "open": "conjecture"}
MATHEMATICS = r"\$[^$]*\$|\\\[(?s:.*?)\\\]"
PYTHON = r"\*|`|(?<!\\)[_&#%]|[<>|]|\^"  # no words of LaTeX
WORDS = r"where|maximum|minimum|sqrt|lambda|clip|gt|lt|ge|le|and_|or_|not_|abs|tanh|sin|cos|exp"
CALLS = rf"(?<![a-zA-Z\\])({WORDS})\(|\*\*"
NAMED = r"\\(?:mathrm|operatorname)\{(?:where|maximum|minimum|clip|gt|lt|ge|le|and_|or_|not_)\}"
ENGLISH = {"a"}  # words of one letter


def check_names(text, verdict):
    """Assert that names of the loop which are no words of English stand in math mode."""
    words = {*re.findall(r"[^\W\d_](?:\w|\\_)*", re.sub(MATHEMATICS, "", text))}
    symbols = {str(s) for e in (verdict.V, verdict.rate) for s in e.free_symbols}
    names = {s for s in symbols if len(s) == 1 or re.search(r"[\d_\[]", s)}
    assert not {word.replace("\\_", "_") for word in words} & (names - ENGLISH), text


def well_formed(verdict):
    """Return the LaTeX of a verdict, after a check of its braces, signs, words and names."""
    text = verdict.latex()
    braces = re.sub(r"\\[{}]", "", text)
    depth = 0
    for letter in braces:
        depth += (letter == "{") - (letter == "}")
        assert depth >= 0, text
    assert depth == 0
    assert text.count("$") % 2 == 0
    assert len(re.findall(r"\\left\b", text)) == len(re.findall(r"\\right\b", text))
    assert text.count(r"\bigl") == text.count(r"\bigr")
    opened = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z*]+)\}", text):
        if kind == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name, text
    assert opened == []
    assert not re.search(PYTHON, re.sub(MATHEMATICS, "", text)), text
    environment = ENVIRONMENTS[verdict.status]
    assert text.startswith(rf"\begin{{{environment}}}")
    assert (r"\begin{proof}" in text) == (verdict.status == "proved")
    if verdict.status == "proved":
        assert not re.search(f"{CALLS}|{NAMED}", text), text
        if verdict.V is not None:
            check_names(text, verdict)
    return text
