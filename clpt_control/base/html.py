"""A page as one HTML file, text as it may hold it, and the few elements that pages are made of.

Nothing is fetched: style and script are in the file, and its Content-Security-Policy allows these
alone.  A notebook shows a thing by a fragment: a little HTML on somebody else's page, which takes
the colour of the text around it, so that it reads on light and on dark.
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
    """Return a text as HTML shows it: nothing of it is markup.

    >>> safe("<b> & 'c'")
    '&lt;b&gt; &amp; &#x27;c&#x27;'
    """
    return escape(plain(text))


def paragraphs(sentences: Sequence[str], style: str = "") -> str:
    """Return a paragraph for each sentence."""
    kind = f' class="{style}"' if style else ""
    return "\n".join(f"<p{kind}>{safe(one)}</p>" for one in sentences)


def table(caption: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table whose first column names the rows; a wide one is moved sideways."""
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
    for first, *rest in rows:
        cells = "".join(
            f"<td{style}>{safe(cell)}</td>"
            for cell, style in zip(rest, styles[1:], strict=True)
        )
        lines.append(f'<tr><th scope="row">{safe(first)}</th>{cells}</tr>')
    return (
        f'<div class="table" role="region" aria-label="{safe(caption)}" tabindex="0"><table>'
        f"<caption>{safe(caption)}</caption>{heads}"
        f"<tbody>{''.join(lines)}</tbody></table></div>"
    )


def _is_number(cell: str) -> bool:
    return re.fullmatch(r"[-+.\d]+(e[-+]\d+)?|-|not known|\d+ of \d+", cell) is not None


def folded(title: str, inner: str) -> str:
    """Return what the reader may unfold; on paper it is open."""
    return f"<details><summary>{safe(title)}</summary>{inner}</details>"


def listing(text: str) -> str:
    """Return a text as it is typed."""
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


def fragment(kind: str, name: object, *pieces: str) -> str:
    """Return what a notebook shows of a thing: its kind, its name, and pieces of HTML."""
    head = (
        f"<div><strong>{safe(kind)}</strong> {safe(shortened(name))}</div>"
        if kind
        else ""
    )
    style = _asset("notebook.css").replace("\n", "")
    return f'<div class="clpt"><style>{style}</style>{head}{"".join(pieces)}</div>'


def facts(rows: Iterable[Sequence[object]], columns: Sequence[str] = ()) -> str:
    """Return a table whose first column names its rows; long cells are shortened."""
    top = "".join(f"<th>{safe(name)}</th>" for name in columns)
    lines = [f"<thead><tr>{top}</tr></thead>"] if columns else []
    for name, *cells in rows:
        rest = "".join(f"<td>{safe(shortened(cell))}</td>" for cell in cells)
        lines.append(f"<tr><th>{safe(shortened(name))}</th>{rest}</tr>")
    return f"<table>{''.join(lines)}</table>"


def shortened(text: object, most: int = LONGEST) -> str:
    """Return a text that is not too long.

    >>> shortened("abcdefghij", 5)
    'ab...'
    """
    whole = str(text)
    return whole if len(whole) <= most else f"{whole[: most - 3]}..."
