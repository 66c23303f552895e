"""Command `clpt estimate`: the flow from recorded fixes, live fixes, or a run."""

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import clpt_control as clpt

from ...base.errors import ClptError, DataError, ScenarioError
from ...base.files import write_together
from ...base.html import Result
from ...base.progress import tell
from ...base.units import finite_or_none
from .printing import (
    FIGURE,
    SCENARIO,
    Json,
    arg,
    cell_text,
    check_out,
    draw_figure,
    finish,
    flag,
    opt,
    say,
)

if TYPE_CHECKING:
    import numpy as np
    import xarray

LIVE = "-"
MISSION = "made_auv_mission.csv"
OF_RUNS = ("method", "every", "prior", "noise", "until")
OF_FIXES = ("scenario", "drifter", "figure", "results")


def estimate(
    source: str | None = arg(
        "FIXES",
        "Table of fixes or a vehicle's files; - for lines of JSON; or a run's NetCDF.",
        default=None,
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
    state: Path | None = opt(
        "FILE", "With -: file of the state, which is taken up again."
    ),
    method: str | None = opt("NAME", "For a run: least-squares (default) or kalman."),
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
    as_json: Json = False,
) -> None:
    """Learn the flow from fixes, recorded or live, or from a run.

    Example:
        clpt estimate --sample --figure learned.png
        clpt estimate fixes.csv --scenario mine.toml --out known.toml
        clpt estimate - --scenario mine.toml --state state.json
        clpt estimate run.nc --method kalman --out known.toml
    """
    check_out(out, *SCENARIO)
    check_out(figure, *FIGURE)
    check_out(results, "the results", (".nc",))
    given = {
        name: value
        for name, value in locals().items()
        if value not in (None, False) and name in (*OF_RUNS, *OF_FIXES, "state")
    }
    if sample:
        source, scenario = _sample(source, scenario)
    if source is None:
        raise DataError(
            f"FIXES: are missing. Give a table, {LIVE} or a run, or --sample"
        )
    if source.endswith(".toml"):
        raise DataError(
            f"{source}: is not a run. Make a run with: clpt run {source} --out run.nc"
        )
    if source.endswith(".nc") and scenario is None:
        _refuse(given, (*OF_FIXES, "state"), "a run")
        of_run(Path(source), method, every, prior, noise, until, out, as_json)
        return
    _refuse(given, OF_RUNS, "fixes. Set the keys of the law in the scenario")
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
    if source == LIVE:
        _refuse(given, ("drifter", "figure", "results"), "live fixes")
        _live(learner, state, out)
        return
    _refuse(given, ("state",), "recorded fixes. Give - to read live fixes")
    _recorded(source, learner, (out, figure, results), drifter, as_json)


def _sample(source: str | None, scenario: Path | None) -> tuple[str, Path]:
    """Return the made mission, and its scenario unless another is given."""
    if source is not None:
        raise DataError(f"{source}: not with --sample. Leave one out")
    folder = Path(clpt.__file__).parent / "data"
    return str(folder / MISSION), scenario or (folder / MISSION).with_suffix(".toml")


def _refuse(given: dict[str, Any], names: tuple[str, ...], what: str) -> None:
    """Refuse options that do not go with the source."""
    for name in names:
        if name in given:
            raise ScenarioError(f"--{name}: not with {what}")


# --- recorded -------------------------------------------------------------------------------------


def _recorded(
    source: str,
    scenario: "clpt.Scenario",
    paths: tuple[Path | None, Path | None, Path | None],
    drifter: bool,
    as_json: bool,
) -> None:
    """Learn from a table or files."""
    from ...ocean.estimation.theta_from_fixes import flow_of_legs
    from ...ocean.gliders.dive_files import read_legs
    from ..pages.fixes_page import learned_flow_plot, report_of, results_of

    out, figure, results = paths
    legs, skipped = read_legs(source, drifter)
    data, estimator = flow_of_legs(legs, scenario)
    if out is not None:
        clpt.save_scenario(known_scenario(scenario, estimator.theta, data), out)
    draw_figure(figure, learned_flow_plot, data)
    if results is not None:
        write_together({results: data})
    data.attrs["title"] = Path(source).name
    report = report_of(data, skipped)
    finish(results_of(report), report, as_json, out, figure, results)


def known_scenario(
    scenario: "clpt.Scenario", theta: "np.ndarray", data: "xarray.Dataset"
) -> "clpt.Scenario":
    """Return the scenario that gives the estimate to the known-flow law."""
    begin = data.attrs["time_origin"][:19]
    titled = scenario.with_values(
        {
            "title": f"{scenario.title or 'Learned flow'}, t = 0 at {begin} UTC",
            "origin": list(data.attrs["origin"]),
        }
    )
    return clpt.currents.known_flow_scenario(titled, theta)


# --- live -----------------------------------------------------------------------------------------


def _live(scenario: "clpt.Scenario", state: Path | None, out: Path | None) -> None:
    """Answer lines of standard input until it ends."""
    from ...ocean.estimation.live_fixes import LiveFixes

    learner = LiveFixes(scenario, state)
    refused = 0
    for number, line in enumerate(sys.stdin, 1):
        if not line.strip():
            continue
        try:
            answer = learner.answer(line)
        except DataError as error:
            tell(f"clpt: line {number}: {error}")
            refused += 1
            continue
        if answer is not None:
            say(json.dumps(answer))
    if out is not None and learner.estimator.legs:
        theta = learner.estimator.theta
        clpt.save_scenario(clpt.currents.known_flow_scenario(scenario, theta), out)
    if refused:
        raise ClptError(f"{refused} line{'s' * (refused > 1)} refused, as told above")


# --- of a run -------------------------------------------------------------------------------------


def of_run(
    run: Path,
    method: str | None,
    every: float | None,
    prior: float | None,
    noise: float | None,
    until: float | None,
    out: Path | None,
    as_json: bool,
) -> None:
    """Estimate theta from fixes of a run."""
    import numpy as np
    import xarray

    from ...ocean.estimation.between_fixes import run_scenario

    data = clpt.load_run(run)
    scenario = run_scenario(data)
    if until is not None:
        if not data.time.values[1] < until <= data.time.values[-1]:
            raise ScenarioError(f"--until {until:g}: must lie within the run")
        data = data.sel(time=slice(None, until * (1 + 1e-12)))
    method = method or "least-squares"
    fitted_flow = clpt.currents.flow_estimate(
        data, method=method, every=every, prior=prior, noise=noise
    )
    assert not isinstance(fitted_flow, xarray.Dataset)
    if out is not None:
        fed = clpt.currents.known_flow_scenario(scenario, fitted_flow.theta)
        clpt.save_scenario(fed, out)
    sd, length = fitted_flow.standard_deviation, scenario.units.length
    speed = f"{length}/{scenario.units.time}"
    report = {
        "method": method,
        "units": {"length": length, "time": scenario.units.time},
        "fixes": len(fitted_flow.misses) + 1,
        "theta": fitted_flow.theta.tolist(),
        "standard_deviation": sd.tolist(),
        "condition_number": finite_or_none(fitted_flow.condition_number),
        "rms_of_misses_left": float(
            np.sqrt(np.mean(np.sum(fitted_flow.misses**2, axis=1)))
        ),
        "steps": len(fitted_flow.steps),
    }
    if scenario.flow.parameters is not None:
        error = np.abs(fitted_flow.theta - np.array(scenario.flow.parameters))
        report["largest_error"] = float(error.max())
    rows = [
        [
            str(k + 1),
            *(f"{fitted_flow.theta[i, k]:#.4g}" for i in range(2)),
            f"{sd[k]:.1e}",
        ]
        for k in range(len(sd))
    ]
    names = "theta_1", "theta_2", "standard deviation"
    columns = ["function", *(f"{name} ({speed})" for name in names)]
    units = {
        "condition_number": "",
        "rms_of_misses_left": length,
        "largest_error": speed,
    }
    sentences = [
        f"{key.replace('_', ' ')}: {cell_text(report[key])} {unit}".rstrip()
        for key, unit in units.items()
        if report.get(key) is not None
    ]
    if out is not None:
        sentences.append(f"Wrote {out}, with law = known-flow and this estimate")
    title = f"{run}: {method}, {report['fixes']} fixes"
    finish([Result(title, columns, rows, sentences)], report, as_json)
