"""Are the learned speed and current those that a vehicle's own ADCP measured?

A glider with a current profiler measures the water's velocity c itself, which the replay never
reads.  Its speed factor is the f that makes dead reckoning d what the vehicle swam,

    f = sum d . (x - c T) / sum d . d,  x the displacement between fixes, T the duration,

and the learned current is compared with c dive by dive.

    python -m analysis.against_adcp FILES --adcp FILE [--out FOLDER]

FILES are dives as for `clpt replay`; the ADCP's CSV has the columns dive, u_east, v_north (m/s).
"""

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import typer

import clpt_control as clpt

from .study import leave, new_figure

SETTLED = 5  # dives before the current is compared


class Comparison(NamedTuple):
    """Speed factors, and rms of a component of currents less the ADCP's from dive 6 on, m/s."""

    learned: float
    standard_error: float
    measured: float
    current: float
    in_file: float


def read_adcp(path: Path) -> dict[int, np.ndarray]:
    """Return the current (2,) of each dive, east and north, m/s."""
    with path.open() as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {
            int(r["dive"]): np.array([float(r["u_east"]), float(r["v_north"])])
            for r in rows
        }


def compared(
    dives: Sequence[clpt.gliders.Dive], adcp: dict[int, np.ndarray]
) -> Comparison:
    """Replay dives and compare what was learned with the ADCP's currents."""
    steps = clpt.replay.replay_dives(dives).steps
    reckoned = np.array([s.dive.through_water for s in steps])
    swum = [
        np.array(s.dive.over_ground) - adcp[s.dive.number] * s.dive.duration
        for s in steps
    ]
    late = steps[SETTLED:]
    off = [step.current - adcp[step.dive.number] for step in late]
    own = [
        np.array([s.dive.dac_east, s.dive.dac_north], float) - adcp[s.dive.number]
        for s in late
    ]
    return Comparison(
        steps[-1].speed,
        steps[-1].speed_error,
        float(np.sum(reckoned * swum) / np.sum(reckoned**2)),
        *(float(np.sqrt(np.mean(np.square(a)))) for a in (off, own)),
    )


def main(
    files: Annotated[list[Path], typer.Argument(help="As for clpt replay.")],
    adcp: Annotated[Path, typer.Option(help="CSV: dive, u_east, v_north (m/s).")],
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/against_adcp"),
) -> None:
    """Leave against_adcp.md and against_adcp.png."""
    dives, _ = clpt.gliders.read_dives(files)
    measured = read_adcp(adcp)
    found = compared(dives, measured)
    figure, axes = new_figure(nrows=2, sharex=True)
    steps = clpt.replay.replay_dives(dives).steps
    number = [step.dive.number for step in steps]
    for ax, side, k in zip(axes, ("east", "north"), (0, 1), strict=True):
        ax.plot(number, [step.current[k] for step in steps], label="learned")
        ax.plot(number, [measured[n][k] for n in number], "k.", label="ADCP")
        ax.set(ylabel=f"current {side} (m/s)")
    axes[1].set(xlabel="dive")
    axes[0].legend(frameon=False, fontsize=8)
    lines = [
        "| | learned from fixes | ADCP | the files' own |",
        "|---|---|---|---|",
        f"| speed factor | {found.learned:.2f} +- {found.standard_error:.2f} | "
        f"{found.measured:.2f} | 1 |",
        "| current from the sixth dive on, rms off the ADCP's, a component | "
        f"{100 * found.current:.1f} cm/s | 0 | {100 * found.in_file:.1f} cm/s |",
    ]
    leave(out, "against_adcp", "\n".join(lines) + "\n", figure)
    typer.echo(
        f"speed factor learned {found.learned:.2f} +- {found.standard_error:.2f}, ADCP "
        f"{found.measured:.2f}"
    )
    typer.echo(
        f"from the sixth dive on, rms off the ADCP's current, a component: learned "
        f"{100 * found.current:.1f} cm/s, the files' own {100 * found.in_file:.1f} cm/s"
    )


if __name__ == "__main__":
    typer.run(main)
