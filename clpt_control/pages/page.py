"""What a page to send is made of, and how it is written as HTML.

Sentences first, then numbers, then sections with figures.  The figures stay figures until the
page is written, so that they can be written as files of their own too.  At its end a page says
with what it was made, and how it is made again.
"""

import platform
from collections.abc import Iterator, Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from itertools import groupby
from textwrap import fill
from typing import TYPE_CHECKING, Any, NamedTuple

from ..figures.svg import inline_svg
from ..html import document, listing, paragraphs, safe, table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PACKAGES = ("clpt-control", "control", "numpy", "scipy", "llvmlite", "xarray", "matplotlib")
WIDTH = 4.8  # inches, of a figure that a telephone shows with letters of their size
LETTERS = 50  # of a title's line there


class Drawn(NamedTuple):
    """A figure with its caption; a wide one is moved sideways on a telephone."""

    name: str
    figure: "Figure"
    caption: str
    wide: bool = False


class Beside(str):
    """HTML that stands beside figures, where there is room."""


class Section(NamedTuple):
    """A part of a page: HTML and figures under a heading."""

    name: str
    heading: str
    parts: Sequence[str | Drawn]


class Card(NamedTuple):
    """A number that matters: what, how much, and what to compare it with."""

    what: str
    value: str
    below: str


class Page(NamedTuple):
    """A page: what it is of, what was asked and found, what to be careful of, and all else."""

    kind: str
    title: str
    sentences: Sequence[str]
    warnings: Sequence[str]
    cards: Sequence[Card]
    sections: Sequence[Section]

    def figures(self) -> Iterator[Drawn]:
        """Yield the figures in their order."""
        for section in self.sections:
            yield from (part for part in section.parts if isinstance(part, Drawn))


def narrow(figure: "Figure", height: float) -> "Figure":
    """Return a figure as wide as a telephone's screen, and so many inches high."""
    figure.set_size_inches(WIDTH, height)
    for ax in figure.axes:
        ax.set_title(fill(ax.get_title(loc="left"), LETTERS), loc="left", fontsize=10)
    return figure


def page_html(page: Page) -> str:
    """Return a page as HTML."""
    written = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    links = "".join(
        f'<li><a href="#{one.name}">{safe(one.heading)}</a></li>' for one in page.sections
    )
    body = "\n".join(
        [
            f'<header><p class="soft">{safe(page.kind)}</p><h1>{safe(page.title)}</h1>',
            f'<div class="lead">{paragraphs(page.sentences)}</div>',
            paragraphs(page.warnings, "alarm"),
            f'<div class="cards">{"".join(map(_card, page.cards))}</div></header>',
            f'<nav aria-label="Contents"><ul>{links}</ul></nav><main>',
            *map(_section, page.sections),
            '</main><footer class="soft">',
            f"<p>Written by clpt-control {version('clpt-control')}, {written}.</p></footer>",
        ]
    )
    return document(page.title, body, "report.css")


def _card(card: Card) -> str:
    return (
        f'<div class="card"><p class="soft">{safe(card.what)}</p><b>{safe(card.value)}</b>'
        f"<small>{safe(card.below)}</small></div>"
    )


def _section(section: Section) -> str:
    lines, name = [], section.name
    for beside, parts in groupby(section.parts, _stands_beside):
        pieces = list(map(_piece, parts))
        lines += [f'<div class="figures">{"".join(pieces)}</div>'] if beside else pieces
    return (
        f'<section aria-labelledby="{name}"><h2 id="{name}">{safe(section.heading)}</h2>'
        + "\n".join(lines)
        + "</section>"
    )


def _stands_beside(part: str | Drawn) -> bool:
    return isinstance(part, Beside) or (isinstance(part, Drawn) and not part.wide)


def _piece(part: str | Drawn) -> str:
    if isinstance(part, Drawn):
        return _figure(part)
    return f"<div>{part}</div>" if isinstance(part, Beside) else part


def _figure(drawn: Drawn) -> str:
    svg = inline_svg(drawn.figure, drawn.name, drawn.caption)
    if drawn.wide:
        said = safe(drawn.caption)
        svg = f'<div class="wide" role="region" aria-label="{said}" tabindex="0">{svg}</div>'
    return f"<figure>{svg}<figcaption>{safe(drawn.caption)}</figcaption></figure>"


def again_section(said: str, commands: list[str], ran_with: str, facts: dict[str, str]) -> Section:
    """Return how to make a page again, with what it was made, and facts of the run."""
    here = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    rows = [
        ["run with", ran_with or "not recorded"],
        ["page made with", f"Python {platform.python_version()}, {here}"],
        *([what, value] for what, value in facts.items()),
    ]
    parts = [f"<p>{said}</p>"]
    if commands:
        parts.append(listing("\n".join(commands)))
    return Section("again", "Make it again", [*parts, table("Versions", ["", ""], rows)])


def solver_facts(attributes: Mapping[Any, Any]) -> dict[str, str]:
    """Return how a run ended, and the numbers of its solver."""
    counts = [
        f"{value} {str(name).removeprefix('solver_')}"
        for name, value in attributes.items()
        if str(name).startswith("solver_")
    ]
    return {
        "engine": str(attributes.get("engine", "not recorded")),
        "ended": str(attributes.get("message", "not recorded")),
        "solver": ", ".join(counts) or "not recorded",
    }
