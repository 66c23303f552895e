"""Text as HTML and XML may hold it, and the few elements that pages are made of."""

import re
from collections.abc import Sequence
from html import escape
from typing import NamedTuple

NO_TEXT = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
WORDS = ' class="words"'


class Result(NamedTuple):
    """What was found, as a terminal and a page show it: a table whose first column names rows."""

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
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
    styles = ["" if all(map(_is_number, cells)) else WORDS for cells in zip(*rows, strict=True)]
    styles = styles or [""] * len(columns)
    heads = "".join(
        f'<th scope="col"{style}>{safe(name)}</th>'
        for name, style in zip(columns, styles, strict=True)
    )
    heads = f"<thead><tr>{heads}</tr></thead>" if any(columns) else ""
    lines = []
    for first, *rest in rows:
        cells = "".join(
            f"<td{style}>{safe(cell)}</td>" for cell, style in zip(rest, styles[1:], strict=True)
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
