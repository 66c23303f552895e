"""A replay as one HTML file, `replay.html`, that works without a net.

Nothing is fetched: style, script, map and charts are in the file, and its Content-Security-Policy
allows that style and script alone.  It is whole without the script, which zooms the map, shows the
dive under the pointer and counts the hours.  Every text is escaped: files may say what they like.
"""

from collections.abc import Sequence
from typing import Any

from ...base.figures import figure_of, inline_svg
from ...base.html import document, listing, paragraphs, safe
from . import cells, places, wording
from .layers import words_of_dive
from .plots import current_plot, dive_clpe_plot
from .track_map import map_svg

ALARM = ' class="alarm"'
KEYS = "".join(  # of the map
    f'<span class="key {style}">{name}</span>'
    for style, name in (
        ("track", "fix to fix"),
        ("miss", "miss, from x, the dead-reckoned end"),
        ("ring", "+ forecast, 90 %"),
        ("next", "next surfacing, 90 %"),
        ("made", "aimed: way made good, 90 %"),
    )
)
# beginnings of cells that are alarms
LOUD = ("OUT", "SPEED", "overdue", "cannot be read")
AGAIN = 60  # s, until a page of a folder that is followed is loaded again
NARROW = 5.8  # inches of a chart, whose letters a telephone shows
# greatest rank of a column that a telephone shows, and a printed page
PHONE, PAPER = (2, 6)


def replay_page(
    found: dict[str, Any], again: bool = False, title: str | None = None
) -> str:
    """Return the page of what `clpt replay --json` prints, with one dive at least.

    A page that is written `again` at each dive is loaded again each minute.
    """
    vehicle = found["vehicle"]
    head, mark = "", ""
    if again:
        head = f'<noscript><meta http-equiv="refresh" content="{AGAIN}"></noscript>\n'
        mark = f' data-again="{AGAIN}"'
    body = "\n".join(
        [
            f"<h1>{safe(title or f'{vehicle}: where it comes up next')}</h1>",
            f'<div class="cards"{mark}>{"".join(_cards(found))}</div>',
            paragraphs(wording.coming(found)),
            f'<div class="body"><div><div class="map">{map_svg(found)}',
            f'<div class="buttons"></div></div>{KEYS}<p id="said" class="soft"></p></div>',
            f"<div>{_charts(found)}</div></div>",
            *_paste(found),
            *_table(found),
            *_remarks(found),
        ]
    )
    name = title or f"{vehicle}, dive {found['each_dive'][-1]['dive']}"
    return document(name, body, "replay.css", "replay.js", head)


def _card(title: str, value: str, below: str, style: str = "", time: str = "") -> str:
    """Return a card; hours to a time are counted on by the script."""
    mark = f' data-time="{safe(time)}"' if time else ""
    return (
        f'<section class="card {style}"><h2>{safe(title)}</h2><b>{safe(value)}</b>'
        f"<small{mark}>{safe(below)}</small></section>"
    )


