"""A replay as one HTML file, `replay.html`, that works without a net.

Nothing is fetched: style, script, map and charts are in the file, and its Content-Security-Policy
allows that style and script alone.  It is whole without the script, which zooms the map, shows the
dive under the pointer, counts the hours and marks a vehicle that becomes overdue.  Every text is
escaped.
"""

from collections.abc import Sequence
from typing import Any

from ...base.figures import figure_of, inline_svg, legend_below
from ...base.html import document, listing, safe
from ..estimation.fix_model import PERCENT
from . import replay_summary, table_rows
from .cards import cards, time_of_computing, unbroken
from .map_layers import layers_of, words_of_dive
from .plots import current_plot, dive_clpe_plot
from .track_map import map_svg

ALARM = ' class="alarm"'
KEYS = {  # kind of a layer: its text in the legend of the map
    "track": "fix to fix",
    "drift": "drift at the surface",
    "miss": "position error, from x, the dead-reckoned end",
    "ring": f"+ forecast, {PERCENT} ellipse",
    "next": f"next surfacing, {PERCENT} ellipse",
    "target": "waypoint",
    "made": f"aimed: distance made good, {PERCENT} ellipse",
}
# beginnings of cells that are alarms
LOUD = ("OUT", "overdue", "cannot be read")
AGAIN = 60  # s, until a page of a folder that is followed is loaded again
NARROW = 4.8  # inches of a chart, whose letters a telephone shows
LEGEND_COLUMNS = 2
# greatest rank of a column that a telephone shows, and a printed page
PHONE, PAPER = (2, 6)
SCRIPTS = ("clock.js", "replay.js")


def replay_page(
    report: dict[str, Any], again: bool = False, title: str | None = None
) -> str:
    """Return the page of what `clpt replay --json` prints, with one dive at least.

    A page that is written `again` at each dive is loaded again each minute.
    """
    vehicle = report["vehicle"]
    head, mark = "", ""
    if again:
        head = f'<noscript><meta http-equiv="refresh" content="{AGAIN}"></noscript>\n'
        mark = f' data-again="{AGAIN}"'
    body = "\n".join(
        [
            f"<h1>{safe(title or f'{vehicle}: next surfacing')}</h1>",
            time_of_computing(report),
            f'<div class="cards"{mark}>{"".join(cards(report))}</div>',
            *(
                f"<p>{unbroken(sentence)}</p>"
                for sentence in replay_summary.beyond_cards(report)
            ),
            f'<div class="body"><div><div class="map">{map_svg(report)}',
            f'<div class="buttons"></div></div>{_legend(report)}'
            '<p id="said" class="soft"></p></div>',
            f"<div>{_charts(report)}</div></div>",
            *_paste(report),
            *_table(report),
            *_remarks(report),
        ]
    )
    name = title or f"{vehicle}, dive {report['each_dive'][-1]['dive']}"
    return document(name, body, "replay.css", SCRIPTS, head)


def _legend(report: dict[str, Any]) -> str:
    """Return the legend of what the map shows."""
    drawn = layers_of(report)
    entries = [(kind, name) for kind, name in KEYS.items() if drawn[kind]]
    if any(map(table_rows.is_outside, report["each_dive"])):
        entries.append(("outside", f"fix outside its {PERCENT} ellipse"))
    return "".join(f'<span class="key {kind}">{name}</span>' for kind, name in entries)


def _paste(report: dict[str, Any]) -> list[str]:
    """Return what goes onto the vehicle."""
    upload = report.get("paste")
    return (
        [f"<h2>To paste: {safe(upload['file'])}</h2>", listing(upload["text"])]
        if upload
        else []
    )


def _charts(report: dict[str, Any]) -> str:
    """Return the position errors and what was learned, over time."""
    charts = []
    for name, plot, high, caption in (
        (
            "clpe",
            dive_clpe_plot,
            0.6,
            "Position error (CLPE) of each dive, one dive ahead",
        ),
        ("learned", current_plot, 1.0, "Learned, with two standard errors"),
    ):
        figure = figure_of(plot, report)
        figure.set_size_inches(NARROW, NARROW * high)
        if plot is dive_clpe_plot:
            legend_below(figure.axes[0], LEGEND_COLUMNS)
        svg = inline_svg(figure, name, caption)
        charts.append(f"<figure>{svg}<figcaption>{caption}</figcaption></figure>")
    return "\n".join(charts)


def _table(report: dict[str, Any]) -> list[str]:
    """Return the table, the last dive first."""
    title = f"Dives, the last one first. {table_rows.TITLE}"
    rows = report["each_dive"]
    words = [f"dive {row['dive']}: {words_of_dive(row)}" for row in rows]
    marks = [f' id="map-dive{k}" title="{safe(text)}"' for k, text in enumerate(words)]
    return cell_table(
        title, [*map(table_rows.cells, rows[::-1])], table_rows.COLUMNS, marks[::-1]
    )


def cell_table(
    title: str,
    rows: Sequence[dict[str, str]],
    columns: table_rows.Columns,
    marks: Sequence[str] = (),
    links: Sequence[str | None] = (),
) -> list[str]:
    """Return a table of cells by title, columns of rank 0 before others.

    A row may have attributes, its first cell a link.
    """
    titles = sorted(rows[0], key=lambda title: columns[title][0] > 0)
    styles = {title: _style(columns[title][0]) for title in titles}
    names = [f"<th{styles[title]}>{safe(title)}</th>" for title in titles]
    lines = [
        f"<h2>{safe(title)}</h2>",
        f'<div class="table"><table><thead><tr>{"".join(names)}</tr></thead><tbody>',
    ]
    blank = [""] * len(rows)
    for row, mark, link in zip(rows, marks or blank, links or blank, strict=True):
        texts = [unbroken(row[title]) for title in titles]
        if link:
            texts[0] = f'<a href="{safe(link)}">{texts[0]}</a>'
        loud = [
            ALARM if row[title].startswith(LOUD) else styles[title] for title in titles
        ]
        cells_of_row = "".join(
            f"<td{style}>{text}</td>" for style, text in zip(loud, texts, strict=True)
        )
        lines.append(f"<tr{mark}>{cells_of_row}</tr>")
    return [*lines, "</tbody></table></div>"]


def _style(rank: int) -> str:
    """Return the class of a column: not on a telephone, nor on paper."""
    return "" if rank <= PHONE else f' class="wide{" most" if rank > PAPER else ""}"'


def _remarks(report: dict[str, Any]) -> list[str]:
    lines = [f"<li>{safe(remark)}</li>" for remark in replay_summary.remarks(report)]
    return (
        [
            "<h2>Learned parameters, notes and skipped dives</h2>",
            "<ul>",
            *lines,
            "</ul>",
        ]
        if lines
        else []
    )
