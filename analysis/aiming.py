"""Does aiming off bring a glider nearer to its waypoint than steering for it?

For each dive after the first, a waypoint is set on eight bearings, at half the way
that the dive made through the water.  One pilot steers for it, as far as it is; the
other by `clpt.replay.aims`, from the earlier dives alone.  Both then fly the dive's
true current: where a way d through the water ends is (I + M) d + c, with
c = miss - M d of the dive as it was flown, M speed factor and compass error that
the whole record tells.  A waypoint far away on the same bearings says how far off the
line both come, and how much nearer, over the whole way of the dive.

    python -m analysis.aiming [FILES...] [--out FOLDER]
"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from clpt_control.estimation.dive import miss
from clpt_control.figures import BLUE, ORANGE, new_figure
from clpt_control.files import make_folder, write_figure, write_text
from clpt_control.geodesy import place_from
from clpt_control.gliders import Dive, read_dives, sample_dives, usable
from clpt_control.progress import progress_bar
from clpt_control.replay import Replay, replay_dives
from clpt_control.replay.aim import aim

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BEARINGS = np.arange(0, 360, 45)
FAR = 200e3  # m


def own_errors(replay: Replay) -> np.ndarray:
    """Return I + M that a replay has learned: what a reckoned way really is."""
    f, psi = replay.steps[-1].speed, np.radians(replay.steps[-1].compass)
    return np.array([[f, psi], [-psi, f]])


def record(dives: list[Dive]) -> np.ndarray:
    """Return distances (m) at each dive's end, and crab angles.

    Shape (dives - 1, 8, 7): to the near waypoint by bearing and aimed, off the line to the
    far one by bearing and aimed, nearer to it by bearing and aimed; the crab angle, degrees.
    """
    true = own_errors(replay_dives(dives))
    replay, found = replay_dives(dives[:1]), []
    with progress_bar("aiming", len(dives) - 1) as report:
        for k, dive in enumerate(dives[1:]):
            found.append([_flown(replay, dive, true, angle) for angle in np.radians(BEARINGS)])
            replay.step(dive)
            report(k + 1)
    return np.array(found)


def _flown(replay: Replay, dive: Dive, true: np.ndarray, angle: float) -> list[float]:
    """Fly one dive to waypoints on one bearing, as `record` has it."""
    flown = np.array([dive.dr_east, dive.dr_north])
    current = miss(dive) - (true - np.eye(2)) @ flown
    line = np.array([np.sin(angle), np.cos(angle)])
    across = np.array([line[1], -line[0]])
    start = dive.t_gps2, dive.lat_gps2, dive.lon_gps2
    full = float(np.hypot(*flown))
    near: list[np.ndarray] = []
    far: list[np.ndarray] = []
    crab = 0.0
    for away, ends in ((full / 2, near), (FAR, far)):
        leg = aim(
            replay,
            start,
            place_from(*start[1:], *(away * line)),
            full / dive.duration,
            dive.duration,
        )
        plan, crab = leg.ahead.plan, leg.crab or 0.0
        for way in (min(away, full) * line, np.array([plan.dr_east, plan.dr_north])):
            ends.append(true @ way + current)
    return [
        *(float(np.hypot(*(end - full / 2 * line))) for end in near),
        *(abs(float(end @ across)) for end in far),
        *(float(end @ line) for end in far),
        abs(crab),
    ]


def main(
    files: Annotated[list[Path] | None, typer.Argument(help="Records, one each.")] = None,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/aiming"),
) -> None:
    """Leave aiming.md and aiming.png."""
    folder = make_folder(out)
    records = {"SG542": usable(sample_dives())[0]}
    records |= {path.stem: usable(read_dives([path])[0])[0] for path in files or []}
    found = {name: record(dives) for name, dives in records.items()}
    lines = [
        "| vehicle | dives | to the waypoint, steered for it (m) | aimed (m) | ratio "
        "| off a long line, steered (m) | aimed (m) | made good, steered (m) | aimed (m) | crab |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    every = {"all": np.concatenate(list(found.values()))} if len(found) > 1 else {}
    for name, sizes in {**found, **every}.items():
        m = np.median(sizes.reshape(-1, 7), axis=0)
        cells = [f"{m[0]:.0f}", f"{m[1]:.0f}", f"{m[1] / m[0]:.2f}", *(f"{v:.0f}" for v in m[2:])]
        lines.append(f"| {name} | {len(sizes)} | {' | '.join(cells)} |")
    write_text(folder / "aiming.md", "\n".join(lines) + "\n")
    write_figure(_drawn(found), folder / "aiming.png")
    typer.echo("\n".join(lines))


def _drawn(found: dict[str, np.ndarray]) -> "Figure":
    """Draw the share of dives that end within a distance, for both pilots."""
    figure, axes = new_figure(2.2 + 2.6 * len(found), 3.6, ncols=len(found), squeeze=False)
    for ax, (name, sizes) in zip(axes[0], found.items(), strict=True):
        for column, label, style, colour in (
            (0, "steered for it", "--", ORANGE),
            (1, "aimed", "-", BLUE),
        ):
            distance = np.sort(sizes[..., column].ravel()) / 1000
            share = np.arange(1, len(distance) + 1) / len(distance)
            ax.step(distance, 100 * share, style, color=colour, label=label, where="post")
        ax.axhline(50, color="black", lw=0.5)
        ax.set(xlabel="distance to the waypoint (km)", xlim=(0, None), ylim=(0, 100))
        ax.set_title(name, loc="left", fontsize=10)
    axes[0, 0].set_ylabel("ends within it (%)")
    axes[0, 0].legend(fontsize=8, frameon=False, loc="lower right")
    return figure


if __name__ == "__main__":
    typer.run(main)
