"""Command `clpt estimate`: the flow from recorded fixes, or of a run."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import clpt_control as clpt

from ...base.errors import ClptError, DataError, ScenarioError, refuse_unused
from ...base.files import check_writable, write_file
from .printing import FIGURE, SCENARIO, Json, arg, draw_figure, finish, flag, opt

if TYPE_CHECKING:
    import xarray

MISSION = "made_auv_mission.csv"
VISITED = 6  # fixes of the track, by a run in the learned flow


def estimate(
    source: str | None = arg(
        "FIXES", "Table of fixes or a vehicle's files; or a run's NetCDF.", default=None
    ),
    scenario: Path | None = opt(
        "SCENARIO", "Scenario file: functions and law, for fixes."
    ),
    out: Path | None = opt(
        "FILE", "Scenario file to write, with the estimate given to law known-flow."
    ),
    figure: Path | None = opt(
        "FILE", "Figure to write: track, forecasts, learned flow."
    ),
    results: Path | None = opt(
        "FILE", "NetCDF file to write; clpt report makes a page of it."
    ),
    sample: bool = flag(
        "Learn from a made AUV mission that ships with the package.", "--sample"
    ),
    drifter: bool = flag(
        "Take an unknown displacement through the water as 0.", "--drifter"
    ),
    every_row: bool = flag(
        "For fixes: each position was measured, also where other rows predict it.",
        "--every-row",
    ),
    method: str = opt(
        "NAME",
        "kalman, fix by fix by the law, or tomography, all recorded fixes at once.",
        default="kalman",
    ),
    every: float | None = opt(
        "TIME", "For a run: time between fixes; default: a tenth of reference.dwell."
    ),
    prior: float | None = opt(
        "SPEED", "For a run: standard deviation of each theta before any fix."
    ),
    noise: float | None = opt(
        "LENGTH", "For a run: standard deviation of a position error."
    ),
    until: float | None = opt("TIME", "For a run: last time to use."),
    shear: float | None = opt(
        "L",
        "For fixes: largest shear of the flow, 1/s, of the guaranteed error; default: what prior "
        "and widths allow.",
    ),
    unmodelled: float | None = opt(
        "SPEED", "For fixes: largest flow beside the functions, m/s; default: 0.01."
    ),
    as_json: Json = False,
) -> None:
    """Learn the flow from recorded fixes, or from a run.

    Example:
        clpt estimate --sample --figure learned.png
        clpt estimate fixes.csv --scenario mine.toml --out known.toml
        clpt estimate run.nc --method kalman --out known.toml
    """
    check_writable(out, *SCENARIO)
    check_writable(figure, *FIGURE)
    check_writable(results, "the results", (".nc",))
    options = {"shear": shear, "unmodelled": unmodelled}
    limits = {name: x for name, x in options.items() if x is not None}
    for name, limit in limits.items():
        if not limit > 0:
            raise ClptError(f"--{name} {limit:g}: must be above 0")
    if sample:
        source, scenario = _sample(source, scenario)
    if source is None:
        raise DataError("FIXES: are missing. Give a table or a run, or --sample")
    if source == "-":
        raise DataError(
            "FIXES: - is no file. For fixes that arrive call clpt.currents.FlowEstimator in Python"
        )
    if source.endswith(".toml"):
        raise DataError(
            f"{source}: is a scenario, not fixes or a run. Give: clpt estimate fixes.csv "
            f"--scenario {source}, or make a run with: clpt run {source} --out run.nc"
        )
    if source.endswith(".nc") and scenario is None:
        of_fixes = {"drifter": drifter or None, "every-row": every_row or None}
        refuse_unused("not with a run", "--", **of_fixes, **limits)
        learned = _of_run(Path(source), method, (every, prior, noise), until)
    else:
        of_runs = {"every": every, "prior": prior, "noise": noise, "until": until}
        reason = "not with fixes. Set the keys of the law in the scenario"
        refuse_unused(reason, "--", **of_runs)
        learned = _recorded(source, scenario, method, drifter, every_row, limits)
    from ..pages.fixes_page import learned_flow_plot, report_of, results_of

    data, known_flow, skipped, truth = learned
    left_out = [{"leg": skip.dive, "why": skip.why} for skip in skipped]
    data.attrs["skipped"] = json.dumps(left_out)
    if out is not None:
        clpt.save_scenario(known_flow, out)
    draw_figure(figure, learned_flow_plot, data)
    data.attrs["title"] = Path(source).name
    if results is not None:
        write_file(results, data)
    report = report_of(data, truth)
    finish(results_of(report), report, as_json, out, figure, results)


def _sample(source: str | None, scenario: Path | None) -> tuple[str, Path]:
    """Return the made mission, and its scenario unless another is given."""
    if source is not None:
        raise DataError(f"{source}: not with --sample. Leave one out")
    folder = Path(clpt.__file__).parent / "data"
    return str(folder / MISSION), scenario or (folder / MISSION).with_suffix(".toml")


# estimate, scenario that is given it, what was skipped, and theta of a run (m/s)
Learned = tuple["xarray.Dataset", "clpt.Scenario", Sequence[Any], Any]


def _recorded(
    source: str,
    scenario: Path | None,
    method: str,
    drifter: bool,
    every_row: bool,
    limits: dict[str, Any],
) -> Learned:
    """Learn from a table or files; the scenario to write begins at the first fix."""
    from ...ocean.estimation.theta_from_fixes import check_method, flow_of_legs
    from ...ocean.gliders.dive_files import read_legs

    if scenario is None:
        raise ScenarioError(
            "--scenario: is missing. Give the scenario file with functions and law; for a run give "
            "its NetCDF file"
        )
    learner = clpt.load_scenario(scenario)
    if not isinstance(learner, clpt.Scenario):
        raise ScenarioError(
            f"{scenario}: is a team's. Give the scenario of one vehicle"
        )
    check_method(method)
    legs, skipped = read_legs(source, drifter, every_row)
    data, theta = flow_of_legs(legs, learner, method, every_row=every_row, **limits)
    begin = data.attrs["time_origin"][:19]
    titled = learner.with_values(
        {
            "title": f"{learner.title or 'Learned flow'}, t = 0 at {begin} UTC",
            "origin": list(data.attrs["origin"]),
            **_visits(data, learner),
        }
    )
    return data, clpt.currents.known_flow_scenario(titled, theta), skipped, None


def _visits(data: "xarray.Dataset", learner: "clpt.Scenario") -> dict[str, Any]:
    """Return tables, of those left out, for a run as long as the track, to some of its fixes."""
    import numpy as np

    from ...base.geodesy import LocalPlane
    from ...base.units import SECONDS
    from ...paper.scenario.recorded_run import fixes_of

    latitude, longitude = data.attrs["origin"]
    plane = LocalPlane(latitude, longitude, learner.units.length)
    reach, plane.widest = plane.widest, np.inf
    points = np.transpose(plane.to_plane(*fixes_of(data)[0]))
    points = points[np.hypot(*points.T) <= reach]
    few = points[np.linspace(0, len(points) - 1, VISITED).astype(int)]
    span = (data.end_time[-1] - data.start_time[0]) / np.timedelta64(VISITED, "s")
    dwell = float(span) / SECONDS[learner.units.time]
    tables = {
        "reference": {"kind": "waypoints", "points": few.tolist(), "dwell": dwell},
        "run": {"duration": VISITED * dwell, "output_step": dwell / 100},
    }
    return {name: tables[name] for name in tables if name in learner.left_out}


def _of_run(
    run: Path,
    method: str,
    settings: tuple[float | None, float | None, float | None],
    until: float | None,
) -> Learned:
    """Estimate theta from fixes of a run; settings are `every`, `prior` and `noise`."""
    import numpy as np

    from ...base.units import METRES, SECONDS
    from ...ocean.estimation.theta_from_fixes import check_method, flow_of_run
    from ...paper.scenario.run_track import run_scenario

    check_method(method)
    data = clpt.load_run(run)
    scenario = run_scenario(data)
    if until is not None:
        if not data.time.values[1] < until <= data.time.values[-1]:
            raise ScenarioError(f"--until {until:g}: must lie within the run")
        data = data.sel(time=slice(None, until * (1 + 1e-12)))
    estimate, theta = flow_of_run(data, method, *settings)
    speed = METRES[scenario.units.length] / SECONDS[scenario.units.time]
    theta_true = scenario.flow.parameters
    truth = None if theta_true is None else np.array(theta_true) * speed
    return estimate, clpt.currents.known_flow_scenario(scenario, theta), (), truth
