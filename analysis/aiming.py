"""Does aiming off bring a glider nearer to its waypoint than steering for it?

For each dive after the first, a waypoint is set on eight bearings, at half the way
that the dive made through the water.  One pilot steers for it, as far as it is, and
ignores the current; one aims off by the current of the dive before, with the speed and
compass that the replay has learned; the last by `Replay.aims`, from all earlier dives.
Each then flies the dive's true current: where a way d through the water ends is (I + M) d + c, with
c = miss - M d of the dive as it was flown, M speed factor and compass error that
the whole record tells.  A waypoint far away on the same bearings says how far off the
line they come, and how much nearer, over the whole way of the dive.

    python -m analysis.aiming [FILES...] [--out FOLDER]
"""

from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from clpt_control.gliders import Dive, read_dives, sample_dives
from clpt_control.replay import Replay, replay_dives

from .study import BLUE, ORANGE, leave, new_figure, place_from, progress_bar

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BEARINGS = np.arange(0, 360, 45)
PILOTS = ("steered", "by the dive before", "aimed")
FAR = 200e3  # m


def own_errors(replay: Replay) -> np.ndarray:
    """Return I + M that a replay has learned: what a reckoned way really is."""
    f, psi = replay.steps[-1].speed, np.radians(replay.steps[-1].compass)
    return np.array([[f, psi], [-psi, f]])


def record(dives: list[Dive]) -> np.ndarray:
    """Return distances (m) at each dive's end, and crab angles.

    Shape (dives - 1, 8, 10), each by `PILOTS`: to the near waypoint, off the line to the far
    one, nearer to it; the crab angle of the last, degrees.
    """
    true = own_errors(replay_dives(dives))
    replay, found = replay_dives(dives[:1]), []
    with progress_bar("aiming", len(dives) - 1) as report:
        for k, (before, dive) in enumerate(pairwise(dives)):
            found.append(
                [_flown(replay, before, dive, true, a) for a in np.radians(BEARINGS)]
            )
            replay.step(dive)
            report(k + 1)
    return np.array(found)


def aimed_off(away: np.ndarray, drift: np.ndarray, full: float) -> np.ndarray:
    """Return the way through the water, `full` at most, that a drift brings to a place or its line.

    >>> aimed_off(np.array([0.0, 10.0]), np.array([3.0, 6.0]), 5.0)
    array([-3.,  4.])
    """
    line = away / np.hypot(*away)
    across = np.array([line[1], -line[0]])
    off = -np.clip(drift @ across, -full, full)
    along = min(float((away - drift) @ line), float(np.sqrt(full**2 - off**2)))
    return off * across + along * line


def current_of(dive: Dive, own: np.ndarray) -> np.ndarray:
    """Return what the water did in a dive, m, with the errors I + M of its own."""
    return np.array([dive.miss_east, dive.miss_north]) - (
        (own - np.eye(2)) @ dive.through_water
    )


def _flown(
    replay: Replay, before: Dive, dive: Dive, true: np.ndarray, angle: float
) -> list[float]:
    """Fly one dive to waypoints on one bearing, as `record` has it."""
    flown, current = np.array(dive.through_water), current_of(dive, true)
    known = own_errors(replay)
    drift = current_of(before, known) * dive.duration / before.duration
    line = np.array([np.sin(angle), np.cos(angle)])
    across = np.array([line[1], -line[0]])
    start = dive.t_gps2, *dive.start
    full = float(np.hypot(*flown))
    near: list[np.ndarray] = []
    far: list[np.ndarray] = []
    crab = 0.0
    for away, ends in ((full / 2, near), (FAR, far)):
        target = place_from(*start[1:], *(away * line))
        speed = full / dive.duration
        (leg,) = replay.aims([target], speed, dive.duration, variation=0.0, start=start)
        plan, crab = leg.ahead.plan, leg.crab or 0.0
        real = aimed_off(away * line, drift, full * np.sqrt(np.linalg.det(known)))
        ways = min(away, full) * line, np.linalg.solve(known, real)
        for way in (*ways, np.array(plan.through_water)):
            ends.append(true @ way + current)
    return [
        *(float(np.hypot(*(end - full / 2 * line))) for end in near),
        *(abs(float(end @ across)) for end in far),
        *(float(end @ line) for end in far),
        abs(crab),
    ]


def main(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Records, one each.")
    ] = None,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/aiming"),
) -> None:
    """Leave aiming.md and aiming.png."""
    records = {"SG542": sample_dives()}
    records |= {path.stem: read_dives([path])[0] for path in files or []}
    found = {name: record(dives) for name, dives in records.items()}
    lines = [
        f"| vehicle | dives | to the waypoint, {' (m) | '.join(PILOTS)} (m) | aimed to steered "
        f"| aimed to before | off a long line, {' (m) | '.join(PILOTS)} (m) "
        f"| made good, {' (m) | '.join(PILOTS)} (m) | crab |",
        "|---" * 14 + "|",
    ]
    every = {"all": np.concatenate(list(found.values()))} if len(found) > 1 else {}
    for name, sizes in {**found, **every}.items():
        m = np.median(sizes.reshape(-1, 10), axis=0)
        cells = [f"{v:.0f}" for v in m]
        cells[3:3] = [f"{m[2] / m[0]:.2f}", f"{m[2] / m[1]:.2f}"]
        lines.append(f"| {name} | {len(sizes)} | {' | '.join(cells)} |")
    leave(out, "aiming", "\n".join(lines) + "\n", _drawn(found))
    typer.echo("\n".join(lines))


def _drawn(found: dict[str, np.ndarray]) -> "Figure":
    """Draw the share of dives that end within a distance, by pilot."""
    figure, axes = new_figure(
        2.2 + 2.6 * len(found), 3.6, ncols=len(found), squeeze=False
    )
    for ax, (name, sizes) in zip(axes[0], found.items(), strict=True):
        for column, (style, colour) in enumerate(
            (("--", ORANGE), (":", "black"), ("-", BLUE))
        ):
            distance = np.sort(sizes[..., column].ravel()) / 1000
            share = np.arange(1, len(distance) + 1) / len(distance)
            ax.step(
                distance,
                100 * share,
                style,
                color=colour,
                label=PILOTS[column],
                where="post",
            )
        ax.axhline(50, color="black", lw=0.5)
        ax.set(xlabel="distance to the waypoint (km)", xlim=(0, None), ylim=(0, 100))
        ax.set_title(name, loc="left", fontsize=10)
    axes[0, 0].set_ylabel("ends within it (%)")
    axes[0, 0].legend(fontsize=8, frameon=False, loc="lower right")
    return figure


if __name__ == "__main__":
    typer.run(main)
