"""How much do forecasts of the next surfacing depend on the priors?

Each number that the estimators begin with is halved and doubled, one at a time;
for every record the ratio is CLPE rms after the third dive over that of the
previous dive's current.  Records are the Seaglider that ships, and FILES.

    python -m analysis.prior_sensitivity [FILES...] [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated, Any
from unittest.mock import patch

import numpy as np
import typer

from clpt_control.estimation import combination, fix_model, held, kalman, wandering
from clpt_control.figures import BLUE, GREY, new_figure
from clpt_control.files import make_folder, write_figure, write_text
from clpt_control.gliders import Dive, read_dives, sample_dives, usable
from clpt_control.progress import progress_bar
from clpt_control.replay import replay_dives

PRIORS: dict[str, tuple[Any, str, Any, Any]] = {
    "current": (fix_model, "CURRENT", 0.5, 2.0),
    "tide": (fix_model, "TIDE", 0.5, 2.0),
    "inertial current": (fix_model, "INERTIAL", 0.5, 2.0),
    "speed": (fix_model, "SPEED", 0.5, 2.0),
    "compass": (fix_model, "COMPASS", 0.5, 2.0),
    "fix": (fix_model, "FIX", 0.5, 2.0),
    "odds of a shelf": (kalman, "SHELF", 0.5, 2.0),
    "usual scatter": (kalman, "USUAL", 0.5, 2.0),
    "spread of scatter": (kalman, "SPREAD", 0.5, 2.0),
    "inertial fading": (kalman, "INERTIAL_FADING", 0.5, 2.0),
    "walk of the speed": (kalman, "SPEED_WALK", 0.5, 2.0),
    "fading of a trend": (wandering, "TREND_FADING", 0.5, 2.0),
    "learned from": (held, "LEARNED", 2 / 3, 1.2),
    "first share": (combination, "SHARE", 0.5, 2.0),
    "weight of it": (combination, "WEIGHT", 0.5, 2.0),
}


def ratio(dives: list[Dive]) -> float:
    """Return CLPE rms after the third dive over the previous dive's."""
    rms = replay_dives(dives).rms(3)
    return float(rms["adaptive"] or np.nan) / float(rms["previous_dive"] or np.nan)


def main(
    files: Annotated[list[Path] | None, typer.Argument(help="Records, one each.")] = None,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/prior_sensitivity"),
) -> None:
    """Leave prior_sensitivity.md and prior_sensitivity.png."""
    folder = make_folder(out)
    records = {"SG542": usable(sample_dives())[0]}
    records |= {path.stem: usable(read_dives([path])[0])[0] for path in files or []}
    base = np.array([ratio(dives) for dives in records.values()])
    found = {}
    with progress_bar("replaying", 2 * len(PRIORS)) as report:
        for k, (name, (module, number, *factors)) in enumerate(PRIORS.items()):
            for j, factor in enumerate(factors):
                with patch.object(module, number, factor * getattr(module, number)):
                    found[name, factor] = np.array([ratio(dives) for dives in records.values()])
                report(2 * k + j + 1)
    lines = [f"| prior | factor | {' | '.join(records)} |", "|---|---|" + "---|" * len(records)]
    for (name, factor), row in {("as they are", 1.0): base, **found}.items():
        lines.append(f"| {name} | {factor:.3g} | " + " | ".join(f"{r:.3f}" for r in row) + " |")
    every = np.array(list(found.values()))
    for k, name in enumerate(records):
        lines.append(f"\n{name}: {every[:, k].min():.3f} to {every[:, k].max():.3f}")
    write_text(folder / "prior_sensitivity.md", "\n".join(lines) + "\n")
    figure, axes = new_figure(2.2 + 2.4 * len(records), 4.6, ncols=len(records), sharey=True)
    for k, (name, ax) in enumerate(zip(records, np.atleast_1d(axes), strict=True)):
        for j, prior in enumerate(PRIORS):
            pair = [row[k] for (which, _), row in found.items() if which == prior]
            ax.plot(pair, [j, j], "-", color=GREY, lw=1)
            ax.plot(pair[:1], [j], "v", color=BLUE, ms=5, label=None if j else "smaller")
            ax.plot(
                pair[1:], [j], "^", color=BLUE, ms=5, mfc="white", label=None if j else "larger"
            )
        ax.axvline(base[k], color="black", lw=0.8)
        ax.set(xlabel="CLPE rms over the previous dive's", yticks=range(len(PRIORS)))
        ax.set_yticklabels(PRIORS)
        ax.set_title(name, loc="left", fontsize=10)
    np.atleast_1d(axes)[0].invert_yaxis()
    np.atleast_1d(axes)[0].legend(fontsize=8, frameon=False)
    write_figure(figure, folder / "prior_sensitivity.png")
    typer.echo("\n".join(lines))


if __name__ == "__main__":
    typer.run(main)
