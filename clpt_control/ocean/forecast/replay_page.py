"""Page of a replay, `replay.html`: cards, map, charts and the table of dives.

Its script zooms the map, shows the dive under the pointer, counts the hours and marks a vehicle
that becomes overdue.
"""

from collections.abc import Sequence

from ...base.figures import legend_below
from ...base.html import Result, listing, safe, unbroken
from ...base.page import Page, Section, drawn
from ..estimation.fix_model import PERCENT
from . import replay_summary, table_rows
from .cards import cards, time_of_computing
from .map_layers import layers_of, words_of_dive
from .plots import current_plot, dive_clpe_plot
from .track_map import map_svg

KEYS = {  # kind of a layer: its text in the legend of the map
    "track": "fix to fix",
    "drift": "drift at the surface",
    "miss": "position error, from x, the dead-reckoned end",
    "ring": f"+ forecast, {PERCENT} ellipse",
    "next": f"next surfacing, {PERCENT} ellipse",
    "target": "waypoint",
    "made": f"aimed: distance made good, {PERCENT} ellipse",
}
AGAIN = 60  # s, until a page of a folder that is followed is loaded again
LEGEND_COLUMNS = 2


def replay_page(
    report: table_rows.Report, again: bool = False, title: str | None = None
) -> Page:
    """Return the page of what `clpt replay --json` prints, with one dive at least.

    A page that is written `again` at each dive is loaded again each minute.
    """
    later = map(unbroken, replay_summary.beyond_cards(report))
    lead = [
        time_of_computing(report),
        f'<div class="cards">{"".join(cards(report))}</div>',
        *(f"<p>{sentence}</p>" for sentence in later),
    ]
    clpe = "Position error (CLPE) of each dive, one dive ahead"
    errors = drawn("clpe", 2.9, clpe, dive_clpe_plot, report)
    legend_below(errors.figure.axes[0], LEGEND_COLUMNS)
    learned = "Learned, with two standard errors"
    charts = [errors, drawn("learned", 4.8, learned, current_plot, report)]
    upload = report.get("paste")
    remarks = replay_summary.remarks(report)
    sections = [Section("track", "Track", figures=charts, more=_map(report))]
    if upload:
        heading = f"To paste: {upload['file']}"
        sections.append(Section("paste", heading, more=listing(upload["text"])))
    heading = "Learned parameters, notes and skipped dives"
    sections += [
        Section("dives", "Dives, the last one first", _dives(report["each_dive"])),
        Section("remarks", heading, Result(sentences=remarks)),
    ]
    return Page(
        "Replay of a glider's dives",
        title or f"{report['vehicle']}: next surfacing",
        [replay_summary.next_surfacing(report["next_dive"])],
        [],
        sections,
        "\n".join(lead),
        ("clock.js", "replay.js"),
        AGAIN * again,
    )


def _map(report: table_rows.Report) -> str:
    """Return the map with its buttons, and the legend of what it shows."""
    layers = layers_of(report)
    entries = [(kind, name) for kind, name in KEYS.items() if layers[kind]]
    if any(map(table_rows.is_outside, report["each_dive"])):
        entries.append(("outside", f"fix outside its {PERCENT} ellipse"))
    keys = (f'<span class="key {kind}">{name}</span>' for kind, name in entries)
    return (
        f'<div><div class="map">{map_svg(report)}<div class="buttons"></div></div>'
        f'{"".join(keys)}<p id="said" class="soft"></p></div>'
    )


def _dives(rows: list[table_rows.Row]) -> Result:
    """Return the table of dives, the last one first."""
    words = [f"dive {row['dive']}: {words_of_dive(row)}" for row in rows]
    marks = [f' id="map-dive{k}" title="{safe(text)}"' for k, text in enumerate(words)]
    cells = [*map(table_rows.cells, rows[::-1])]
    return ranked_table(table_rows.TITLE, cells, table_rows.COLUMNS, marks[::-1])


def ranked_table(
    title: str,
    rows: Sequence[dict[str, str]],
    columns: table_rows.Columns,
    attributes: Sequence[str],
    links: Sequence[str | None] = (),
) -> Result:
    """Return a table of cells by title, columns of rank 0 before others."""
    titles = sorted(rows[0], key=lambda title: columns[title][0] > 0)
    cells = [[row[title] for title in titles] for row in rows]
    ranks = [columns[title][0] for title in titles]
    return Result(title, titles, cells, (), ranks, attributes, links)
