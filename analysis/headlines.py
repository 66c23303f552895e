"""Does the headline of a replay, "next surfacing, 90 % within", hold 90 % of what comes?

Each record is fed dive by dive.  After each dive the headline is what `clpt replay` prints
then; the fix at the end of the next used dive says whether it held.  Where dives between the
two are missing from the record, that fix is not the next surfacing: such a pair is left out.
The size of an ellipse is the geometric mean of its half axes; that of a time is what is printed
behind its +-.

    python -m analysis.headlines [FILES and FOLDERS, a vehicle each...] [--seas 3] [--out FOLDER]

`--seas N` adds a row of the made seas of `analysis.glider_forecasts`, N vehicles in each.
"""

from math import hypot, nan
from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import typer

from clpt_control import DataError
from clpt_control.gliders import Dive, make_dive, read_dives, sample_dives
from clpt_control.replay import Replay

from .glider_forecasts import SEAS
from .made_seas import made_dives
from .study import GREY, displacement, leave, new_figure, place_from, progress_bar

COLUMNS = (
    "vehicle",
    "surfacings",
    "place held",
    "median size (m)",
    "median miss (m)",
    "time held",
    "median +- (min)",
    "median error (min)",
    "90th percentile (min)",
)


class Headline(NamedTuple):
    """One headline and what came: m and min; `away` is 1 on the edge of the ellipse."""

    away: float
    size: float
    miss: float
    late: float
    doubt: float


def headline(replay: Replay, dive: Dive) -> Headline:
    """Return the headline of a replay, judged by the dive that came."""
    said = replay.next_dive().as_dict()
    east, north = displacement(said["latitude"], said["longitude"], *dive.end)
    turn = np.radians(said["ellipse_bearing"])
    long, short = said["ellipse_long"], said["ellipse_short"]
    along = east * np.sin(turn) + north * np.cos(turn)
    across = east * np.cos(turn) - north * np.sin(turn)
    time = replay.next_dive().plan.t_gpse
    return Headline(
        float(hypot(along / long, across / short)),
        float(np.sqrt(long * short)),
        hypot(east, north),
        (dive.t_gpse - time) / 60,
        said.get("time_half_width", nan) / 60,
    )


def record(dives: list[Dive]) -> np.ndarray:
    """Return the headlines after each dive of a record but the last, a row each."""
    replay, found = Replay(), []
    with progress_bar("headlines", len(dives)) as report:
        for k, dive in enumerate(dives):
            if k and not any("missing after dive" in note for note in dive.notes):
                found.append(headline(replay, dive))
            replay.step(dive)
            report(k + 1)
    return np.array(found).reshape(-1, len(Headline._fields))


def afloat(dives: list[Dive]) -> list[Dive]:
    """Return made dives with fixes where they end, each begun where the last one ended."""
    found, place = [], (dives[0].lat_gps2, dives[0].lon_gps2)
    for dive in dives:
        end = place_from(*place, *dive.over_ground)
        start, after = (dive.t_gps2, *place), (dive.t_gpse, *end)
        found.append(make_dive(dive.number, start, after, dive.through_water))
        place = end
    return found


def line(name: str, found: np.ndarray) -> str:
    """Return a row of the table."""
    away, size, miss, late, doubt = found.T
    late = np.abs(late)
    timed = np.isfinite(doubt).any()
    cells = [
        name,
        f"{len(found)}",
        f"{100 * np.mean(away <= 1):.0f} %",
        f"{np.median(size):.0f}",
        f"{np.median(miss):.0f}",
        f"{100 * np.mean(late <= doubt):.0f} %" if timed else "-",
        f"{np.median(doubt):.0f}" if timed else "-",
        f"{np.median(late):.0f}",
        f"{np.quantile(late, 0.9):.0f}",
    ]
    return f"| {' | '.join(cells)} |"


def main(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Records, one each.")
    ] = None,
    seas: Annotated[int, typer.Option(help="Made vehicles in each sea.")] = 0,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/headlines"),
) -> None:
    """Leave headlines.md and headlines.png."""
    records = {} if files else {"SG542": sample_dives()}
    for path in files or []:
        dives = read_dives([path])[0]
        if len(dives) < 2:
            raise DataError(f"{path}: has {len(dives)} usable dives; two are needed")
        records[dives[-1].vehicle or path.stem] = dives
    found = {name: record(dives) for name, dives in records.items()}
    if len(found) > 1:
        found["all"] = np.concatenate(list(found.values()))
    if seas:
        made = [made_dives(sea, 1000 + k) for sea in SEAS.values() for k in range(seas)]
        found["made seas"] = np.concatenate([record(afloat(dives)) for dives in made])
    lines = [f"| {' | '.join(COLUMNS)} |", "|---" * len(COLUMNS) + "|"]
    lines += [line(name, rows) for name, rows in found.items()]
    figure, ax = new_figure()
    for name, rows in found.items():
        share = 100 * (np.arange(len(rows)) + 1) / len(rows)
        ax.step(np.sort(rows[:, 0]), share, where="post", label=name)
    ax.plot([0, 1, 1], [90, 90, 0], color=GREY, linestyle="--", label="said")
    ax.set(
        xlabel="miss, of the 90 % ellipse",
        ylabel="surfacings within (%)",
        ylim=(0, 100),
    )
    ax.legend(frameon=False, fontsize=8)
    leave(out, "headlines", "\n".join(lines) + "\n", figure)
    typer.echo("\n".join(lines))


if __name__ == "__main__":
    typer.run(main)