def _cards(found: dict[str, Any]) -> list[str]:
    """Return the headline: when, where, aim, current, speed, how good, marks."""
    ahead, last = found["next_dive"], found["each_dive"][-1]
    time = f"{places.clock(ahead['time'])} {wording.within(ahead)}"
    since, first = wording.from_now(ahead["hours_from_now"]), "first"
    if ahead["now_is"] == "clock":
        title = f"Next surfacing (written {ahead['now'][11:16]} UTC)"
        cards = [_card(title, time, since, first, ahead["time"])]
    else:
        cards = [
            _card("Next surfacing", time, f"{since} from the {ahead['now_is']}", first)
        ]
    where = places.in_degrees(ahead["latitude"], ahead["longitude"])
    near = f"90 % within {cells.half_axes(ahead)} m"
    record = wording.record_sentence(found["headlines"])
    cards.append(_card("Where", ahead["place"], f"{where}; {near}; {record}", first))
    for leg in found["aim"][:1]:
        way = f"to {leg['place']}; {leg['made_good']:.0f} m made good, {leg['state']}"
        cards.append(_card("Aim", wording.heading_words(leg), way, first))
    error = max(last["current_east_error"], last["current_north_error"])
    current = places.velocity(last["current_east"], last["current_north"])
    cards.append(_card(f"Current, dive {last['dive']}", current, f"+- {error:.2f} m/s"))
    if last["speed_factor"] is not None:
        value = f"{last['speed_factor']:.2f} +- {last['speed_factor_error']:.2f}"
        cards.append(_card("Factor on speed", value, "1: as fast as its files say"))
    before = f"previous dive's current: {last['clpe']['previous_dive']:.0f} m"
    before += "" if last["inside_90"] else "; outside the 90 % ellipse"
    cards.append(
        _card(f"Miss, dive {last['dive']}", f"{last['clpe']['adaptive']:.0f} m", before)
    )
    for anomaly in found["anomalies"][-1:]:
        change = f"changed by {anomaly['change']:+z.2f} since dive {anomaly['since']}"
        title = f"Mark of dive {anomaly['dive']}"
        cards.append(_card(title, cells.speed_mark(anomaly), change, "alarm"))
    return cards


def _paste(found: dict[str, Any]) -> list[str]:
    """Return what goes onto the vehicle."""
    one = found.get("paste")
    return (
        [f"<h2>To paste: {safe(one['file'])}</h2>", listing(one["text"])] if one else []
    )


def _charts(found: dict[str, Any]) -> str:
    """Return the misses and what was learned, over time."""
    charts = []
    for name, plot, high, caption in (
        ("clpe", dive_clpe_plot, 0.6, "Miss (CLPE) of each dive, one dive ahead"),
        ("learned", current_plot, 1.0, "Learned, with two standard errors"),
    ):
        figure = figure_of(plot, found)
        figure.set_size_inches(NARROW, NARROW * high)
        svg = inline_svg(figure, name, caption)
        charts.append(f"<figure>{svg}<figcaption>{caption}</figcaption></figure>")
    return "\n".join(charts)


def _table(found: dict[str, Any]) -> list[str]:
    """Return the table, the last dive first."""
    title = "Dives, the last one first: miss (CLPE, m) one dive ahead, currents in m/s"
    rows = found["each_dive"]
    words = [f"dive {row['dive']}: {words_of_dive(row)}" for row in rows]
    marks = [f' id="map-dive{k}" title="{safe(one)}"' for k, one in enumerate(words)]
    return cell_table(
        title, [*map(cells.cells, rows[::-1])], cells.COLUMNS, marks[::-1]
    )


def cell_table(
    title: str,
    rows: Sequence[dict[str, str]],
    columns: cells.Columns,
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
    none = [""] * len(rows)
    for row, mark, link in zip(rows, marks or none, links or none, strict=True):
        texts = [safe(row[title]) for title in titles]
        if link:
            texts[0] = f'<a href="{safe(link)}">{texts[0]}</a>'
        loud = [
            ALARM if row[title].startswith(LOUD) else styles[title] for title in titles
        ]
        each = "".join(
            f"<td{style}>{text}</td>" for style, text in zip(loud, texts, strict=True)
        )
        lines.append(f"<tr{mark}>{each}</tr>")
    return [*lines, "</tbody></table></div>"]


def _style(rank: int) -> str:
    """Return the class of a column: not on a telephone, nor on paper."""
    return "" if rank <= PHONE else f' class="wide{" most" if rank > PAPER else ""}"'


def _remarks(found: dict[str, Any]) -> list[str]:
    lines = [f"<li>{safe(remark)}</li>" for remark in wording.remarks(found)]
    return (
        ["<h2>Learned, noted and skipped</h2>", "<ul>", *lines, "</ul>"]
        if lines
        else []
    )
