"""Pages as single HTML files: escaped text, elements, documents, and fragments for notebooks.

Nothing is fetched: style and script are in the file, and its Content-Security-Policy allows only
them.  A fragment is the HTML of an object in a notebook; its colours follow the notebook's text, so
that it is readable on light and dark backgrounds.
"""

import re
from base64 import b64encode
from collections.abc import Iterable, Sequence
from functools import cache
from hashlib import sha256
from html import escape
from importlib import resources
from typing import NamedTuple

NO_TEXT = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
WORDS = ' class="words"'
LONGEST = 300  # letters of a cell


class Result(NamedTuple):
    """A table of results for the terminal and for pages; its first column names rows."""

    title: str = ""
    columns: Sequence[str] = ()
    rows: Sequence[Sequence[str]] = ()
    sentences: Sequence[str] = ()


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


def table(caption: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table whose first column names the rows; wide tables scroll horizontally."""
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
    for name, *values in rows:
        cells = "".join(
            f"<td{style}>{safe(cell)}</td>"
            for cell, style in zip(values, styles[1:], strict=True)
        )
        lines.append(f'<tr><th scope="row">{safe(name)}</th>{cells}</tr>')
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


def document(
    title: str, body: str, style: str, scripts: Sequence[str] = (), head: str = ""
) -> str:
    """Return a page; `style` and `scripts` name files of the package, next to `page.css`."""
    styles = _asset("page.css") + _asset(style)
    policy = f"default-src 'none'; style-src {_hash(styles)}"
    ending = ""
    if scripts:
        code = "".join(map(_asset, scripts))
        policy += f"; script-src {_hash(code)}"
        ending = f"<script>{code}</script>"
    return "\n".join(
        [
            "<!DOCTYPE html>",
            '<html lang="en"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"{head}<title>{safe(title)}</title>",
            f"<style>{styles}</style></head><body>",
            f"{body}{ending}</body></html>",
            "",
        ]
    )


@cache
def _asset(name: str) -> str:
    return (resources.files("clpt_control") / "data" / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


def fragment(kind: str, name: object, *contents: str) -> str:
    """Return the HTML of an object in a notebook: its kind, its name, and contents."""
    head = (
        f"<div><strong>{safe(kind)}</strong> {safe(shortened(name))}</div>"
        if kind
        else ""
    )
    style = _asset("notebook.css").replace("\n", "")
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
