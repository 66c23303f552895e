"""How much do forecasts of the next surfacing depend on the priors?

Each number that the estimator begins with is halved and doubled, one at a time;
for every record the ratio is CLPE rms after the third dive over that of the
previous dive's current.  Records are the Seaglider that ships, and FILES.

    python -m analysis.prior_sensitivity [FILES...] [--out FOLDER]
"""

from itertools import product
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from clpt_control.gliders import Dive, read_dives, sample_dives
from clpt_control.ocean.estimation.fix_model import FixModel, Priors
from clpt_control.ocean.forecast.replay_summary import clpe_rms
from clpt_control.replay import Replay

from .study import BLUE, GREY, leave, new_figure, progress_bar

RESTLESS = ("size", "memory", "scatter")  # of a kind of sea
PRIORS = (
    *("fix", "current", "tide", "inertial", "shear", "speed", "compass", "shelf"),
    *("inertial_fading", "tide_fading", "speed_fading", "compass_fading"),
    *("degrees_of_freedom", "weight_memory"),
    *RESTLESS,  # of all kinds of sea at once
)
FACTORS = (0.5, 2.0)


def changed(name: str, factor: float) -> Priors:
    """Return the priors with one number multiplied."""
    priors = Priors()
    if name not in RESTLESS:
        return priors._replace(**{name: factor * getattr(priors, name)})
    kinds = (k._replace(**{name: factor * getattr(k, name)}) for k in priors.kinds)
    return priors._replace(kinds=tuple(kinds))


def ratio(dives: list[Dive], priors: Priors) -> float:
    """Return CLPE rms after the third dive over the previous dive's."""
    rms = clpe_rms(Replay(model=FixModel(priors=priors)).feed(dives))
    return float(rms["adaptive"] or np.nan) / float(rms["previous_dive"] or np.nan)


def main(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Records, one each.")
    ] = None,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/prior_sensitivity"),
) -> None:
    """Leave prior_sensitivity.md and prior_sensitivity.png."""
    records = {"SG542": sample_dives()}
    records |= {path.stem: read_dives([path])[0] for path in files or []}
    base = np.array([ratio(dives, Priors()) for dives in records.values()])
    found = {}
    with progress_bar("replaying", len(FACTORS) * len(PRIORS)) as report:
        for k, (name, factor) in enumerate(product(PRIORS, FACTORS)):
            priors = changed(name, factor)
            found[name, factor] = np.array(
                [ratio(dives, priors) for dives in records.values()]
            )
            report(k + 1)
    lines = [
        f"| prior | factor | {' | '.join(records)} |",
        "|---|---|" + "---|" * len(records),
    ]
    for (name, factor), row in {("as they are", 1.0): base, **found}.items():
        lines.append(
            f"| {name} | {factor:.3g} | " + " | ".join(f"{r:.3f}" for r in row) + " |"
        )
    every = np.array(list(found.values()))
    for k, name in enumerate(records):
        lines.append(f"\n{name}: {every[:, k].min():.3f} to {every[:, k].max():.3f}")
    figure, axes = new_figure(
        2.2 + 2.4 * len(records), 4.6, ncols=len(records), sharey=True
    )
    for k, (name, ax) in enumerate(zip(records, np.atleast_1d(axes), strict=True)):
        for j, prior in enumerate(PRIORS):
            pair = [row[k] for (which, _), row in found.items() if which == prior]
            ax.plot(pair, [j, j], "-", color=GREY, lw=1)
            ax.plot(
                pair[:1], [j], "v", color=BLUE, ms=5, label=None if j else "smaller"
            )
            ax.plot(
                pair[1:],
                [j],
                "^",
                color=BLUE,
                ms=5,
                mfc="white",
                label=None if j else "larger",
            )
        ax.axvline(base[k], color="black", lw=0.8)
        ax.set(xlabel="CLPE rms over the previous dive's", yticks=range(len(PRIORS)))
        ax.set_yticklabels(PRIORS)
        ax.set_title(name, loc="left", fontsize=10)
    np.atleast_1d(axes)[0].invert_yaxis()
    np.atleast_1d(axes)[0].legend(fontsize=8, frameon=False)
    leave(out, "prior_sensitivity", "\n".join(lines) + "\n", figure)
    typer.echo("\n".join(lines))


if __name__ == "__main__":
    typer.run(main)
