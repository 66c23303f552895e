"""Pages of runs, ensembles, fixes, replays and fleets: one HTML file each, which fetches nothing.

A sentence or cards come first, then sections: a result beside its figures.  Figures stay figures
until the page is written, so that they can be files of their own too.  Style and script are in the
file, and its Content-Security-Policy allows only them.  A page reads well without its script.
Every text is escaped.
"""

import platform
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from hashlib import sha256
from textwrap import fill
from typing import TYPE_CHECKING, Any, NamedTuple

from .figures import TITLE, figure_of, inline_svg
from .html import Result, asset, paragraphs, safe, table
from .run_attributes import versions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PACKAGES = (
    "clpt-control",
    "control",
    "numpy",
    "scipy",
    "llvmlite",
    "xarray",
    "matplotlib",
)
WIDTH = 4.8  # inches, of a figure that a telephone shows with letters of their size
LETTERS = 53  # of a title's line there
RECORDED = ("software", "engine", "method", "message")  # attributes


class Drawn(NamedTuple):
    """A figure with its caption; a wide one is moved sideways on a telephone."""

    name: str
    figure: "Figure"
    caption: str
    wide: bool = False


class Section(NamedTuple):
    """A part of a page under a heading: HTML, a result beside its figures, wide figures."""

    name: str
    heading: str
    result: Result = Result()
    figures: Sequence[Drawn] = ()
    more: str = ""


class Page(NamedTuple):
    """A page: its kind, its title, what it is of, warnings and sections.

    Its `lead` is HTML in place of the sentences.  A page is loaded again each so many seconds, if
    `again` is not 0.
    """

    kind: str
    title: str
    sentences: Sequence[str]
    warnings: Sequence[str]
    sections: Sequence[Section]
    lead: str = ""
    scripts: Sequence[str] = ("figures.js",)
    again: int = 0

    @property
    def figures(self) -> list[Drawn]:
        """The figures in their order."""
        return [figure for section in self.sections for figure in section.figures]


def drawn(
    name: str, height: float, caption: str, plot: Callable[..., Any], *data: Any
) -> Drawn:
    """Return the figure of a plot, as wide as a telephone's screen, and so many inches high."""
    figure = figure_of(plot, *data)
    figure.set_size_inches(WIDTH, height)
    for ax in figure.axes:
        ax.set_title(fill(ax.get_title(loc="left"), LETTERS), **TITLE)
    return Drawn(name, figure, caption)


def page_html(page: Page) -> str:
    """Return a page as HTML."""
    links = "".join(
        f'<li><a href="#{section.name}">{safe(section.heading)}</a></li>'
        for section in page.sections
    )
    contents = f'<nav aria-label="Contents"><ul>{links}</ul></nav>'
    style, script = asset("page.css"), "".join(map(asset, page.scripts))
    head, mark = "", ""
    if page.again:
        mark = f' data-again="{page.again}"'
        refresh = f'<meta http-equiv="refresh" content="{page.again}">'
        head = f"<noscript>{refresh}</noscript>"
    policy = f"default-src 'none'; style-src {_hash(style)}; script-src {_hash(script)}"
    return "\n".join(
        [
            "<!DOCTYPE html>",
            '<html lang="en"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"{head}<title>{safe(page.title)}</title>",
            f"<style>{style}</style></head><body{mark}>",
            f'<header><p class="soft">{safe(page.kind)}</p><h1>{safe(page.title)}</h1>',
            f'<div class="lead">{page.lead or paragraphs(page.sentences)}</div>',
            f"{paragraphs(page.warnings, 'alarm')}</header>",
            f"{contents if len(page.sections) > 1 else ''}<main>",
            *map(_section, page.sections),
            '</main><footer class="soft">',
            f"<p>Written by {versions('clpt-control')}.</p></footer>",
            f"<script>{script}</script></body></html>",
            "",
        ]
    )


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


def _section(section: Section) -> str:
    result, name = section.result, section.name
    wide = [_figure(item) for item in section.figures if item.wide]
    narrow = [_figure(item) for item in section.figures if not item.wide]
    table_html = table(result) if result.columns else ""
    if narrow:
        table_html = f"<div>{table_html}</div>" if table_html else ""
        table_html = f'<div class="figures">{"".join(narrow)}{table_html}</div>'
    sentences = paragraphs([f"{item.removesuffix('.')}." for item in result.sentences])
    return (
        f'<section aria-labelledby="{name}"><h2 id="{name}">{safe(section.heading)}</h2>'
        + "\n".join([section.more, table_html, sentences, *wide])
        + "</section>"
    )


def _figure(drawn: Drawn) -> str:
    svg, hint = inline_svg(drawn.figure, drawn.name, drawn.caption), ""
    if drawn.wide:
        caption = safe(drawn.caption)
        svg = f'<div class="wide" role="region" aria-label="{caption}" tabindex="0">{svg}</div>'
        hint = ' <span class="hint">Scroll sideways to see all of it.</span>'
    return f"<figure>{svg}<figcaption>{safe(drawn.caption)}{hint}</figcaption></figure>"


def versions_section(attrs: Mapping[Any, Any]) -> Section:
    """Return what the attributes record of versions and solver, and what made the page."""
    names = [str(name) for name in attrs]
    recorded = [
        name for name in names if name in RECORDED or name.startswith("solver_")
    ]
    rows = [[name.replace("_", " "), str(attrs[name])] for name in recorded]
    rows.append(
        ["page made with", f"Python {platform.python_version()}, {versions(*PACKAGES)}"]
    )
    return Section("versions", "Versions", Result("Software", ["", ""], rows))
