"""How a notebook shows a thing: a small fragment of HTML on somebody else's page.

It takes the colour of the text around it, so that it reads on light and on dark, and fetches
nothing.
"""

from collections.abc import Iterable, Sequence

from .text import folded, listing, safe

LONGEST, MOST = 300, 6000  # letters of a cell, and of a text that unfolds
STYLE = (
    ".clpt{font:13px/1.45 system-ui,sans-serif;max-width:72em;overflow-x:auto;--paper:transparent;"
    "--card:rgb(128 128 128/.25);--soft:currentColor;--rule:rgb(128 128 128/.35)}"
    ".clpt table{border-collapse:collapse;margin:.3em 0;font-size:inherit}"
    ".clpt tr{background:none!important;border-top:1px solid var(--rule)}"
    ".clpt th,.clpt td{text-align:left!important;vertical-align:top;padding:.15em 1em .15em 0;"
    "font-weight:normal;max-width:46em;overflow-wrap:break-word;white-space:normal}"
    ".clpt th{opacity:.7;white-space:nowrap}"
    ".clpt pre{max-height:24em;overflow:auto;background:none;color:inherit}"
    ".clpt svg,.clpt img{max-width:100%;height:auto;background:none}"
    ".clpt svg{font-family:DejaVu Sans,Verdana,Arial,sans-serif}"
)


def fragment(kind: str, name: object, *pieces: str) -> str:
    """Return what a notebook shows of a thing: its kind, its name, and pieces of HTML."""
    head = f"<div><strong>{safe(kind)}</strong> {safe(shortened(name))}</div>" if kind else ""
    return f'<div class="clpt"><style>{STYLE}</style>{head}{"".join(pieces)}</div>'


def facts(rows: Iterable[Sequence[object]], columns: Sequence[str] = ()) -> str:
    """Return a table whose first column names its rows; long cells are shortened."""
    top = "".join(f"<th>{safe(name)}</th>" for name in columns)
    lines = [f"<thead><tr>{top}</tr></thead>"] if columns else []
    for name, *cells in rows:
        rest = "".join(f"<td>{safe(shortened(cell))}</td>" for cell in cells)
        lines.append(f"<tr><th>{safe(shortened(name))}</th>{rest}</tr>")
    return f"<table>{''.join(lines)}</table>"


def unfolding(title: str, text: str) -> str:
    """Return a text that the reader may unfold."""
    return folded(title, listing(shortened(text, MOST)))


def shortened(text: object, most: int = LONGEST) -> str:
    """Return a text that is not too long.

    >>> shortened("abcdefghij", 5)
    'ab...'
    """
    whole = str(text)
    return whole if len(whole) <= most else f"{whole[: most - 3]}..."
