"""HTML: escaped text, elements of pages, and fragments for notebooks.

A fragment is the HTML of an object in a notebook; its colours follow the notebook's text, so
that it is readable on light and dark backgrounds.
"""

import re
from collections.abc import Iterable, Sequence
from functools import cache
from html import escape
from importlib import resources
from typing import NamedTuple

NO_TEXT = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
UNBROKEN = re.compile(  # angles, times and sizes that stay on one line
    r"\d+(?: \d\d)?\.\d+ [NSEW]\b|\+- [\d.]+ \w+|\d+ x \d+ m\b|\d+ of \d+|"
    r"(?:\d{4}-)?\d\d-\d\d \d\d:\d\d"
)
WORDS = ' class="words"'
ALARM = ' class="alarm"'
LOUD = ("OUT", "overdue", "cannot be read")  # beginnings of cells that are alarms
LONGEST = 300  # letters of a cell


class Result(NamedTuple):
    """A table of results for the terminal and for pages; its first column names rows.

    On a page, columns of a high rank are hidden on a telephone and on paper; a row may have
    attributes in HTML, and its name a link.
    """

    title: str = ""
    columns: Sequence[str] = ()
    rows: Sequence[Sequence[str]] = ()
    sentences: Sequence[str] = ()
    ranks: Sequence[int] = ()
    attributes: Sequence[str] = ()
    links: Sequence[str | None] = ()


def plain(text: object) -> str:
    r"""Return a text without characters that no XML, HTML or UTF-8 file may hold.

    >>> plain("a\x00b\udc80") == "a\ufffdb\ufffd"
    True
    """
    return NO_TEXT.sub("\ufffd", str(text))


def safe(text: object) -> str:
    """Return a text with its markup escaped for HTML.

    >>> safe("<b> & 'c'")
    '&lt;b&gt; &amp; &#x27;c&#x27;'
    """
    return escape(plain(text))


def paragraphs(sentences: Sequence[str], style: str = "") -> str:
    """Return a paragraph for each sentence."""
    kind = f' class="{style}"' if style else ""
    return "\n".join(f"<p{kind}>{safe(sentence)}</p>" for sentence in sentences)


def unbroken(text: str) -> str:
    """Return a text as HTML that keeps angles, times and sizes on one line.

    >>> unbroken("42 55.80 S")
    '<span class="whole">42 55.80 S</span>'
    """
    return UNBROKEN.sub(
        lambda match: f'<span class="whole">{match[0]}</span>', safe(text)
    )


def table(result: Result) -> str:
    """Return a table whose first column names the rows; wide tables scroll horizontally."""
    caption, columns, rows = result[:3]
    styles = [f' class="rank{rank}"' if rank else "" for rank in result.ranks]
    if not styles:
        styles = [
            "" if all(map(_is_number, cells)) else WORDS
            for cells in zip(*rows, strict=True)
        ]
    styles = styles or [""] * len(columns)
    heads = "".join(
        f'<th scope="col"{style}>{safe(name)}</th>'
        for name, style in zip(columns, styles, strict=True)
    )
    heads = f"<thead><tr>{heads}</tr></thead>" if any(columns) else ""
    lines = []
    for k, (name, *values) in enumerate(rows):
        attributes = result.attributes[k] if result.attributes else ""
        text = unbroken(name)
        if result.links and result.links[k]:
            text = f'<a href="{safe(result.links[k])}">{text}</a>'
        cells = "".join(
            f"<td{ALARM if cell.startswith(LOUD) else style}>{unbroken(cell)}</td>"
            for cell, style in zip(values, styles[1:], strict=True)
        )
        lines.append(f'<tr{attributes}><th scope="row">{text}</th>{cells}</tr>')
    return (
        f'<div class="table" role="region" aria-label="{safe(caption)}" tabindex="0"><table>'
        f"<caption>{safe(caption)}</caption>{heads}"
        f"<tbody>{''.join(lines)}</tbody></table></div>"
    )


def _is_number(cell: str) -> bool:
    return re.fullmatch(r"[-+.\d]+(e[-+]\d+)?|-|not known|\d+ of \d+", cell) is not None


def folded(title: str, inner: str) -> str:
    """Return a collapsed section; on paper it is open."""
    return f"<details><summary>{safe(title)}</summary>{inner}</details>"


def listing(text: str) -> str:
    """Return a text as preformatted code."""
    return f"<pre><code>{safe(text)}</code></pre>"


@cache
def asset(name: str) -> str:
    """Return the text of a file of the package's data: a style, a script, a template."""
    return (resources.files("clpt_control") / "data" / name).read_text("utf-8")


def fragment(kind: str, name: object, *contents: str) -> str:
    """Return the HTML of an object in a notebook: its kind, its name, and contents."""
    head = (
        f"<div><strong>{safe(kind)}</strong> {safe(shortened(name))}</div>"
        if kind
        else ""
    )
    style = asset("notebook.css").replace("\n", "")
    return f'<div class="clpt"><style>{style}</style>{head}{"".join(contents)}</div>'


def facts(rows: Iterable[Sequence[object]], columns: Sequence[str] = ()) -> str:
    """Return a table whose first column names its rows; long cells are shortened."""
    heads = "".join(f"<th>{safe(name)}</th>" for name in columns)
    lines = [f"<thead><tr>{heads}</tr></thead>"] if columns else []
    for name, *cells in rows:
        row = "".join(f"<td>{safe(shortened(cell))}</td>" for cell in cells)
        lines.append(f"<tr><th>{safe(shortened(name))}</th>{row}</tr>")
    return f"<table>{''.join(lines)}</table>"


def shortened(text: object, most: int = LONGEST) -> str:
    """Return a text of at most `most` characters.

    >>> shortened("abcdefghij", 5)
    'ab...'
    """
    string = str(text)
    return string if len(string) <= most else f"{string[: most - 3]}..."
