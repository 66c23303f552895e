"""Commands on tracks: `clpt excitation`, its bounds, and the waypoints of `clpt tune`."""

from pathlib import Path
from typing import Any

import clpt_control as clpt

from ...base.errors import ClptError, refuse_unused
from ...base.files import check_writable, write_together
from ...base.html import Result
from ...base.progress import progress_bar
from ...base.units import at_least, at_most
from .printing import (
    FIGURE,
    SCENARIO,
    Json,
    Report,
    ScenarioFile,
    Start,
    Window,
    cell_text,
    draw_figure,
    finish,
    flag,
    opt,
)


def excitation(
    scenario: ScenarioFile,
    window: Window = None,
    start: Start = None,
    figure: Path | None = opt(
        "FILE", ".png, .pdf or .svg: eigenvalues and directions."
    ),
    bounds: bool = flag(
        "Bound CLPE and errors for every start of the learner instead; with fixes, the error of "
        "the learned flow.",
        "--bounds",
    ),
    radius: float | None = opt(
        "R", "With --bounds: largest V(0); default: that of the scenario's own start."
    ),
    error: float | None = opt(
        "LENGTH",
        "With --bounds: CLPE to come to; default: a hundredth of what R allows.",
    ),
    shear: float | None = opt(
        "L",
        "With --bounds and fixes: largest shear of the flow, 1/s; default: what prior and "
        "widths allow.",
    ),
    unmodelled: float | None = opt(
        "SPEED",
        "With --bounds and fixes: largest flow beside the functions, m/s; default: 0.01.",
    ),
    as_json: Json = False,
) -> None:
    """Measure excitation along a track, and the time to learn.

    A team is measured vehicle by vehicle, and together.

    Example:
        clpt excitation mine.toml --figure excitation.png
        clpt excitation mine.toml --bounds --radius 0.1 --error 0.01
        clpt excitation fixes.toml --bounds --shear 2e-5 --figure bound.png
    """
    limits = {"shear": shear, "unmodelled": unmodelled}
    of_bounds = {"radius": radius, "error": error, **limits}
    if bounds:
        if start is not None:
            raise ClptError("--start: is not of --bounds. Leave one out")
        options = {**of_bounds, "window": window}
        _bound_errors(scenario, options, figure, as_json)
        return
    reason = "is of --bounds. Give that too, or leave it out"
    refuse_unused(reason, "--", **of_bounds)
    from ..pages.results import is_team

    source = (
        clpt.load_run(scenario)
        if scenario.suffix == ".nc"
        else clpt.load_scenario(scenario)
    )
    if figure is not None and is_team(source):
        raise ClptError("--figure: is for one vehicle. Leave it out for a team")
    check_writable(figure, *FIGURE)
    excitation = clpt.gramian(source, window, start)
    draw_figure(figure, excitation.plot)
    finish([excitation.result], excitation.report, as_json, figure)


def _bound_errors(
    scenario: Path, given: dict[str, float | None], figure: Path | None, as_json: bool
) -> None:
    """Print bounds on CLPE and errors for every start of the learner, or at fixes."""
    from ...paper.scenario.file import load_vehicle_scenario
    from ...theory.excitation.certify_fixes import FixBounds

    check_writable(figure, *FIGURE)
    experiment = load_vehicle_scenario(scenario)
    bounds = clpt.certify(experiment, **given)
    if isinstance(bounds, FixBounds):
        draw_figure(figure, bounds.plot)
        finish([bounds.result], bounds.report(), as_json, figure)
        return
    if figure is not None:
        raise ClptError("--figure: with --bounds is of fixes. Leave one out")
    length = bounds.units["length"]
    time = bounds.units["time"]
    columns = [
        f"from ({time})",
        "V at most",
        f"CLPE at most ({length})",
        f"error of a flow parameter at most ({length}/{time})",
    ]
    numbers = zip(bounds.time, bounds.V, bounds.clpe, bounds.flow_error, strict=True)
    rows = [[at_most(number, 6) for number in row] for row in numbers]
    # a bound holds until the next row
    rows = [row for k, row in enumerate(rows) if row[1:] != rows[k - 1][1:] or not k]
    start = f"V(0) <= {at_least(bounds.radius, 6)}"
    title = f"For every start with {start}, windows of {bounds.window:g} {time}"
    most = f"{at_most(bounds.clpe[0])} {length}{bounds.known_until}"
    sentences = [bounds.said, f"CLPE is never above {most}"]
    if bounds.disturbance > 0:
        end = "is not shown to end below a bound"
        if bounds.ultimate is not None:
            end = f"ends at most at {at_most(bounds.ultimate)} {length}"
        weakest = "if later windows excite like the run's weakest"
        bound = f"|Delta| <= {at_most(bounds.disturbance)} {length}/{time}"
        sentences.append(f"with {bound} it {end}, {weakest}")
    sentences.append(
        f"a window of small errors leaves {at_most(1 - bounds.drops.min())} of V at worst"
    )
    finish([Result(title, columns, rows, sentences)], bounds.report(), as_json)


