"""What `clpt replay` is asked of dives to come: `--next`, `--aim`, and how it says them."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import hypot
from typing import Any

import typer

from .help_pages import Command

PAIR = re.compile(r"\s*[-+.\d]+\s+[-+.\d]+\s*")  # both numbers quoted as one word
CLOSE = 1000.0  # m; who is so close to a waypoint goes on to the next one


class WithPlaces(Command):
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
