"""Numbers over time as small SVG charts: misses, current, speed."""

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from math import ceil, floor, log10
from typing import Any, NamedTuple

from ..html.text import safe
from ..units import seconds_since_1970

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 640.0, 190.0, 52.0, 24.0, 8.0
DAYS = (0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000)  # between ticks
TICKS = 5
DAY = 86400.0
ERRORS = 2.0  # standard errors in a band
MODELS = {
    "no_flow": ("no flow", "a"),
    "previous_dive": ("previous dive's current", "b"),
    "adaptive": ("forecast", "c"),
    "flow_model": ("flow model", "d"),
}


class Series(NamedTuple):
    """Values over the dives, None where there is none, with standard errors or without."""

    name: str
    style: str
    values: Sequence[float | None]
    errors: Sequence[float] | None = None


def replay_lines(found: dict[str, Any]) -> str:
    """Return the charts of what `clpt replay --json` prints, with one dive at least."""
    rows = found["each_dive"]
    times = [seconds_since_1970(row["end"]) for row in rows]
    misses = [
        Series(*MODELS[model], [row["clpe"][model] for row in rows]) for model in rows[0]["clpe"]
    ]
    current = [
        Series(
            axis,
            style,
            [row[f"current_{axis}"] for row in rows],
            [row[f"current_{axis}_error"] for row in rows],
        )
        for axis, style in (("east", "c"), ("north", "b"))
    ]
    charts = [
        line_chart("Miss (CLPE, m)", times, misses, 0.0),
        line_chart("Learned current (m/s; band: 2 standard errors)", times, current, 0.0),
    ]
    if rows[0]["speed_factor"] is not None:
        values = [row["speed_factor"] for row in rows]
        speed = Series("factor", "d", values, [row["speed_factor_error"] for row in rows])
        charts.append(line_chart("Factor on speed (band: 2 standard errors)", times, [speed], 1.0))
    return "\n".join(charts)


def line_chart(title: str, times: Sequence[float], series: list[Series], base: float) -> str:
    """Return a chart of series over times, s since 1970; a line stands at the base."""
    known = [base]
    for one in series:
        errors = one.errors or [0.0] * len(times)
        for value, error in zip(one.values, errors, strict=True):
            if value is not None:
                known += [value - ERRORS * error, value + ERRORS * error]
    low, high = min(known), max(known)
    if high == low:
        low, high = low - 0.5, high + 0.5
    begin, end = times[0], max(times[-1], times[0] + 3600)

    def x(time: float) -> float:
        return LEFT + (WIDTH - LEFT - 8) * (time - begin) / (end - begin)

    def y(value: float) -> float:
        return HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (value - low) / (high - low)

    drawn = []
    for value in ticks(low, high):
        style = "base" if value == base else "grid"
        drawn.append(f'<path class="{style}" d="M{LEFT:g} {y(value):.1f}H{WIDTH - 8:g}"/>')
        drawn.append(_text(LEFT - 6, y(value) + 4, "end", f"{value:g}"))
    for time, name in dates(begin, end):
        drawn.append(f'<path class="grid" d="M{x(time):.1f} {TOP:g}V{HEIGHT - BOTTOM:g}"/>')
        drawn.append(_text(x(time), HEIGHT - 7, "middle", name))
    for one in series:
        points = [
            (x(t), y(value), y(value - ERRORS * e), y(value + ERRORS * e))
            for t, value, e in zip(times, one.values, one.errors or [0.0] * len(times), strict=True)
            if value is not None
        ]
        if one.errors is not None:
            band = [f"{p[0]:.1f} {p[3]:.1f}" for p in points]
            band += [f"{p[0]:.1f} {p[2]:.1f}" for p in reversed(points)]
            drawn.append(f'<path class="band {one.style}" d="M{"L".join(band)}Z"/>')
        if points:
            way = "L".join(f"{p[0]:.1f} {p[1]:.1f}" for p in points)
            drawn.append(f'<path class="line {one.style}" d="M{way}"/>')
        drawn += [
            f'<circle class="dot {one.style}" cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="2.4"/>'
            for p in points
        ]
    keys = " ".join(f'<span class="key {one.style}">{safe(one.name)}</span>' for one in series[:9])
    return (
        f'<figure><figcaption>{safe(title)} <span class="keys">{keys}</span></figcaption>'
        f'<svg class="lines" viewBox="0 0 {WIDTH:g} {HEIGHT:g}" role="img" '
        f'aria-label="{safe(title)}">' + "".join(drawn) + "</svg></figure>"
    )


def _text(x: float, y: float, anchor: str, text: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{safe(text)}</text>'


def ticks(low: float, high: float) -> list[float]:
    """Return round values in an interval.

    >>> ticks(-0.13, 0.29)
    [-0.1, 0.0, 0.1, 0.2]
    """
    rough = (high - low) / TICKS
    power = 10.0 ** floor(log10(rough))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= rough * 0.999)
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]


def dates(begin: float, end: float) -> list[tuple[float, str]]:
    """Return round times between two (s since 1970), and how an axis names them.

    >>> dates(1454277890.0, 1454500000.0)
    [(1454284800.0, '1 Feb'), (1454371200.0, '2 Feb'), (1454457600.0, '3 Feb')]
    """
    days = next((d for d in DAYS if d * DAY * TICKS >= end - begin), DAYS[-1])
    step = days * DAY
    times = [k * step for k in range(ceil(begin / step), floor(end / step) + 1)]
    return [(time, _date(time, days)) for time in times]


def _date(time: float, days: float) -> str:
    date = datetime(1970, 1, 1, tzinfo=UTC) + timedelta(seconds=time)
    day = f"{date.day} {date:%b}"
    if days >= 200:
        return f"{date:%b} {date.year}"
    return f"{day} {date:%H:%M}" if days < 1 and date.hour else day
