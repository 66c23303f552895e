"""A replay as one HTML file, `replay.html`, that works without a net.

Nothing is fetched: style, script, map and charts are in the file, and its Content-Security-Policy
allows that style and script alone.  It is whole without the script, which zooms the map, shows the
dive under the pointer and counts the hours.  Every text is escaped: files may say what they like.
"""

from base64 import b64encode
from collections.abc import Sequence
from hashlib import sha256
from html import escape
from importlib import resources
from typing import Any, NamedTuple

from .exchange import plain
from .page_lines import replay_lines
from .page_map import replay_map
from .wording import compass, in_degrees, velocity

ALARM = ' class="alarm"'
PHONE, PAPER = 2, 6  # greatest rank of a column that a telephone shows, and a printed page


class Told(NamedTuple):
    """What the command says of a replay, for its page.

    `headlines` are sentences on the next surfacing and where to aim; `titles` of columns, with
    their ranks, and `cells`, a row for each dive; `remarks` on what was noted and skipped.
    """

    vehicle: str
    headlines: Sequence[str]
    titles: Sequence[tuple[str, int]]
    cells: Sequence[Sequence[str]]
    remarks: Sequence[str]


def replay_page(found: dict[str, Any], told: Told) -> str:
    """Return the page of what `clpt replay --json` prints, with one dive at least."""
    style, script = (_asset(f"replay.{kind}") for kind in ("css", "js"))
    policy = f"default-src 'none'; style-src {_hash(style)}; script-src {_hash(script)}"
    title = f"{told.vehicle}, dive {found['each_dive'][-1]['dive']}"
    text = "\n".join(
        [
            "<!DOCTYPE html>",
            '<html lang="en"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{_safe(title)}</title>",
            f"<style>{style}</style></head><body>",
            f"<h1>{_safe(told.vehicle)}: where it comes up next</h1>",
            f'<div class="cards">{"".join(_cards(found))}</div>',
            *(f"<p>{_safe(line)}</p>" for line in told.headlines),
            f'<div class="body"><div><div class="map">{replay_map(found)}',
            f'<div class="buttons"></div></div>{_keys(found)}',
            '<p id="said" class="soft"></p></div>',
            f"<div>{replay_lines(found)}</div></div>",
            *_table(found, told),
            *_remarks(told.remarks),
            f"<script>{script}</script></body></html>",
        ]
    )
    return text + "\n"


def _safe(text: object) -> str:
    return escape(plain(text))


def _asset(name: str) -> str:
    return (resources.files("clpt_control") / "data" / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


def _card(title: str, value: str, below: str, style: str = "") -> str:
    return (
        f'<section class="card {style}"><h2>{_safe(title)}</h2><b>{_safe(value)}</b>'
        f"<small>{below}</small></section>"
    )


def _cards(found: dict[str, Any]) -> list[str]:
    """Return the headline: when, where, aim, current, speed, how good, marks."""
    ahead, last = found["next_dive"], found["each_dive"][-1]
    time = f"{ahead['time'][:10]} {ahead['time'][11:16]} UTC"
    if ahead["now_is"] == "clock":
        since = f'<span data-time="{_safe(ahead["time"])}">{ahead["hours_from_now"]:+.1f} h</span>'
        since += f"; written {_safe(ahead['now'][11:16])} UTC"
    else:
        since = f"{ahead['hours_from_now']:.1f} h after the {_safe(ahead['now_is'])}"
    half = f"{ahead['ellipse_90_long']:.0f} x {ahead['ellipse_90_short']:.0f} m"
    cards = [
        _card("Next surfacing", time, since, "first"),
        _card(
            "Where",
            ahead["place"],
            f"{_safe(in_degrees(ahead['latitude'], ahead['longitude']))}; 90 % within {half}",
            "first",
        ),
        *(_aim(leg) for leg in (found.get("aim") or [])[:1]),
    ]
    error = max(last["current_east_error"], last["current_north_error"])
    current = velocity(last["current_east"], last["current_north"])
    cards.append(_card(f"Current, dive {last['dive']}", current, f"+- {error:.2f} m/s"))
    if last["speed_factor"] is not None:
        value = f"{last['speed_factor']:.2f} +- {last['speed_factor_error']:.2f}"
        cards.append(_card("Factor on speed", value, "1: as fast as its files say"))
    miss = f"{last['clpe']['adaptive']:.0f} m"
    before = f"previous dive's current: {last['clpe']['previous_dive']:.0f} m"
    inside = "" if last["inside_90"] else "; outside the 90 % ellipse"
    cards.append(_card(f"Miss, dive {last['dive']}", miss, before + inside))
    for anomaly in found["anomalies"][-1:]:
        mark = "SPEED" if anomaly["certain"] else "SPEED?"
        said = f"changed by {anomaly['change']:+.2f} since dive {anomaly['since']}"
        cards.append(_card(f"Mark of dive {anomaly['dive']}", mark, said, "alarm"))
    return cards


def _aim(leg: dict[str, Any]) -> str:
    heading, magnetic = leg["heading"], leg["heading_magnetic"]
    value = "stay" if heading is None else f"heading {compass(heading)}"
    if magnetic is not None:
        value += f" (mag {compass(magnetic)})"
    below = f"to {_safe(leg['place'])}; {leg['made_good']:.0f} m made good, {_safe(leg['state'])}"
    return _card("Aim", value, below, "first")


def _keys(found: dict[str, Any]) -> str:
    """Return the legend of the map."""
    keys = [("c", "fix to fix"), ("miss", "miss, from x, the dead-reckoned end")]
    keys += [("ring", "+ forecast, 90 %"), ("next", "next surfacing, 90 %")]
    keys += (
        [("aim", "to the waypoint"), ("made", "aimed: way made good, 90 %")]
        if found.get("aim")
        else []
    )
    return (
        '<p class="keys">'
        + " ".join(f'<span class="key {style}">{_safe(name)}</span>' for style, name in keys)
        + "</p>"
    )


def _table(found: dict[str, Any], told: Told) -> list[str]:
    """Return the table, the last dive first, columns of rank 0 before others."""
    order = sorted(range(len(told.titles)), key=lambda k: told.titles[k][1] > 0)
    styles = [_shown_on(rank) for _, rank in told.titles]
    names = [f"<th{styles[k]}>{_safe(told.titles[k][0])}</th>" for k in order]
    lines = [
        "<h2>Dives, the last one first: miss (CLPE, m) one dive ahead, currents in m/s</h2>",
        f'<div class="table"><table><thead><tr>{"".join(names)}</tr></thead><tbody>',
    ]
    for row, cells in list(zip(found["each_dive"], told.cells, strict=True))[::-1]:
        made = []
        for k in order:
            loud = cells[k] == "OUT" or cells[k].startswith("SPEED")
            made.append(f"<td{ALARM if loud else styles[k]}>{_safe(cells[k])}</td>")
        lines.append(f'<tr data-dive="{_safe(row["dive"])}">{"".join(made)}</tr>')
    return [*lines, "</tbody></table></div>"]


def _shown_on(rank: int) -> str:
    """Return the class of a column: not on a telephone, nor on paper."""
    return "" if rank <= PHONE else f' class="wide{" most" if rank > PAPER else ""}"'


def _remarks(remarks: Sequence[str]) -> list[str]:
    if not remarks:
        return []
    lines = [f"<li>{_safe(remark)}</li>" for remark in remarks]
    return ["<h2>Learned, noted and skipped</h2>", "<ul>", *lines, "</ul>"]
