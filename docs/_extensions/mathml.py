"""Formulas as MathML, which browsers draw by themselves: no script, no font, no network.

Rates have a prime, not a dot: without a math font a dot lies on its letter.
"""

import re

from docutils import nodes
from docutils.utils.math import MathError, latex2mathml

DOT = re.compile(r"\\dot(?:\{((?:\\\w+\{\w*\}|[^{}])*)\}|\s+(\\?\w+))")


def setup(app):
    """Make it a renderer of formulas."""
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def inline(translator, node):
    """Put a formula into its line."""
    translator.body.append(mathml(node, as_block=False))
    raise nodes.SkipNode


def block(translator, node):
    """Put a formula on a line of its own."""
    translator.body.append(f'<div class="formula">{mathml(node, as_block=True)}</div>')
    raise nodes.SkipNode


def mathml(node, as_block):
    """MathML of a node's LaTeX; what cannot be read fails the build with its place."""
    source = DOT.sub(r"{\1\2}'", node.astext().strip())
    if as_block and r"\\" in source and r"\begin" not in source:
        source = rf"\begin{{aligned}}{source}\end{{aligned}}"
    try:
        found = latex2mathml.tex2mathml(source, as_block=as_block)
    except MathError as problem:
        raise ValueError(f"{node.source}:{node.line}: {problem}: {source}") from None
    # a bar or a prime is no operator between two things: browsers would put space about it
    return re.sub(
        r"<mo([^>]*)>([|‖'])</mo>", r'<mo\1 lspace="0" rspace="0">\2</mo>', found
    )