def tune_waypoints(
    scenario: Path,
    out: Path | None,
    search: dict[str, Any],
    figure: Path | None,
    as_json: bool,
) -> None:
    """Find waypoints by `clpt.theory.design_track`, and write the scenario with them."""
    from ...paper.scenario.file import load_vehicle_scenario, scenario_to_text

    if out is None:
        raise ClptError("--waypoints: needs --out. Give the scenario file to write")
    experiment = load_vehicle_scenario(scenario)
    check_writable(out, *SCENARIO)
    check_writable(figure, *FIGURE)
    with progress_bar(f"designing {scenario.name}", 1.0) as report:
        design = clpt.theory.design_track(experiment, **search, progress=report)
    results: dict[Path, Any] = {out: scenario_to_text(design.scenario, out.parent)}
    if figure is not None:
        from ...base.figures import figure_of

        results[figure] = figure_of(design.plot)
    write_together(results)
    finish([_result(design.report)], design.report, as_json, *results)


DESIGNED = {  # what of a track is said, by key
    "learning_time": "time until no flow parameter is off by {level:.3g} {length}/{time} ({time})",
    "error_at_end": "largest flow-parameter error at the end ({length}/{time})",
    "smallest_eigenvalue": "smallest eigenvalue of the joint Gramian",
    "ceiling": "its upper bound for this motion of the vehicle",
    "of_the_run": "of the run with {law} (clpt excitation)",
    "closed_length": "closed length ({length})",
    "largest_speed": "largest speed through the water ({length}/{time})",
    "positions": "x1 from, to; x2 from, to ({length})",
    "clpe_rms_last_quarter": "CLPE rms, last quarter ({length})",
    "waypoints": "waypoints ({length})",
}


def _result(report: Report) -> Result:
    """Return the old track beside the new one."""
    units = report["units"]
    tracks = report["before"], report["after"]
    words = {**units, "law": report["law"], "level": tracks[1]["level"]}
    rows = [
        [name.format(**words), *(_cell(key, track[key]) for track in tracks)]
        for key, name in DESIGNED.items()
        if key != "ceiling" or tracks[1][key] is not None
    ]
    goal = f"{report['law']} learns soonest"
    if report["goal"] == "kappa":
        goal = "the smallest eigenvalue is largest"
    title = (
        f"Track on which {goal}; Gramian over {report['start']:g} to "
        f"{report['start'] + report['window']:g} {units['time']}, along {report['trajectory']}"
    )
    sentence = f"the best of {report['tracks_tried']} tracks"
    if report["own_track_kept"]:
        sentence = (
            f"no better one of {report['tracks_tried']} tracks was found within these limits, so "
            "it stays as it is. Give another seed, or allow more length, speed or area"
        )
    return Result(title, ["", "before", "after"], rows, [sentence])


def _cell(key: str, value: Any) -> str:
    if value is None:
        return "not within the run"
    if key == "waypoints":
        return "\n".join(f"{x1:z8.3f} {x2:z8.3f}" for x1, x2 in value)
    if key == "positions":
        return "; ".join(cell_text(pair) for pair in value)
    return cell_text(list(value.values()) if isinstance(value, dict) else value)
