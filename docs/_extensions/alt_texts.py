"""Alternative texts of the figures that cells draw, of `alt_texts.toml` beside this file.

A page whose figures are more or fewer than its texts fails the build.
"""

import tomllib
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

TEXTS = Path(__file__).with_suffix(".toml")
FOLDER = "jupyter_execute"  # of pictures that MyST-NB writes


def add_texts(app, doctree):
    """Give each figure of a page its text."""
    page = app.env.docname
    texts = tomllib.loads(TEXTS.read_text("utf-8")).get(page, [])
    figures = [node for node in doctree.findall(nodes.image) if FOLDER in node["uri"]]
    if len(texts) != len(figures):
        words = "%s: %d figures of cells, %d texts in alt_texts.toml"
        logger = logging.getLogger(__name__)
        logger.warning(words, page, len(figures), len(texts))
    for figure, text in zip(figures, texts, strict=False):
        figure["alt"] = text


def setup(app):
    """Read every page so."""
    app.connect("doctree-read", add_texts, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
