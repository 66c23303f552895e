"""What does a limit of the vehicle's speed cost, with hedging and without?

The paper's scenario with `vehicle.max_speed` from 1 to 3 m/s, and without a limit.  The flow
reaches 2 m/s at places of the track.  With hedging the learner is told what could not be flown;
V' is -e^T KD e whatever the limit is.  Without it the difference acts like a disturbance.

    python -m analysis.limited_speed [--law NAME] [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

import clpt_control as clpt
from clpt_control.simulation.summary import run_and_report

from .study import BLUE, GREY, RED, leave, new_figure, progress_bar

SPEEDS = (1.0, 1.25, 1.5, 2.0, 3.0)  # m/s
SHOWN = 1.5  # m/s, in the upper picture
LINES = {
    True: {"color": BLUE, "linestyle": "-", "marker": "o", "label": "with hedging"},
    False: {"color": RED, "linestyle": "--", "marker": "s", "label": "without hedging"},
}


def reported(base: clpt.Scenario, speed: float | None, hedging: bool) -> Any:
    """Return the report of a run with a limit, or without one."""
    values: dict[str, Any] = {"vehicle.max_speed": speed}
    if speed is not None:
        values["learning.hedging"] = hedging
    return run_and_report(base.with_values(values))


def figure(base: clpt.Scenario, runs: dict, free: Any) -> Any:
    """Draw V along the runs at one limit, and the CLPE of the last cycle over the limit."""
    picture, (top, bottom) = new_figure(6.4, 5.6, nrows=2)
    for hedging, line in LINES.items():
        run = runs[SHOWN, hedging].fine
        plain = {**line, "marker": None, "linewidth": 0.9}
        top.semilogy(run.time, run.lyapunov, **plain)
        last = [
            runs[speed, hedging].summary["clpe_rms_per_cycle"][-1] for speed in SPEEDS
        ]
        bottom.semilogy(SPEEDS, last, markersize=5, **line)
    top.semilogy(
        free.fine.time, free.fine.lyapunov, color=GREY, ls=":", label="no limit"
    )
    bottom.axhline(
        free.summary["clpe_rms_per_cycle"][-1], color=GREY, ls=":", label="no limit"
    )
    units = base.units
    top.set(xlabel=f"time ({units.time})", ylabel=f"V ({units.length}²)")
    title = f"V of a vehicle with at most {SHOWN:g} {units.length}/{units.time}"
    top.set_title(title, loc="left", fontsize=10)
    bottom.set(xlabel=f"largest speed ({units.length}/{units.time})")
    bottom.set_ylabel(f"CLPE rms, last cycle ({units.length})")
    for ax in (top, bottom):
        ax.legend(frameon=False, fontsize=8)
    return picture


def main(
    law: Annotated[
        str, typer.Option(help="The law, by its name in `clpt laws`.")
    ] = "learned-flow",
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/limited_speed"),
) -> None:
    """Run every limit; leave limited_speed.md and limited_speed.png."""
    base = clpt.paper_scenario().with_values({"learning.law": law})
    runs: dict[tuple[float, bool], Any] = {}
    with progress_bar("limits of the speed", 2 * len(SPEEDS) + 1) as report:
        free = reported(base, None, True)
        for speed in SPEEDS:
            for hedging in LINES:
                runs[speed, hedging] = reported(base, speed, hedging)
                report(len(runs) + 1)
    lines = [
        "| largest speed (m/s) | hedging | CLPE rms, first and last cycle (m) | largest flow "
        "parameter error, t = 2000 (m/s) | V rises by, in all (m²) | at the limit | flow faster |",
        "|---|---|---|---|---|---|---|",
    ]
    for (speed, hedging), one in [*runs.items(), ((np.inf, True), free)]:
        rms, V = one.summary["clpe_rms_per_cycle"], one.fine.lyapunov.values
        rise = np.clip(np.diff(V), 0.0, None).sum()
        found = one.summary.get("speed", {"share_at_limit": 0.0, "faster_flow": None})
        faster = found["faster_flow"]["share"] if found["faster_flow"] else 0.0
        error = one.summary["max_flow_parameter_error"]["2000"]
        lines.append(
            f"| {speed:g} | {'yes' if hedging else 'no'} | {rms[0]:.2g}, {rms[-1]:.2g} | "
            f"{error:.3g} | {rise:.2g} | {100 * found['share_at_limit']:.1f} % | "
            f"{100 * faster:.1f} % |"
        )
    text = "\n".join(lines) + "\n"
    leave(out, "limited_speed", text, figure(base, runs, free))
    typer.echo(text)


if __name__ == "__main__":
    typer.run(main)
