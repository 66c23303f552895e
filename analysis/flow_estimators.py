"""What does each estimator of theta forecast of a glider's dives, beside the replay?

Each dive is forecast from the dives before it: theta by least squares, a Kalman filter whose
parameters walk, or motion tomography (`clpt.estimation.flow_estimate`), then the dead reckoning
carried by theta phi.  The functions are a steady current, alone or with gaussians where the track
comes near.  None of them learns the vehicle's speed or its compass; `clpt replay` does.

    python -m analysis.flow_estimators [FILES] [--out FOLDER]
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

import clpt_control as clpt

from .study import BLUE, GREEN, RED, leave, new_figure, progress_bar

FUNCTIONS = {"steady": None, "steady and gaussians of 20 km": 20e3}
METHODS = ("least-squares", "kalman", "tomography")
BEFORE = {
    "no flow": "no_flow",
    "previous dive's current": "previous_dive",
    "replay": "adaptive",
}


def forecast_misses(
    dives: Sequence[clpt.gliders.Dive], method: str, width: float | None
) -> np.ndarray:
    """Return how far each dive but the first came up from its forecast, (n - 1,), m."""
    missed = []
    for k in range(1, len(dives)):
        basis, prior = clpt.estimation.dive_basis(dives[: k + 1], width)
        found = clpt.estimation.flow_estimate(
            dives[:k], method, basis=basis, prior=prior
        )
        left = np.array([dives[k].miss_east, dives[k].miss_north]) - found.miss(
            dives[k]
        )
        missed.append(np.hypot(*left))
    return np.array(missed)


def rms(values: np.ndarray) -> float:
    """Return the root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def main(
    files: Annotated[
        list[Path] | None, typer.Argument(help="As for clpt replay.")
    ] = None,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/flow_estimators"),
) -> None:
    """Leave flow_estimators.md and flow_estimators.png."""
    read = clpt.gliders.read_dives(files)[0] if files else clpt.gliders.sample_dives()
    dives, _ = clpt.gliders.usable(read)
    if len(dives) < 5:
        raise clpt.DataError(
            f"{len(dives)} dives can be used; the study needs 5 at least"
        )
    replay = clpt.replay.replay_dives(dives)
    # a wild fix is settled by the next dive's start
    dives = [step.dive for step in replay.steps]
    missed = {
        name: np.array([step.clpe[key] for step in replay.steps[1:]])
        for name, key in BEFORE.items()
    }
    cases = [(method, label) for label in FUNCTIONS for method in METHODS]
    with progress_bar("forecasting", len(cases)) as report:
        for done, (method, label) in enumerate(cases, 1):
            missed[f"{method}, {label}"] = forecast_misses(
                dives, method, FUNCTIONS[label]
            )
            report(done)
    lines = [
        "| forecast | after the first dive, m | after the third dive, m |",
        "|---|---|---|",
    ]
    lines += [
        f"| {name} | {rms(m):.0f} | {rms(m[2:]):.0f} |" for name, m in missed.items()
    ]
    leave(out, "flow_estimators", "\n".join(lines) + "\n", picture(dives, missed))
    typer.echo("\n".join(lines))


def picture(dives, missed):
    """Draw the miss of each dive."""
    figure, ax = new_figure(7.0, 4.0)
    number = [dive.number for dive in dives[1:]]
    ax.plot(number, missed["no flow"] / 1000, ":", color="black", label="no flow")
    ax.plot(number, missed["replay"] / 1000, "-", color="black", label="replay")
    marks = zip(METHODS, (BLUE, RED, GREEN), ("s", "o", "^"), strict=True)
    label = list(FUNCTIONS)[-1]
    for method, colour, mark in marks:
        values = missed[f"{method}, {label}"] / 1000
        ax.plot(number, values, mark, color=colour, ms=5, alpha=0.8, label=method)
    ax.set(
        xlabel="dive", ylabel="miss of the forecast (km)", title=f"Functions: {label}"
    )
    ax.set_ylim(bottom=0)
    figure.legend(loc="outside lower center", ncols=5, fontsize=8, frameon=False)
    return figure


if __name__ == "__main__":
    typer.run(main)
