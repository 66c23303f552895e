"""What `clpt replay` is asked of dives to come: `--next`, `--aim`, and how it says them."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import hypot
from typing import Any

import typer
from typer.core import TyperCommand

PAIR = re.compile(r"\s*[-+.\d]+\s+[-+.\d]+\s*")  # both numbers quoted as one word
CLOSE = 1000.0  # m; who is so close to a waypoint goes on to the next one


class WithPlaces(TyperCommand):
    """A command whose option `--aim LAT LON` may be given more than once."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the two words after each `--aim` as one."""
        return super().parse_args(ctx, joined(args))


def joined(args: Sequence[str]) -> list[str]:
    """Return words in which a waypoint is one word.

    >>> joined(["a.nc", "--aim", "-43.1", "8.5", "--json"])
    ['a.nc', '--aim=-43.1,8.5', '--json']
    """
    found, rest = [], list(args)
    while rest:
        word = rest.pop(0)
        if word == "--aim" and rest and "," not in rest[0] and not PAIR.fullmatch(rest[0]):
            word = "--aim=" + ",".join(rest[:2])
            rest = rest[2:]
        found.append(word)
    return found


def waypoint(text: str) -> tuple[float, float]:
    """Return the place that an option gives, degrees."""
    try:
        lat, lon = map(float, text.replace(",", " ").split())
    except ValueError:
        raise typer.BadParameter(
            f"--aim {text.replace(',', ' ')}: must be a latitude and a longitude in decimal "
            "degrees, such as --aim -43.05 8.40"
        ) from None
    return lat, lon


@dataclass
class Ahead:
    """Plan of the next dive (s; m east, m north), and waypoints to aim at, in their order.

    Speed (m/s), hours and variation (degrees east) are for aiming. `follows`: what the dives so
    far do not allow is said, and work goes on.
    """

    plan: tuple = ()
    targets: list[tuple[float, float]] = field(default_factory=list)
    speed: float | None = None
    hours: float | None = None
    variation: float | None = None
    follows: bool = False

    def check(self) -> None:
        """Refuse what cannot be, before work begins."""
        from ..errors import ScenarioError
        from ..replay.aim import check_speed, checked_target
        from ..replay.surfacing import check_plan

        if self.plan:
            check_plan(*self.plan)
        if not self.targets and (self.speed, self.hours) != (None, None):
            raise ScenarioError("--speed and --hours are for --aim LAT LON; give a waypoint")
        for target in self.targets:
            checked_target(*target)
        hours = 1.0 if self.hours is None else self.hours
        check_speed(1.0 if self.speed is None else self.speed, 3600 * hours)

    def next_dive(self, replay: Any) -> Any:
        """Return the `NextDive` of a replay."""
        from ..replay.surfacing import next_dive

        return next_dive(replay, *self.plan)

    def aims(self, replay: Any) -> list[Any]:
        """Return an `Aim` for each waypoint ahead; those that were come close to are dropped."""
        from ..errors import ScenarioError
        from ..geodesy import displacement
        from ..replay.aim import aims

        last = replay.steps[-1].dive
        fix = last.lat_gpse, last.lon_gpse
        while len(self.targets) > 1 and hypot(*displacement(*fix, *self.targets[0])) < CLOSE:
            self.targets.pop(0)
        duration = None if self.hours is None else 3600 * self.hours
        if not self.targets:
            return []
        try:
            return aims(replay, self.targets, self.speed, duration, self.variation)
        except ScenarioError as error:
            if not self.follows:
                raise
            typer.echo(f"so far, {error}", err=True)
            return []


def next_surfacing(ahead: dict[str, Any]) -> str:
    """Return the sentence on `NextDive.as_dict`."""
    from ..replay.wording import place

    uncovered = ahead["flow_model_covers"] is False
    return (
        f"next surfacing {when(ahead)}, "
        f"after {ahead['duration'] / 3600:.2f} h and {ahead['dr_east']:+.0f} m "
        f"east, {ahead['dr_north']:+.0f} m north through the water: "
        f"{place(ahead['latitude'], ahead['longitude'])}, 90 % within "
        f"{ahead['ellipse_90_long']:.0f} x {ahead['ellipse_90_short']:.0f} m"
        + (f"; the flow model does not cover it: {ahead['why_uncovered']}" if uncovered else "")
    )


def when(ahead: dict[str, Any]) -> str:
    """Return when the next surfacing is, of `NextDive.as_dict`.

    >>> when({"time": "2016-02-03T14:19:59Z", "hours_from_now": 4.5, "now_is": "clock"})
    '2016-02-03 14:19 UTC, in 4.5 h'
    """
    from ..replay.wording import from_now

    said = f"{ahead['time'][:10]} {ahead['time'][11:16]} UTC, {from_now(ahead['hours_from_now'])}"
    return said if ahead["now_is"] == "clock" else f"{said} from the {ahead['now_is']}"


def aimed(leg: dict[str, Any]) -> str:
    """Return the sentence on `Aim.as_dict`."""
    from ..replay.aim import AGAINST, REACHED
    from ..replay.wording import compass, place, velocity

    if leg["bearing"] is None:
        bears = "here"
    else:
        bears = f"{leg['distance'] / 1000:.1f} km to {compass(leg['bearing'])}"
    said = f"aim at {place(leg['latitude'], leg['longitude'])}, {bears}: "
    against = leg["state"] == AGAINST
    if against:
        current = velocity(leg["current_east"], leg["current_north"])
        said += (
            f"cannot be made against the current, {current}, at {leg['speed_expected']:.2f} m/s; "
            "best "
        )
    if leg["heading"] is None:
        said += "stay"
    else:
        said += f"heading {compass(leg['heading'])}"
        if leg["heading_magnetic"] is not None:
            said += f" (magnetic {compass(leg['heading_magnetic'])})"
        if leg["crab"] is not None:
            said += f", crab {leg['crab']:+.0f}"
    full = f"{leg['through_water_full']:.0f} m"
    if leg["state"] == REACHED:
        said += f", {leg['through_water']:.0f} of {full} through the water; there at {_end(leg)}"
    else:
        made = leg["made_good"]
        said += f", {made:.0f} m made good of {full}" if made >= 0 else f", {-made:.0f} m are lost"
        said += f", then {leg['left'] / 1000:.1f} km"
        said += "" if against else f"; there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h"
    return (
        f"{said}; expected miss {leg['expected_miss']:.0f} m, 90 % within "
        f"{leg['ellipse_90_long']:.0f} x {leg['ellipse_90_short']:.0f} m"
    )


def _end(leg: dict[str, Any]) -> str:
    return f"{leg['end'][:10]} {leg['end'][11:16]} UTC"
