"""`clpt replay`: a glider's dives, each forecast before its end."""

import time
from collections.abc import Callable, Sequence
from math import isfinite
from pathlib import Path
from typing import Annotated, Any

import typer

from .printing import Json, print_json
from .replay_table import place, show

WRITTEN = ("replay.nc", "map.png", "clpe.png", "current.png")


def replay(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Seaglider, OG1 or CSV files, or folders of them.")
    ] = None,
    sample: Annotated[bool, typer.Option("--sample", help="Replay the dives that ship.")] = False,
    estimator: Annotated[str, typer.Option(help="kalman, rls or gradient.")] = "kalman",
    flow: Annotated[
        str, typer.Option(help="steady, then any of tides, inertial and gaussians.")
    ] = "steady,M2,inertial",
    width: Annotated[str, typer.Option(help="Width of the gaussians, such as 20km.")] = "20km",
    learn_speed: Annotated[
        bool, typer.Option(help="Learn a factor on speed and a compass error.")
    ] = True,
    flow_model: Annotated[
        Path | None,
        typer.Option(help="Forecast (NetCDF) or fit (TOML) to compare with and learn from."),
    ] = None,
    plan: Annotated[
        tuple[float, float, float] | None,
        typer.Option("--next", help="Plan of the next dive: hours, m east, m north."),
    ] = None,
    least_duration: Annotated[
        float, typer.Option(help="Dives must last longer than this, s.")
    ] = 4000.0,
    out: Annotated[Path | None, typer.Option(help="Folder for NetCDF and figures.")] = None,
    follow: Annotated[
        Path | None, typer.Option(help="Folder to watch for new files; --out is its folder replay.")
    ] = None,
    every: Annotated[float, typer.Option(help="Time between looks at that folder, s.")] = 10.0,
    patience: Annotated[
        float, typer.Option(help="End after so long without a new file, s.")
    ] = float("inf"),
    as_json: Json = False,
) -> None:
    """Replay a glider's dives, each forecast before its end."""
    from ..errors import DataError, ScenarioError
    from ..estimation.between_fixes import make_estimator
    from ..estimation.fix_model import FixModel
    from ..files import make_folder
    from ..ocean.gliders.dive_files import read_dives
    from ..ocean.gliders.dive_table import sample_dives
    from ..ocean.gliders.dives import usable
    from ..ocean.places import read_width
    from ..ocean.replay.flow_models import carried, read_flow_model
    from ..ocean.replay.follow import continued
    from ..ocean.replay.next_dive import next_dive
    from ..ocean.replay.replay import Replay
    from ..progress import progress_bar

    if bool(files) + sample + (follow is not None) != 1:
        raise ScenarioError("give files of dives, --sample for those that ship, or --follow FOLDER")
    if follow is not None:
        out = follow / "replay" if out is None else out
    if not (least_duration >= 0 and every > 0 and patience >= 0):
        raise ScenarioError("--least-duration and --patience must be 0 s or more, --every above 0")
    parts = tuple(name.strip() for name in flow.split(","))
    if flow_model is None and "model" in parts:
        raise ScenarioError(f"flow {flow}: its part model needs --flow-model FILE")
    if flow_model is not None and "model" not in parts:
        parts = (*parts, "model")  # a factor on it, that the dives may find to be none
    model = FixModel(parts, learn_speed, 1000 * read_width(width))
    make_estimator(estimator, model)
    forecast = None if flow_model is None else read_flow_model(flow_model)
    warned: list[str] = []
    state = [Replay(estimator, model, forecast)]
    if plan is not None and not (all(map(isfinite, plan)) and plan[0] > 0):
        raise ScenarioError(f"--next {plan}: must be finite, its hours above 0")

    def upcoming(result: Replay) -> Any:
        return next_dive(result) if plan is None else next_dive(result, 3600 * plan[0], plan[1:])

    def run(dives: list[Any], unread: list[Any]) -> tuple[Replay, list[Any]]:
        used, unused = usable(dives, least_duration)
        try:
            check_tides(model.flow, used)
        except DataError as error:
            if follow is None:
                raise
            if not warned:  # the record grows
                warned.append(str(error))
                typer.echo(f"so far, {error}", err=True)
        state[0], rest = continued(state[0], used)
        with progress_bar("replaying dives", max(len(rest), 1)) as report:
            for k, dive in enumerate(rest):
                state[0].step(dive if forecast is None else carried(dive, forecast))
                report(k + 1)
        return state[0], [*unread, *unused]

    written: list[Path] = []
    if follow is not None and out is not None:
        result, skipped = watch(follow, out, run, upcoming, every, patience)
    else:
        result, skipped = run(*((sample_dives(), []) if sample else read_dives(files or [])))
        if not result.steps:
            raise DataError(f"no dive can be used; dive {skipped[0].dive}: {skipped[0].why}")
        if out is not None:
            written = write(result, make_folder(out), upcoming(result))
    summary = result.summary(skipped)
    summary["next_dive"] = upcoming(result).as_dict() if result.steps else None
    if as_json:
        print_json(summary)
        return
    show(result, summary)
    for path in written:
        typer.echo(f"{path}: written")


