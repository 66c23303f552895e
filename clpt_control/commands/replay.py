"""`clpt replay`: a glider's dives, each forecast before its end."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from .printing import Json, print_json, print_table


def replay(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Seaglider, OG1 or CSV files, or folders of them.")
    ] = None,
    sample: Annotated[bool, typer.Option("--sample", help="Replay the dives that ship.")] = False,
    estimator: Annotated[str, typer.Option(help="kalman, rls or gradient.")] = "kalman",
    flow: Annotated[
        str, typer.Option(help="steady, then tides and inertial, such as steady,M2,inertial.")
    ] = "steady,M2,inertial",
    learn_speed: Annotated[
        bool, typer.Option(help="Learn a factor on speed and a compass error.")
    ] = True,
    least_duration: Annotated[
        float, typer.Option(help="Dives must last longer than this, s.")
    ] = 4000.0,
    out: Annotated[Path | None, typer.Option(help="Folder for NetCDF and figures.")] = None,
    follow: Annotated[
        Path | None, typer.Option(help="Folder to watch for new files; needs --out.")
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
    from ..ocean.dive_files import read_dives
    from ..ocean.dive_table import sample_dives
    from ..ocean.dives import usable
    from ..ocean.replay import Replay
    from ..progress import progress_bar

    if bool(files) + sample + (follow is not None) != 1:
        raise ScenarioError("give files of dives, --sample for those that ship, or --follow FOLDER")
    if follow is not None and out is None:
        raise ScenarioError("--follow needs --out, a folder for the results and the state")
    if not (least_duration >= 0 and every > 0 and patience >= 0):
        raise ScenarioError("--least-duration and --patience must be 0 s or more, --every above 0")
    model = FixModel(tuple(name.strip() for name in flow.split(",")), learn_speed)
    make_estimator(estimator, model)

    def run(dives: list[Any], unread: list[Any]) -> tuple[Replay, list[Any]]:
        used, unused = usable(dives, least_duration)
        result = Replay(estimator, model)
        with progress_bar("replaying dives", max(len(used), 1)) as report:
            for k, dive in enumerate(used):
                result.step(dive)
                report(k + 1)
        return result, [*unread, *unused]

    written: list[Path] = []
    if follow is not None and out is not None:
        result, skipped = watch(follow, make_folder(out), run, every, patience)
    else:
        result, skipped = run(*((sample_dives(), []) if sample else read_dives(files or [])))
        if not result.steps:
            raise DataError(f"no dive can be used; dive {skipped[0].dive}: {skipped[0].why}")
        if out is not None:
            written = write(result, make_folder(out))
    summary = result.summary(skipped)
    if as_json:
        print_json(summary)
        return
    show(result, summary)
    for path in written:
        typer.echo(f"{path}: written")


def watch(
    folder: Path, out: Path, run: Callable, every: float, patience: float
) -> tuple[Any, list[Any]]:
    """Replay a folder again whenever a file arrives.

    Parameters
    ----------
    folder, out : Path
        Where files arrive; where results and ``state.json`` lie.
    run : callable
        Dives and what was left out -> replay and all that was left out.
    every, patience : float
        Time between looks, and without a new file before the end, s.

    Returns
    -------
    result : Replay
    skipped : list of Skipped
    """
    from ..ocean.follow import Follower

    for left in (*out.glob(".replay.nc.*"), *out.glob(".state.json.*")):
        left.unlink(missing_ok=True)  # of a run that was killed while it wrote
    follower = Follower(folder, out / "state.json")
    first, quiet = True, 0.0
    while True:
        arrived = follower.look()
        if arrived or first:
            result, skipped = run(*follower.dives())
            if result.steps:
                write(result, out)
            said = f"{len(arrived)} new files, {len(result.steps)} dives used"
            if result.steps:
                step = result.steps[-1]
                said += f"; dive {step.dive.number}: CLPE {step.clpe['adaptive']:.0f} m" + (
                    f"; speed anomaly: {step.anomaly}" if step.anomaly else ""
                )
            typer.echo(said, err=True)
            first, quiet = False, 0.0
        if quiet >= patience:
            return result, skipped
        time.sleep(every)
        quiet += every


def write(result: Any, folder: Path) -> list[Path]:
    """Write a replay's NetCDF and figures into a folder.

    Parameters
    ----------
    result : Replay
        With one dive at least.
    folder : Path
        An existing folder.

    Returns
    -------
    list of Path
        The files.
    """
    from ..files import write_netcdf
    from ..ocean.replay_file import replay_dataset
    from ..ocean.replay_plots import save_replay_figures

    write_netcdf(replay_dataset(result), folder / "replay.nc")
    return [folder / "replay.nc", *save_replay_figures(result, folder)]


def show(result: Any, summary: dict[str, Any]) -> None:
    """Print a replay: a row per dive, then the whole.

    Parameters
    ----------
    result : Replay
        With one dive at least.
    summary : dict
        As `Replay.summary` gives it.
    """
    rows = []
    for step in result.steps:
        current = " ".join(
            f"{v:+.3f}({1000 * e:.0f})"
            for v, e in zip(step.current, step.current_error, strict=True)
        )
        long, short, angle = ellipse(step.covariance)
        rows.append([
            str(step.dive.number),
            *(f"{step.clpe[key]:.0f}" for key in ("no_flow", "previous_dive", "adaptive")),
            current,
            f"{step.speed:.3f}({1000 * step.speed_error:.0f})",
            f"{step.forecast[0]:+.0f} {step.forecast[1]:+.0f}",
            f"{long:.0f} x {short:.0f}, {angle:.0f}",
            "in" if step.inside else "OUT",
            "SPEED" if step.anomaly else "",
        ])  # fmt: skip
    print_table(
        "CLPE (m), one dive ahead; learned (standard error, last digits); forecast surfacing",
        ["dive", "no flow", "previous", "adaptive", "current E N (m/s)", "speed", "E N of DR (m)",
         "90 % ellipse (m, deg)", "", ""],
        rows,
    )  # fmt: skip
    keys = (("clpe_rms", "CLPE rms (m)"), ("clpe_rms_after_1", "after the first dive"),
            ("clpe_rms_after_3", "after the third dive"))  # fmt: skip
    table = [
        [name, *("-" if v is None else f"{v:.0f}" for v in summary[key].values())]
        for key, name in keys
    ]
    print_table("", ["", "no flow", "previous dive", "adaptive"], table)
    for step in result.steps:
        if step.anomaly:
            typer.echo(f"speed anomaly: {step.anomaly}")
    if summary["dac_identity_median"] is not None:
        typer.echo(
            "miss / duration differs from the file's own current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if result.steps:
        typer.echo(f"surfaced in the 90 % ellipse: {100 * summary['inside_90']:.0f} %")
    typer.echo(f"learned: {', '.join(summary['learned']) or 'nothing'}")
    if summary["held"]:
        typer.echo(f"held, for the dives do not excite them: {', '.join(summary['held'])}")
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        typer.echo(f"skipped {name}: {entry['why']}")


def ellipse(covariance: Any) -> tuple[float, float, float]:
    """Give half axes (m) and bearing of the long axis (degrees).

    Parameters
    ----------
    covariance : ndarray, shape (2, 2)
        East and north, m^2.

    Returns
    -------
    long, short : float
        Half axes of the 90 % ellipse, m.
    bearing : float
        Of the long one, degrees clockwise from north, 0 to 180.
    """
    import numpy as np

    from ..ocean.replay import ELLIPSE

    size, axes = np.linalg.eigh(covariance)
    short, long = np.sqrt(ELLIPSE * size)
    bearing = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180.0
    return float(long), float(short), float(bearing)
