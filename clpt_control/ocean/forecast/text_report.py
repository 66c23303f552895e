"""A replay in sentences, made of what `clpt replay --json` prints."""

from typing import Any

from ..estimation.fix_model import PERCENT
from .table_rows import (
    AGAINST,
    BASES,
    REACHED,
    UNDER_WAY,
    against,
    clock,
    compass,
    ellipse_words,
    heading_words,
    place,
    when,
    wide,
)


def next_surfacing(ahead: dict[str, Any]) -> str:
    """Return the sentence on `NextDive.as_dict`."""
    remarks = "".join(
        f"; {remark}" for remark in (wide(ahead), uncovered(ahead)) if remark
    )
    return (
        f"next surfacing {when(ahead)}, "
        f"after {ahead['duration'] / 3600:.2f} h and {ahead['dr_east']:+z.0f} m "
        f"east, {ahead['dr_north']:+z.0f} m north through the water ({BASES[ahead['basis']]}): "
        f"{place(ahead['latitude'], ahead['longitude'])}, {ellipse_words(ahead)}{remarks}"
    )


def uncovered(ahead: dict[str, Any]) -> str:
    """Return why the flow model does not cover the next dive, empty if it does."""
    why = ahead["why_uncovered"]
    return f"the flow model does not cover the next dive: {why}" if why else ""


def record_sentence(forecast: dict[str, Any]) -> str:
    """Return how many surfacings were as forecast.

    >>> record_sentence({"judged": 13, "inside": 12, "on_time": 13})
    'forecast, made before the dive: 12 of 13 inside their 90 % ellipse, 13 within their 90 % time'
    """
    count = forecast["judged"]
    if not count:
        return "no forecast has been checked yet: ellipse and time are those of any vehicle"
    inside = f"{forecast['inside']} of {count} inside their {PERCENT} ellipse"
    on_time = f"{forecast['on_time']} within their {PERCENT} time"
    return f"forecast, made before the dive: {inside}, {on_time}"


def aim_sentence(leg: dict[str, Any]) -> str:
    """Return the sentence on `Aim.as_dict`."""
    text, made_good = (
        f"aim at {place(leg['latitude'], leg['longitude'])}, ",
        leg["made_good"],
    )
    if leg["bearing"] is not None:
        text += f"{leg['distance'] / 1000:.1f} km to {compass(leg['bearing'])}: "
    if leg["state"] == AGAINST:
        text += f"{against(leg)}; best "
    text += heading_words(leg)
    if leg["crab"] is not None:
        text += f", crab {leg['crab']:+z.0f}"
    full = f"{leg['through_water_full']:.0f} m"
    if leg["state"] == REACHED:
        through_water = f"{leg['through_water']:.0f} of {full} through the water"
        text += f", {through_water}; there at {clock(leg['end'])}"
    else:
        text += (
            f", {made_good:.0f} m made good of {full}"
            if made_good >= 0
            else f", {-made_good:.0f} m are lost"
        )
        text += f", then {leg['left'] / 1000:.1f} km"
    if leg["state"] == UNDER_WAY:
        text += f"; there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h"
    error = f"expected position error {leg['expected_miss']:.0f} m"
    return f"{text}; {error}, {ellipse_words(leg)}"


def coming(report: dict[str, Any]) -> list[str]:
    """Return what comes of what `--json` prints: the next surfacing, aims, the route."""
    first = [next_surfacing(report["next_dive"])] if report["next_dive"] else []
    return first + _legs_and_route(report, 0)


def beyond_cards(report: dict[str, Any]) -> list[str]:
    """Return sentences on what no card has: later legs and the route."""
    why = uncovered(report["next_dive"])
    return ([why] if why else []) + _legs_and_route(report, 1)


def _legs_and_route(report: dict[str, Any], first: int) -> list[str]:
    """Return the sentences on aims from the first one on, and on the route."""
    legs = [*map(aim_sentence, report["aim"][first:])]
    return legs + (route_sentences(report["route"]) if "route" in report else [])


def route_sentences(route: dict[str, Any]) -> list[str]:
    """Return a sentence for each waypoint of a route, and for each area."""
    lines = []
    for waypoint in route["waypoints"]:
        times = [
            clock(waypoint[key]) if waypoint[key] else ""
            for key in ("not_before", "time", "by")
        ]
        early, middle, late = times
        text = f"there {middle}" if middle else "not there"
        text += f"; cannot be made before {early} (90 %)" if early else ""
        text += f", made by {late} (90 %)" if late else ""
        if waypoint["made"] < 1:
            share = f"{100 * waypoint['made']:.0f} % of {route['draws']} draws"
            text += f"; made within {route['dives']} dives in {share}"
        lines.append(f"route to {waypoint['place']}: {text}")
    entered = ((area["name"], 100 * area["entered"]) for area in route["areas"])
    return lines + [
        f"{name}: entered in {share:.0f} % of the draws" for name, share in entered
    ]


def remarks(summary: dict[str, Any]) -> list[str]:
    """Return lines on what was learned, noted and skipped, of what `--json` prints."""
    lines: list[str] = []
    if "flow_model" in summary and summary["each_dive"]:
        lines += coverage(summary["flow_model"], summary["used"])
    if summary["dac_identity_median"] is not None:
        lines.append(
            "position error / duration differs from the file's depth-averaged current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if summary["each_dive"]:
        lines.append(record_sentence(summary["forecast"]))
        lines.append(
            "hindsight, with the dead reckoning and duration of each dive: "
            "{inside} of {judged} inside".format(**summary["hindsight"])
        )
        if summary["parts"]:
            chances = ", ".join(
                f"{name} {p:.2f}" for name, p in summary["parts"].items()
            )
            lines.append(f"probability that a part is present: {chances}")
        lines.append(f"learned: {summary['said']}")
    if summary["held"]:
        lines.append(f"not yet known from these dives: {', '.join(summary['held'])}")
    lines += by_reason(summary["notes"], "note")
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        lines.append(f"skipped {name}: {entry['why']}")
    return lines


def coverage(model: dict[str, Any], used: int) -> list[str]:
    """Return lines that say which dives a flow model covers, and why not the others.

    >>> none = {"dive": 7, "why": "outside the forecast's area"}
    >>> model = {"source": "f.nc", "about": "gridded", "covered": 3, "uncovered": [none]}
    >>> for line in coverage(model, 4):
    ...     print(line)
    flow model f.nc (gridded) covers 3 of 4 dives
    no flow model for dive 7: outside the forecast's area
    """
    lines = [
        f"flow model {model['source']} ({model['about']}) covers {model['covered']} of {used} dives"
    ]
    return [*lines, *by_reason(model["uncovered"], "why", "no flow model for ")]


def by_reason(entries: list[dict[str, Any]], key: str, before: str = "") -> list[str]:
    """Return a line for each reason, with the dives that share it.

    >>> by_reason([{"dive": 3, "note": "odd"}, {"dive": 5, "note": "odd"}], "note")
    ['dives 3, 5: odd']
    """
    reasons: dict[str, list[str]] = {}
    for entry in entries:
        reasons.setdefault(entry[key], []).append(str(entry["dive"]))
    lines = []
    for why, dives in reasons.items():
        named = f"dive{'s'[: len(dives) > 1]} {', '.join(dives)}"
        if len(dives) > 6:
            named = f"{len(dives)} dives from {dives[0]} to {dives[-1]}"
        lines.append(f"{before}{named}: {why}")
    return lines