def check_tides(flow: Sequence[str], dives: Sequence[Any]) -> None:
    """Refuse tides that the dives are too few to tell apart.

    A single tide is allowed on any record: its prior holds it.

    Parameters
    ----------
    flow : sequence of str
        As ``--flow`` names it.
    dives : sequence of Dive
        By time.

    Raises
    ------
    DataError
        If two tides need a longer record.
    """
    from ..estimation.fix_model import OTHERS
    from ..ocean.tidal.rayleigh import check_separable

    tides = [name for name in flow[1:] if name not in OTHERS]
    if len(tides) > 1 and dives:
        hours = (dives[-1].t_gpse - dives[0].t_gps2) / 3600
        check_separable(tides, hours, f"--flow {','.join(flow)}")


def watch(
    folder: Path, out: Path, run: Callable, upcoming: Callable, every: float, patience: float
) -> tuple[Any, list[Any]]:
    """Replay a folder on whenever a file arrives.

    Parameters
    ----------
    folder, out : Path
        Where files arrive; where results and the folder ``state`` lie.
    run : callable
        Dives and what was left out -> replay and all that was left out.
    upcoming : callable
        Replay -> forecast of its next dive.
    every, patience : float
        Time between looks, and without a new file before the end, s.

    Returns
    -------
    result : Replay
    skipped : list of Skipped
    """
    from ..ocean.replay.follow import Follower

    follower = Follower(folder, out / "state")
    for name in WRITTEN:
        for left in out.glob(f".{name}.*"):
            left.unlink(missing_ok=True)  # of a run that was killed while it wrote
    first, quiet = True, 0.0
    while True:
        arrived = follower.look()
        if arrived or first:
            result, skipped = run(*follower.dives())
            said = f"{len(arrived)} new files, {len(result.steps)} dives used"
            if result.steps:
                ahead, step = upcoming(result), result.steps[-1]
                write(result, out, ahead)
                said += (
                    f"; dive {step.dive.number}: CLPE {step.clpe['adaptive']:.0f} m"
                    + (f"; speed anomaly: {step.anomaly}" if step.anomaly else "")
                    + f"; next surfacing near {place(ahead.latitude, ahead.longitude)}"
                )
            typer.echo(said, err=True)
            first, quiet = False, 0.0
        if quiet >= patience:
            return result, skipped
        try:
            time.sleep(every)
        except KeyboardInterrupt:  # the user's way to end it
            return result, skipped
        quiet += every


def write(result: Any, folder: Path, ahead: Any) -> list[Path]:
    """Write a replay's NetCDF and figures into a folder.

    Parameters
    ----------
    result : Replay
        With one dive at least.
    folder : Path
        An existing folder.
    ahead : NextDive
        For the map.

    Returns
    -------
    list of Path
        The files.
    """
    from ..files import write_netcdf
    from ..ocean.replay.file import replay_dataset
    from ..ocean.replay.plots import save_replay_figures

    write_netcdf(replay_dataset(result), folder / "replay.nc")
    return [folder / "replay.nc", *save_replay_figures(result, folder, ahead)]
