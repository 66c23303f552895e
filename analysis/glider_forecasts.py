"""How good are forecasts of the next surfacing, sea by sea, with one set of defaults?

In each made sea vehicles are replayed; the ratio is CLPE rms
after the third dive over that of the previous dive's current, one value a
vehicle, their geometric mean in the table.  The Seaglider that ships is the last row.

    python -m analysis.glider_forecasts [--vehicles 12] [--out FOLDER]
"""

from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from clpt_control.gliders import sample_dives
from clpt_control.ocean.forecast.replay_summary import clpe_rms
from clpt_control.replay import Replay, replay_dives

from .made_seas import DAY, QUARTER_DAY, Sea, made_dives
from .study import BLUE, leave, new_figure, progress_bar

WAVES = (0.03, QUARTER_DAY, 1)  # internal waves, forgotten in six hours
SWING, STORM = (0.05, 2 * DAY), (0.12, 2 * DAY)  # inertial oscillations
SEAS = {
    "keeps what it had, speed exact": Sea(walk=0.03, heading="any"),
    "the same, restless": Sea(walk=0.1, heading="any"),
    "the same, one heading": Sea(walk=0.03, heading="one"),
    "wanders, scatters, speed 10 %": Sea(
        walk=0.03, scatter=0.02, speed_sd=0.1, compass_sd=0.03, heading="mower"
    ),
    "scatters by 5 cm/s": Sea(scatter=0.05, heading="any"),
    "steady, speed 10 %": Sea(speed_sd=0.1),
    "quiet ocean": Sea(
        eddying=((0.05, 5 * DAY, 1), (0.02, 18000.0, 1)), speed_sd=0.07, dives=40
    ),
    "eddying ocean": Sea(
        eddying=((0.2, 3 * DAY, 1), WAVES),
        inertial=SWING,
        speed_sd=0.07,
        compass_sd=0.02,
        dives=40,
    ),
    "the same, 8 h dives": Sea(
        eddying=((0.15, 3 * DAY, 1), WAVES),
        inertial=SWING,
        speed_sd=0.05,
        hours=8.0,
        dives=40,
    ),
    "smooth eddies": Sea(
        eddying=((0.2, 2 * DAY, 2), (0.02, 14400.0, 1)),
        speed_sd=0.05,
        heading="wander",
        dives=40,
    ),
    "across an eddy": Sea(
        eddy=(0.5, 25e3), eddying=((0.02, 14400.0, 1),), speed_sd=0.05, heading="one"
    ),
    "across a jet": Sea(
        jet=(1.4, 30e3),
        eddying=((0.03, 14400.0, 1),),
        speed_sd=0.05,
        heading="one",
        hours=5.0,
    ),
    "shelf, M2": Sea(
        eddying=((0.07, 2 * DAY, 1), (0.02, 14400.0, 1)),
        tides=(("M2", 0.3),),
        speed_sd=0.07,
        hours=3.0,
        dives=40,
    ),
    "shelf, four tides": Sea(
        eddying=((0.07, 2 * DAY, 1), (0.02, 14400.0, 1)),
        heading="mower",
        tides=(("M2", 0.2), ("S2", 0.08), ("K1", 0.1), ("O1", 0.06)),
        speed_sd=0.05,
        hours=3.0,
        dives=60,
    ),
    "after a storm": Sea(
        eddying=((0.08, 3 * DAY, 1), (0.015, 14400.0, 1)),
        inertial=STORM,
        speed_sd=0.05,
        dives=40,
    ),
    "fourteen dives only": Sea(
        eddying=((0.12, 3 * DAY, 1), WAVES),
        inertial=SWING,
        speed_sd=0.1,
        compass_sd=0.03,
        heading="mower",
        dives=14,
    ),
}


def ratio(replay: Replay) -> float:
    """Return CLPE rms after the third dive over the previous dive's."""
    rms = clpe_rms(replay, 3)
    return float(rms["adaptive"] or np.nan) / float(rms["previous_dive"] or np.nan)


def inside_share(replay: Replay) -> float:
    """Return the share of dives inside the ellipse of their hindsight."""
    hindsight = replay.summary()["hindsight"]
    return hindsight["inside"] / hindsight["judged"]


def judged(name: str, seed: int) -> dict[str, Any]:
    """Replay one vehicle of a sea."""
    sea = SEAS[name]
    replay = replay_dives(made_dives(sea, seed))
    return {"sea": name, "ratio": ratio(replay), "inside": inside_share(replay)}


def geometric(values: list[float]) -> float:
    """Return the geometric mean."""
    return float(np.exp(np.mean(np.log(values))))


def main(
    vehicles: Annotated[int, typer.Option(help="Vehicles in each sea.")] = 12,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/glider_forecasts"),
) -> None:
    """Leave glider_forecasts.md and glider_forecasts.png."""
    jobs = [(name, 1000 + seed) for name in SEAS for seed in range(vehicles)]
    records: dict[str, list[dict[str, Any]]] = {name: [] for name in SEAS}
    with ProcessPoolExecutor() as pool, progress_bar("replaying", len(jobs)) as report:
        for k, found in enumerate(pool.map(judged, *zip(*jobs, strict=True))):
            records[found["sea"]].append(found)
            report(k + 1)
    lines = [
        "| sea | ratio | worst | in the 90 % ellipse, hindsight |",
        "|---|---|---|---|",
    ]
    for name, rows in records.items():
        lines.append(
            f"| {name} | {geometric([row['ratio'] for row in rows]):.2f} | "
            f"{max(row['ratio'] for row in rows):.2f} | "
            f"{100 * np.mean([row['inside'] for row in rows]):.0f} % |"
        )
    real = replay_dives(sample_dives())
    lines.append(
        f"| Seaglider SG542 | {ratio(real):.2f} | - | {100 * inside_share(real):.0f} % |"
    )
    means = [geometric([row["ratio"] for row in rows]) for rows in records.values()]
    lines.append(
        f"\nGeometric mean of the seas: {geometric(means):.3f}; worst {max(means):.2f}"
    )
    leave(out, "glider_forecasts", "\n".join(lines) + "\n", picture(records, real))
    typer.echo("\n".join(lines))


def picture(records: dict[str, list[dict[str, Any]]], real: Replay) -> Any:
    """Draw a row for each sea: vehicles as dots, means as marks."""
    figure, ax = new_figure(7.2, 5.6)
    names = [*records, "Seaglider SG542"]
    for k, rows in enumerate(records.values()):
        ax.plot(
            [row["ratio"] for row in rows],
            [k] * len(rows),
            ".",
            color=BLUE,
            ms=4,
            alpha=0.35,
            label=None if k else "each vehicle",
        )
    means = [geometric([row["ratio"] for row in rows]) for rows in records.values()]
    ax.plot(
        [*means, ratio(real)], range(len(names)), "o", color=BLUE, ms=5, label="mean"
    )
    ax.axvline(1, color="black", lw=0.8)
    ax.set(
        yticks=range(len(names)),
        yticklabels=names,
        xscale="log",
        xticks=[0.2, 0.5, 1, 2],
        xticklabels=["0.2", "0.5", "1", "2"],
        xlabel="CLPE rms over that of the previous dive's current",
    )
    ax.minorticks_off()
    ax.invert_yaxis()
    figure.legend(loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    return figure


if __name__ == "__main__":
    typer.run(main)
